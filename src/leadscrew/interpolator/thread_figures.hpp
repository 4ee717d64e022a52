#pragma once
// What lines in step with the spindle came to.

#include <cstdint>
#include <leadscrew/base/line.hpp>

namespace leadscrew::interpolator {

struct ThreadFigures {
  std::int64_t lines = 0;  ///< that were cut in step
  double run_in = 0;       ///< units of path length, ≥ 0: the longest way from a line's beginning until it was in step
  base::Line run_in_line{};       ///< of the program, there
  std::int64_t out_of_step = 0;   ///< lines whose end had to be made for before they were in step
  base::Line out_of_step_line{};  ///< of the program, the first of them
};

}  // namespace leadscrew::interpolator
