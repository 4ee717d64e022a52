#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <butterfly.hpp>
#include <cmath>
#include <leadscrew/planner/rest_to_rest.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <planned.hpp>

namespace test_time_bound {

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

/// What it takes less to pass over a corner at 1e-4·j·T², where words do not show it, than to stop: twice that speed over a.
constexpr double over_corner = 2 * 1e-4 * 20000 * 1e-6 / 1000;

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
      geometry::Arc(start, start, 0, 1, 0, 0, sweep, geometry::Arc::helix_length(10, sweep, 0)), feed, {}};
  EXPECT_NEAR(bound({circle}, mill(acceleration)), time, 0.00051);
}

INSTANTIATE_TEST_SUITE_P(Figures, FullCircle,
                         testing::Values(Circle{10, 1000, 6.293}, Circle{100, 1000, 0.727}, Circle{10, 200, 6.333},
                                         Circle{100, 200, 1.597}));

/// Of X and Y so unlike that Y alone holds back nearly everywhere; jerk as a plan needs it.
machine::Machine unlike(double of_x, double of_y) {
  machine::Machine machine = machine::mill3();
  for (const auto& [axis, acceleration] : {std::pair{base::Axis::X, of_x}, std::pair{base::Axis::Y, of_y}})
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e5, 1e5, 1e6, acceleration, 3e5, 0.001};
  return machine;
}

// Y goes from one end of its travel to the other, at rest at both: 2·√(2R/a) a half of the circle. Where it turns back the
// curve alone asks for acceleration of it.
TEST(TimeBound, OfACircleThatOneAxisHoldsBackIsThatOfItsTravel) {
  const double quarter = std::acos(0.0);
  for (const double radius : {0.1, 10.0}) {
    for (const int halves : {1, 2, 7}) {
      const double expected = halves * 2 * std::sqrt(2 * radius / 50);
      const auto arc = arc_piece({0, radius}, 0, 0, 2 * quarter * halves, 1e6);
      const double time = bound({arc}, unlike(1e9, 50));
      EXPECT_LE(time, expected * (1 + 1e-9)) << radius << " " << halves;
      EXPECT_GE(time, expected * (1 - 1e-4)) << radius << " " << halves;
    }
  }
}

TEST(TimeBound, IsNotAboveAMotionWhereAnAxisThatIsFarSlowerTurnsBack) {
  const std::vector<toolpath::Element> two_arcs = {arc_piece({}, 0.1, 0, std::acos(0.0), 10),
                                                   arc_piece({0.1, -0.1}, 0.1, 0, std::acos(0.0), 10)};
  const std::vector<toolpath::Element> bow = {arc_piece({}, -0.018, 0.008, -2.25, 10)};
  for (const auto& path : {two_arcs, bow}) {
    const machine::Machine machine = unlike(6000, 45);
    double planned = 0;
    for (const auto& chunk : testing_support::plan(path, machine)) planned += chunk.duration.value();
    const double time = bound(path, machine);
    EXPECT_LE(time, planned * (1 + 1e-6));
    EXPECT_GE(time, 0.9 * planned);
  }
}

TEST(TimeBound, OfACircleInPartsIsThatOfTheWholeWhereAnAxisTurnsBackNextToAJoint) {
  const double quarter = std::acos(0.0);
  const machine::Machine machine = unlike(48, 75);
  const double expected = bound({arc_piece({-0.1}, 0, 0, 4 * quarter, 100)}, machine);
  for (const double beside : {1e-16, 2e-16, 1e-15, 1e-13, 1e-9, 1e-6}) {
    for (const double share : {beside, 0.0, -beside}) {
      geometry::Point at{-0.1};
      std::vector<toolpath::Element> quarters;
      for (const double sweep : {quarter + share, quarter, quarter, quarter - share}) {
        const auto arc = arc_piece(at, 0, 0, sweep, 100);
        at = geometry::end(arc.curve);
        quarters.push_back(arc);
      }
      EXPECT_NEAR(bound(quarters, machine), expected, 1e-5 * expected) << share;
    }
  }
}

std::vector<toolpath::Element> path_along(const geometry::NurbsForm& form, double feed) {
  std::vector<toolpath::Element> path;
  for (const geometry::Nurbs& piece : geometry::smooth_pieces(form))
    path.emplace_back(toolpath::Piece{piece, feed, {}});
  return path;
}

// NURBS curves, v ≤ 200. The cubic x = 20u, y = −50u³ + 80u² − 10u: as published, to four digits. The butterfly at F =
// 10: as published; at F = 100: by a reachability analysis in the spline's own parameter on 76 800 knots, 5.0231 s
// and 9.8989 s, of which the published figures, 5.026 s and 9.907 s, are within 1e-3.
struct Spline {
  geometry::NurbsForm form;
  double feed, acceleration, time, within;
};
class AlongASpline : public testing::TestWithParam<Spline> {};

TEST_P(AlongASpline, TakesTheLeastTime) {
  const Spline& spline = GetParam();
  EXPECT_NEAR(bound(path_along(spline.form, spline.feed), mill(spline.acceleration)), spline.time, spline.within);
}

geometry::NurbsForm cubic() {
  return {3, {0, 0, 0, 0, 1, 1, 1, 1}, {{}, {20.0 / 3, -10.0 / 3}, {40.0 / 3, 20}, {20, 20}}, {1, 1, 1, 1}};
}

INSTANTIATE_TEST_SUITE_P(Figures, AlongASpline,
                         testing::Values(Spline{cubic(), 10, 1000, 2.994, 0.00051},
                                         Spline{cubic(), 10, 200, 3.032, 0.00051},
                                         Spline{cubic(), 100, 1000, 0.4085, 0.000051},
                                         Spline{cubic(), 100, 200, 0.819, 0.00051},
                                         Spline{testing_support::butterfly(), 10, 1000, 38.31, 0.0051},
                                         Spline{testing_support::butterfly(), 10, 200, 38.50, 0.0051},
                                         Spline{testing_support::butterfly(), 100, 1000, 5.0231, 5e-4},
                                         Spline{testing_support::butterfly(), 100, 200, 9.8989, 1e-3}));

TEST(TimeBound, OfACuspIsThatOfItsTwoBranches) {
  // x′ = 3(1 − 2t)², y′ = 3(1 − 2t): up, and back down the other side.
  const auto path = path_along({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{}, {10, 10}, {0, 10}, {10}}, {1, 1, 1, 1}}, 50);
  ASSERT_EQ(path.size(), 2u);
  const machine::Machine machine = mill(1000);
  const double whole = bound(path, machine), first = bound({path[0]}, machine), second = bound({path[1]}, machine);
  EXPECT_LE(whole, first + second);
  EXPECT_GE(whole, first + second - over_corner);
  EXPECT_NEAR(first, second, 1e-4 * first);
  EXPECT_GT(first, trapezoid(geometry::length(std::get<toolpath::Piece>(path[0]).curve), 50, 1000 * std::sqrt(2.0)));
}

TEST(TimeBound, OfASemicircleAsASplineIsThatOfTheArc) {
  // Quarters of degree 2, √½ the middle weights.
  const double half = std::sqrt(0.5);
  const geometry::NurbsForm form{
      2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}, {{10, 0}, {10, 10}, {0, 10}, {-10, 10}, {-10, 0}}, {1, half, 1, half, 1}};
  const double expected = bound({arc_piece({10}, 0, 0, std::acos(-1.0), 100)}, mill(1000));
  EXPECT_NEAR(bound(path_along(form, 100), mill(1000)), expected, 1e-4 * expected);
}

TEST(TimeBound, StopsWhereAPieceSaysSo) {
  auto first = line_piece({}, {10}, 50);
  first.stop = true;
  EXPECT_NEAR(bound({first, line_piece({10}, {20}, 50)}, mill(1000)), 2 * trapezoid(10, 50, 1000), 1e-12);
}

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
  const double corner = bound({there, up}, mill(1000));
  EXPECT_LE(corner, 2 * one);
  EXPECT_GE(corner, 2 * one - over_corner);
  EXPECT_NEAR(bound({there, toolpath::Dwell{{10}, 0.3, {}}, line_piece({10}, {20}, 50)}, mill(1000)), 2 * one + 0.3,
              1e-12);
}

// A path read back from words has kinks of its own: motion may run over what words cannot show (random campaign, seed 1, number
// 56337).
TEST(TimeBound, PassesOverAKinkThatWordsDoNotShow) {
  const machine::Machine machine = mill(1000);
  const double feed = 0.5, most = 1e-4 * 20000 * 1e-6 / feed;
  for (const double kink : {2e-6, 0.9 * most, 1.1 * most, 4 * most}) {
    const double passed = bound({line_piece({}, {10}, feed), line_piece({10}, {20, 10 * kink}, feed)}, machine);
    const double speed = std::min(feed, feed * most / kink), lost = (feed - speed) * (feed - speed) / (1000 * feed);
    EXPECT_NEAR(passed, trapezoid(20, feed, 1000) + lost, 1e-9 + 1e-3 * lost) << kink;
  }
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

/// The greater speed is reached, and left, within a small part of the first of a curve's intervals.
TEST(TimeBound, OfACurveWhoseFeedJumpsIsThatOfItsFeeds) {
  const double half = 3.141592653589793;
  std::vector<toolpath::Element> circle;
  double expected = 0;
  geometry::Point at{};
  for (const double feed : {0.04, 0.1, 0.04}) {
    const auto arc = arc_piece(at, 1, 0, half, feed);
    at = geometry::end(arc.curve);
    circle.push_back(arc);
    expected += half / feed;
  }
  EXPECT_NEAR(bound(circle, mill(300)), expected, 1e-3);
}

RC_GTEST_PROP(TimeBound, IsNeverAboveAJerkLimitedMotion, ()) {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  machine::Machine machine = mill(*rc::gen::inRange(50, 5000));
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y})
    machine.axes[base::index(axis)]->acceleration *= *rc::gen::element(0.01, 0.1, 1.0, 10.0);
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

}  // namespace test_time_bound
