#include <gtest/gtest.h>

#include <leadscrew/base/number_text.hpp>

namespace test_number_text {

using namespace leadscrew::base;

TEST(NumberText, IsAsShortAsReadsBack) {
  EXPECT_EQ(text(0.1), "0.1");
  EXPECT_EQ(text(1.0 / 3), "0.3333333333333333");
}

TEST(NumberText, HasAtMostSoManyDigits) {
  EXPECT_EQ(text(1.0 / 3, 9), "0.333333333");
  EXPECT_EQ(text(2.5, 9), "2.5");
  EXPECT_EQ(text(12345678901.0, 10), "1.23456789e+10");
  EXPECT_EQ(rounded_text(1.23456), "1.235");
}

TEST(NumberText, HasSoManyDecimals) {
  EXPECT_EQ(fixed_text(2, 3), "2.000");
  EXPECT_EQ(fixed_text(1.0006, 3), "1.001");
  EXPECT_EQ(fixed_text(1e300, 2).size(), 304U);
}

}  // namespace test_number_text
