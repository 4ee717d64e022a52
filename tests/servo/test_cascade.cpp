// The cascade of position and velocity loops: its law, its following errors, its limit, and loops with play and
// friction.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random_numbers.hpp>
#include <vector>

#include "loops.hpp"
#include "runge_kutta.hpp"

namespace leadscrew::servo::testing {
namespace test_cascade {

using testing_support::any;
using testing_support::logarithmic;

AxisLoop cascade_loop(const AxisOptions& axis, const CascadeOptions& cascade, double period) {
  return {SimulatedAxis::create(axis).value(), Cascade::create(cascade, period).value(), period};
}

RC_GTEST_PROP(Cascade, ClosesTheLoopAsItsLawSays, ()) {
  const double period = 1e-3;
  const AxisOptions axis{.drive = {logarithmic(50, 1000), any(0, 2) * logarithmic(1, 50)}};
  const double share = any(0, 101) / 100.0;
  const CascadeOptions options{.position_gain = logarithmic(5, 60),
                               .velocity_gain = logarithmic(0.05, 0.8) / (axis.drive.acceleration * period),
                               .integral_gain = any(0, 2) * logarithmic(0.01, 1),
                               .velocity_forward = share,
                               .acceleration_forward = any(0, 3) * 1e-3};
  AxisLoop loop = cascade_loop(axis, options, period);
  SmallSteps reference(axis);
  std::vector<long double> missing;
  long double last = 0, farthest = 0;
  for (int k = 0; k < 200; ++k) {
    const double wanted = 3 * std::sin(0.05 * k), speed = 150 * std::cos(0.05 * k);
    const double acceleration = -7500 * std::sin(0.05 * k);
    loop.follow({wanted, speed, acceleration});
    missing.push_back(options.position_gain * (wanted - reference.position) + share * speed -
                      (reference.position - last) / period);
    last = reference.position;
    long double sum = 0;
    for (const long double each : missing) sum += each;
    const long double command = options.velocity_gain * missing.back() + options.integral_gain * period * sum +
                                options.acceleration_forward * acceleration;
    reference.advance(static_cast<double>(command), period, 20);
    farthest = std::max(farthest, std::fabs(reference.position));
    RC_ASSERT(std::fabs(loop.axis().screw().position - reference.position) <= 1e-6 * farthest);
    if (farthest > 1e6) break;
  }
}

struct Ramp {
  double error = 0;  ///< mm, in the end
  double speed = 0;  ///< mm/s
};

/// 5 s at 20 mm/s on a drive of 500 mm/s² for a unit of command.
Ramp on_a_ramp(double velocity_forward, double integral_gain) {
  const double period = 1e-3;
  AxisLoop loop = cascade_loop(
      {.drive = {500, 2}},
      {.position_gain = 20, .velocity_gain = 0.4, .integral_gain = integral_gain, .velocity_forward = velocity_forward},
      period);
  Ramp ramp;
  for (int k = 0; k < 5000; ++k) {
    ramp = {20 * k * period - loop.axis().slide(), loop.axis().screw().velocity};
    loop.follow({20 * k * period, 20});
  }
  return ramp;
}

/// The integral makes the velocity what is wanted: w = Kv·e + share·V = V.
TEST(Cascade, LagsByWhatIsNotFedForward) {
  EXPECT_NEAR(on_a_ramp(0, 10).error, 20.0 / 20, 1e-9);
  EXPECT_NEAR(on_a_ramp(0.75, 10).error, 5.0 / 20, 1e-9);
  EXPECT_NEAR(on_a_ramp(1, 10).error, 0, 1e-9);
  // Without it the damping takes 2·V/500 units of command, and those another 1/P of velocity.
  EXPECT_NEAR(on_a_ramp(1, 0).error, 2 * 20.0 / 500 / 0.4 / 20, 1e-9);
}

/// Greatest distance past the end of a long step that is travelled at the command's limit.
double overshoot(double travel, double limit) {
  AxisLoop loop = cascade_loop({.drive = velocity_drive(10, 0.02), .command_limit = limit},
                               {.position_gain = 10, .velocity_gain = 0.5, .integral_gain = 10, .limit = limit}, 1e-3);
  double past = 0;
  for (int k = 0; k < 40000; ++k) {
    loop.follow({travel});
    past = std::max(past, loop.axis().slide() - travel);
  }
  EXPECT_NEAR(loop.axis().slide(), travel, 1e-6);
  return past;
}

TEST(Cascade, DoesNotWindUp) {
  EXPECT_NEAR(overshoot(200, 1), overshoot(50, 1), 1e-3);
  EXPECT_LT(overshoot(50, 1), 0.5);
}

/// Measured at the screw, the slide lies half the play off, on the side it came from; measured at the slide, it does
/// not.
TEST(LoopsWithPlay, EndWhereTheEncoderIs) {
  for (const EncoderPlace place : {EncoderPlace::screw, EncoderPlace::slide}) {
    AxisOptions axis{.drive = velocity_drive(1, 0.01), .friction = 5, .backlash = 0.1, .encoder_place = place};
    AxisLoop loop = pid_loop(axis, {.gains = {20, 0, 0}}, 1e-3);
    for (int k = 0; k < 3000; ++k) loop.follow({5});
    const double stuck = 5 * 0.01 / 20;  // friction holds what pulls less: K·P·e/τ = 5
    const double off = place == EncoderPlace::screw ? 0.05 : 0;
    EXPECT_NEAR(loop.axis().slide(), 5 - off, stuck + 1e-9);
    for (int k = 0; k < 3000; ++k) loop.follow({2});
    EXPECT_NEAR(loop.axis().slide(), 2 + off, stuck + 1e-9);
  }
}

/// Between two counts a loop sees nothing, so that it may rest anywhere within one.
TEST(LoopsWithCounts, RestWithinHalfACount) {
  AxisLoop loop = pid_loop({.drive = velocity_drive(1, 0.01), .encoder_resolution = 0.01}, {.gains = {20, 0, 0}}, 1e-3);
  for (int k = 0; k < 3000; ++k) loop.follow({1.23});
  EXPECT_NEAR(loop.axis().slide(), 1.23, 0.005 + 1e-9);
  EXPECT_NEAR(loop.axis().screw().velocity, 0, 1e-12);
  EXPECT_NE(loop.axis().slide(), loop.axis().reading());
}

std::string refusal(const CascadeOptions& options) {
  const auto cascade = Cascade::create(options, 1e-3);
  return cascade ? "" : std::string(cascade.error().code) + ": " + cascade.error().message;
}

TEST(Cascade, SaysWhichOptionIsWrong) {
  EXPECT_EQ(refusal({.position_gain = 20, .velocity_gain = 1}), "");
  EXPECT_EQ(refusal({.position_gain = 0, .velocity_gain = 1}), "servo-controller: the gain of the position loop is 0");
  EXPECT_EQ(refusal({.position_gain = 20}), "servo-controller: the gain of the velocity loop is 0");
  EXPECT_EQ(refusal({.position_gain = 20, .velocity_gain = 1, .integral_gain = -1}),
            "servo-controller: the integral gain is -1");
  EXPECT_EQ(refusal({.position_gain = 20, .velocity_gain = 1, .velocity_forward = 2}),
            "servo-controller: the share of velocity fed forward is 2");
}

}  // namespace test_cascade
}  // namespace leadscrew::servo::testing
