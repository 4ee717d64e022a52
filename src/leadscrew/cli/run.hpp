#pragma once
// `leadscrew run`: programs become words.
//
// Each program is read three times, by readers that know nothing of each other: whole, for its problems, before
// anything moves; by the pipeline, which makes the words; and by the referee, which judges every word as it comes.
//
//   program ─▶ pipeline ─▶ word ─┬─▶ trace
//      │                         ├─▶ recording ─▶ report
//      └─▶ moves ─▶ referee ◀────┘

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status run(const Job& job, Console& console);

}  // namespace leadscrew::cli
