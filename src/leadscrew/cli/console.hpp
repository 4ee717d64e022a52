#pragma once
// Standard output for data; standard error for diagnostics and the progress bar.

#include <chrono>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/results/style.hpp>
#include <string>
#include <string_view>

namespace leadscrew::cli {

using results::Style;
using results::Tone;

enum class ColorChoice { automatic, always, never };

/// How far a long piece of work has come.
struct Progress {
  std::string_view work;              ///< "reading", "moving"
  std::int64_t bytes = 0, total = 0;  ///< of the file that is read
  std::int64_t words = 0;
  double motion_seconds = 0;  ///< of the words made so far
};

class Console {
 public:
  /// A bar is shown only where standard error is a terminal.
  Console(ColorChoice color, bool quiet);
  ~Console() { clear_progress(); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  const Style& output_style() const { return output_style_; }
  const Style& error_style() const { return error_style_; }

  /// Writes data to standard output. Errors: `io-write`.
  base::Result<void> output(std::string_view text);
  void diagnostic(const base::Diagnostic& diagnostic);
  void error_text(std::string_view text);

  void begin_progress();
  /// Drawn at most ten times a second; costs a look at the clock.
  void progress(const Progress& progress);
  void clear_progress();

 private:
  using Clock = std::chrono::steady_clock;

  Style output_style_, error_style_;
  bool shows_progress_ = false;
  bool drawn_ = false;
  Clock::time_point begun_, drawn_at_;
};

}  // namespace leadscrew::cli
