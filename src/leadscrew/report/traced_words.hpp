#pragma once
// Words of positions alone, for recordings of traces that somebody else made.

#include <cmath>
#include <leadscrew/base/word.hpp>

namespace leadscrew::report {

/// Feed is told from one position to the next: by the linear axes where they move, else by the rotary ones.
class TracedWords {
 public:
  explicit TracedWords(base::Period period) : period_(period.seconds()) {}

  /// One period after the one before.
  base::Word next(const base::AxisVector& position, base::Line line) {
    double linear = 0, rotary = 0;
    for (const base::Axis axis : base::all_axes) {
      const double step = count_ > 0 ? position[base::index(axis)] - word_.position[base::index(axis)] : 0;
      (base::is_rotary(axis) ? rotary : linear) += step * step;
    }
    const double travelled = std::sqrt(linear > 0 ? linear : rotary);
    word_.tick = base::Tick{count_++};
    word_.position = position;
    word_.path_length += travelled;
    word_.speed = word_.feed = travelled / period_;
    word_.line = line;
    word_.state = travelled > 0 ? base::MotionState::changing : base::MotionState::rest;
    return word_;
  }

  /// mm; degrees where only rotary axes moved.
  double length() const { return word_.path_length; }

 private:
  double period_;  ///< s
  std::int64_t count_ = 0;
  base::Word word_;  ///< the last
};

}  // namespace leadscrew::report
