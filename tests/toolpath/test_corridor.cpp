// Corridors and the motions in them: against brute force, differences and closed forms.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/corridor_barrier.hpp>
#include <leadscrew/toolpath/corridor_check.hpp>
#include <leadscrew/toolpath/corridor_optimum.hpp>
#include <leadscrew/toolpath/corridor_plan.hpp>
#include <leadscrew/toolpath/corridor_start.hpp>
#include <numbers>
#include <random_numbers.hpp>

namespace leadscrew::toolpath::testing {
namespace test_corridor {

using testing_support::any;

constexpr CorridorLimits<2> mill = {{200, 200}, {1000, 1000}, {20000, 20000}};

double real(double from, double to) {
  return from + (to - from) * any(0, 1000001) / 1e6;
}

CorridorLeg<2> random_arc(double margin) {
  const double radius = real(0.5, 20), begin = real(0, 6.28), turn = (any(0, 2) == 0 ? 1 : -1) * real(0.1, 3.1);
  const Vector<2> center = {real(-5, 5), real(-5, 5)};
  const auto at = [&](double angle) {
    return Vector<2>{center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle)};
  };
  return arc_leg<2>(at(begin), at(begin + turn), 0, 1, center, turn, margin, 100);
}

CorridorLeg<2> random_line(double margin) {
  return line_leg<2>({real(-5, 5), real(-5, 5)}, {real(6, 9), real(6, 9)}, margin, 100);
}

RC_GTEST_PROP(CorridorLegs, HaveTheirNearestPlaces, ()) {
  const CorridorLeg<2> leg = any(0, 2) == 0 ? random_arc(1) : random_line(1);
  const double at = real(0, leg.length);
  const Vector<2> x = along(leg.at(at), real(-0.4, 0.4), {real(-1, 1), real(-1, 1)});
  double least = unlimited, where = 0;
  constexpr int looks = 20000;
  for (int k = 0; k <= looks; ++k) {
    const double s = leg.length * k / looks, off = size(between(leg.at(s), x));
    if (off < least) least = off, where = s;
  }
  RC_ASSERT(std::abs(size(leg.nearest(x).offset) - least) <= 2 * leg.length / looks);
  RC_ASSERT(std::abs(leg.advance(x) - where) <= 3 * leg.length / looks + 0.5 * (1 - std::cos(least)));
}

/// Beyond a joint by 0.9 margins and back to as much before it: what lies behind it is 1.8 from where motion had been.
TEST(CorridorCheck, CountsWhatGoesBackOverAJoint) {
  constexpr double margin = 0.1;
  Corridor<2> corridor;
  corridor.limits = mill;
  corridor.legs = {line_leg<2>({0, 0}, {10, 0}, margin, 100), line_leg<2>({10, 0}, {20, 0}, margin, 100)};
  const auto greatest_share = [&](double ahead, double back) {
    TimeSpline<2> motion;
    for (const double x : {0.0, 0.0, 0.0, 5.0, 9.0, ahead, ahead, ahead, back, back, back, 12.0, 20.0, 20.0, 20.0})
      motion.points.push_back({x, 0});
    double pass = 0;
    while (motion.at(pass)[0] < 10) pass += 0.001;
    motion.passes = {pass};
    const std::vector<double> shares = shares_of_margins(corridor, motion);
    return *std::max_element(shares.begin(), shares.end());
  };
  EXPECT_GT(greatest_share(10 + 0.9 * margin, 10 - 0.9 * margin), 1.7);
  EXPECT_LT(greatest_share(10 + 0.9 * margin, 10 + 0.9 * margin), 1);
}

Corridor<2> zigzag(double margin) {
  Corridor<2> corridor;
  corridor.limits = mill;
  Vector<2> at = {0, 0};
  for (int k = 1; k <= 5; ++k) {
    const Vector<2> next = {k * 1.5, (k % 2) * 1.1};
    corridor.legs.push_back(line_leg<2>(at, next, margin, 100));
    at = next;
  }
  corridor.legs.push_back(arc_leg<2>(at, {at[0] + 2, at[1]}, 0, 1, {at[0] + 1, at[1]}, -std::numbers::pi, margin, 100));
  return corridor;
}

TimeSpline<2> start_of(const Corridor<2>& corridor) {
  return start_motion<2>(corridor, suitable_interval(corridor), {0, corridor.legs.back().length, {}, {}});
}

/// Along Newton's step d: gᵀd = −δ, dᵀHd = δ.
TEST(CorridorBarriers, HaveTheDerivativesThatTheyAssemble) {
  const Corridor<2> corridor = zigzag(0.01);
  const TimeSpline<2> start = start_of(corridor);
  const CorridorBarrier<2> barrier(corridor, start.intervals(), 1.3 * start.interval);
  Passing passing{start.passes, {}};
  barrier.assign(passing);
  const CorridorPoint<2> at{start.points, 1.1};
  constexpr double t = 50;
  ASSERT_TRUE(std::isfinite(barrier.value(t, at, passing)));
  NewtonModel<2> model;
  barrier.assemble(t, at, passing, model);
  std::vector<Vector<2>> step;
  double w_step = 0;
  const double decrement = model.solve(0, step, w_step);
  ASSERT_GT(decrement, 0);
  const auto value_along = [&](double length) {
    CorridorPoint<2> moved = at;
    for (std::size_t k = 0; k < step.size(); ++k) moved.points[k] = along(at.points[k], length, step[k]);
    moved.w += length * w_step;
    return barrier.value(t, moved, passing);
  };
  const double length = 1e-4 / std::sqrt(decrement);
  EXPECT_NEAR((value_along(length) - value_along(-length)) / (2 * length * decrement), -1, 1e-4);
}

/// Rest to rest along a line: v²/a + va/j = L, T = 2(v/a + a/j).
TEST(LeastTimeInACorridor, OfOneLineIsNearTheClosedForm) {
  Corridor<2> corridor;
  corridor.limits = mill;
  corridor.legs.push_back(line_leg<2>({0, 0}, {6, 0}, 0.01, 1e9));
  const auto found = least_time(corridor, start_of(corridor));
  ASSERT_TRUE(found);
  const double a = 1000, j = 20000, v = (-a / j + std::sqrt(a * a / (j * j) + 4 * 6 / a)) * a / 2;
  EXPECT_NEAR(found->seconds() / (2 * (v / a + a / j)), 1, 0.01);
}

TEST(LeastTimeInACorridor, KeepsItsLimits) {
  const Corridor<2> corridor = zigzag(0.01);
  const auto found = least_time(corridor, start_of(corridor));
  ASSERT_TRUE(found);
  const double h = found->interval;
  const auto& c = found->points;
  for (std::size_t k = 0; k + 3 < c.size(); ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(std::abs(c[k + 3][i] - 3 * c[k + 2][i] + 3 * c[k + 1][i] - c[k][i]), 20000 * h * h * h);
      EXPECT_LE(std::abs(c[k + 2][i] - 2 * c[k + 1][i] + c[k][i]), 1000 * h * h);
    }
    EXPECT_LE(size(between(c[k], c[k + 1])), 100 * h);
  }
  EXPECT_EQ(found->points.front(), corridor.legs.front().from);
  EXPECT_EQ(found->points.back(), corridor.legs.back().to);
}

/// The proof is never below what samples find, and not far above it.
TEST(CorridorChecks, BoundWhatSamplesFind) {
  for (const double margin : {0.002, 0.01, 0.1}) {
    SCOPED_TRACE(margin);
    const Corridor<2> corridor = zigzag(margin);
    const auto found = least_time(corridor, start_of(corridor));
    ASSERT_TRUE(found);
    double sampled = 0;
    std::size_t leg = 0;
    const int looks = 40 * static_cast<int>(found->intervals());
    for (int k = 0; k <= looks; ++k) {
      const double time = static_cast<double>(found->intervals()) * k / looks;
      while (leg < found->passes.size() && time > found->passes[leg]) ++leg;
      sampled = std::max(sampled, size(corridor.legs[leg].nearest(found->at(time)).offset) / margin);
    }
    const std::vector<double> shares = shares_of_margins(corridor, *found);
    const double proven = *std::max_element(shares.begin(), shares.end());
    EXPECT_GE(proven, sampled - 1e-9);
    EXPECT_LE(proven, 1.05 * sampled);
    EXPECT_LE(sampled, 1.03);
  }
}

/// Where motion goes back along a leg farther than the margin, the proof says so.
TEST(CorridorChecks, SeeMotionThatGoesBack) {
  Corridor<2> corridor;
  corridor.limits = mill;
  corridor.legs.push_back(line_leg<2>({0, 0}, {6, 0}, 0.01, 100));
  TimeSpline<2> motion;
  for (int k = 0; k < 3; ++k) motion.points.push_back({0, 0});
  for (const double x : {1.0, 2.0, 3.0, 2.8, 2.9, 4.0, 5.0}) motion.points.push_back({x, 0});
  for (int k = 0; k < 3; ++k) motion.points.push_back({6, 0});
  motion.interval = 0.01;
  EXPECT_GT(shares_of_margins(corridor, motion).front(), 3);
}

TEST(CorridorPlans, AreTheSameInAnyTwoCoordinates) {
  const auto planned = [](std::size_t first, std::size_t second) {
    Corridor<3> corridor;
    corridor.limits = {{200, 200, 200}, {1000, 1000, 1000}, {20000, 20000, 20000}};
    Vector<3> at = {0.5, 0.5, 0.5};
    for (int k = 0; k < 4; ++k) {
      Vector<3> next = at;
      next[k % 2 == 0 ? first : second] += 3;
      corridor.legs.push_back(line_leg<3>(at, next, 0.01, 100));
      at = next;
    }
    return plan_in(corridor, {0, 3, {}, {}}, 0.004);
  };
  const auto xy = planned(0, 1), yz = planned(1, 2);
  ASSERT_TRUE(xy && yz);
  EXPECT_EQ(xy->interval, yz->interval);
  for (std::size_t k = 0; k < xy->points.size(); ++k) {
    EXPECT_EQ(xy->points[k][0], yz->points[k][1]);
    EXPECT_EQ(xy->points[k][1], yz->points[k][2]);
    EXPECT_EQ(xy->points[k][2], 0.5);
  }
}

}  // namespace test_corridor
}  // namespace leadscrew::toolpath::testing
