#pragma once
// Tasks on all processors of this computer, or on those of a world, those that take longest first; what is done already is not
// done again.

#include <leadscrew/console/console.hpp>
#include <leadscrew/sweep/shards.hpp>
#include <leadscrew/sweep/work.hpp>
#include <leadscrew/sweep/world.hpp>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// What is to do.
struct Plan {
  std::vector<std::int64_t> order;  ///< tasks, the most costly first; of those with one key the first alone
  std::int64_t done_before = 0;     ///< tasks whose results are there
};

/// Reads the shards of the folder. Errors: those of for_each_line().
base::Result<Plan> plan_of(const Work& work, const std::string& shards);

/// What came of it.
struct Ended {
  std::int64_t done = 0;    ///< tasks
  std::int64_t failed = 0;  ///< that have to be done again, told on standard error
  options::Status status = options::Status::done;
  double processor_s = 0;  ///< of all processes together, from their beginning to their end
};

/// By so many processes of this computer, ≥ 1, which the calling process starts and waits for; it must have no other thread. A
/// process that is killed ends the others: `sweep-process` is told.
Ended run_alone(Work& work, const Plan& plan, const std::string& shards, int processes, console::Console& console);

/// As a rank of a world; all have the same plan. What rank 0 returns is of all.
Ended run_ranked(Work& work, const Plan& plan, const std::string& shards, World& world, console::Console& console);

}  // namespace leadscrew::sweep
