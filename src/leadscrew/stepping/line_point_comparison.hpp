#pragma once
// Point comparison along a line in any number of axes: one axis a clock, the one that is furthest behind. Of two axes
// that is the sign of F = |a|y − |b|x, as in a plane (pulse::LinearPointComparison).

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::stepping {

template <std::size_t axis_count>
class LinePointComparison {
 public:
  static constexpr std::size_t axes = axis_count;

  /// Way of each axis, signed, |way| ≤ pulse::greatest_coordinate.
  constexpr explicit LinePointComparison(const std::array<std::int64_t, axes>& way) {
    for (std::size_t i = 0; i < axes; ++i) {
      way_[i] = pulse::absolute(way[i]);
      sign_[i] = pulse::sign(way[i]);
      left_ += way_[i];
    }
  }

  constexpr bool done() const { return left_ == 0; }

  constexpr pulse::Pulse<axes> step() {
    pulse::Pulse<axes> pulse;
    if (done()) return pulse;
    std::size_t last = axes;
    for (std::size_t i = 0; i < axes; ++i) {
      if (done_[i] == way_[i]) continue;
      if (last == axes || done_[i] * way_[last] < done_[last] * way_[i]) last = i;
    }
    --left_;
    ++done_[last];
    pulse.step[last] = sign_[last];
    return pulse;
  }

  /// Steps that an axis still has to make.
  constexpr std::int64_t left(std::size_t axis) const { return way_[axis] - done_[axis]; }

 private:
  std::array<std::int64_t, axes> way_{}, done_{};
  std::array<std::int8_t, axes> sign_{};
  std::int64_t left_ = 0;
};

}  // namespace leadscrew::stepping
