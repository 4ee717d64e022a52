#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/rest_to_rest.hpp>

namespace test_rest_to_rest {

using leadscrew::machine::Derivatives;
using leadscrew::planner::rest_to_rest;
using leadscrew::planner::RestToRest;

/// Numbers over eight decades.
double positive() {
  return std::pow(10.0, *rc::gen::inRange(-4000, 4001) / 1000.0);
}

/// Distance covered, by adding up the seven phases one after the other.
long double distance(const RestToRest& motion) {
  long double s = 0, v = 0, a = 0;
  const auto phase = [&](long double j, long double t) {
    s += t * (v + t * (a / 2 + t * j / 6));
    v += t * (a + t * j / 2);
    a += t * j;
  };
  phase(motion.jerk, motion.jerk_time);
  phase(0, motion.acceleration_time);
  phase(-static_cast<long double>(motion.jerk), motion.jerk_time);
  phase(0, motion.cruise_time);
  phase(-static_cast<long double>(motion.jerk), motion.jerk_time);
  phase(0, motion.acceleration_time);
  phase(motion.jerk, motion.jerk_time);
  return s;
}

RC_GTEST_PROP(RestToRest, CoversTheDistanceWithinTheBounds, ()) {
  const double length = positive();
  const Derivatives limits{positive(), positive(), positive()};
  const RestToRest motion = rest_to_rest(length, limits);
  RC_ASSERT(motion.jerk_time >= 0 && motion.acceleration_time >= 0 && motion.cruise_time >= 0);
  RC_ASSERT(std::abs(static_cast<double>(distance(motion) / length) - 1) < 1e-13);
  RC_ASSERT(motion.peak_speed() <= limits.velocity * (1 + 1e-13));
  RC_ASSERT(motion.peak_acceleration() <= limits.acceleration * (1 + 1e-13));
  RC_ASSERT(motion.jerk <= limits.jerk);
}

RC_GTEST_PROP(RestToRest, IsTheFastestOfItsKind, ()) {
  // Brute force: no symmetric profile with its speed and acceleration bounds anywhere below the limits is faster.
  const double length = positive();
  const Derivatives limits{positive(), positive(), positive()};
  const double duration = rest_to_rest(length, limits).duration();
  for (const double v : {0.999, 0.9, 0.5, 0.1}) {
    for (const double a : {1.0, 0.99, 0.7, 0.2}) {
      const double slower =
          rest_to_rest(length, {limits.velocity * v, limits.acceleration * a, limits.jerk}).duration();
      RC_ASSERT(slower >= duration * (1 - 1e-13));
    }
  }
}

// The published square: four sides of 10 mm from rest to rest (v ≤ 200; programmed feed, acceleration, jerk, time of
// all four).
struct Square {
  double feed, acceleration, jerk, time;
};
class SquareOfTenMillimetres : public testing::TestWithParam<Square> {};

TEST_P(SquareOfTenMillimetres, TakesThePublishedTime) {
  const auto& [feed, acceleration, jerk, time] = GetParam();
  EXPECT_NEAR(4 * rest_to_rest(10, {feed, acceleration, jerk}).duration(), time, 5.1e-5);
}

INSTANTIATE_TEST_SUITE_P(Figures, SquareOfTenMillimetres,
                         testing::Values(Square{10, 1000, 20000, 4.1789}, Square{100, 1000, 20000, 1.0246},
                                         Square{10, 200, 5000, 4.3600}, Square{100, 200, 5000, 1.9560}));

TEST(RestToRest, AcceptsAnInfiniteVelocity) {
  const RestToRest motion = rest_to_rest(10, {INFINITY, 1000, 20000});
  EXPECT_EQ(motion.cruise_time, 0);
  EXPECT_NEAR(static_cast<double>(distance(motion)), 10, 1e-12);
}

}  // namespace test_rest_to_rest
