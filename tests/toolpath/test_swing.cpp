#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/toolpath/frechet.hpp>
#include <leadscrew/toolpath/swing.hpp>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_swing {

/// p at u by its third derivative, −6 and then 6, summed step by step.
double summed(const Swing& swing, double u) {
  constexpr int steps = 20'000;
  double p = 0, first = 0, second = 0;
  const double h = u / steps;
  for (int k = 0; k < steps; ++k) {
    const double third = (k + 0.5) * h < swing.w() ? -6 : 6;
    p += h * (first + h * (second / 2 + h * third / 6));
    first += h * (second + h * third / 2);
    second += h * third;
  }
  return p;
}

/// Where the blend of two lines that turn by θ in a plane is, c = 1, the corner at the origin.
Polyline places(const Swing& swing, double angle, int count) {
  const Point in{1, 0}, out{std::cos(angle), std::sin(angle)};
  const auto p = [&](double u) {
    const double behind = std::max(u - swing.w(), 0.0);
    return -u * u * u + 2 * behind * behind * behind;
  };
  Polyline curve;
  for (int k = 0; k <= count; ++k) {
    const double u = static_cast<double>(k) / count;
    curve.push_back(sum(scaled(-p(1 - u), in), p(u), out));
  }
  return curve;
}

RC_GTEST_PROP(Swing, ReachesAsFarAsItsThirdDerivativeSays, ()) {
  const Swing swing(2 * std::sin(uniform(0.01, 3.1) / 2));
  RC_ASSERT(std::abs(swing.reach() - summed(swing, 1)) <= 1e-3);
}

RC_GTEST_PROP(Swing, HasTheControlPointsOfItsSpline, ()) {
  const Swing swing(2 * std::sin(uniform(0.01, 3.1) / 2));
  const double w = swing.w();
  geometry::NurbsForm form{3, {0, 0, 0, 0, w, 1 - w, 1, 1, 1, 1}, {}, {1, 1, 1, 1, 1, 1}};
  const std::array<double, 6> values = swing.control_values();
  // A graph over u: control points at the means of three knots each.
  for (std::size_t k = 0; k < values.size(); ++k)
    form.points.push_back({(form.knots[k + 1] + form.knots[k + 2] + form.knots[k + 3]) / 3, values[k]});
  const geometry::Nurbs graph = geometry::smooth_pieces(form).at(0);
  const double u = uniform(0.001, 0.999);
  const geometry::PointJet there = graph.jets_at(u);
  RC_ASSERT(std::abs(there[0].value - u) <= 1e-9);
  RC_ASSERT(std::abs(there[1].value - summed(swing, u)) <= 1e-3);
}

/// Both bounds are met: on the outer side of each line, and at the corner.
RC_GTEST_PROP(Swing, GoesAsFarFromTheLinesAsFromTheCorner, ()) {
  const double angle = uniform(0.01, 3.1);
  const Swing swing(2 * std::sin(angle / 2));
  double outside = 0, nearest = INFINITY;
  for (const Point& place : places(swing, angle, 4000)) {
    outside = std::max(outside, -place[1]);
    nearest = std::min(nearest, norm(place));
  }
  RC_ASSERT(std::abs(outside - swing.deviation()) <= 1e-5 * swing.deviation());
  RC_ASSERT(std::abs(nearest - swing.deviation()) <= 1e-5 * swing.deviation());
}

RC_GTEST_PROP(Swing, DeviatesNoFartherThanItSays, ()) {
  const double angle = uniform(0.01, 3.1);
  const Swing swing(2 * std::sin(angle / 2));
  const Point in{1, 0}, out{std::cos(angle), std::sin(angle)};
  Polyline lines;
  for (int k = -400; k <= 400; ++k)
    lines.push_back(scaled(swing.reach() * std::abs(k) / 400, k < 0 ? scaled(-1, in) : out));
  RC_ASSERT(is_frechet_within(lines, places(swing, angle, 400), 1.001 * swing.deviation()));
  RC_ASSERT(!is_frechet_within(lines, places(swing, angle, 400), 0.99 * swing.deviation()));
}

TEST(Swing, LiesInTheRangeItTells) {
  for (double angle = 0.001; angle < 3.14; angle += 0.001) {
    const Swing swing(2 * std::sin(angle / 2));
    ASSERT_GT(swing.w(), 0.093);
    ASSERT_LT(swing.w(), 0.104);
  }
}

}  // namespace test_swing
}  // namespace leadscrew::toolpath::testing
