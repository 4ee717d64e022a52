// How verdicts come out of figures.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/row.hpp>

namespace leadscrew::study {
namespace {

TEST(Verdicts, ExactMeansEveryPublishedDigit) {
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

}  // namespace
}  // namespace leadscrew::study
