#pragma once
// The axis by small steps of Runge and Kutta's classical method in long double: shares no formula with the room but the
// differential equation.

#include <algorithm>
#include <cmath>
#include <leadscrew/servo/simulated_axis.hpp>

namespace leadscrew::servo::testing {

class SmallSteps {
 public:
  explicit SmallSteps(const AxisOptions& options) : options_(options) {}

  void advance(double command, double seconds, int steps) {
    const long double limit = options_.command_limit;
    const long double pull = options_.drive.acceleration * std::clamp<long double>(command, -limit, limit);
    const long double step = static_cast<long double>(seconds) / steps;
    for (int k = 0; k < steps; ++k) {
      const SmallSteps before = *this;
      go(pull, step);
      if (options_.friction > 0 && before.velocity * velocity < 0) {
        // It turned: back, to where the chord of its velocity has 0, and on from there.
        const long double share = before.velocity / (before.velocity - velocity);
        *this = before;
        go(pull, share * step);
        velocity = 0;
        go(pull, (1 - share) * step);
      }
    }
  }

  long double position = 0, velocity = 0, slide = 0;

 private:
  void go(long double pull, long double step) {
    if (velocity == 0 && std::fabs(pull) <= std::max(options_.friction, options_.breakaway)) return;
    const long double against = std::copysign<long double>(options_.friction, velocity != 0 ? velocity : pull);
    const auto slope = [&](long double v) { return pull - against - options_.drive.damping * v; };
    const long double v1 = velocity, a1 = slope(v1);
    const long double v2 = v1 + step / 2 * a1, a2 = slope(v2);
    const long double v3 = v1 + step / 2 * a2, a3 = slope(v3);
    const long double v4 = v1 + step * a3, a4 = slope(v4);
    position += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    velocity += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    const long double play = static_cast<long double>(options_.backlash) / 2;
    slide = std::clamp(slide, position - play, position + play);
  }

  AxisOptions options_;
};

}  // namespace leadscrew::servo::testing
