#pragma once
// What shards hold, as one table: results.jsonl, results.csv, results.npy in the folder of the sweep, a row a task, in the order
// of tasks, whoever did them and when.

#include <leadscrew/base/result.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/work.hpp>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// DIR/shards.
std::string shards_of_sweep(const std::string& folder);

/// Writes DIR/tasks.jsonl, which says which tasks the sweep has: what a later merge needs. Errors: `io-open`, `io-write`.
base::Result<void> write_tasks(const Work& work, const std::string& folder);

/// The rows that are there, and what they took.
struct Merged {
  std::vector<json::Json> rows;    ///< in the order of tasks; those that are not done are left out
  std::int64_t tasks = 0;          ///< that the sweep has
  double processor_s = 0;          ///< that the tasks took, each once
  std::vector<std::string> files;  ///< written
};

/// Errors: `sweep-tasks` where the folder holds no sweep, those of reading and writing.
base::Result<Merged> merge(const std::string& folder);

}  // namespace leadscrew::sweep
