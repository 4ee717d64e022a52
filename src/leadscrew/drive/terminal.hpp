#pragma once
// A terminal that gives keys as they are pressed, and is as it was before when all is over.

#include <termios.h>

#include <optional>
#include <string_view>

namespace leadscrew::drive {

class Terminal {
 public:
  /// Where standard input and standard error are a terminal that can be drawn on; none otherwise.
  static std::optional<termios> settings();

  /// From `before`: keys come at once and are not shown; ^C still is a signal.
  explicit Terminal(const termios& before);
  ~Terminal() { restore(before_); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// The next key that was pressed, if one was.
  static std::optional<char> key();
  static int columns();
  static int rows();
  static void draw(std::string_view text);

  /// By whoever is still there: also from a process that is not in front.
  static void restore(const termios& settings);

 private:
  termios before_;
};

}  // namespace leadscrew::drive
