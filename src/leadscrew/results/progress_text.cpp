#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/results/progress_text.hpp>

namespace leadscrew::results {

namespace {

constexpr int bar_width = 20;

std::string count_text(std::int64_t count) {
  if (count >= 1'000'000) return fmt::format("{:.1f} M", static_cast<double>(count) / 1e6);
  if (count >= 10'000) return fmt::format("{} k", count / 1000);
  return fmt::format("{}", count);
}

}  // namespace

std::string progress_text(const Progress& progress, double elapsed_seconds, int width) {
  const double done =
      progress.total > 0 ? static_cast<double>(progress.bytes) / static_cast<double>(progress.total) : 1;
  const auto filled = static_cast<std::size_t>(done * bar_width);
  std::string text =
      fmt::format("{} {:3.0f} % [{:.<20}]", progress.work, std::floor(done * 100), std::string(filled, '#'));
  if (progress.words > 0) {
    text += fmt::format("  {} words  {:.0f}x real time", count_text(progress.words),
                        progress.motion_seconds / elapsed_seconds);
  }
  if (done > 0.01 && done < 1)
    text += fmt::format("  {} left", results::clock_text(elapsed_seconds * (1 - done) / done));
  return text.substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

}  // namespace leadscrew::results
