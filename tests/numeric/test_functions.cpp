#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>
#include <random>

// Against the functions of the C library in extended precision, 64 bits of mantissa.

namespace test_functions {

namespace numeric = leadscrew::numeric;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// In units in the last place of the exact value.
double ulps(double found, long double exact) {
  if (exact == 0) return found == 0 ? 0 : infinity;
  const int exponent = std::max(std::ilogb(exact), -1022);
  return static_cast<double>(std::abs(found - exact) / std::ldexp(1.0L, exponent - 52));
}

/// Of many magnitudes and both signs, the same every time.
class Draw {
 public:
  double operator()(int least_exponent, int greatest_exponent) {
    std::uniform_real_distribution<double> mantissa(1, 2);
    std::uniform_int_distribution<int> exponent(least_exponent, greatest_exponent);
    const double magnitude = std::ldexp(mantissa(generator_), exponent(generator_));
    return generator_() % 2 == 0 ? magnitude : -magnitude;
  }

 private:
  std::mt19937_64 generator_{1};
};

constexpr int draws = 200'000;

TEST(Functions, AnglesOfPointsAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const int spread = i % 3 == 0 ? 40 : 3;
    const double x = draw(-spread, spread), y = draw(-spread, spread);
    greatest = std::max(greatest, ulps(numeric::atan2(y, x), std::atan2(static_cast<long double>(y), x)));
  }
  EXPECT_LE(greatest, 1.7);
  EXPECT_GT(greatest, 0.49);
}

TEST(Functions, AnglesOnAxesAndDiagonalsAreThoseOfTheLibrary) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-300, -1e300, infinity}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, -1e-300, 1e300, -infinity}) {
      const double found = numeric::atan2(y, x);
      EXPECT_EQ(found, std::atan2(y, x)) << y << ' ' << x;
      EXPECT_EQ(std::signbit(found), std::signbit(y));
    }
  }
  EXPECT_TRUE(std::isnan(numeric::atan2(std::nan(""), 1)));
}

TEST(Functions, ArcSinesAndArcCosinesAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = i % 2 == 0 ? draw(-30, -1) : std::copysign(1 - std::abs(draw(-40, -2)), draw(0, 0));
    const auto error = [](double found, long double exact) {
      return std::abs(static_cast<double>(found - exact)) / 0x1p-52 / std::max(1.0, std::abs(found));
    };
    greatest = std::max(greatest, ulps(numeric::asin(x), std::asin(static_cast<long double>(x))));
    greatest = std::max(greatest, error(numeric::acos(x), std::acos(static_cast<long double>(x))));
  }
  EXPECT_LE(greatest, 2.5);
  EXPECT_EQ(numeric::asin(1), std::numbers::pi / 2);
  EXPECT_EQ(numeric::acos(1), 0);
  EXPECT_TRUE(std::isnan(numeric::asin(1.5)) && std::isnan(numeric::acos(-1.5)));
}

TEST(Functions, RootsOfSumsOfSquaresAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const int spread = i % 3 == 0 ? 60 : 2;
    const double x = draw(-spread, spread), y = draw(-spread, spread), z = draw(-spread, spread);
    const long double fine = x, square = fine * fine + static_cast<long double>(y) * y;
    greatest = std::max(greatest, ulps(numeric::hypot(x, y), std::sqrt(square)));
    greatest = std::max(greatest, ulps(numeric::hypot(x, y, z), std::sqrt(square + static_cast<long double>(z) * z)));
  }
  EXPECT_LE(greatest, 1.5);
  EXPECT_GT(greatest, 0.49);
}

TEST(Functions, RootsOfSumsOfSquaresNeitherOverflowNorVanish) {
  EXPECT_EQ(numeric::hypot(3e300, -4e300), 5e300);
  EXPECT_NEAR(numeric::hypot(3e-310, 4e-310) / 5e-310, 1, 1e-13);
  EXPECT_EQ(numeric::hypot(0, 0), 0);
  EXPECT_EQ(numeric::hypot(-7.25, 0, 0), 7.25);
  EXPECT_EQ(numeric::hypot(-infinity, 1), infinity);
  EXPECT_TRUE(std::isnan(numeric::hypot(std::nan(""), 1)));
}

TEST(Functions, CubeRootsAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = draw(-1070, 1022);
    greatest = std::max(greatest, ulps(numeric::cbrt(x), std::cbrt(static_cast<long double>(x))));
  }
  EXPECT_LE(greatest, 0.51);
  for (std::int64_t i = -200; i <= 200; ++i) EXPECT_EQ(numeric::cbrt(static_cast<double>(i * i * i)), i);
}

TEST(Functions, LogarithmsAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = i % 2 == 0 ? std::abs(draw(-1070, 1022)) : 1 + draw(-50, -2);
    greatest = std::max(greatest, ulps(numeric::log(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LE(greatest, 1);
  EXPECT_GT(greatest, 0.49);
  EXPECT_EQ(numeric::log(1), 0);
  EXPECT_EQ(numeric::log(0), -infinity);
  EXPECT_EQ(numeric::log(infinity), infinity);
  EXPECT_TRUE(std::isnan(numeric::log(-1)));
}

TEST(Functions, PowersOfELessOneAreRight) {
  Draw draw;
  double greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = draw(-60, 8);
    greatest = std::max(greatest, ulps(numeric::expm1(x), std::expm1(static_cast<long double>(x))));
  }
  EXPECT_LE(greatest, 3);
  EXPECT_EQ(numeric::expm1(0), 0);
  EXPECT_EQ(numeric::expm1(1e4), infinity);
  EXPECT_EQ(numeric::expm1(-1e4), -1);
}

}  // namespace test_functions
