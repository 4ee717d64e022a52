#pragma once
// The line of the progress bar.

#include <cstdint>
#include <string>
#include <string_view>

namespace leadscrew::results {

/// How far a long piece of work has come.
struct Progress {
  std::string_view work;              ///< "reading", "moving"
  std::int64_t bytes = 0, total = 0;  ///< of the file that is read
  std::int64_t words = 0;
  double motion_seconds = 0;  ///< of the words made so far
};

/// `moving  43 % [########..........]  1.2 M words  35x real time  0:12 left`, cut to `width` characters.
std::string progress_text(const Progress& progress, double elapsed_seconds, int width);

}  // namespace leadscrew::results
