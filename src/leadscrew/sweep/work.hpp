#pragma once
// Independent tasks, whatever they are: programs of an archive, or random ones.

#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/key.hpp>
#include <vector>

namespace leadscrew::sweep {

class Work {
 public:
  virtual ~Work() = default;

  virtual std::int64_t count() const = 0;
  /// Of task 0 … count() − 1.
  virtual Key key(std::int64_t task) const = 0;
  /// About how long it takes, in any unit: tasks that take longest are begun first.
  virtual double cost(std::int64_t task) const = 0;
  /// What stands before the result in a row: task, program, machine and the like.
  virtual std::vector<json::Json::Member> place(std::int64_t task) const = 0;
  /// What the task finds: the same on every computer, whoever does it, so that no time of the computer is in it. What is wrong
  /// with a program is a result. Errors, after which the task has to be done again: a file that has changed since its key
  /// was made, `interrupted`, files that cannot be written.
  virtual base::Result<json::Json> result(std::int64_t task) = 0;
};

}  // namespace leadscrew::sweep
