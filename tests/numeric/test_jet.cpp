#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/jet.hpp>

// Closed forms of the derivatives, written out by hand, are the judge.

namespace {

using leadscrew::numeric::Jet;

void expect_near(const Jet& jet, double f, double f1, double f2, double f3) {
  EXPECT_NEAR(jet.value, f, 1e-12 * (1 + std::abs(f)));
  EXPECT_NEAR(jet.first, f1, 1e-12 * (1 + std::abs(f1)));
  EXPECT_NEAR(jet.second, f2, 1e-12 * (1 + std::abs(f2)));
  EXPECT_NEAR(jet.third, f3, 1e-12 * (1 + std::abs(f3)));
}

class JetAt : public testing::TestWithParam<double> {};

TEST_P(JetAt, PowersFollowThePowerRule) {
  const double u = GetParam();
  const Jet x = Jet::parameter(u);
  expect_near(x * x * x * x, u * u * u * u, 4 * u * u * u, 12 * u * u, 24 * u);
}

TEST_P(JetAt, QuotientHasItsDerivatives) {
  const double u = GetParam(), d = 1 + u * u;  // 1/(1+u²)
  const Jet x = Jet::parameter(u);
  expect_near(Jet(1) / (1 + x * x), 1 / d, -2 * u / (d * d), (6 * u * u - 2) / (d * d * d),
              24 * u * (1 - u * u) / (d * d * d * d));
}

TEST_P(JetAt, SineOfASquareHasItsDerivatives) {
  const double u = GetParam(), s = std::sin(u * u), c = std::cos(u * u);
  const Jet x = Jet::parameter(u);
  expect_near(sin(x * x), s, 2 * u * c, 2 * c - 4 * u * u * s, -12 * u * s - 8 * u * u * u * c);
  expect_near(cos(x * x), c, -2 * u * s, -2 * s - 4 * u * u * c, -12 * u * c + 8 * u * u * u * s);
}

TEST_P(JetAt, RootOfAShiftedParameterHasItsDerivatives) {
  const double u = GetParam(), r = std::sqrt(u + 5);
  expect_near(sqrt(Jet::parameter(u) + 5), r, 0.5 / r, -0.25 / (r * r * r), 0.375 / (r * r * r * r * r));
}

INSTANTIATE_TEST_SUITE_P(Values, JetAt, testing::Values(-2.5, -0.3, 0.7, 1.0, 3.25));

}  // namespace
