#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/planner/cubic_basis.hpp>
#include <vector>

namespace test_cubic_basis {

using leadscrew::planner::CubicBasis;
using leadscrew::planner::dot;
using leadscrew::planner::Four;

/// Widths over three decades, some of them equal; at both ends, as those of a clamped spline, knots may coincide.
std::vector<double> random_knots(std::size_t intervals) {
  std::vector<double> knots = {*rc::gen::inRange(-100, 100) / 7.0};
  double width = 1;
  for (std::size_t k = 0; k < intervals; ++k) {
    if (*rc::gen::inRange(0, 3) > 0) width = std::pow(10.0, *rc::gen::inRange(-1500, 1501) / 1000.0);
    knots.push_back(knots.back() + width);
  }
  if (*rc::gen::arbitrary<bool>()) {
    knots.insert(knots.begin(), 2, knots.front());
    knots.insert(knots.end(), 2, knots.back());
  }
  return knots;
}

std::array<double, 6> six(const std::vector<double>& knots, std::size_t at) {
  std::array<double, 6> t{};
  for (std::size_t i = 0; i < 6; ++i) t[i] = knots[at + i];
  return t;
}

/// B(i, p) at s, by the recursion of Cox and de Boor; `span` holds s.
long double cox_de_boor(const std::vector<double>& t, std::size_t span, std::size_t i, std::size_t p, long double s) {
  if (p == 0) return i == span ? 1 : 0;
  long double value = 0;
  const long double rise = static_cast<long double>(t[i + p]) - t[i];
  const long double fall = static_cast<long double>(t[i + p + 1]) - t[i + 1];
  if (rise > 0) value += (s - t[i]) / rise * cox_de_boor(t, span, i, p - 1, s);
  if (fall > 0) value += (t[i + p + 1] - s) / fall * cox_de_boor(t, span, i + 1, p - 1, s);
  return value;
}

/// The outermost two of the eight knots that four functions have bear upon none of them here.
std::vector<double> eight(const std::array<double, 6>& t) {
  std::vector<double> knots = {t[0] - 1};
  knots.insert(knots.end(), t.begin(), t.end());
  knots.push_back(t[5] + 1);
  return knots;
}

RC_GTEST_PROP(CubicBasis, IsTheRecursionOfCoxAndDeBoor, ()) {
  const auto t = six(random_knots(5), 0);
  RC_PRE(t[2] < t[3]);
  const CubicBasis basis(t);
  const std::vector<double> knots = eight(t);
  RC_ASSERT(basis.h == t[3] - t[2]);
  for (const double u : {0.0, 0.1, 0.37, 0.5, 0.83, 1.0}) {
    const Four value = basis.value(u);
    const long double s = t[2] + u * (static_cast<long double>(t[3]) - t[2]);
    for (std::size_t j = 0; j < 4; ++j) {
      RC_ASSERT(std::abs(value[j] - cox_de_boor(knots, 3, j, 3, s)) <= 2e-15L);
    }
  }
}

RC_GTEST_PROP(CubicBasis, SumsToOneAndIsNowhereNegative, ()) {
  const auto t = six(random_knots(5), 0);
  RC_PRE(t[2] < t[3]);
  const CubicBasis basis(t);
  for (int k = 0; k <= 64; ++k) {
    const double u = k / 64.0;
    const Four value = basis.value(u), slope = basis.slope(u), bend = basis.bend(u);
    double sum = 0, slopes = 0, bends = 0, steepness = 0, bending = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      RC_ASSERT(value[j] >= -1e-15);
      sum += value[j];
      slopes += slope[j], steepness += std::abs(slope[j]);
      bends += bend[j], bending += std::abs(bend[j]);
    }
    RC_ASSERT(std::abs(sum - 1) <= 1e-15 * 4);
    RC_ASSERT(std::abs(slopes) <= 1e-14 * (steepness + 1 / basis.h));
    RC_ASSERT(std::abs(bends) <= 1e-14 * (bending + 1 / (basis.h * basis.h)));
  }
}

/// A cubic's differences over a step d: (f(+d) − f(−d))/2d exceeds the slope by d²f‴/6, two of them tell by how much;
/// the second difference is exact.
RC_GTEST_PROP(CubicBasis, HasTheDerivativesThatDifferencesShow, ()) {
  const auto t = six(random_knots(5), 0);
  RC_PRE(t[2] < t[3]);
  const CubicBasis basis(t);
  const std::vector<double> knots = eight(t);
  const long double h = static_cast<long double>(t[3]) - t[2], d = h / 8;
  for (const double u : {0.25, 0.375, 0.5, 0.75}) {
    const Four slope = basis.slope(u), bend = basis.bend(u);
    for (std::size_t j = 0; j < 4; ++j) {
      const auto at = [&](int k) { return cox_de_boor(knots, 3, j, 3, t[2] + u * h + k * d); };
      const long double near = (at(1) - at(-1)) / (2 * d), far = (at(2) - at(-2)) / (4 * d);
      RC_ASSERT(std::abs(slope[j] - (4 * near - far) / 3) <= 2e-14L / h);
      RC_ASSERT(std::abs(bend[j] - (at(1) - 2 * at(0) + at(-1)) / (d * d)) <= 2e-13L / (h * h));
    }
  }
}

RC_GTEST_PROP(CubicBasis, JoinsWithTwoContinuousDerivatives, ()) {
  const std::vector<double> knots = random_knots(6);
  std::vector<double> c(knots.size() - 2);
  for (double& x : c) x = *rc::gen::inRange(0, 1000001) / 1e6;
  for (std::size_t k = 0; k + 6 < knots.size(); ++k) {
    if (!(knots[k + 2] < knots[k + 3] && knots[k + 3] < knots[k + 4])) continue;
    const CubicBasis left(six(knots, k)), right(six(knots, k + 1));
    const double h = std::min(left.h, right.h);
    const auto jump = [&](const Four& before, const Four& after) {
      return std::abs(dot(before, &c[k]) - dot(after, &c[k + 1]));
    };
    RC_ASSERT(jump(left.value(1), right.value(0)) <= 1e-14);
    RC_ASSERT(jump(left.slope(1), right.slope(0)) <= 1e-13 / h);
    RC_ASSERT(jump(left.bend(1), right.bend(0)) <= 1e-12 / (h * h));
  }
}

TEST(CubicBasis, OfEvenKnotsIsTheCardinalSpline) {
  const CubicBasis basis({-2, -1, 0, 1, 2, 3});
  const Four value = basis.value(0), slope = basis.slope(0), bend = basis.bend(0);
  const Four values = {1.0 / 6, 2.0 / 3, 1.0 / 6, 0}, slopes = {-0.5, 0, 0.5, 0}, bends = {1, -2, 1, 0};
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(value[j], values[j], 1e-15);
    EXPECT_NEAR(slope[j], slopes[j], 1e-15);
    EXPECT_NEAR(bend[j], bends[j], 1e-15);
  }
}

TEST(CubicBasis, OfOneClampedIntervalIsBernsteins) {
  const CubicBasis basis({1, 1, 1, 3, 3, 3});
  const double u = 0.3, w = 0.7;
  const Four value = basis.value(u), expected = {w * w * w, 3 * u * w * w, 3 * u * u * w, u * u * u};
  for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(value[j], expected[j], 1e-15);
}

/// A cubic spline clamped at its first knot and, unless knots follow its last interval, at its last.
struct Spline {
  std::vector<double> knots, c;

  double at(double s) const {
    std::size_t k = 0;
    while (k + 4 < c.size() && knots[k + 1] < s) ++k;
    std::array<double, 6> t{};
    for (std::size_t i = 0; i < 6; ++i) {
      t[i] = knots[k + i < 2 ? 0 : std::min(k + i - 2, knots.size() - 1)];
    }
    const CubicBasis basis(t);
    return dot(basis.value((s - t[2]) / basis.h), &c[k]);
  }
};

RC_GTEST_PROP(CubicBasis, AKnotMoreLeavesTheSplineAsItIs, ()) {
  Spline spline;
  const auto intervals = *rc::gen::inRange<std::size_t>(1, 12), beyond = *rc::gen::inRange<std::size_t>(0, 4);
  spline.knots = {3};
  for (std::size_t k = 0; k < intervals + beyond; ++k) {
    spline.knots.push_back(spline.knots.back() + *rc::gen::inRange(1, 1000) / 100.0);
  }
  double greatest = 0;
  for (std::size_t i = 0; i < intervals + 3; ++i) {
    spline.c.push_back(*rc::gen::inRange(-1000, 1001) / 1000.0);
    greatest = std::max(greatest, std::abs(spline.c.back()));
  }
  const double from = spline.knots.front(), to = spline.knots[intervals];
  Spline finer = spline;
  for (int count = *rc::gen::inRange(1, 6); count > 0; --count) {
    const double s = from + (to - from) * *rc::gen::inRange(1, 1000) / 1000.0;
    if (std::find(finer.knots.begin(), finer.knots.end(), s) != finer.knots.end()) continue;
    leadscrew::planner::insert_knot(finer.knots, finer.c, s);
  }
  RC_ASSERT(finer.c.size() - spline.c.size() == finer.knots.size() - spline.knots.size());
  RC_ASSERT(std::is_sorted(finer.knots.begin(), finer.knots.end()));
  for (int k = 0; k <= 200; ++k) {
    const double s = from + (to - from) * k / 200;
    RC_ASSERT(std::abs(finer.at(s) - spline.at(s)) <= 1e-12 * greatest);
  }
}

}  // namespace test_cubic_basis
