#pragma once
// The promises themselves as tasks: random programs on random machines (campaign/), each read, planned, made into words and
// judged by the referee. What does not keep a promise is kept, and made smaller as long as it still does not.
//
//     DIR/counterexamples/SEED-NUMBER.ngc, .toml and .tbl, and SEED-NUMBER-reduced.ngc

#include <leadscrew/campaign/cases.hpp>
#include <leadscrew/sweep/work.hpp>
#include <string>

namespace leadscrew::sweep {

/// What came of a case.
struct Judgement {
  std::string broken;  ///< the promise that was not kept, such as "jerk"; empty: all were
  json::Json result;   ///< of the row
};

/// The case of this number: of those that are drawn for it the first whose motion takes about a tenth of a second, so that a
/// task takes about 10 ms; one in 100 of a kind is larger.
campaign::Case chosen_case(std::uint64_t seed, std::int64_t number);

/// Runs it, at its period or at one that makes a thousand words or so of it.
Judgement judge(const campaign::Case& given);

/// A program that breaks the same promise with fewer lines; the changes of the feed stay. Of so many runs at most.
std::string reduced(const campaign::Case& given, const std::string& broken, int most_runs);

class Campaign final : public Work {
 public:
  struct Setup {
    std::uint64_t seed = 1;
    std::int64_t first = 0, count = 0;
    std::string counterexamples;  ///< folder
  };
  explicit Campaign(Setup setup) : setup_(std::move(setup)) {}

  std::int64_t count() const override { return setup_.count; }
  Key key(std::int64_t task) const override;
  double cost(std::int64_t) const override { return 1; }
  /// Task, seed, number and kind.
  std::vector<json::Json::Member> place(std::int64_t task) const override;
  base::Result<json::Json> result(std::int64_t task) override;

 private:
  base::Result<void> keep(const campaign::Case& given, const std::string& broken, std::int64_t number) const;

  Setup setup_;
};

}  // namespace leadscrew::sweep
