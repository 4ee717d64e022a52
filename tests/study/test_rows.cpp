// How verdicts come out of figures.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/row.hpp>
#include <optional>
#include <type_traits>

namespace leadscrew::study {
namespace test_rows {

constexpr Source somewhere = {Paper::fpga_interpolation, "Table 1"};

// No figure is published without its source.
static_assert(!std::is_default_constructible_v<Source> && !std::is_constructible_v<Source, Paper>);
static_assert(!std::is_constructible_v<Published, double>);
static_assert(!std::is_assignable_v<std::optional<Published>&, double>);
static_assert(std::is_assignable_v<std::optional<Published>&, Published>);

TEST(Rows, HoldAPublishedFigureWithItsSourceAndABareOneAsExpected) {
  const Row printed = exact_row("", {}, Published(7, somewhere), 7), bare = exact_row("", {}, 7, 7);
  ASSERT_TRUE(printed.published.has_value());
  EXPECT_EQ(printed.published->value, 7);
  EXPECT_EQ(printed.published->source.paper, Paper::fpga_interpolation);
  EXPECT_EQ(printed.published->source.where, "Table 1");
  EXPECT_FALSE(printed.expected.has_value());
  EXPECT_FALSE(bare.published.has_value());
  EXPECT_EQ(bare.expected, 7);
  EXPECT_EQ(expecting(printed, 8).expected, 8);
  EXPECT_EQ(expecting(printed, 8).published->value, 7);
}

TEST(Verdicts, FittedMeansEveryDigitOfAFigureSolvedFor) {
  EXPECT_EQ(fitted_row("", {"s", 1}, {10.1, somewhere}, 10.06).verdict, Verdict::fitted);
  EXPECT_EQ(fitted_row("", {"s", 1}, {10.1, somewhere}, 10.2).verdict, Verdict::differs);
  EXPECT_EQ(fitted_row("", {"s", 1}, {10.1, somewhere}, NAN).verdict, Verdict::differs);
  EXPECT_EQ(name(Verdict::fitted), "fitted");
}

TEST(Verdicts, ExactMeansEveryDigit) {
  const Scale seconds = {"s", 3};
  EXPECT_EQ(exact_row("", seconds, 2.994, 2.9944).verdict, Verdict::exact);
  EXPECT_EQ(exact_row("", seconds, 2.994, 2.9946).verdict, Verdict::differs);
  EXPECT_EQ(exact_row("", seconds, 2.994, 2.9946, 0.0002).verdict, Verdict::exact);
  EXPECT_EQ(exact_row("", seconds, 2.994, NAN).verdict, Verdict::differs);
}

TEST(Verdicts, ReproducedMeansWithinTheAccuracy) {
  EXPECT_EQ(reproduced_row("", {}, 78, 77.6, 0.5).verdict, Verdict::reproduced);
  EXPECT_EQ(reproduced_row("", {}, 78, 77.4, 0.5).verdict, Verdict::differs);
  EXPECT_EQ(reproduced_row("", {}, 78, NAN, 0.5).verdict, Verdict::differs);
}

TEST(Verdicts, NoWorseMeansNotMore) {
  EXPECT_EQ(at_most_row("", {}, 336, 336).verdict, Verdict::no_worse);
  EXPECT_EQ(at_most_row("", {}, 336, 337).verdict, Verdict::worse);
  EXPECT_EQ(at_most_row("", {}, 336, NAN).verdict, Verdict::worse);
}

TEST(Verdicts, ALimitIsKeptOrExceeded) {
  EXPECT_EQ(limit_row("", {}, 1, 1.0009, 0.001).verdict, Verdict::kept);
  EXPECT_EQ(limit_row("", {}, 1, 1.0011, 0.001).verdict, Verdict::exceeded);
  EXPECT_EQ(limit_row("", {}, 1, NAN, 0.001).verdict, Verdict::exceeded);
}

TEST(Figures, AreWrittenWithTheirDigits) {
  EXPECT_EQ(decimal(3.14159, 2), "3.14");
  EXPECT_EQ(decimal(-0.70, 2), "-0.70");
  EXPECT_EQ(decimal(534, 0), "534");
  EXPECT_EQ(decimal(0, 3), "0.000");
  EXPECT_EQ(decimal(4.44e-7, 4), "4.4e-07");
}

}  // namespace test_rows
}  // namespace leadscrew::study
