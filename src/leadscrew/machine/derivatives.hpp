#pragma once
// One value for each of velocity, acceleration and jerk.

#include <algorithm>

namespace leadscrew::machine {

/// One number for each derivative by time: limits of an axis or along a path (units and seconds), or ratios of a value
/// over its limit.
struct Derivatives {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;

  constexpr double greatest() const { return std::max({velocity, acceleration, jerk}); }
  friend constexpr bool operator==(const Derivatives&, const Derivatives&) = default;
};

/// The greater of each.
constexpr Derivatives greater(const Derivatives& a, const Derivatives& b) {
  return {std::max(a.velocity, b.velocity), std::max(a.acceleration, b.acceleration), std::max(a.jerk, b.jerk)};
}

}  // namespace leadscrew::machine
