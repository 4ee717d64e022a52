#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <leadscrew/base/digits.hpp>
#include <limits>
#include <random>
#include <string>

namespace leadscrew::base {
namespace test_digits {

std::string digits(double value) {
  char text[digits_room];
  return {text, write_digits(text, value)};
}

std::string as_printf(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

TEST(Digits, KeepsWholeNumbersShort) {
  EXPECT_EQ(digits(0), "0");
  EXPECT_EQ(digits(-12), "-12");
  EXPECT_EQ(digits(0.5), "0.5");
  EXPECT_EQ(digits(0.001), "0.001");
  EXPECT_EQ(digits(0.1), "0.10000000000000001");
}

TEST(Digits, AgreesWithPrintfAtEdges) {
  for (int exponent = -20; exponent <= 20; ++exponent) {
    double value = std::pow(10.0, exponent);
    for (int i = 0; i < 8; ++i) value = std::nextafter(value, 0.0);
    for (int i = 0; i < 16; ++i, value = std::nextafter(value, 1e300)) EXPECT_EQ(digits(value), as_printf(value));
  }
  for (int exponent = -70; exponent <= 70; ++exponent)
    EXPECT_EQ(digits(std::ldexp(1.0, exponent)), as_printf(std::ldexp(1.0, exponent)));
  for (const double value : {-0.0, 1e-4, 9999999999999999.0, 123456789012345.98, 99999999999999.999, 4503599627370495.5,
                             std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(digits(value), as_printf(value));
    EXPECT_EQ(digits(-value), as_printf(-value));
  }
}

TEST(Digits, AgreesWithPrintfOnEveryMagnitude) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> exponent(-6, 17), mantissa(-1, 1);
  for (int i = 0; i < 300000; ++i) {
    double value = std::pow(10.0, exponent(random)) * mantissa(random);
    if (i % 3 == 0) value = std::round(value * 1000) / 1000;
    if (i % 7 == 0) value = std::floor(value) + 0.5;
    ASSERT_EQ(digits(value), as_printf(value));
  }
}

RC_GTEST_PROP(Digits, AgreeWithPrintfForAnyBits, (std::uint64_t bits)) {
  const double value = std::bit_cast<double>(bits);
  if (std::isfinite(value)) RC_ASSERT(digits(value) == as_printf(value));
}

}  // namespace test_digits
}  // namespace leadscrew::base
