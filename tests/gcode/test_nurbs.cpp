// The arithmetic of curves with knots of any kind: ends clamped, knots judged one by one, how far a curve reaches.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/nurbs.hpp>

#include "curve_promises.hpp"

namespace leadscrew::gcode {
namespace test_nurbs {

using base::Axis;

// A curve with knots of any kind: with runs of up to p inside, clamped or not at either end.
NurbsCurve some_curve() {
  NurbsCurve curve;
  curve.degree = *rc::gen::inRange(1, highest_degree + 1);
  const int p = curve.degree, n = *rc::gen::inRange(p + 1, 12);
  double knot = *rc::gen::inRange(-3, 3);
  int run = 0;
  for (int i = 0; i <= n + p; ++i) {
    const bool at_end = i - run == 0 || i - run == n;
    if (i > 0 && (run >= (at_end ? p + 1 : p) || *rc::gen::arbitrary<bool>())) {
      knot += *rc::gen::inRange(1, 50) / 8.0;
      run = 0;
    }
    curve.knots.push_back(knot);
    ++run;
  }
  for (int i = 0; i < n; ++i) {
    ControlPoint point;
    for (std::size_t k = 0; k < 3; ++k) point.position[k] = *rc::gen::inRange(-4000, 4000) / 8.0;
    point.weight = *rc::gen::inRange(1, 100) / 16.0;
    curve.points.push_back(point);
  }
  return curve;
}

RC_GTEST_PROP(Clamping, LeavesTheCurveAsItIs, ()) {
  const NurbsCurve before = some_curve();
  RC_PRE(knots_are_apart(before));
  const double from = before.knots[static_cast<std::size_t>(before.degree)], to = before.knots[before.points.size()];
  NurbsCurve after = before;
  clamp_ends(after);
  RC_ASSERT(knots_keep_their_promises(after));
  RC_ASSERT(after.knots.front() == from);
  RC_ASSERT(after.knots.back() == to);
  for (int i = 0; i <= 50; ++i) {
    const double u = from + (to - from) * i / 50;
    const auto a = point_of(before, u), b = point_of(after, u);
    for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(std::fabs(static_cast<double>(a[k] - b[k])) < 1e-10);
  }
  const NurbsCurve once = after;
  clamp_ends(after);
  RC_ASSERT(after == once);
}

RC_GTEST_PROP(KnotJudge, PassesWhatIsWell, ()) {
  const NurbsCurve curve = some_curve();
  NurbsCurve growing = curve;
  growing.knots.clear();
  growing.points.clear();
  for (std::size_t i = 0; i < curve.knots.size(); ++i) {
    growing.knots.push_back(curve.knots[i]);
    const bool all_points = i >= curve.points.size();
    if (!all_points) growing.points.push_back(curve.points[i]);
    RC_ASSERT(judge_last_knot(growing, all_points) == KnotProblem::none);
  }
}

// Against the greatest of many points.
RC_GTEST_PROP(Reach, IsThatOfTheCurve, ()) {
  NurbsCurve curve = some_curve();
  RC_PRE(knots_are_apart(curve));
  clamp_ends(curve);
  long double high = -1e9L, low = 1e9L;
  constexpr int samples = 400;
  for (std::size_t span = 1; span < curve.knots.size(); ++span) {
    const double from = curve.knots[span - 1], to = curve.knots[span];
    for (int i = 0; from < to && i <= samples; ++i) {
      const long double x = point_of(curve, from + (to - from) * i / samples)[1];
      high = std::max(high, x);
      low = std::min(low, x);
    }
  }
  const double above = reach_beyond(curve, Axis::Y, 1, -1e6), below = reach_beyond(curve, Axis::Y, -1, 1e6);
  RC_ASSERT(above >= high - 2e-6L);
  RC_ASSERT(below <= low + 2e-6L);
  // Between two samples a curve rises by the square of their distance, more where weights of 1 to 100 sharpen it.
  RC_ASSERT(above <= high + 1);
  RC_ASSERT(below >= low - 1);
  // No limit that the curve keeps is reported, none that it breaks is missed.
  RC_ASSERT(reach_beyond(curve, Axis::Y, 1, above + 1e-5) == above + 1e-5);
  RC_ASSERT(reach_beyond(curve, Axis::Y, 1, above - 1e-5) > above - 1e-5);
  RC_ASSERT(reach_beyond(curve, Axis::Y, -1, below - 1e-5) == below - 1e-5);
  RC_ASSERT(reach_beyond(curve, Axis::Y, -1, below + 1e-5) < below + 1e-5);
}

// Of the parabola P0 = 0, P1 = h, P2 = 0 the greatest is h/2, exactly.
TEST(Reach, OfAParabolaIsHalfItsHeight) {
  NurbsCurve curve{2, {{}, {}, {}}, {0, 0, 0, 1, 1, 1}};
  curve.points[1].position[0] = 10;
  EXPECT_NEAR(reach_beyond(curve, Axis::X, 1, 1), 5, 1e-6);
  EXPECT_EQ(reach_beyond(curve, Axis::X, 1, 5), 5);
  EXPECT_NEAR(reach_beyond(curve, Axis::X, 1, 4.99999), 5, 1e-6);
  EXPECT_EQ(reach_beyond(curve, Axis::X, -1, 0), 0);
  // With weight w in the middle it is h·w / (1 + w).
  curve.points[1].weight = 9;
  EXPECT_NEAR(reach_beyond(curve, Axis::X, 1, 5), 9, 1e-6);
}

TEST(Reach, EndsAlsoWithWeightsFarApart) {
  NurbsCurve curve{5, {{}, {}, {}, {}, {}, {}}, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}};
  for (std::size_t i = 0; i < 6; ++i) curve.points[i] = {{i % 2 ? 1e9 : -1e9}, i % 2 ? least_weight : greatest_weight};
  EXPECT_LE(reach_beyond(curve, Axis::X, 1, 500), 1e9);
}

}  // namespace test_nurbs
}  // namespace leadscrew::gcode
