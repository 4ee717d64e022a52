#pragma once
// What a sweep is told by: figures of all its rows.

#include <leadscrew/json/json.hpp>
#include <leadscrew/results/style.hpp>
#include <leadscrew/sweep/merge.hpp>
#include <leadscrew/sweep/sensitivity.hpp>
#include <map>
#include <string>
#include <vector>

namespace leadscrew::sweep {

inline constexpr const char* sweep_schema = "leadscrew.sweep/1";

struct Summary {
  std::int64_t tasks = 0;
  std::int64_t rows = 0;                                              ///< tasks that have a result
  std::int64_t done_before = 0, done = 0, failed = 0;                 ///< by this start and before it
  std::int64_t kept = 0, not_kept = 0, rejected = 0, unreadable = 0;  ///< of the rows
  std::map<std::string, std::int64_t> rows_of_others;                 ///< as Merged has them
  std::vector<std::string>
      refused;  ///< the first programs that were rejected or cannot be read, each once: place and error
  std::int64_t more_refused = 0;  ///< that are not listed
  std::string last_refused;       ///< program and code
  double time_s = 0;              ///< of all motions together
  double tasks_processor_s = 0;   ///< s of the processor that the tasks of all rows took
  double processor_s = 0;         ///< of this start, everything
  double wall_s = 0;              ///< of this start
  std::vector<std::string> files;
  std::vector<Sensitivity> sensitivities;  ///< where limits were changed
};

/// Counts a row.
void observe(const json::Json& row, Summary& summary);

json::Json json_of(const Summary& summary);
std::string text_of(const Summary& summary, const results::Style& style);
/// That rows are by other builds, and how to have them done again; empty where all are by this one.
std::string told_of_others(const Summary& summary);

}  // namespace leadscrew::sweep
