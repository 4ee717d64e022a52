// Koren's tables and the comparison of circular interpolators, by the rows of the studies.

#include <gtest/gtest.h>

#include <leadscrew/study/chopped.hpp>
#include <leadscrew/study/studies.hpp>
#include <string>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace {

TEST(Chopped, CutsTowardsZero) {
  constexpr double unit = 1.0 / (1 << 26);
  EXPECT_EQ(Chopped(1 + unit).value(), 1 + unit);
  EXPECT_EQ(Chopped(1 + 1.99 * unit).value(), 1 + unit);
  EXPECT_EQ(Chopped(-1 - 1.99 * unit).value(), -1 - unit);
  // (1 + u)(1 − u) = 1 − u²: just below 1, although double rounds it to 1.
  EXPECT_EQ((Chopped(1 + unit) * Chopped(1 - unit / 2)).value(), 1 + unit / 2 - unit / 2);
  EXPECT_LT((Chopped(1) - Chopped(1e-30)).value(), 1);
  EXPECT_EQ((Chopped(1) + Chopped(1e-30)).value(), 1);
}

const char* digits_of(std::size_t column) {
  constexpr std::array<const char*, 6> names = {"T = 1",     "T = 0.1",    "T = 0.01",
                                                "T = 0.001", "T = 0.0001", "T = 0.00001"};
  return names[column];
}

/// Every figure but the two that the paper has otherwise.
TEST(KorenTable1, ComesOutInChoppedNumbers) {
  const Rows rows = table_1_rows({});
  ASSERT_EQ(rows.size(), 24u);
  int exact = 0, reproduced = 0;
  for (const Row& row : rows) {
    exact += row.verdict == Verdict::exact;
    reproduced += row.verdict == Verdict::reproduced;
  }
  EXPECT_EQ(exact, 19);
  EXPECT_EQ(reproduced, 1);
  EXPECT_EQ(ours(rows, "Euler", digits_of(2)), 10160);
  EXPECT_EQ(ours(rows, "Tustin", digits_of(0)), 9460);
  EXPECT_NEAR(ours(rows, "Runge-Kutta", digits_of(0)), 9795.53, 0.005);
  EXPECT_EQ(ours(rows, "state transition", digits_of(5)), 9945);
  EXPECT_EQ(verdict(rows, "Tustin", digits_of(1)), "differs");
  EXPECT_EQ(verdict(rows, "state transition", digits_of(3)), "differs");
}

TEST(KorenOrders, AreTwoFourAndSixAStep) {
  const Rows rows = orders_rows({});
  for (const char* method : {"Euler", "Heun, eq. 23", "Runge-Kutta"}) {
    EXPECT_EQ(verdict(rows, method, "exponent of T, each step"), "exact") << method;
    EXPECT_EQ(verdict(rows, method, "exponent of T, half a turn"), "exact") << method;
  }
  EXPECT_EQ(verdict(rows, "the proposed method, eq. 27", "exponent of T, greatest of a turn"), "differs");
  EXPECT_NEAR(ours(rows, "the proposed method, eq. 27", "exponent of T, greatest of a turn"), 1, 0.01);
}

TEST(Koren10001, ComesOut) {
  const Rows rows = half_circle_rows({});
  EXPECT_EQ(verdict(rows, "eq. 27, remainders empty", "radius after half a turn"), "exact");
  EXPECT_EQ(ours(rows, "eq. 27, remainders half full", "radius after half a turn"), 10000);
  EXPECT_EQ(ours(rows, "as in hardware, remainders half full", "radius after half a turn"), 10002);
}

TEST(LectureStudy, ComesOut) {
  const Rows rows = lecture_rows({});
  for (const Row& row : rows) {
    const Verdict expected = row.what == "out of the feed DDA" ? Verdict::reproduced
                             : row.what == "feed of Y"         ? Verdict::differs
                             : row.published.has_value()       ? Verdict::exact
                                                               : Verdict::measured;
    EXPECT_EQ(row.verdict, expected) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
  }
  EXPECT_EQ(rows.size(), 23u);
}

TEST(FpgaTable1Study, ComesOut) {
  const Rows rows = fpga_rows({});
  ASSERT_EQ(rows.size(), 12u);
  for (const Row& row : rows) EXPECT_EQ(row.verdict == Verdict::exact, row.what != "logic elements") << row.group;
}

}  // namespace
}  // namespace leadscrew::study::testing
