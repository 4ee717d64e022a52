#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_change.hpp>

namespace leadscrew::planner {

SpeedChange change_speed(double speed, double acceleration, double to, const machine::Derivatives& limits) {
  const double A = limits.acceleration, J = limits.jerk, a = acceleration;
  const double when_let_go = speed + a * std::abs(a) / (2 * J);
  const double sign = to < when_let_go ? -1 : 1;
  // Towards `sign`, Δv = (p² − a²)/2J + p t + p²/2J with p the peak of acceleration, held for t.
  const double from = sign * a, change = sign * (to - speed);
  const double unbounded = std::sqrt(std::max(0.0, J * change + from * from / 2));
  const double peak = std::max(std::min(A, unbounded), from);
  const double held = std::max(0.0, (change - (peak * peak - from * from / 2) / J) / peak);
  SpeedChange result;
  result.phases = {{{sign * J, (peak - from) / J}, {0, peak > 0 ? held : 0}, {-sign * J, peak / J}}};
  double v = speed, b = a;
  for (const auto& [jerk, t] : result.phases) {
    result.way += t * (v + t * (b / 2 + t * jerk / 6));
    v += t * (b + t * jerk / 2);
    b += t * jerk;
  }
  return result;
}

}  // namespace leadscrew::planner
