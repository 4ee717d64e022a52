// Axes under pulse-driven loops that follow the steps of words.

#include <gtest/gtest.h>
#include <leadscrew/servo/pulse_servo.hpp>

#include <cmath>

namespace leadscrew::servo::testing {
namespace test_pulse_servo {

/// From rest to `speed` in a tenth of a second and on; X and half of it in Y.
base::Word moving(const machine::Machine& machine, int k, double speed) {
  const double t = k * machine.period.seconds(), ramp = 0.1;
  const double travel = t < ramp ? speed * t * t / (2 * ramp) : speed * (t - ramp / 2);
  base::Word word;
  word.tick = base::Tick{k};
  word.position = {2 + travel, -1 - travel / 2, 3};
  return word;
}

/// UDC = f/Kv, and the slide lags V/Kv, within the pulse that steps and encoder are coarse.
TEST(PulseServo, LagsByTheCounterOverTheGain) {
  machine::Machine machine = machine::mill3();
  machine.drives[0].position_gain = 25;
  PulseServo servo = PulseServo::create(machine).value();
  EXPECT_DOUBLE_EQ(servo.longest_lag(), 1.0 / 25);
  Followed last;
  for (int k = 0; k < 2000; ++k) {
    if (const auto followed = servo.follow(moving(machine, k, 20))) last = *followed;
  }
  EXPECT_EQ(base::count(last.word.tick), 1998);
  EXPECT_NEAR(last.word.position[0] - last.position[0], 20.0 / 25, 1.5e-3);
  EXPECT_NEAR(last.word.position[1] - last.position[1], -10.0 / 40, 1.5e-3);
  EXPECT_NEAR(static_cast<double>(servo.loop(base::Axis::X)->following_error()), 20.0 / 25 / 0.001, 2);
  EXPECT_NEAR(last.velocity[0], 20, 0.02);
  EXPECT_NEAR(last.position[2], 3, 1e-12);
  EXPECT_EQ(servo.loop(base::Axis::A), nullptr);
}

/// Commands and encoder pulses are equal when all is at rest, there and back.
TEST(PulseServo, LosesNoPulse) {
  const machine::Machine machine = machine::mill3();
  PulseServo servo = PulseServo::create(machine).value();
  std::vector<base::Word> words;
  for (int k = 0; k < 800; ++k) words.push_back(moving(machine, k, 30));
  for (int k = 799; k >= 0; --k) words.push_back(moving(machine, k, 30));
  for (int k = 0; k < 1000; ++k) words.push_back(words.back());
  Followed last;
  for (std::size_t k = 0; k < words.size(); ++k) {
    words[k].tick = base::Tick{static_cast<std::int64_t>(k)};
    if (const auto followed = servo.follow(words[k])) last = *followed;
  }
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
    const PulseLoop& loop = *servo.loop(axis);
    EXPECT_EQ(loop.commanded(), 0);
    EXPECT_EQ(loop.encoder_count(), 0);
    EXPECT_EQ(loop.lost(), 0);
    EXPECT_EQ(loop.following_error(), 0);
  }
  EXPECT_NEAR(last.position[0], 2, 1e-3);
  EXPECT_NEAR(last.velocity[0], 0, 1e-3);
}

TEST(PulseServo, RefusesWhatTheStepClockCannotGive) {
  machine::Machine machine = machine::mill3();
  machine.axes[0]->blu = 1e-5;
  const auto servo = PulseServo::create(machine);
  ASSERT_FALSE(servo);
  EXPECT_EQ(servo.error().code, "step-rate");
}

}  // namespace test_pulse_servo
}  // namespace leadscrew::servo::testing
