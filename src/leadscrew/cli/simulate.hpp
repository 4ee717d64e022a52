#pragma once
// `leadscrew simulate`: programs become words, and words become motion of slides under simulated loops.
//
//   program ─▶ pipeline ─▶ word ─▶ loops ─▶ slides ─┬─▶ following errors, contour error, feed
//      │                                            ├─▶ trace
//      └─▶ moves ─────────────────────────▶ referee ◀

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status simulate(const Job& job, Console& console);

}  // namespace leadscrew::cli
