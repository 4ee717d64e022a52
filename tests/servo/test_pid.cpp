// Closed loops of PID controllers, held beside small steps of integration and what feed-forward and windup are known
// for.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random_numbers.hpp>
#include <vector>

#include "loops.hpp"
#include "runge_kutta.hpp"

namespace leadscrew::servo::testing {
namespace test_pid {

using testing_support::any;
using testing_support::logarithmic;

/// The law as it is written, with every error kept.
class WrittenLaw {
 public:
  WrittenLaw(const PidOptions& options, double period) : options_(options), period_(period) {}

  long double command(const Setpoint& setpoint, long double reading) {
    errors_.push_back(setpoint.position - reading);
    long double sum = 0;
    for (const long double error : errors_) sum += error;
    const long double before = errors_.size() > 1 ? errors_[errors_.size() - 2] : 0;
    const long double divisor = options_.form == PidForm::standard ? period_ : 1;
    return options_.gains.proportional * errors_.back() + options_.gains.integral * period_ * sum +
           options_.gains.derivative * (errors_.back() - before) / divisor +
           options_.velocity_forward * setpoint.velocity + options_.acceleration_forward * setpoint.acceleration;
  }

 private:
  PidOptions options_;
  long double period_;
  std::vector<long double> errors_;
};

/// Step, ramp and sine in one.
Setpoint wanted_at(double time, double step, double speed, double swing) {
  return {step + speed * time + swing * std::sin(20 * time), speed + 20 * swing * std::cos(20 * time),
          -400 * swing * std::sin(20 * time)};
}

RC_GTEST_PROP(Pid, ClosesTheLoopAsItsLawSays, ()) {
  const double period = logarithmic(1e-3, 0.02);
  const AxisOptions axis{.drive = velocity_drive(logarithmic(1, 25), logarithmic(0.01, 0.1))};
  PidOptions options{
      .gains = {logarithmic(0.2, 8), any(0, 2) * logarithmic(0.5, 50), any(0, 2) * logarithmic(0.5, 25)}};
  if (any(0, 2) == 0) {
    options.form = PidForm::standard;
    options.gains.derivative *= period;
  }
  options.velocity_forward = any(0, 2) * logarithmic(1e-3, 0.2);
  options.acceleration_forward = any(0, 2) * logarithmic(1e-5, 1e-2);
  const double step = any(-100, 101) / 10.0, speed = any(-100, 101) / 10.0, swing = any(0, 100) / 100.0;

  AxisLoop loop = pid_loop(axis, options, period);
  WrittenLaw law(options, period);
  SmallSteps reference(axis);
  double farthest = 0, fastest = 0;
  for (int k = 0; k < 150; ++k) {
    const Setpoint setpoint = wanted_at(k * period, step, speed, swing);
    loop.follow(setpoint);
    const auto command = static_cast<double>(law.command(setpoint, reference.position));
    reference.advance(command, period, 20 + static_cast<int>(60 * period * axis.drive.damping));
    farthest = std::max(farthest, static_cast<double>(std::fabs(reference.position)));
    fastest = std::max(fastest, static_cast<double>(std::fabs(reference.velocity)));
    RC_ASSERT(std::fabs(loop.axis().screw().position - reference.position) <= 1e-6 * farthest);
    RC_ASSERT(std::fabs(loop.axis().screw().velocity - reference.velocity) <= 1e-6 * fastest);
    if (farthest > 1e9) break;  // random gains need not be stable
  }
}

TEST(Pid, PublishedAndStandardFormsDifferByThePeriodUnderD) {
  const double period = 0.01;
  Pid published = Pid::create({.gains = {2, 2, 15}}, period).value();
  Pid standard = Pid::create({.gains = {2, 2, 0.15}, .form = PidForm::standard}, period).value();
  for (int k = 0; k < 20; ++k) {
    const double error = std::sin(k);
    EXPECT_NEAR(published.command({error}, 0), standard.command({error}, 0), 1e-12);
  }
  Pid first = Pid::create({.gains = {2, 2, 15}}, period).value();
  EXPECT_DOUBLE_EQ(first.command({1}, 0), 2 + 2 * period + 15);
  EXPECT_DOUBLE_EQ(first.command({1.5}, 0), 2 * 1.5 + 2 * period * 2.5 + 15 * 0.5);
}

double error_on_a_ramp(const PidOptions& options, double speed) {
  const double period = 1e-3;
  AxisLoop loop = pid_loop({.drive = velocity_drive(10, 0.02)}, options, period);
  double error = 0;
  for (int k = 0; k < 5000; ++k) {
    error = k * period * speed - loop.axis().screw().position;
    loop.follow({k * period * speed, speed});
  }
  return error;
}

/// V/Kv without; nothing with 1/K, and nothing with an integral.
TEST(Pid, VelocityFedForwardTakesAwayTheFollowingError) {
  const double speed = 5, kv = 30;
  EXPECT_NEAR(error_on_a_ramp({.gains = {3, 0, 0}}, speed), speed / kv, 1e-9);
  EXPECT_NEAR(error_on_a_ramp({.gains = {3, 0, 0}, .velocity_forward = 0.1}, speed), 0, 1e-9);
  EXPECT_NEAR(error_on_a_ramp({.gains = {3, 30, 0}}, speed), 0, 1e-9);
}

/// Rest to rest along a cubic: what is fed forward is K·u = v + τ·a, of the middle of the period that begins.
TEST(Pid, AccelerationFedForwardTakesAwayMostOfTheRest) {
  const double period = 1e-3, gain = 10, lag = 0.02, travel = 50, duration = 1;
  const auto error_with = [&](double velocity, double acceleration) {
    AxisLoop loop =
        pid_loop({.drive = velocity_drive(gain, lag)},
                 {.gains = {3, 0, 0}, .velocity_forward = velocity, .acceleration_forward = acceleration}, period);
    const auto at = [&](int k) {
      const double t = std::min(k * period / duration, 1.0);
      return travel * t * t * t * (10 - 15 * t + 6 * t * t);
    };
    double worst = 0;
    for (int k = 0; k < 1200; ++k) {
      worst = std::max(worst, std::fabs(at(k) - loop.axis().screw().position));
      loop.follow(setpoint_of(at(k), at(k + 1), at(k + 2), period));
    }
    return worst;
  };
  const double none = error_with(0, 0), velocity = error_with(1 / gain, 0), both = error_with(1 / gain, lag / gain);
  EXPECT_GT(none, 2);
  EXPECT_LT(velocity, none / 10);
  EXPECT_LT(both, velocity / 10);
}

struct Answer {
  double overshoot = 0;   ///< mm
  double last_error = 0;  ///< mm
};

Answer answer_to_a_step(AntiWindup anti_windup, double travel, double limit) {
  const double period = 1e-3;
  const PidOptions options{
      .gains = {4, 20, 0.1}, .form = PidForm::standard, .limit = limit, .anti_windup = anti_windup};
  const auto pid = Pid::create(options, period).value();
  AxisLoop loop(SimulatedAxis::create({.drive = velocity_drive(10, 0.02), .command_limit = limit}).value(), pid,
                period);
  Answer answer;
  for (int k = 0; k < 60000; ++k) {
    loop.follow({travel});
    answer.overshoot = std::max(answer.overshoot, loop.axis().screw().position - travel);
    answer.last_error = travel - loop.axis().screw().position;
  }
  return answer;
}

/// The longer the command is at its limit, the more an unguarded integral overshoots; a guarded one not a bit.
TEST(PidWindup, IsKeptFromGrowingWithTheTimeAtTheLimit) {
  const Answer small = answer_to_a_step(AntiWindup::conditional, 0.01, 1);  // never at its limit
  const Answer guarded = answer_to_a_step(AntiWindup::conditional, 50, 1);
  const Answer longer = answer_to_a_step(AntiWindup::conditional, 200, 1);
  const Answer unguarded = answer_to_a_step(AntiWindup::none, 50, 1);
  EXPECT_NEAR(guarded.last_error, 0, 1e-6);
  EXPECT_NEAR(small.last_error, 0, 1e-9);
  EXPECT_LT(guarded.overshoot, 0.2);
  EXPECT_NEAR(longer.overshoot, guarded.overshoot, 0.05);
  EXPECT_GT(unguarded.overshoot, 20 * guarded.overshoot);
}

/// P and D are 0, I·T = 1/8: up to the limit of 1 it sums eight errors, and no ninth; one that leads back it does.
TEST(PidWindup, StopsTheSumAtTheLimitAndLetsItReturn) {
  Pid pid = Pid::create({.gains = {0, 1, 0}, .velocity_forward = 1, .limit = 1}, 0.125).value();
  for (int k = 0; k < 20; ++k) pid.command({1}, 0);
  EXPECT_EQ(pid.sum(), 8);
  EXPECT_EQ(pid.command({.position = 1, .velocity = 5}, 0), 1);
  EXPECT_EQ(pid.sum(), 8);
  EXPECT_EQ(pid.command({.position = -1, .velocity = 5}, 0), 1);  // at its limit still, by what is fed forward
  EXPECT_EQ(pid.sum(), 7);
  EXPECT_EQ(pid.command({.position = -1, .velocity = -5}, 0), -1);
  EXPECT_EQ(pid.sum(), 7);
}

TEST(PidWindup, GuardChangesNothingBelowTheLimit) {
  Pid guarded = Pid::create({.gains = {2, 30, 5}, .limit = 100}, 0.01).value();
  Pid unguarded = Pid::create({.gains = {2, 30, 5}, .limit = 100, .anti_windup = AntiWindup::none}, 0.01).value();
  for (int k = 0; k < 200; ++k) {
    const double error = std::sin(0.1 * k);
    EXPECT_EQ(guarded.command({error}, 0), unguarded.command({error}, 0));
  }
}

RC_GTEST_PROP(Pid, NeverExceedsItsLimit, ()) {
  const double limit = logarithmic(0.1, 10);
  Pid pid = Pid::create({.gains = {logarithmic(0.1, 10), logarithmic(0.1, 50), logarithmic(0.1, 25)},
                         .limit = limit,
                         .anti_windup = any(0, 2) == 0 ? AntiWindup::none : AntiWindup::conditional},
                        0.01)
                .value();
  for (int k = 0; k < 100; ++k) RC_ASSERT(std::fabs(pid.command({any(-100, 101) / 10.0}, 0)) <= limit);
}

std::string refusal(const PidOptions& options, double period) {
  const auto pid = Pid::create(options, period);
  return pid ? "" : std::string(pid.error().code) + ": " + pid.error().message;
}

TEST(Pid, SaysWhichOptionIsWrong) {
  EXPECT_EQ(refusal({.gains = {2, 2, 15}}, 0.01), "");
  EXPECT_EQ(refusal({.gains = {2, 2, 15}}, 0), "servo-controller: the period is 0");
  EXPECT_EQ(refusal({.gains = {-2, 2, 15}}, 0.01), "servo-controller: the proportional gain is -2");
  EXPECT_EQ(refusal({.gains = {2, -2, 15}}, 0.01), "servo-controller: the integral gain is -2");
  EXPECT_EQ(refusal({.gains = {2, 2, -15}}, 0.01), "servo-controller: the derivative gain is -15");
  EXPECT_EQ(refusal({.velocity_forward = -1}, 0.01), "servo-controller: the feed-forward of velocity is -1");
  EXPECT_EQ(refusal({.acceleration_forward = -1}, 0.01), "servo-controller: the feed-forward of acceleration is -1");
  EXPECT_EQ(refusal({.limit = 0}, 0.01), "servo-controller: the limit of the command is 0");
}

}  // namespace test_pid
}  // namespace leadscrew::servo::testing
