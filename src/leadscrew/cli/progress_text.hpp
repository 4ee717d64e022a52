#pragma once
// The line of the progress bar.

#include <leadscrew/cli/console.hpp>
#include <string>

namespace leadscrew::cli {

/// `moving  43 % [########..........]  1.2 M words  35x real time  0:12 left`, cut to `width` characters.
std::string progress_text(const Progress& progress, double elapsed_seconds, int width);

}  // namespace leadscrew::cli
