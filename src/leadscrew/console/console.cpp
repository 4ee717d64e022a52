#include <sys/ioctl.h>

#include <algorithm>
#include <cstdlib>
#include <leadscrew/console/console.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/results/diagnostic_text.hpp>

namespace leadscrew::console {

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Style style_of(int descriptor, ColorChoice color) {
  if (color != ColorChoice::automatic) return {color == ColorChoice::always};
  const bool wanted = environment("NO_COLOR").empty() && environment("TERM") != "dumb";
  return {wanted && ::isatty(descriptor) == 1};
}

int progress_width() {
  winsize size = {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

Console::Console(ColorChoice color, bool quiet)
    : output_style_(style_of(STDOUT_FILENO, color)),
      error_style_(style_of(STDERR_FILENO, color)),
      shows_progress_(!quiet && ::isatty(STDERR_FILENO) == 1 && environment("TERM") != "dumb") {}

base::Result<void> Console::output(std::string_view text) {
  clear_progress();
  return files::write_all(STDOUT_FILENO, text, "standard output");
}

void Console::diagnostic(const base::Diagnostic& diagnostic) {
  error_text(results::diagnostic_text(diagnostic, error_style_));
}

void Console::error_text(std::string_view text) {
  if (errors_ != nullptr) {
    errors_->append(text);
    return;
  }
  clear_progress();
  // There is nowhere to say that standard error cannot be written.
  static_cast<void>(files::write_all(STDERR_FILENO, text, "standard error"));
}

void Console::begin_progress() {
  begun_ = drawn_at_ = Clock::now();
}

void Console::progress(const Progress& progress) {
  if (!shows_progress_) return;
  const auto now = Clock::now();
  if (now - drawn_at_ < std::chrono::milliseconds(100)) return;
  drawn_at_ = now;
  const double elapsed = std::chrono::duration<double>(now - begun_).count();
  const std::string text = "\r" + results::progress_text(progress, elapsed, progress_width() - 1) + "\033[K";
  drawn_ = true;
  static_cast<void>(files::write_all(STDERR_FILENO, text, "standard error"));
}

void Console::clear_progress() {
  if (!drawn_) return;
  drawn_ = false;
  static_cast<void>(files::write_all(STDERR_FILENO, "\r\033[K", "standard error"));
}

options::Status write_output(Console& console, std::string_view text) {
  const auto written = console.output(text);
  if (written) return options::Status::done;
  if (written.error().code == "io-write") console.diagnostic(written.error());
  return options::status_of(written.error());
}

}  // namespace leadscrew::console
