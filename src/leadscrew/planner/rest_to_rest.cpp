#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/rest_to_rest.hpp>

namespace leadscrew::planner {

RestToRest rest_to_rest(double distance, const machine::Derivatives& limits) {
  const double V = limits.velocity, A = limits.acceleration, J = limits.jerk, L = distance;

  // The ramp to full speed: with constant acceleration where A is reached on the way to V.
  RestToRest motion{.jerk = J};
  const bool reaches_acceleration = V >= A * A / J;
  motion.jerk_time = reaches_acceleration ? A / J : std::sqrt(V / J);
  motion.acceleration_time = reaches_acceleration ? V / A - A / J : 0;
  const double ramps = V * (2 * motion.jerk_time + motion.acceleration_time);  // both together
  if (ramps <= L) {
    motion.cruise_time = (L - ramps) / V;
    return motion;
  }

  // Full speed is not reached. Peak speed from L = V_p (V_p/A + A/J), without cancellation; good where it is ≥ A²/J.
  const double half = A * A / (2 * J);
  const double peak = A * L / (half + std::sqrt(half * half + A * L));
  motion.jerk_time = peak >= A * A / J ? A / J : numeric::cbrt(L / (2 * J));
  motion.acceleration_time = peak >= A * A / J ? std::max(0.0, peak / A - A / J) : 0;
  motion.cruise_time = 0;
  return motion;
}

}  // namespace leadscrew::planner
