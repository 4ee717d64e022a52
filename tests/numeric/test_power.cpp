#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/power.hpp>
#include <quad.hpp>
#include <random>

// Judged by the series in quadruple precision, and by the C library in extended precision.

namespace test_power {

namespace numeric = leadscrew::numeric;
using testing_support::magnitude;
using testing_support::Quad;
using testing_support::quad;

constexpr int draws = 20'000;

/// By halving x sixteen times, ten terms, and squaring.
Quad quad_exp(Quad x) {
  if (x < 0) return 1 / quad_exp(-x);
  const Quad small = x / 65536;
  Quad term = 1, less_one = 0;
  for (int n = 1; n <= 10; ++n) less_one += term *= small / n;
  for (int i = 0; i < 16; ++i) less_one = less_one * (2 + less_one);
  return 1 + less_one;
}

TEST(FineExponential, HasNinetyFourBits) {
  std::mt19937_64 generator{1};
  std::uniform_real_distribution<double> drawn(-20, 20);
  double worst = 0;
  for (int k = 0; k < draws; ++k) {
    const double x = drawn(generator);
    const Quad right = quad_exp(x);
    worst = std::max(worst, static_cast<double>(magnitude(quad(numeric::exp(x)) - right) / right));
  }
  EXPECT_LE(worst, 0x1p-94);
  EXPECT_EQ(numeric::exp(0).value(), 1);
}

TEST(FineLogarithm, IsUndoneByTheExponential) {
  std::mt19937_64 generator{2};
  std::uniform_real_distribution<double> drawn(-20, 20);
  double worst = 0;
  for (int k = 0; k < draws; ++k) {
    const double x = std::exp2(drawn(generator));
    const Quad found = quad(numeric::fine_log(x));
    const Quad error = magnitude(quad_exp(found) / x - 1);
    worst = std::max(worst, static_cast<double>(error / std::max<Quad>(1, magnitude(found))));
  }
  EXPECT_LE(worst, 0x1p-94);
  EXPECT_EQ(numeric::fine_log(1).value(), 0);
}

TEST(Powers, AreTheNearestDoubles) {
  std::mt19937_64 generator{3};
  std::uniform_real_distribution<double> exponent(-2, 2), magnitude(-6, 6);
  double worst = 0;
  for (int k = 0; k < draws; ++k) {
    const double base = std::pow(10, magnitude(generator)), x = exponent(generator), found = numeric::pow(base, x);
    const long double right = std::pow(static_cast<long double>(base), static_cast<long double>(x));
    const double unit = std::ldexp(1.0, std::ilogb(right) - 52);
    worst = std::max(worst, static_cast<double>(std::abs(found - right)) / unit);
  }
  EXPECT_LE(worst, 0.502);  // what extended precision rounds by is below 1/500 of a double's last place
}

TEST(Powers, ThatAreWholeAreExact) {
  EXPECT_EQ(numeric::pow(100, 0.5), 10);
  EXPECT_EQ(numeric::pow(10000, 0.75), 1000);
  EXPECT_EQ(numeric::pow(3, 20), 3486784401);
  EXPECT_EQ(numeric::pow(0.1, 1), 0.1);
  EXPECT_EQ(numeric::pow(7, 0), 1);
}

}  // namespace test_power
