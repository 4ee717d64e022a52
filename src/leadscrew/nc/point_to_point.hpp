#pragma once
// Koren's point-to-point routine: every axis steps at every command until its position counter is zero, whatever the
// others do.

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::nc {

template <std::size_t axis_count>
class PointToPoint {
 public:
  static constexpr std::size_t axes = axis_count;

  /// Displacement of each axis, signed, BLU.
  constexpr explicit PointToPoint(const std::array<std::int64_t, axes>& left) : left_(left) {}

  constexpr bool done() const { return left_ == std::array<std::int64_t, axes>{}; }

  constexpr pulse::Pulse<axes> step() {
    pulse::Pulse<axes> pulse;
    for (std::size_t i = 0; i < axes; ++i) {
      pulse.step[i] = pulse::sign(left_[i]);
      left_[i] -= pulse.step[i];
    }
    return pulse;
  }

  constexpr std::int64_t left(std::size_t axis) const { return pulse::absolute(left_[axis]); }

 private:
  std::array<std::int64_t, axes> left_;
};

}  // namespace leadscrew::nc
