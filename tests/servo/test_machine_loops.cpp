// Loops of a machine's axes: what is not told, and what is.

#include <gtest/gtest.h>
#include <leadscrew/servo/machine_loops.hpp>

#include <cmath>

namespace leadscrew::servo::testing {
namespace test_machine_loops {

/// The built-in mill with an encoder that is as good as exact.
machine::Machine finely_read() {
  machine::Machine machine = machine::mill3();
  for (machine::AxisDrive& drive : machine.drives) drive.encoder_counts = 1e9;
  return machine;
}

/// Error of X after a second of constant acceleration, or of constant speed.
double error_after_a_second(const machine::Machine& machine, double speed, double acceleration) {
  Servo servo = Servo::create(loops_of(machine), machine.period).value();
  double error = 0;
  const double period = machine.period.seconds();
  for (int k = 0; k * period < 1; ++k) {
    base::Word word;
    word.position[0] = speed * k * period + acceleration * k * period * k * period / 2;
    if (const auto followed = servo.follow(word)) error = followed->word.position[0] - followed->position[0];
  }
  return error;
}

TEST(MachineLoops, FollowWithoutErrorWhatIsFedForwardWhole) {
  for (const std::int64_t nanoseconds : {100'000, 1'000'000, 4'000'000}) {
    machine::Machine machine = finely_read();
    machine.period = {nanoseconds};
    EXPECT_NEAR(error_after_a_second(machine, 50, 0), 0, 1e-6) << nanoseconds;
    EXPECT_NEAR(error_after_a_second(machine, 0, 500), 0, 1e-5) << nanoseconds;
  }
}

TEST(MachineLoops, LagByTheirGainWithoutFeedForward) {
  machine::Machine machine = finely_read();
  machine.drives[0].velocity_forward = machine.drives[0].acceleration_forward = 0;
  EXPECT_NEAR(error_after_a_second(machine, 50, 0), 50.0 / 40, 1e-6);
  machine.drives[0].position_gain = 25;
  EXPECT_NEAR(error_after_a_second(machine, 50, 0), 50.0 / 25, 1e-6);
  EXPECT_DOUBLE_EQ(longest_lag(loops_of(machine)), 1.0 / 25);
  machine.drives[0].controller = machine::AxisDrive::Controller::pid;
  machine.drives[0].gain = 4;
  machine.drives[0].proportional = 5;
  EXPECT_NEAR(error_after_a_second(machine, 50, 0), 50.0 / 20, 1e-6);
  EXPECT_DOUBLE_EQ(longest_lag(loops_of(machine)), 1.0 / 20);
}

TEST(MachineLoops, KeepTheirGainsWithinWhatThePeriodAllows) {
  machine::Machine machine = machine::mill3();
  machine.period = {10'000'000};
  const auto cascade = std::get<CascadeOptions>(loops_of(machine)[0]->controller);
  EXPECT_DOUBLE_EQ(cascade.velocity_gain, 30);
  EXPECT_DOUBLE_EQ(cascade.position_gain, 6);
  EXPECT_LT(std::fabs(error_after_a_second(machine, 0, 500)), 1);
}

TEST(MachineLoops, HaveThePlayOfTheScrewAndTheCountsOfTheEncoder) {
  machine::Machine machine = machine::mill3();
  machine.screws[1].backlash = 0.03;
  machine.drives[1].encoder_counts = 2000;
  machine.drives[1].encoder = machine::AxisDrive::Encoder::slide;
  machine.drives[1].friction = 70;
  const ServoOptions options = loops_of(machine);
  EXPECT_EQ(options[0]->axis.backlash, 0);
  EXPECT_EQ(options[0]->axis.encoder_resolution, 0.001);
  EXPECT_EQ(options[0]->axis.command_limit, 2000);
  EXPECT_EQ(options[1]->axis.backlash, 0.03);
  EXPECT_EQ(options[1]->axis.encoder_resolution, 0.0005);
  EXPECT_EQ(options[1]->axis.friction, 70);
  EXPECT_EQ(options[1]->axis.encoder_place, EncoderPlace::slide);
  EXPECT_FALSE(options[3]);
}

}  // namespace test_machine_loops
}  // namespace leadscrew::servo::testing
