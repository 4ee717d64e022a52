#pragma once
// From one speed to another in the least time within bounds of acceleration and jerk: three phases of constant jerk.
//
//   acceleration   peak .--------.              A speed that lies below the one that motion comes to while its
//                      /          \             acceleration is brought to 0, v + a|a|/2J, is reached by braking, any
//                 from             '-- 0        other by the mirror image.

#include <array>
#include <leadscrew/planner/rest_to_rest.hpp>

namespace leadscrew::planner {

/// Of constant jerk.
struct Phase {
  double jerk = 0;      ///< units/s³
  double duration = 0;  ///< seconds, ≥ 0
};

struct SpeedChange {
  std::array<Phase, 3> phases{};
  double way = 0;  ///< that it takes, units
};

/// From `speed` and `acceleration` to the speed `to` ≥ 0 and acceleration 0, by the bounds of acceleration and jerk.
/// Speed stays between both, and what it comes to while acceleration is brought to 0.
SpeedChange change_speed(double speed, double acceleration, double to, const machine::Derivatives& limits);

}  // namespace leadscrew::planner
