#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/log_sum.hpp>
#include <limits>

namespace test_log_sum {

using leadscrew::numeric::LogSum;

TEST(LogSum, IsThatOfTheLogarithmsOneByOne) {
  LogSum sum(1e-12);
  EXPECT_EQ(sum.value(), 0);
  double expected = 0;
  for (int i = 1; i <= 500; ++i) {
    const double factor = std::exp(8 * std::sin(i));
    EXPECT_TRUE(sum.add(factor));
    expected += std::log(factor);
    EXPECT_NEAR(sum.value(), expected, 1e-11);
  }
}

TEST(LogSum, HoldsFarMoreThanADouble) {
  for (const double factor : {2e-100, 2e-12, 0.5, 2.0, 1e9, 1e100}) {
    LogSum sum(1e-100);
    for (int i = 0; i < 10'000; ++i) ASSERT_TRUE(sum.add(factor));
    EXPECT_NEAR(sum.value(), 10'000 * std::log(factor), 1e-11 * std::abs(sum.value())) << factor;
  }
}

TEST(LogSum, TakesNoFactorThatIsNotAboveTheLeast) {
  LogSum sum(1e-12);
  EXPECT_TRUE(sum.add(3));
  for (const double factor : {1e-12, 1e-300, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(sum.add(factor)) << factor;
  }
  EXPECT_DOUBLE_EQ(sum.value(), std::log(3));
  EXPECT_TRUE(sum.add(std::nextafter(1e-12, 1)));
}

}  // namespace test_log_sum
