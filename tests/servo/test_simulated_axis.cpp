// What an axis does under commands, held beside small steps of integration and what each of its options promises.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/servo/simulated_axis.hpp>
#include <random_numbers.hpp>
#include <vector>

#include "runge_kutta.hpp"

namespace leadscrew::servo::testing {
namespace test_simulated_axis {

using testing_support::any;
using testing_support::logarithmic;

SimulatedAxis made(const AxisOptions& options) {
  return SimulatedAxis::create(options).value();
}

Drive any_drive() {
  if (any(0, 5) == 0) return {logarithmic(1, 1e4), 0};  // a mass that is pushed
  return velocity_drive(logarithmic(0.5, 100), logarithmic(1e-3, 1));
}

double any_command() {
  return any(0, 6) == 0 ? 0 : any(-1000, 1001) / 100.0;
}

RC_GTEST_PROP(SimulatedAxis, AgreesWithRungeAndKuttaUnderHeldCommands, ()) {
  AxisOptions options{.drive = any_drive()};
  if (any(0, 3) == 0) options.command_limit = logarithmic(0.1, 10);
  SimulatedAxis axis = made(options);
  SmallSteps reference(options);
  double farthest = 0, fastest = 0;
  for (int k = 0; k < 30; ++k) {
    const double command = any_command(), seconds = logarithmic(1e-4, 0.1);
    axis.advance(command, seconds);
    reference.advance(command, seconds, 20 + static_cast<int>(60 * seconds * options.drive.damping));
    farthest = std::max(farthest, static_cast<double>(std::fabs(reference.position)));
    fastest = std::max(fastest, static_cast<double>(std::fabs(reference.velocity)));
    RC_ASSERT(std::fabs(axis.screw().position - reference.position) <= 1e-7 * farthest);
    RC_ASSERT(std::fabs(axis.screw().velocity - reference.velocity) <= 1e-7 * fastest);
    RC_ASSERT(axis.slide() == axis.screw().position);
    RC_ASSERT(axis.reading() == axis.screw().position);
  }
}

/// Also where d·t is so small that differences of near equals would show, and where it is so large that nothing is
/// left.
TEST(SimulatedAxis, HoldIntegralsAreThoseOfTheirSeries) {
  for (double damping : {1e-12, 1e-6, 0.1, 0.2499, 0.2501, 1.0, 3.0}) {
    long double first = 0, second = 0, term = 1;  // of t = 1
    for (int k = 1; k < 60; ++k) {
      first += term / k;
      second += term / k / (k + 1);
      term *= -static_cast<long double>(damping) / k;
    }
    const HoldIntegrals got = hold_integrals(damping, 1);
    EXPECT_NEAR(got.first, static_cast<double>(first), 1e-15) << damping;
    EXPECT_NEAR(got.second, static_cast<double>(second), 1e-15) << damping;
  }
  EXPECT_DOUBLE_EQ(hold_integrals(1e3, 1).first, 1e-3);
  EXPECT_DOUBLE_EQ(hold_integrals(1e3, 1).second, 1e-3 - 1e-6);
}

TEST(SimulatedAxis, ReachesItsGainAsTheTimeConstantSays) {
  SimulatedAxis axis = made({.drive = velocity_drive(10, 0.02)});
  axis.advance(3, 0.02);
  EXPECT_NEAR(axis.screw().velocity, 30 * (1 - std::exp(-1.0)), 1e-12);
  axis.advance(3, 2);
  EXPECT_NEAR(axis.screw().velocity, 30, 1e-12);
  EXPECT_NEAR(axis.screw().position, 30 * (2.02 - 0.02), 1e-10);
}

/// 2 A·0.5 N·m/A on 0.01 kg·m²: 100 rad/s²; a screw of 10 mm.
TEST(SimulatedAxis, OfACurrentMotorAcceleratesByTorqueOverInertia) {
  const double per_radian = 10 / (2 * 3.14159265358979323846);
  const CurrentMotor motor{
      .amplifier = 2, .torque_constant = 0.5, .inertia = 0.01, .viscous_friction = 0, .travel_per_radian = per_radian};
  SimulatedAxis axis = made({.drive = current_drive(motor), .command_limit = 3});
  axis.advance(8, 0.1);  // limited to 3
  EXPECT_NEAR(axis.screw().velocity, 300 * per_radian * 0.1, 1e-9);
  EXPECT_NEAR(axis.screw().position, 300 * per_radian * 0.005, 1e-9);
  EXPECT_NEAR(acceleration_of(1, motor), 100 * per_radian, 1e-9);
  EXPECT_NEAR(reflected_inertia(500, per_radian), 500 * 1e-6 * per_radian * per_radian, 1e-15);
}

RC_GTEST_PROP(SimulatedAxis, WithFrictionAndPlayAgreesWithSmallSteps, ()) {
  AxisOptions options{.drive = velocity_drive(logarithmic(1, 20), logarithmic(0.01, 0.1))};
  options.friction = options.drive.acceleration * logarithmic(0.01, 3);
  if (any(0, 2) == 0) options.breakaway = options.friction * logarithmic(1, 3);
  options.backlash = logarithmic(1e-3, 0.3);
  SimulatedAxis axis = made(options);
  SmallSteps reference(options);
  // The chord of a step finds a stop to within the square of the step.
  const double pull = 20 * options.drive.acceleration;
  double bound = 1e-9;
  for (int k = 0; k < 6; ++k) {
    const double command = any_command(), seconds = logarithmic(1e-3, 0.05);
    axis.advance(command, seconds);
    reference.advance(command, seconds, 2000);
    bound += pull * std::pow(seconds / 2000, 2);
    RC_ASSERT(std::fabs(axis.screw().position - reference.position) <= bound);
    RC_ASSERT(std::fabs(axis.slide() - reference.slide) <= bound);
  }
}

TEST(AxisFriction, HoldsBelowBreakawayAndBrakesFromThere) {
  const AxisOptions options{.drive = velocity_drive(10, 0.02), .friction = 1000, .breakaway = 1500};
  SimulatedAxis axis = made(options);
  axis.advance(3, 10);  // pulls 1500 mm/s²
  EXPECT_EQ(axis.screw().position, 0);
  EXPECT_EQ(axis.screw().velocity, 0);
  axis.advance(3.001, 10);  // in the long run (1500.5 − 1000)·τ
  EXPECT_NEAR(axis.screw().velocity, 500.5 * 0.02, 1e-9);
  axis.advance(-3.001, 10);
  EXPECT_NEAR(axis.screw().velocity, -500.5 * 0.02, 1e-9);
  axis.advance(0, 10);
  EXPECT_EQ(axis.screw().velocity, 0);
}

/// v(t) = 0 of v′ = −c − d·v: t = τ·ln(1 + v/(c·τ)); and what it travels until then.
TEST(AxisFriction, StopsWhereTheClosedFormSays) {
  SimulatedAxis axis = made({.drive = velocity_drive(10, 0.02), .friction = 400});
  axis.advance(5, 10);
  const double v = 50 - 400 * 0.02, begin = axis.screw().position;
  axis.advance(0, 10);
  const double t = 0.02 * std::log(1 + v / (400 * 0.02));
  EXPECT_NEAR(axis.screw().position - begin, -400 * 0.02 * t + 0.02 * v, 1e-11);
}

RC_GTEST_PROP(AxisFriction, NeverGivesEnergy, ()) {
  AxisOptions options{.drive = any_drive(), .friction = any(0, 2) * logarithmic(1, 1000)};
  options.breakaway = any(0, 2) * logarithmic(1, 1000);
  options.backlash = any(0, 2) * logarithmic(1e-3, 1);
  SimulatedAxis axis = made(options);
  axis.advance(any_command(), 0.05);
  double speed = std::fabs(axis.screw().velocity);
  for (int k = 0; k < 50; ++k) {
    const double position = axis.screw().position;
    axis.advance(0, logarithmic(1e-5, 0.05));
    RC_ASSERT(std::fabs(axis.screw().velocity) <= speed);
    if (speed == 0) RC_ASSERT(axis.screw().position == position);
    speed = std::fabs(axis.screw().velocity);
  }
}

TEST(AxisBacklash, SlideLagsByThePlayAfterEachReversal) {
  SimulatedAxis axis = made({.drive = velocity_drive(1, 0.01), .backlash = 0.08});
  axis.advance(2, 1);
  EXPECT_DOUBLE_EQ(axis.slide(), axis.screw().position - 0.04);
  const double forward = axis.slide();
  axis.advance(-2, 0.01);  // turned back within the play: the slide keeps the place where the screw turned
  const double turned = axis.slide();
  EXPECT_GT(turned, forward);
  axis.advance(-2, 0.02);
  EXPECT_EQ(axis.slide(), turned);
  axis.advance(-2, 1);
  EXPECT_DOUBLE_EQ(axis.slide(), axis.screw().position + 0.04);
}

/// Measured at the slide, a quantised loop of the same play sees it; measured at the screw it does not.
TEST(AxisBacklash, ShowsInReadingsOfTheSlideAlone) {
  AxisOptions options{.drive = velocity_drive(1, 0.01), .backlash = 0.08};
  SimulatedAxis at_screw = made(options);
  options.encoder_place = EncoderPlace::slide;
  SimulatedAxis at_slide = made(options);
  for (SimulatedAxis* axis : {&at_screw, &at_slide}) axis->advance(2, 1);
  EXPECT_EQ(at_screw.reading(), at_screw.screw().position);
  EXPECT_EQ(at_slide.reading(), at_slide.screw().position - 0.04);
}

TEST(AxisEncoder, ReadsTheNearestMultiple) {
  AxisOptions options{.drive = {1, 0}, .encoder_resolution = 0.01};
  for (const double command : {1.0, -1.0}) {
    SimulatedAxis axis = made(options);
    for (int k = 0; k < 400; ++k) {
      axis.advance(command, 1e-3);
      const double counts = axis.reading() / 0.01;
      EXPECT_NEAR(counts, std::round(counts), 1e-9);
      EXPECT_LE(std::fabs(axis.reading() - axis.screw().position), 0.005 + 1e-12);
    }
    EXPECT_NEAR(axis.reading(), command * 0.08, 1e-12);
  }
}

std::string refusal(const AxisOptions& options) {
  const auto axis = SimulatedAxis::create(options);
  return axis ? "" : std::string(axis.error().code) + ": " + axis.error().message;
}

TEST(SimulatedAxis, SaysWhichOptionIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({.drive = {1, 0}}), "");
  EXPECT_EQ(refusal({.drive = {0, 1}}), "servo-axis: the drive's acceleration for one unit of command is 0");
  EXPECT_EQ(refusal({.drive = {1, nan}}), "servo-axis: the drive's damping is nan");
  EXPECT_EQ(refusal({.drive = {1, 1}, .command_limit = 0}), "servo-axis: the limit of the command is 0");
  EXPECT_EQ(refusal({.drive = {1, 1}, .friction = -1}), "servo-axis: friction is -1");
  EXPECT_EQ(refusal({.drive = {1, 1}, .breakaway = -1}), "servo-axis: breakaway is -1");
  EXPECT_EQ(refusal({.drive = {1, 1}, .backlash = -2}), "servo-axis: backlash is -2");
  EXPECT_EQ(refusal({.drive = {1, 1}, .encoder_resolution = -0.5}), "servo-axis: the encoder's resolution is -0.5");
}

}  // namespace test_simulated_axis
}  // namespace leadscrew::servo::testing
