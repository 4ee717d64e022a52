#pragma once
// The line of the progress bar.

#include <leadscrew/cli/console.hpp>
#include <string>

namespace leadscrew::cli {

/// `moving  43 % [########..........]  1.2 M words  35x real time  0:12 left`, cut to `width` characters.
std::string progress_text(const Progress& progress, double elapsed_seconds, int width);

/// 0:12, 3:05, 1:02:03.
std::string clock_text(double seconds);

}  // namespace leadscrew::cli
