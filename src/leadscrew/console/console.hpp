#pragma once
// Standard output for data; standard error for diagnostics and the progress bar.

#include <chrono>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/options/status.hpp>
#include <leadscrew/results/progress_text.hpp>
#include <leadscrew/results/style.hpp>
#include <string>
#include <string_view>

namespace leadscrew::console {

using results::Style;
using results::Tone;

enum class ColorChoice { automatic, always, never };

using results::Progress;

class Console {
 public:
  /// A bar is shown only where standard error is a terminal.
  Console(ColorChoice color, bool quiet);
  /// Of one of several programs at a time: what `other` would write to standard error is added to `errors`, which must
  /// outlive this, and there is no bar.
  Console(const Console& other, std::string& errors)
      : output_style_(other.output_style_), error_style_(other.error_style_), errors_(&errors) {}
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
  std::string* errors_ = nullptr;  ///< where they are kept; null: standard error
  bool shows_progress_ = false;
  bool drawn_ = false;
  Clock::time_point begun_, drawn_at_;
};

/// Writes to standard output. Says why if it cannot, but keeps silent where a reader has closed the pipe.
options::Status write_output(Console& console, std::string_view text);

}  // namespace leadscrew::console
