// Feed and chord errors of parameter steps: the expected figures, and marches that share no code with the study's.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/studies.hpp>
#include <vector>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_feed_fluctuation {

const Rows& rows() {
  static const Rows rows = feed_fluctuation_rows({});
  return rows;
}

constexpr const char* greatest = "feed error, greatest";
constexpr const char* least = "feed error, least";

TEST(KorenLinFeedError, OfUniformStepsIsAThirdEitherWay) {
  const char* group = "expected: plane cubic, V 10 mm/s, T 10 ms, uniform";
  EXPECT_NEAR(ours(rows(), group, least), -33, 0.5);
  EXPECT_NEAR(ours(rows(), group, greatest), 28, 0.5);
  EXPECT_EQ(verdict(rows(), group, "feed error, size, below"), "worse");
}

TEST(KorenLinFeedError, OfFirstOrderIsBelowTwoPercent) {
  const char* group = "expected: plane cubic, V 10 mm/s, T 10 ms, taylor1";
  EXPECT_NEAR(ours(rows(), group, least), -0.70, 0.005);
  EXPECT_NEAR(ours(rows(), group, greatest), 0.53, 0.005);
  EXPECT_EQ(verdict(rows(), group, "feed error, size, below"), "no worse");
}

TEST(KorenLinFeedError, OfSecondOrderIsAHundredthOfThat) {
  const char* group = "expected: plane cubic, V 10 mm/s, T 10 ms, taylor2";
  EXPECT_NEAR(ours(rows(), group, least), -0.005, 0.0005);
  EXPECT_NEAR(ours(rows(), group, greatest), 0.016, 0.0005);
}

TEST(KorenLinFeedError, VanishesWhenTheChordIsCorrected) {
  const char* group = "expected: plane cubic, V 10 mm/s, T 10 ms, newton";
  EXPECT_NEAR(ours(rows(), group, least), 0, 1e-6);
  EXPECT_NEAR(ours(rows(), group, greatest), 0, 1e-6);
}

TEST(KorenLinFeedError, OfFirstOrderPassesTwoPercentBetween20And50Milliseconds) {
  EXPECT_NEAR(ours(rows(), "expected: plane cubic, V 10 mm/s, T 20 ms, taylor1", "feed error, size"), 1.4, 0.05);
  EXPECT_NEAR(ours(rows(), "expected: plane cubic, V 10 mm/s, T 50 ms, taylor1", "feed error, size"), 3.3, 0.05);
}

constexpr const char* sampling = "plane cubic, V 10 mm/s, 1 ms and the time of interpolation as T";

TEST(KorenLinChordError, FallsBy44PercentWithAPeriodOfThreeQuarters) {
  EXPECT_NEAR(ours(rows(), sampling, "chord error saved by T = 1.5 ms in place of 2 ms"), 43.75, 0.1);
  EXPECT_EQ(verdict(rows(), sampling, "chord error saved by T = 1.5 ms in place of 2 ms"), "exact");
}

/// 1 − (1.6667/2)².
TEST(KorenLinChordError, FallsBy31PercentByAComputerOneAndAHalfTimesAsFast) {
  const Row row = found(rows(), sampling, "chord error saved by a computer 50 % faster");
  EXPECT_EQ(published(row), 44);
  EXPECT_NEAR(row.ours.value_or(NAN), 30.56, 0.1);
  EXPECT_EQ(row.verdict, Verdict::differs);
}

TEST(KorenLinChordError, At10MillisecondsIs444Nanometres) {
  EXPECT_EQ(verdict(rows(), "expected: plane cubic, V 10 mm/s", "chord error at T = 10 ms"), "exact");
}

TEST(KorenLinCurve, HasTheExpectedLengthAndSharpestBend) {
  EXPECT_EQ(verdict(rows(), "expected: plane cubic, V 10 mm/s", "length"), "exact");
  EXPECT_EQ(verdict(rows(), "expected: plane cubic, V 10 mm/s", "smallest radius of curvature"), "exact");
}

/// First-order march along the cubic written out; the errors in %.
struct Errors {
  double least = 1e9, greatest = -1e9;
};
Errors first_order_by_hand(double speed, double period) {
  const auto y = [](double u) { return ((-50 * u + 80) * u - 10) * u; };
  Errors errors;
  double u = 0;
  while (true) {
    const double next = u + speed * period / std::hypot(20, (-150 * u + 160) * u - 10);
    if (next >= 1) return errors;
    const double error = 100 * (std::hypot(20 * (next - u), y(next) - y(u)) / (speed * period) - 1);
    errors = {std::min(errors.least, error), std::max(errors.greatest, error)};
    u = next;
  }
}

TEST(FeedFluctuation, OfFirstOrderIsThatOfAMarchByHandAtEveryPeriod) {
  for (const int milliseconds : {1, 2, 5, 10}) {
    const std::string group = "plane cubic, V 10 mm/s, T " + std::to_string(milliseconds) + " ms, taylor1";
    const Errors expected = first_order_by_hand(10, milliseconds / 1e3);
    EXPECT_NEAR(ours(rows(), group, least), expected.least, 1e-6) << group;
    EXPECT_NEAR(ours(rows(), group, greatest), expected.greatest, 1e-6) << group;
  }
}

TEST(FeedFluctuation, OfArcLengthIsOnlyThatOfChordsBesideArcs) {
  // A chord is shorter than its arc by (VT)²κ²/24: 1.5 nm of 0.1 mm here.
  const char* group = "plane cubic, V 10 mm/s, T 10 ms, arc-length";
  EXPECT_LT(ours(rows(), group, greatest), 1e-4);
  const double kappa = 0.35522, step_length = 0.1;
  EXPECT_NEAR(ours(rows(), group, least), -100 * step_length * step_length * kappa * kappa / 24, 1e-4);
}

TEST(FeedFluctuation, ChordErrorsFollowEquation3WhereStepsAreShort) {
  for (const char* rule : {"taylor1", "taylor2", "newton", "arc-length"}) {
    for (const char* course : {"plane cubic, V 10 mm/s, T 1 ms, ", "plane cubic, V 10 mm/s, T 10 ms, "})
      EXPECT_EQ(verdict(rows(), course + std::string(rule), "chord error"), "reproduced") << course << rule;
  }
  // Steps as long as the bend is wide are not what the equation is for.
  EXPECT_EQ(verdict(rows(), "butterfly, V 100 mm/s, T 10 ms, newton", "chord error"), "differs");
}

TEST(ButterflyFeedError, OfTaylorsStepsIsOutOfAllBounds) {
  const double first =
      ours(rows(), "expected: butterfly, V 100 mm/s, T 1 ms, taylor1", "feed error along the curve, size");
  const double second =
      ours(rows(), "expected: butterfly, V 100 mm/s, T 1 ms, taylor2", "feed error along the curve, size");
  EXPECT_NEAR(first, 78, 0.5);
  EXPECT_NEAR(second, 75, 0.5);
}

// VT = 0.01 mm is less than half of the sharpest radius: there the correction converges.
TEST(ButterflyFeedError, OfCorrectedChordsVanishesWhereStepsAreShortBesideBends) {
  const char* group = "butterfly, V 10 mm/s, T 1 ms, newton";
  EXPECT_LT(ours(rows(), group, greatest), 0.1);
  EXPECT_GT(ours(rows(), group, least), -0.1);
}

TEST(FeedFluctuation, HasARowForEveryRulePeriodAndCourse) {
  const auto is_chord = [](const Row& row) { return row.what == "chord error"; };
  EXPECT_EQ(std::count_if(rows().begin(), rows().end(), is_chord), 3 * 4 * 5);
}

}  // namespace test_feed_fluctuation
}  // namespace leadscrew::study::testing
