// Axes that follow words.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <cmath>
#include <leadscrew/servo/contour.hpp>
#include <leadscrew/servo/servo.hpp>
#include <vector>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_servo {

constexpr base::Period period{1'000'000};
constexpr double seconds = 1e-3;

LoopOptions proportional(double kv, double time_constant, double velocity_forward = 0) {
  return {{.drive = velocity_drive(1, time_constant)},
          PidOptions{.gains = {.proportional = kv}, .velocity_forward = velocity_forward}};
}

/// A line in X and Y from (5, −3) on; Z rises as well.
base::Word on_a_line(int k, double vx, double vy) {
  base::Word word;
  word.tick = base::Tick{k};
  word.position[0] = 5 + vx * k * seconds;
  word.position[1] = -3 + vy * k * seconds;
  word.position[2] = k;
  return word;
}

TEST(Servo, FollowsALineWithTheErrorOfItsGains) {
  ServoOptions options;
  options[0] = proportional(20, 0.02);
  options[1] = proportional(25, 0.02);
  Servo servo = Servo::create(options, period).value();
  Followed last;
  for (int k = 0; k < 4000; ++k) {
    if (const auto followed = servo.follow(on_a_line(k, 6, 8))) last = *followed;
  }
  EXPECT_EQ(base::count(last.word.tick), 3997);
  const double lag_x = last.word.position[0] - last.position[0], lag_y = last.word.position[1] - last.position[1];
  EXPECT_NEAR(lag_x, 6.0 / 20, 1e-9);
  EXPECT_NEAR(lag_y, 8.0 / 25, 1e-9);
  const double across = (lag_x * 8 - lag_y * 6) / 10;
  EXPECT_NEAR(across, line_contour_error(10, std::atan2(8.0, 6.0), {20, 0.02}, {25, 0.02}), 1e-9);
  EXPECT_EQ(last.position[2], 3997);  // has no loop
  EXPECT_EQ(servo.loop(base::Axis::Z), nullptr);
}

TEST(Servo, FeedsForwardFromTheWordsToCome) {
  ServoOptions options;
  options[0] = proportional(20, 0.02, 1);
  Servo servo = Servo::create(options, period).value();
  double error = 1;
  for (int k = 0; k < 4000; ++k) {
    if (const auto followed = servo.follow(on_a_line(k, 6, 8)))
      error = followed->word.position[0] - followed->position[0];
  }
  EXPECT_NEAR(error, 0, 1e-9);
}

/// Bit for bit what an axis loop alone does, two words later; and every word comes out again, in order.
TEST(Servo, IsItsAxisLoops) {
  ServoOptions options;
  options[0] = proportional(30, 0.01, 0.9);
  Servo servo = Servo::create(options, period).value();
  AxisLoop loop = pid_loop(options[0]->axis, std::get<PidOptions>(options[0]->controller), seconds);
  const auto at = [](int k) { return k < 500 ? std::sin(0.01 * k) : std::sin(5.0); };
  for (int k = 0; k < 502; ++k) {
    base::Word word;
    word.tick = base::Tick{k};
    word.position[0] = at(k);
    const auto followed = servo.follow(word);
    EXPECT_EQ(followed.has_value(), k >= 2);
    if (!followed) continue;
    EXPECT_EQ(base::count(followed->word.tick), k - 2);
    EXPECT_EQ(followed->position[0], loop.axis().slide());
    loop.follow(setpoint_of(at(k - 2), at(k - 1), at(k), seconds));
  }
}

TEST(Servo, RestsWhereItsFirstWordIsAndTakesNoMemory) {
  ServoOptions options;
  options[0] = proportional(20, 0.02);
  options[3] = {{.drive = velocity_drive(1, 0.02)}, CascadeOptions{.position_gain = 20, .velocity_gain = 1}};
  Servo servo = Servo::create(options, period).value();
  base::Word word;
  word.position[0] = 123.456;
  word.position[3] = -90;
  const auto before = testing_support::allocations();
  for (int k = 0; k < 100; ++k) {
    const auto followed = servo.follow(word);
    if (!followed) continue;
    ASSERT_EQ(followed->position, word.position);
  }
  EXPECT_EQ(testing_support::allocations(), before);
}

TEST(Servo, NamesTheAxisThatIsWrong) {
  ServoOptions options;
  options[1] = proportional(20, 0.02);
  options[1]->axis.backlash = -1;
  EXPECT_EQ(Servo::create(options, period).error().message, "axis Y: backlash is -1");
  options[1]->axis.backlash = 0;
  options[1]->controller = CascadeOptions{};
  const auto made = Servo::create(options, period);
  EXPECT_EQ(made.error().code, "servo-controller");
  EXPECT_EQ(made.error().message, "axis Y: the gain of the position loop is 0");
}

}  // namespace test_servo
}  // namespace leadscrew::servo::testing
