// Following errors, overshoot and measured feed of motions that are known.

#include <gtest/gtest.h>
#include <leadscrew/servo/tracking.hpp>

#include <cmath>

namespace leadscrew::servo::testing {
namespace test_tracking {

base::AxisSet axes(std::initializer_list<base::Axis> list) {
  base::AxisSet set;
  for (const base::Axis axis : list) set.insert(axis);
  return set;
}

constexpr base::Period period = {1'000'000};

Followed followed(double commanded, double actual, double velocity = 0) {
  Followed result;
  result.word.position[0] = commanded;
  result.position[0] = actual;
  result.velocity[0] = velocity;
  result.word.feed = 3;
  result.word.state = base::MotionState::changing;
  return result;
}

TEST(Tracking, TellsGreatestAndRootMeanSquareOfTheError) {
  Tracking tracking(axes({base::Axis::X}), period);
  for (const double error : {0.0, 0.3, -0.4, 0.0}) tracking.observe(followed(1, 1 - error));
  EXPECT_DOUBLE_EQ(tracking.axis(base::Axis::X).greatest, 0.4);
  EXPECT_DOUBLE_EQ(tracking.axis(base::Axis::X).rms, 0.25);
  EXPECT_EQ(tracking.axis(base::Axis::Y).greatest, 0);
}

/// Only where the axis stands, only beyond the place and in the direction it came from.
TEST(Tracking, CountsAsOvershootWhatIsBeyondAStop) {
  Tracking tracking(axes({base::Axis::X}), period);
  const auto overshoot = [&] { return tracking.axis(base::Axis::X).overshoot; };
  tracking.observe(followed(0, 9));  // before any motion
  tracking.observe(followed(1, 2));  // in motion
  EXPECT_EQ(overshoot(), 0);
  tracking.observe(followed(1, 0.5));
  EXPECT_EQ(overshoot(), 0);
  tracking.observe(followed(1, 1.25));
  EXPECT_EQ(overshoot(), 0.25);
  tracking.observe(followed(-1, 0));
  tracking.observe(followed(-1, 0));
  EXPECT_EQ(overshoot(), 0.25);
  tracking.observe(followed(-1, -1.5));
  EXPECT_EQ(overshoot(), 0.5);
}

TEST(Tracking, MeasuresFeedByTheLinearAxes) {
  Tracking tracking(axes({base::Axis::X, base::Axis::Y, base::Axis::A}), period);
  Followed turning = followed(0, 0, 3);
  turning.velocity = {3, -4, 0, 90};
  tracking.observe(turning);
  EXPECT_DOUBLE_EQ(tracking.measured_feed(), 5);
  tracking.observe(followed(1, 1, 1));
  Followed rest = followed(1, 1, 7);
  rest.word.state = base::MotionState::rest;
  tracking.observe(rest);
  EXPECT_DOUBLE_EQ(tracking.feed().measured_max, 7);
  EXPECT_DOUBLE_EQ(tracking.feed().measured_mean, 3);
  EXPECT_DOUBLE_EQ(tracking.feed().commanded_max, 3);
  Tracking rotary(axes({base::Axis::A}), period);
  rotary.observe(turning);
  EXPECT_DOUBLE_EQ(rotary.measured_feed(), 90);
}

/// Both feeds are of the linear axes: of words that turn A alone, whose feed is in degrees/s, there is none.
TEST(Tracking, CommandsNoFeedWhereRotaryAxesAloneAreFed) {
  Tracking tracking(axes({base::Axis::X, base::Axis::A}), period);
  Followed turning = followed(0, 0);
  for (int k = 0; k < 4; ++k) {
    turning.word.position[3] += 0.09;
    turning.velocity = {0, 0, 0, 90};
    turning.word.feed = 90;
    tracking.observe(turning);
  }
  EXPECT_EQ(tracking.feed().commanded_max, 0);
  EXPECT_EQ(tracking.feed().measured_max, 0);
  turning.word.position[0] += 0.002;
  turning.word.feed = 2;
  tracking.observe(turning);
  EXPECT_DOUBLE_EQ(tracking.feed().commanded_max, 2);
}

/// Where feed is the tip's, both are, however fast the axes go for it.
TEST(Tracking, TellsTheFeedOfTheTip) {
  Tracking tracking(axes({base::Axis::X, base::Axis::A}), period);
  tracking.observe(followed(0, 0, 40), TipMotion{});
  tracking.observe(followed(0.04, 0.04, 40), TipMotion{0.003, 3.5});
  EXPECT_DOUBLE_EQ(tracking.feed().commanded_max, 3);
  EXPECT_DOUBLE_EQ(tracking.measured_feed(), 3.5);
  EXPECT_DOUBLE_EQ(tracking.feed().measured_max, 3.5);
}

}  // namespace test_tracking
}  // namespace leadscrew::servo::testing
