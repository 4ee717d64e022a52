#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/jet.hpp>

// Closed forms of the derivatives, written out by hand, are the judge; and double-double, of plain arithmetic.

namespace test_jet {

using leadscrew::numeric::DoubleDouble;
using leadscrew::numeric::Jet;

void expect_near(const Jet<>& jet, double f, double f1, double f2, double f3) {
  EXPECT_NEAR(jet.value, f, 1e-12 * (1 + std::abs(f)));
  EXPECT_NEAR(jet.first, f1, 1e-12 * (1 + std::abs(f1)));
  EXPECT_NEAR(jet.second, f2, 1e-12 * (1 + std::abs(f2)));
  EXPECT_NEAR(jet.third, f3, 1e-12 * (1 + std::abs(f3)));
}

/// Every derivative, which may have lost as many digits more as its size above that of the value.
template <std::size_t N>
void expect_same(const Jet<N>& jet, const Jet<N>& right, double tolerance = 1e-12) {
  for (std::size_t k = 0; k <= N; ++k) EXPECT_NEAR(jet[k], right[k], tolerance * (1 + std::abs(right[k]))) << k;
}

class JetAt : public testing::TestWithParam<double> {};

TEST_P(JetAt, PowersFollowThePowerRule) {
  const double u = GetParam();
  const Jet<> x = Jet<>::parameter(u);
  expect_near(x * x * x * x, u * u * u * u, 4 * u * u * u, 12 * u * u, 24 * u);
}

TEST_P(JetAt, QuotientHasItsDerivatives) {
  const double u = GetParam(), d = 1 + u * u;  // 1/(1+u²)
  const Jet<> x = Jet<>::parameter(u);
  expect_near(Jet<>(1) / (1 + x * x), 1 / d, -2 * u / (d * d), (6 * u * u - 2) / (d * d * d),
              24 * u * (1 - u * u) / (d * d * d * d));
}

TEST_P(JetAt, SineOfASquareHasItsDerivatives) {
  const double u = GetParam(), s = std::sin(u * u), c = std::cos(u * u);
  const Jet<> x = Jet<>::parameter(u);
  expect_near(sin(x * x), s, 2 * u * c, 2 * c - 4 * u * u * s, -12 * u * s - 8 * u * u * u * c);
  expect_near(cos(x * x), c, -2 * u * s, -2 * s - 4 * u * u * c, -12 * u * c + 8 * u * u * u * s);
}

TEST_P(JetAt, RootOfAShiftedParameterHasItsDerivatives) {
  const double u = GetParam(), r = std::sqrt(u + 5);
  expect_near(sqrt(Jet<>::parameter(u) + 5), r, 0.5 / r, -0.25 / (r * r * r), 0.375 / (r * r * r * r * r));
}

/// atan(u²)′ = 2u/(1 + u⁴), differentiated twice more.
TEST_P(JetAt, ArcTangentOfASquareHasItsDerivatives) {
  const double u = GetParam(), u4 = u * u * u * u, d = 1 + u4;
  const Jet<> x = Jet<>::parameter(u);
  expect_near(atan2(x * x, Jet<>(1)), std::atan(u * u), 2 * u / d, (2 - 6 * u4) / (d * d),
              u * u * u * (24 * u4 - 40) / (d * d * d));
}

/// √(u² + 4)′ = u/r, r″ = 4/r³, r‴ = −12u/r⁵.
TEST_P(JetAt, HypotenuseHasItsDerivatives) {
  const double u = GetParam(), r = std::sqrt(u * u + 4);
  const Jet<> x = Jet<>::parameter(u);
  expect_near(hypot(x, Jet<>(2)), r, u / r, 4 / (r * r * r), -12 * u / (r * r * r * r * r));
  expect_same<3>(hypot(x, Jet<>(1.2), Jet<>(1.6)), hypot(x, Jet<>(2)));
}

/// acos(u/4)′ = −1/√(16 − u²).
TEST_P(JetAt, ArcCosineHasItsDerivatives) {
  const double u = GetParam(), w = 16 - u * u, r = std::sqrt(w);
  expect_near(acos(Jet<>::parameter(u) / Jet<>(4)), std::acos(u / 4), -1 / r, -u / (w * r),
              -(16 + 2 * u * u) / (w * w * r));
}

/// r(u) at the angle φ(u) of the plane, from whichever side it passes the half-lines where signs change.
TEST_P(JetAt, PolarCoordinatesComeBackFromTheirPoint) {
  const double u = GetParam();
  for (const double turn : {-2.9, -1.6, 0.0, 0.4, 1.5, 3.1}) {
    const auto t = Jet<5>::parameter(u);
    const Jet<5> radius = 3.0 + 0.1 * t * t, angle = turn + 0.2 * (t - u) - 0.03 * (t - u) * (t - u);
    const Jet<5> x = radius * cos(angle), y = radius * sin(angle);
    expect_same(hypot(x, y), radius, 1e-11);
    expect_same(atan2(y, x), angle, 1e-11);
    if (turn > 0) expect_same(acos(x / radius), angle, turn > 3 ? 1e-7 : 1e-10);
  }
}

TEST_P(JetAt, OfAnyOrderBeginsAsThatOfThree) {
  const double u = GetParam();
  const auto of = [&](const auto& x) { return sin(x * x) / sqrt(x + 5.0) + cos(x) * hypot(x, 0.5 * x + 1.0); };
  const Jet<> three = of(Jet<>::parameter(u));
  const Jet<5> five = of(Jet<5>::parameter(u));
  const Jet<1> one = of(Jet<1>::parameter(u));
  const Jet<0> none = of(Jet<0>::parameter(u));
  for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR(five[k], three[k], 1e-11 * (1 + std::abs(three[k])));
  for (std::size_t k = 0; k <= 1; ++k) EXPECT_NEAR(one[k], three[k], 1e-12 * (1 + std::abs(three[k])));
  EXPECT_NEAR(none[0], three.value, 1e-12);
}

/// (1/(u + 4))⁽ᵏ⁾ = (−1)ᵏ k!/(u + 4)ᵏ⁺¹ and √(u + 4)⁽ᵏ⁾ = (1/2)(1/2 − 1)…(u + 4)^(1/2 − k).
TEST_P(JetAt, OfTheSixthOrderHasItsDerivatives) {
  const double v = GetParam() + 4;
  const auto x = Jet<6>::parameter(GetParam()) + 4.0;
  const Jet<6> inverse = Jet<6>(1) / x, root = sqrt(x);
  double of_inverse = 1 / v, of_root = std::sqrt(v);
  for (int k = 0; k <= 6; ++k) {
    const auto order = static_cast<std::size_t>(k);
    EXPECT_NEAR(inverse[order], of_inverse, 1e-13 * std::abs(of_inverse));
    EXPECT_NEAR(root[order], of_root, 1e-13 * std::abs(of_root));
    of_inverse *= -(k + 1) / v;
    of_root *= (0.5 - k) / v;
  }
}

INSTANTIATE_TEST_SUITE_P(Values, JetAt, testing::Values(-2.5, -0.3, 0.7, 1.0, 3.25));

/// In double-double a quotient times its divisor is the dividend to 30 digits; in double it is that to 15.
TEST(Jet, KeepsThePrecisionOfItsScalar) {
  using Fine = Jet<3, DoubleDouble>;
  const Fine x(1.7, 1, 0.3, -0.2), y(0.9, -0.4, 0.25, 1.1);
  const Fine back = x / y * y;
  const Jet<4, DoubleDouble> t = Jet<4, DoubleDouble>::parameter(0.7),
                             again = t * t / (t + DoubleDouble(3)) * (t + DoubleDouble(3));
  for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR((back[k] - x[k]).value(), 0, 1e-29);
  for (std::size_t k = 0; k <= 4; ++k) EXPECT_NEAR((again[k] - (t * t)[k]).value(), 0, 1e-29);
  const Jet<> coarse = Jet<>(1.7, 1, 0.3, -0.2) / Jet<>(0.9, -0.4, 0.25, 1.1);
  for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR(coarse[k], (x / y)[k].value(), 1e-14);
}

TEST(Jet, IsOrderedByItsValue) {
  const Jet<> low(1, 9, 9, 9), high(2, 0, 0, 0), same(1, 0, 0, 0);
  EXPECT_TRUE(low < high && high > low && low <= high && high >= low);
  EXPECT_TRUE(low <= same && low >= same && !(low < same) && !(low > same));
  EXPECT_FALSE(low == same);
  EXPECT_TRUE(low < 1.5 && 1.5 > low);
}

}  // namespace test_jet
