// The cubic between words beside the motion that the words are of.

#include <gtest/gtest.h>

#include <leadscrew/steps/reference.hpp>

namespace leadscrew::steps {
namespace test_reference {

/// Position after x periods of a motion with speed 30 and a jerk of 1 that turns to −1 at x = `turn`; BLU and periods.
double position(double x, double turn) {
  const double after = std::max(0.0, x - turn);
  return 30 * x + 2 * x * x + x * x * x / 6 - after * after * after / 3;
}

TEST(Reference, StraysByATwentiethOfJerkTimesPeriodCubed) {
  double worst = 0;
  for (double turn = -2; turn < 3; turn += 0.01) {
    double words[4];
    for (int k = 0; k < 4; ++k) words[k] = position(k - 1, turn);
    const Span span{words[1], words[2] - words[1], speed_between(words[1] - words[0], words[2] - words[1], 0),
                    speed_between(words[2] - words[1], words[3] - words[2], 0)};
    for (double x = 0; x <= 1; x += 0.01) {
      worst = std::max(worst, std::fabs(span.begin + span.displacement_at(x) - position(x, turn)));
    }
  }
  EXPECT_LT(worst, 1.0 / 20);
  EXPECT_GT(worst, 1.0 / 100);
}

TEST(Reference, RestsWhereWordsRest) {
  EXPECT_EQ(speed_between(5, 0, 100), 0);
  EXPECT_EQ(speed_between(0, -5, 100), 0);
}

TEST(Reference, TurnsSmoothlyWhereWordsDoAndAtTheWordWhereTheyDoNot) {
  EXPECT_EQ(speed_between(1, -0.5, 2), 0.25);
  EXPECT_EQ(speed_between(100, -50, 2), 0);
}

TEST(Reference, FindsWhereTheCubicTurns) {
  double at[2];
  const Span there_and_back{0, 0, 1, -1};
  ASSERT_EQ(turning_points(there_and_back, at), 1);
  EXPECT_NEAR(at[0], 0.5, 1e-15);
  const Span twice{0, 0.1, -1, -1};
  ASSERT_EQ(turning_points(twice, at), 2);
  EXPECT_NEAR(at[0] + at[1], 1, 1e-15);
  EXPECT_NEAR(twice.speed_at(at[0]), 0, 1e-15);
  EXPECT_EQ(turning_points({0, 1, 1, 1}, at), 0);
}

}  // namespace test_reference
}  // namespace leadscrew::steps
