#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_change.hpp>
#include <random_numbers.hpp>

namespace test_speed_change {

using namespace leadscrew;
using testing_support::any;
using testing_support::logarithmic;

/// Integrated step by step, not by the formulas that made it.
RC_GTEST_PROP(SpeedChange, EndsAtTheSpeedWithoutAccelerationInsideTheBounds, ()) {
  const machine::Derivatives limits{0, logarithmic(10, 1e4), logarithmic(100, 1e6)};
  const double a = limits.acceleration * any(-1000, 1000) / 1000;
  const double speed = logarithmic(0.1, 500) + a * a / (2 * limits.jerk),
               to = any(0, 5) == 0 ? 0 : logarithmic(0.1, 500);
  const planner::SpeedChange change = planner::change_speed(speed, a, to, limits);
  double v = speed, b = a, s = 0, fastest = speed, slowest = speed;
  for (const auto& [jerk, duration] : change.phases) {
    RC_ASSERT(duration >= 0);
    RC_ASSERT(std::abs(jerk) <= limits.jerk);
    constexpr int steps = 64;
    const double h = duration / steps;
    for (int k = 0; k < steps; ++k) {
      s += h * (v + h * (b / 2 + h * jerk / 6));
      v += h * (b + h * jerk / 2);
      b += h * jerk;
      RC_ASSERT(std::abs(b) <= limits.acceleration * (1 + 1e-9));
      fastest = std::max(fastest, v);
      slowest = std::min(slowest, v);
    }
  }
  const double scale = 1e-9 * (1 + fastest);
  RC_ASSERT(std::abs(v - to) <= scale);
  RC_ASSERT(std::abs(b) <= 1e-9 * limits.acceleration);
  RC_ASSERT(std::abs(s - change.distance) <= 1e-9 * (1 + change.distance));
  const double let_go = speed + a * std::abs(a) / (2 * limits.jerk);
  RC_ASSERT(fastest <= std::max({speed, to, let_go}) + scale);
  RC_ASSERT(slowest >= std::min({speed, to, let_go}) - scale);
}

TEST(SpeedChange, TakesTheTextbooksTime) {
  // 100 mm/s with 1000 mm/s² and 20000 mm/s³: v/a + a/j, and half the distance at the mean speed.
  const planner::SpeedChange stop = planner::change_speed(100, 0, 0, {0, 1000, 20000});
  EXPECT_NEAR(stop.phases[0].duration + stop.phases[1].duration + stop.phases[2].duration, 0.15, 1e-12);
  EXPECT_NEAR(stop.distance, 100 * 0.15 / 2, 1e-9);
}

}  // namespace test_speed_change
