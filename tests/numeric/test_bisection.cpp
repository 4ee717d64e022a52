#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/bisection.hpp>

namespace test_bisection {

using leadscrew::numeric::bisect;
using leadscrew::numeric::Bracket;
using leadscrew::numeric::last_index;

TEST(Bisection, ClosesUponWhereTheConditionEnds) {
  const Bracket found = bisect(0, 4, 200, [](double x) { return x * x < 2; }, 1e-15);
  EXPECT_LE(found.from, std::sqrt(2));
  EXPECT_GE(found.to, std::sqrt(2));
  EXPECT_LE(found.to - found.from, 1e-15 * found.to);
}

TEST(Bisection, HalvesNoMoreOftenThanTold) {
  int asked = 0;
  const Bracket found = bisect(0, 1, 5, [&](double) {
    ++asked;
    return true;
  });
  EXPECT_EQ(asked, 5);
  EXPECT_EQ(found.from, 1 - 1.0 / 32);
  EXPECT_EQ(found.to, 1);
}

TEST(Bisection, FindsTheLastIndex) {
  for (std::size_t last = 3; last <= 20; ++last) {
    EXPECT_EQ(last_index(3, 20, [&](std::size_t index) { return index <= last; }), last);
  }
  EXPECT_EQ(last_index(7, 7, [](std::size_t) { return false; }), 7U) << "is not asked for what holds";
}

}  // namespace test_bisection
