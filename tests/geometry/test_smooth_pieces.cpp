#include <gtest/gtest.h>

#include <leadscrew/geometry/curve.hpp>
#include <random>

#include "nurbs_forms.hpp"

namespace leadscrew::geometry::testing {
namespace test_smooth_pieces {

std::vector<double> parameters(const std::vector<Nurbs>& pieces) {
  std::vector<double> cuts;
  for (std::size_t i = 1; i < pieces.size(); ++i) cuts.push_back(pieces[i].first_parameter());
  return cuts;
}

double length_of_one(const std::vector<Nurbs>& pieces) {
  EXPECT_EQ(pieces.size(), 1u);
  return pieces.at(0).length();
}

/// |dq/ds| = 1 in X Y Z everywhere on the pieces, also close to their ends.
void expect_unit_speed(const std::vector<Nurbs>& pieces) {
  for (const Nurbs& piece : pieces) {
    for (double share = 0.5; share * piece.length() > 1e-11; share *= 0.7) {
      for (const double s : {piece.length() * share, piece.length() * (1 - share)}) {
        const PointJet jet = piece.jets(s);
        const double noise = 1e-13 / std::min(s, piece.length() - s);
        ASSERT_NEAR(std::hypot(jet[0].first, jet[1].first, jet[2].first), 1, 1.1e-7 + noise) << s;
      }
    }
  }
}

TEST(SmoothPieces, OfASimpleCubicAreOne) {
  // x = 20u, y = −50u³ + 80u² − 10u.
  const auto pieces =
      smooth_pieces(bezier({point(0, 0), point(20.0 / 3, -10.0 / 3), point(40.0 / 3, 20), point(20, 20)}));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].length(), 29.8413, 5e-5);
}

TEST(SmoothPieces, AreCutAtCorners) {
  const auto pieces = smooth_pieces(spline(
      3, {point(0, 0), point(1, 0), point(2, 0), point(3, 0), point(3, 1), point(3, 2), point(4, 3)}, {0.5, 0.5, 0.5}));
  EXPECT_EQ(parameters(pieces), std::vector<double>{0.5});
  EXPECT_EQ(pieces[0].end(), point(3, 0));
}

TEST(SmoothPieces, AreNotCutWhereATripleKnotLeavesThemStraight) {
  const auto pieces = smooth_pieces(spline(
      3, {point(0, 0), point(1, 0), point(2, 0), point(3, 0), point(5, 0), point(7, 0), point(9, 0)}, {0.5, 0.5, 0.5}));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_DOUBLE_EQ(pieces[0].length(), 9);
}

TEST(SmoothPieces, AreCutWhereTheCurvatureSteps) {
  const std::vector<Point> points = {point(0, 0), point(1, 0), point(2, 1), point(3, 0), point(4, 2)};
  EXPECT_EQ(parameters(smooth_pieces(spline(2, points, {0.25, 0.5}))), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(parameters(smooth_pieces(spline(3, points, {0.5}))), std::vector<double>{});
  std::vector<Point> more = points;
  more.push_back(point(5, 5));
  EXPECT_EQ(parameters(smooth_pieces(spline(3, more, {0.5, 0.5}))), std::vector<double>{0.5});
}

TEST(SmoothPieces, HaveBreaksWhereTheThirdDerivativeStepsOrBends) {
  const std::vector<Point> points = {point(0, 0), point(1, 0), point(2, 1), point(3, 0), point(4, 2), point(6, 1)};
  std::vector<Point> more = points;
  more.push_back(point(7, 3));
  const auto breaks = [](int degree, const std::vector<Point>& around, const std::vector<double>& inner) {
    const auto pieces = smooth_pieces(spline(degree, around, inner));
    EXPECT_EQ(pieces.size(), 1u);
    std::vector<double> knots;
    for (const double s : pieces[0].breaks()) knots.push_back(std::round(pieces[0].parameter(s) * 1e12) / 1e12);
    return knots;
  };
  EXPECT_EQ(breaks(3, points, {0.25, 0.5}), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(breaks(4, points, {0.25}), (std::vector<double>{0.25}));
  EXPECT_EQ(breaks(5, more, {0.25}), std::vector<double>{});
}

TEST(SmoothPieces, AreCutAtACusp) {
  // x′ = 3(1 − 2t)², y′ = 3(1 − 2t).
  const auto pieces = smooth_pieces(bezier({point(0, 0), point(1, 1), point(0, 1), point(1, 0)}));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[1].first_parameter(), 0.5, 1e-14);
  // ∫ 3 τ √(1 + τ²) dτ over τ = 1 − 2t from 0 to 1, half of that for each half.
  EXPECT_NEAR(pieces[0].length(), (2 * std::sqrt(2.0) - 1) / 2, 1e-13);
  EXPECT_NEAR(pieces[1].length(), (2 * std::sqrt(2.0) - 1) / 2, 1e-13);
  expect_unit_speed(pieces);
  // s = ((1 + τ²)^(3/2) − 1)/2 from the cusp.
  for (double s = 0.5; s > 1e-9; s /= 3) {
    const double tau = std::sqrt(std::expm1(std::log1p(2 * s) * 2 / 3));
    EXPECT_NEAR(pieces[1].parameter(s), 0.5 + tau / 2, 1e-8 * tau + 1e-14) << s;
  }
}

TEST(SmoothPieces, HaveFiniteDerivativesAtACusp) {
  for (const Nurbs& piece : smooth_pieces(bezier({point(0, 0), point(1, 1), point(0, 1), point(1, 0)}))) {
    for (const double s : {0.0, piece.length()}) {
      const PointJet jet = piece.jets(s);
      EXPECT_NEAR(std::hypot(jet[0].first, jet[1].first), 1, 1e-6);
      EXPECT_TRUE(std::isfinite(jet[0].second) && std::isfinite(jet[1].third));
    }
  }
}

/// Straight, out of a point that four control points share: nothing but the first derivative is left, however near.
TEST(SmoothPieces, AreSmoothUpToControlPointsThatCoincide) {
  NurbsForm form = spline(4, {point(0, 0), point(9, 1), point(8, -7), point(8, -7), point(8, -7), point(8, -7)}, {0.5});
  form.weights = {1, 10, 1, 10, 1, 3};
  const auto pieces = smooth_pieces(form);
  const Nurbs& last = pieces.back();
  for (double left = 1e-3; left > 1e-11; left /= 1.7) {
    const PointJet jet = last.jets(last.length() - left);
    EXPECT_NEAR(std::hypot(jet[0].first, jet[1].first), 1, 1e-7) << left;
    EXPECT_LE(std::hypot(jet[0].second, jet[1].second) * left, 1e-5) << left;
    EXPECT_LE(std::hypot(jet[0].third, jet[1].third) * left * left, 2e-3) << left;
  }
}

TEST(SmoothPieces, AreNumbersHoweverShort) {
  NurbsForm form;
  form.degree = 4;
  form.knots = {0, 0, 0, 0, 0, 84.875, 85, 85, 85, 85, 85};
  form.weights = {1.1, 2.6, 2.9, 1.3, 2.2, 3.5};
  form.points = {point(-0.009, -0.01), point(-0.006, 0.004), point(0.002, -0.002),
                 point(0.002, -0.002), point(0.002, -0.002), point(0.002, -0.002)};
  for (const Nurbs& piece : smooth_pieces(form)) {
    for (int k = 0; k <= 100; ++k) {
      const PointJet jet = piece.jets(piece.length() * k / 100);
      EXPECT_TRUE(std::isfinite(jet[0].value) && std::isfinite(jet[1].third)) << piece.length() << " " << k;
    }
  }
}

TEST(SmoothPieces, AreCutAtAReversal) {
  // Straight, x = 3t(1 − t).
  const auto pieces = smooth_pieces(bezier({point(0, 0), point(1, 0), point(1, 0), point(0, 0)}));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].length(), 0.75, 1e-14);
  EXPECT_NEAR(pieces[0].end()[0], 0.75, 1e-15);
  expect_unit_speed(pieces);
}

TEST(SmoothPieces, AreCutAtATurnTooTightToTellFromACorner) {
  // A cusp opened by h: radius about h², h in units of the curve.
  const auto turn = [](double opened) {
    return smooth_pieces(bezier({point(0, 0), point(1 + opened, 1), point(-opened, 1), point(1, 0)}));
  };
  for (const double opened : {1e-7, -1e-7}) {
    const auto pieces = turn(opened);
    EXPECT_GE(pieces.size(), 2u);
    expect_unit_speed(pieces);
  }
  const auto wide = turn(-0.01);
  EXPECT_EQ(wide.size(), 1u);
  expect_unit_speed(wide);
}

TEST(SmoothPieces, BeginAndEndAtCoincidingControlPoints) {
  for (const auto& points : {std::vector<Point>{point(0, 0), point(0, 0), point(1, 2), point(3, 0)},
                             {point(0, 0), point(0, 0), point(0, 0), point(3, 0)},
                             {point(0, 0), point(1, 2), point(3, 0), point(3, 0)},
                             {point(0, 0), point(0, 0), point(3, 1), point(3, 1)},
                             {point(1, 1), point(1, 1), point(1, 1), point(3, 4), point(9, 1), point(9, 1)}}) {
    const auto pieces = smooth_pieces(bezier(points));
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].start(), points.front());
    EXPECT_EQ(pieces[0].end(), points.back());
    const double chords = static_cast<double>(chord_length(bezier(points), 0, 1, 2000));
    EXPECT_NEAR(pieces[0].length(), chords, 1e-6);
    expect_unit_speed(pieces);
  }
}

TEST(SmoothPieces, OfDegreeOneAreThePolygon) {
  const std::vector<Point> points = {point(0, 0), point(3, 4), point(3, 4), point(6, 8), point(6, 0)};
  NurbsForm form = spline(1, points, {0.25, 0.5, 0.75});
  const auto pieces = smooth_pieces(form);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_DOUBLE_EQ(pieces[0].length(), 5);
  EXPECT_DOUBLE_EQ(pieces[2].length(), 8);
  EXPECT_EQ(pieces[1].end(), point(6, 8));
}

TEST(SmoothPieces, OfACurveThatStandsStillAreNone) {
  EXPECT_TRUE(smooth_pieces(bezier({point(1, 2), point(1, 2), point(1, 2)})).empty());
}

TEST(SmoothPieces, OfWhatIsNoFormAreNone) {
  const NurbsForm good = spline(2, {point(0, 0), point(1, 0), point(1, 1), point(2, 1)}, {0.5});
  EXPECT_FALSE(smooth_pieces(good).empty());
  for (int flaw = 0; flaw < 7; ++flaw) {
    NurbsForm form = good;
    if (flaw == 0) form.degree = 6;
    if (flaw == 1) form.knots.pop_back();
    if (flaw == 2) form.weights[1] = 0;
    if (flaw == 3) std::swap(form.knots[0], form.knots[5]);
    if (flaw == 4) form.weights.pop_back();
    if (flaw == 5) form.degree = 0;
    if (flaw == 6) form = spline(1, {point(0, 0), point(1, 0), point(2, 0), point(3, 0)}, {0.5, 0.5});
    EXPECT_TRUE(smooth_pieces(form).empty()) << flaw;
  }
}

TEST(SmoothPieces, MeasureSecondaryAndRotaryAxesWhereTheTipStands) {
  const auto along = [](std::size_t axis, std::size_t other) {
    std::vector<Point> points(3);
    for (std::size_t k = 0; k < 3; ++k) {
      points[k][axis] = 4 * static_cast<double>(k);
      points[k][other] = 90 * static_cast<double>(k * k);
    }
    return length_of_one(smooth_pieces(bezier(points)));
  };
  EXPECT_NEAR(along(1, 3), 8, 1e-13);
  EXPECT_NEAR(along(6, 5), 8, 1e-13);
  EXPECT_NEAR(along(4, 5),
              static_cast<double>(
                  chord_length(bezier({{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 4, 90}, {0, 0, 0, 0, 8, 360}}), 0, 1, 4000)),
              1e-6);
}

TEST(SmoothPieces, AreCutWhereTheTipBeginsToMove) {
  // A alone, then X with it.
  NurbsForm form = spline(1, {{0, 0, 0, 0}, {0, 0, 0, 90}, {5, 0, 0, 90}}, {0.5});
  const auto pieces = smooth_pieces(form);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_DOUBLE_EQ(pieces[0].length(), 90);
  EXPECT_DOUBLE_EQ(pieces[1].length(), 5);
}

TEST(SmoothPieces, AreCutAtNearlyCoincidingKnots) {
  // Three knots within 1e-9 are a corner as good as one triple knot; two are a step of the curvature.
  const std::vector<Point> points = {point(0, 0), point(1, 0), point(2, 0), point(3, 0),
                                     point(3, 1), point(3, 2), point(4, 3)};
  EXPECT_EQ(smooth_pieces(spline(3, points, {0.5, 0.5 + 1e-9, 0.5 + 2e-9})).size(), 2u);
  const std::vector<Point> fewer(points.begin(), points.end() - 1);
  EXPECT_EQ(smooth_pieces(spline(3, fewer, {0.5, 0.5 + 1e-9})).size(), 2u);
  EXPECT_EQ(smooth_pieces(spline(3, fewer, {0.5, 0.6})).size(), 1u);
}

TEST(SmoothPieces, OfACurveOfThousandsOfPointsAreOne) {
  std::mt19937 random(1);
  std::vector<Point> points;
  std::vector<double> inner;
  for (int k = 0; k < 3000; ++k) {
    points.push_back(point(k * 0.1 + 0.02 * static_cast<double>(random() % 3), 5 * std::sin(k * 0.05)));
    if (k >= 4) inner.push_back((k - 3) / 2997.0);
  }
  const auto pieces = smooth_pieces(spline(3, points, inner));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].breaks().size(), 2996u);
  expect_unit_speed(pieces);
  const Curve curve = pieces[0];
  EXPECT_EQ(breaks(curve).size(), 2996u);
}

}  // namespace test_smooth_pieces
}  // namespace leadscrew::geometry::testing
