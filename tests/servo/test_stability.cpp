#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/stability.hpp>

namespace leadscrew::servo::testing {
namespace test_stability {

constexpr base::Period period{1'000'000};

ServoOptions one_axis(const LoopOptions& loop) {
  ServoOptions options;
  options[0] = loop;
  return options;
}

LoopOptions proportional(double gain, double time_constant, double proportional) {
  PidOptions pid;
  pid.gains.proportional = proportional;
  return {{.drive = velocity_drive(gain, time_constant)}, pid};
}

/// Of P before K/(s(τs + 1)), held over T: with a = e^(−T/τ) the poles are those of z² + (P·b₁ − 1 − a)z + a + P·b₀,
/// b₁ = K(T − τ(1 − a)), b₀ = K(τ(1 − a) − Ta). By Jury they lie inside the circle while a + P·b₀ < 1 and
/// 2(1 + a) > P(b₁ − b₀).
double greatest_proportional(double gain, double time_constant, double T) {
  const double a = std::exp(-T / time_constant);
  const double b1 = gain * (T - time_constant * (1 - a)), b0 = gain * (time_constant * (1 - a) - T * a);
  const double by_product = (1 - a) / b0;
  return b1 > b0 ? std::min(by_product, 2 * (1 + a) / (b1 - b0)) : by_product;
}

TEST(Stability, EndsWhereJurySaysSo) {
  for (const double time_constant : {0.0002, 0.001, 0.02, 0.2}) {
    const double greatest = greatest_proportional(10, time_constant, period.seconds());
    EXPECT_TRUE(check_stable(one_axis(proportional(10, time_constant, 0.99 * greatest)), period)) << time_constant;
    EXPECT_FALSE(check_stable(one_axis(proportional(10, time_constant, 1000 * greatest)), period)) << time_constant;
    const auto beyond = check_stable(one_axis(proportional(10, time_constant, 1.01 * greatest)), period);
    ASSERT_FALSE(beyond) << time_constant;
    EXPECT_EQ(beyond.error().code, "servo-unstable");
    EXPECT_NE(beyond.error().message.find("axis X"), std::string::npos);
  }
}

/// P and I before K/(s(τs + 1)) at short periods: by Routh stable while P > τI. It swings wider by a factor of e in
/// 1.7 s.
TEST(Stability, IsLookedAtForSecondsAtShortPeriodsToo) {
  for (const std::int64_t nanoseconds : {10'000, 20'000, 1'000'000}) {
    LoopOptions loop = proportional(10, 0.2, 0.5);
    std::get<PidOptions>(loop.controller).gains.integral = 4;
    EXPECT_FALSE(check_stable(one_axis(loop), {nanoseconds})) << nanoseconds;
    std::get<PidOptions>(loop.controller).gains.integral = 1;
    EXPECT_TRUE(check_stable(one_axis(loop), {nanoseconds})) << nanoseconds;
  }
}

/// As above, a little beyond P = τI: it swings less than twice as wide at the end of the observation.
TEST(Stability, SlowGrowthIsSeen) {
  LoopOptions loop = proportional(10, 0.2, 0.5);
  std::get<PidOptions>(loop.controller).gains.integral = 2.52;
  EXPECT_FALSE(check_stable(one_axis(loop), period));
  std::get<PidOptions>(loop.controller).gains.integral = 2.4;
  EXPECT_TRUE(check_stable(one_axis(loop), period));
}

/// A velocity loop that is read as a difference of readings has the poles of z² + (PT/2 − 1)z + PT/2.
TEST(Stability, OfACascadeEndsAtTwoOverThePeriod) {
  LoopOptions loop{{.drive = {1, 0}}, CascadeOptions{.position_gain = 1e-3}};
  CascadeOptions& cascade = std::get<CascadeOptions>(loop.controller);
  for (const double T : {100e-6, 1e-3, 10e-3}) {
    const base::Period of{std::llround(T * 1e9)};
    cascade.velocity_gain = 1.98 / T;
    EXPECT_TRUE(check_stable(one_axis(loop), of)) << T;
    cascade.velocity_gain = 2.02 / T;
    EXPECT_FALSE(check_stable(one_axis(loop), of)) << T;
  }
}

/// Limits do not make a loop stable, they hide that it is not.
TEST(Stability, IsThatOfTheLoopWithoutItsLimits) {
  LoopOptions loop = proportional(10, 0.02, 2 * greatest_proportional(10, 0.02, period.seconds()));
  loop.axis.command_limit = 1e-3;
  loop.axis.friction = 5;
  loop.axis.encoder_resolution = 0.001;
  std::get<PidOptions>(loop.controller).limit = 1e-3;
  EXPECT_FALSE(check_stable(one_axis(loop), period));
}

TEST(Stability, LetsTheUsualLoopsAndThePublishedGainsPass) {
  for (const std::int64_t nanoseconds : {10'000, 1'000'000, 10'000'000}) {
    machine::Machine machine = machine::mill3();
    machine.period = {nanoseconds};
    EXPECT_TRUE(check_stable(loops_of(machine), machine.period)) << nanoseconds;
  }
  for (const PidGains& gains : {PidGains{2, 2, 15}, PidGains{6, 50, 25}}) {
    LoopOptions loop = proportional(10, 0.02, 0);
    std::get<PidOptions>(loop.controller).gains = gains;
    EXPECT_TRUE(check_stable(one_axis(loop), {10'000'000}));
  }
}

}  // namespace test_stability
}  // namespace leadscrew::servo::testing
