#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/rest_to_rest.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <planned.hpp>

namespace {

using namespace leadscrew;
using planner::TimeBound;
using testing_support::arc_piece;
using testing_support::line_piece;

machine::Machine mill(double acceleration) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->acceleration = acceleration;
  }
  return machine;
}

double bound(const std::vector<toolpath::Element>& path, const machine::Machine& machine) {
  TimeBound bound(machine);
  for (const auto& element : path) bound.push(element);
  bound.finish();
  return bound.seconds();
}

/// Trapezoid of speed: up at a, at most v, down at a.
double trapezoid(double length, double v, double a) {
  return v * v / a <= length ? length / v + v / a : 2 * std::sqrt(length / a);
}

// Full circle, R = 10 mm, v ≤ 200: the velocity-and-acceleration optimum as published.
struct Circle {
  double feed, acceleration, time;
};
class FullCircle : public testing::TestWithParam<Circle> {};

TEST_P(FullCircle, TakesThePublishedLeastTime) {
  const auto& [feed, acceleration, time] = GetParam();
  geometry::Point start{};
  start[0] = 10;
  const auto sweep = geometry::sweep_angle(10, 0, 10, 0, 1);
  const toolpath::Piece circle{
      geometry::Arc(start, start, 0, 1, 0, 0, sweep, geometry::Arc::way(10, sweep, 0)), feed, {}};
  EXPECT_NEAR(bound({circle}, mill(acceleration)), time, 0.00051);
}

INSTANTIATE_TEST_SUITE_P(Figures, FullCircle,
                         testing::Values(Circle{10, 1000, 6.293}, Circle{100, 1000, 0.727}, Circle{10, 200, 6.333},
                                         Circle{100, 200, 1.597}));

TEST(TimeBound, OfALineIsATrapezoid) {
  for (const double length : {0.01, 1.0, 8.0, 300.0}) {
    for (const double feed : {5.0, 90.0, 1e300}) {
      const double expected = trapezoid(length, std::min(feed, 200.0), 1000);
      EXPECT_NEAR(bound({line_piece({}, {length}, feed)}, mill(1000)), expected, 1e-12 * expected);
    }
  }
}

TEST(TimeBound, StopsAtCornersAndDwells) {
  const auto there = line_piece({}, {10}, 50), up = line_piece({10}, {10, 10}, 50);
  const double one = trapezoid(10, 50, 1000);
  EXPECT_NEAR(bound({there, up}, mill(1000)), 2 * one, 1e-12);
  EXPECT_NEAR(bound({there, toolpath::Dwell{{10}, 0.3, {}}, line_piece({10}, {20}, 50)}, mill(1000)), 2 * one + 0.3,
              1e-12);
}

TEST(TimeBound, PassesThroughSmoothJoints) {
  std::vector<toolpath::Element> pieces;
  for (int k = 0; k < 5000; ++k) pieces.push_back(line_piece({k * 0.01}, {(k + 1) * 0.01}, 80));
  const double expected = trapezoid(50, 80, 1000);
  const double time = bound(pieces, mill(1000));
  EXPECT_NEAR(time, expected, 1e-9);
}

TEST(TimeBound, OfACircleInPiecesIsThatOfTheWhole) {
  const auto whole = arc_piece({}, 10, 0, 6.0, 100);
  std::vector<toolpath::Element> pieces;
  geometry::Point at{};
  for (int k = 0; k < 12; ++k) {
    const auto piece = arc_piece(at, 10, 0, 0.5, 100);
    at = geometry::end(piece.curve);
    pieces.push_back(piece);
  }
  EXPECT_NEAR(bound(pieces, mill(1000)), bound({whole}, mill(1000)), 1e-4);
}

RC_GTEST_PROP(TimeBound, IsNeverAboveAJerkLimitedMotion, ()) {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  const machine::Machine machine = mill(*rc::gen::inRange(50, 5000));
  for (int k = *rc::gen::inRange(1, 10); k > 0; --k) {
    const double feed = *rc::gen::element(3.0, 40.0, 300.0, static_cast<double>(INFINITY));
    if (*rc::gen::arbitrary<bool>()) {
      const auto arc =
          arc_piece(at, at[0] + *rc::gen::inRange(1, 30000) / 1000.0, at[1], *rc::gen::inRange(1, 9000) / 1000.0, feed);
      at = geometry::end(arc.curve);
      path.push_back(arc);
    } else {
      geometry::Point next = at;
      next[0] += *rc::gen::inRange(1, 20000) / 1000.0;
      next[1] += *rc::gen::inRange(-20000, 20000) / 1000.0;
      path.push_back(line_piece(at, next, feed));
      at = next;
    }
  }
  double planned = 0;
  for (const auto& chunk : testing_support::plan(path, machine)) planned += chunk.duration.value();
  RC_ASSERT(bound(path, machine) <= planned * (1 + 1e-6));
  RC_ASSERT(bound(path, machine) > 0);
}

}  // namespace
