#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/geometry/arc_length_map.hpp>
#include <leadscrew/geometry/kinks.hpp>
#include <leadscrew/numeric/gauss.hpp>

#include "nurbs_forms.hpp"

namespace leadscrew::geometry::testing {
namespace test_arc_length_map {

TEST(Gauss, IsExactForPolynomialsOfDegreeFifteen) {
  for (int k = 0; k <= 16; ++k) {
    const double integral = numeric::integrate_gauss_8([&](double x) { return std::pow(x, k); }, 0, 1);
    const double error = std::abs(integral * (k + 1) - 1);
    EXPECT_EQ(error <= 5e-16, k < 16) << k;
  }
}

/// Value and two derivatives of x(σ).
std::array<double, 3> at(const MapPiece& piece, double s) {
  const auto& c = piece.c;
  return {piece.x_begin + s * (c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * c[4])))),
          c[0] + s * (2 * c[1] + s * (3 * c[2] + s * (4 * c[3] + s * 5 * c[4]))),
          2 * c[1] + s * (6 * c[2] + s * (12 * c[3] + s * 20 * c[4]))};
}

RC_GTEST_PROP(ArcLengthMap, IsTwiceContinuouslyDifferentiable, ()) {
  NurbsForm form = random_form();
  const auto p = static_cast<std::size_t>(form.degree);
  if (form.knots[p] == form.knots[p + 1]) return;
  Moving moving;
  for (std::uint8_t i = 0; i < base::axis_count; ++i) {
    const bool moves = std::any_of(form.points.begin(), form.points.end(),
                                   [&](const Point& point) { return point[i] != form.points[0][i]; });
    if (moves) moving.coordinate[moving.count++] = i;
  }
  Metric metric;
  for (std::uint8_t k = 0; k < moving.count; ++k) metric.slot[metric.count++] = k;
  if (metric.count == 0) return;
  const RationalBezier curve = bezier_of_span(form, moving, true, p);
  const Kinks kinks = find_kinks(curve, metric);
  if (!kinks.inside.empty() || longest_possible(curve, metric) < 1e-3) return;
  std::vector<MapPiece> from_start, from_end;
  map_arc_length(curve, metric, {kinks.at_start, kinks.at_end}, {}, from_start, from_end);
  RC_ASSERT(!from_start.empty() && !from_end.empty());
  RC_ASSERT(from_start.front().x_begin == 0 && from_start.back().x_end == 0.5);
  RC_ASSERT(from_end.front().x_begin == -0.5 && from_end.back().x_end == 0);
  for (const auto& pieces : {from_start, from_end}) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const MapPiece& piece = pieces[i];
      const double width = piece.x_end - piece.x_begin;
      const auto end = at(piece, piece.length);
      RC_ASSERT(std::abs(end[0] - piece.x_end) <= 2e-15 * width + 1e-16);
      if (i + 1 == pieces.size()) continue;
      const MapPiece& next = pieces[i + 1];
      RC_ASSERT(next.x_begin == piece.x_end);
      if (piece.is_straight || next.is_straight) continue;
      const double h = piece.length;
      RC_ASSERT(std::abs(end[1] - next.c[0]) <= 1e-13 * width / h);
      RC_ASSERT(std::abs(end[2] - 2 * next.c[1]) <= 1e-12 * width / (h * h));
    }
  }
}

RC_GTEST_PROP(ArcLengthMap, TellsTheLengthBetweenAnyTwoPlaces, ()) {
  // Against chords of the judge.
  const NurbsForm form = random_form();
  for (const Nurbs& piece : smooth_pieces(form)) {
    if (piece.length() < 1e-3) continue;
    const double s = piece.length() * *rc::gen::inRange(1, 80) / 100, step = piece.length() / 10;
    const long double chords = chord_length(form, piece.parameter(s), piece.parameter(s + step), 200);
    RC_ASSERT(std::abs(static_cast<double>(chords / step) - 1) <= 2e-6 + 1e-13 * 1e5 / step);
  }
}

}  // namespace test_arc_length_map
}  // namespace leadscrew::geometry::testing
