#pragma once
// What shards hold, as one table: results.jsonl, results.csv, results.npy in the folder of the sweep, a row a task, in the order
// of tasks, whoever did them and when.

#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/work.hpp>
#include <map>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// A file that appears whole. Errors: `io-open`, `io-write`.
base::Result<void> write_text(const std::string& path, const std::string& text);

/// DIR/shards.
std::string shards_of_sweep(const std::string& folder);

/// Writes DIR/tasks.jsonl, which says which tasks the sweep has: what a later merge needs. Errors: `io-open`, `io-write`.
base::Result<void> write_tasks(const Work& work, const std::string& folder);

/// Gets each row, in the order of tasks; those that are not done are left out.
using RowSink = std::function<void(const json::Json&)>;

/// What there is, and what it took.
struct Merged {
  std::int64_t tasks = 0;                              ///< that the sweep has
  std::int64_t rows = 0;                               ///< of tasks that are done
  std::map<std::string, std::int64_t> rows_of_others;  ///< of these, by builds that are not build_name(); "": not told
  double processor_s = 0;                              ///< that the tasks took, each once
  std::vector<std::string> files;                      ///< written
};

/// `see` may be empty. Errors: `sweep-tasks` where the folder holds no sweep, those of reading and writing.
base::Result<Merged> merge(const std::string& folder, const RowSink& see = {});

}  // namespace leadscrew::sweep
