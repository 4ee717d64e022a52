#include <leadscrew/machine/derivatives.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor_stops.hpp>

namespace leadscrew::toolpath {

namespace {

/// Along the leg; of an arc, what every direction in its plane allows, acceleration and jerk of the turning included.
machine::Derivatives limits_along(const CorridorLeg<3>& leg, const CorridorLimits<3>& limits) {
  machine::Derivatives along{leg.feed, unlimited, unlimited};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = leg.is_arc ? (i == leg.first || i == leg.second ? 1 : 0) : std::abs(leg.direction[i]);
    if (!(share > 0)) continue;
    along.velocity = std::min(along.velocity, limits.velocity[i] / share);
    along.acceleration = std::min(along.acceleration, limits.acceleration[i] / share);
    along.jerk = std::min(along.jerk, limits.jerk[i] / share);
  }
  if (leg.is_arc) {
    along.velocity = std::min({along.velocity, std::sqrt(along.acceleration * leg.radius),
                               numeric::cbrt(along.jerk * leg.radius * leg.radius)});
  }
  return along;
}

/// From rest to the speed, s.
double ramp_time(double speed, const machine::Derivatives& most) {
  const double rise = most.acceleration / most.jerk;
  return speed > most.acceleration * rise ? speed / most.acceleration + rise : 2 * std::sqrt(speed / most.jerk);
}

/// From rest to rest, in at most seven phases of constant jerk.
double from_rest_to_rest(double length, const machine::Derivatives& most) {
  if (length > most.velocity * ramp_time(most.velocity, most))
    return length / most.velocity + ramp_time(most.velocity, most);
  const double speed_by_jerk = numeric::cbrt(length * length * most.jerk / 4), a = most.acceleration;
  const double rise = a / most.jerk;
  if (speed_by_jerk <= a * rise) return 2 * ramp_time(speed_by_jerk, most);
  // L = v²/a + v a/j.
  const double speed = (std::sqrt(rise * rise * a * a + 4 * a * length) - a * rise) / 2;
  return 2 * ramp_time(speed, most);
}

}  // namespace

double time_with_stops(const Corridor<3>& corridor, double begin, double end) {
  double total = 0;
  const std::size_t last = corridor.legs.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const CorridorLeg<3>& leg = corridor.legs[k];
    const machine::Derivatives most = limits_along(leg, corridor.limits);
    const double length = (k == last ? end : leg.length) - (k == 0 ? begin : 0);
    total += from_rest_to_rest(length, most);
    // A ramp loses half of its time.
    if (k == 0 && corridor.begin == CorridorEnd::moving) total -= ramp_time(most.velocity, most) / 2;
    if (k == last && corridor.end == CorridorEnd::moving) total -= ramp_time(most.velocity, most) / 2;
  }
  return total;
}

}  // namespace leadscrew::toolpath
