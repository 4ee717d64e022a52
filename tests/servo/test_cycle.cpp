// What is called every period takes no memory.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <cmath>
#include <leadscrew/servo/adaptive_feed.hpp>
#include <leadscrew/servo/pulse_loop.hpp>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_cycle {

template <class Run>
std::int64_t allocations_of(Run&& run) {
  const std::int64_t before = testing_support::allocations();
  for (int k = 0; k < 2000; ++k) run(k);
  return testing_support::allocations() - before;
}

TEST(ServoCycle, AxisLoopsTakeNoMemory) {
  const AxisOptions axis{.drive = velocity_drive(10, 0.02),
                         .command_limit = 5,
                         .friction = 20,
                         .backlash = 0.01,
                         .encoder_resolution = 0.001};
  AxisLoop pid = pid_loop(axis, {.gains = {2, 2, 15}, .limit = 5}, 1e-3);
  const auto cascade = Cascade::create({.position_gain = 20, .velocity_gain = 0.2, .integral_gain = 1}, 1e-3).value();
  AxisLoop cascaded(SimulatedAxis::create(axis).value(), cascade, 1e-3);
  EXPECT_EQ(allocations_of([&](int k) {
              pid.follow({std::sin(0.01 * k)});
              cascaded.follow({std::sin(0.01 * k)});
            }),
            0);
}

TEST(ServoCycle, PulseLoopsTakeNoMemory) {
  PulseLoop loop =
      PulseLoop::create({.converter = 0.1, .amplifier = 5, .motor = 0.2, .holes = 200, .time_constant = 0.02}).value();
  loop.load(1000);
  EXPECT_EQ(allocations_of([&](int) {
              loop.run_through(0.01);
              loop.pulse(1);
            }),
            0);
  EXPECT_GT(loop.encoder_count(), 900);
}

TEST(ServoCycle, AdaptiveFeedTakesNoMemoryEvenWhenItsSensorFails) {
  AdaptiveFeed adaptive = AdaptiveFeed::create({.limit = 400}).value();
  EXPECT_EQ(
      allocations_of([&](int k) { adaptive.sample(k < 1000 ? std::optional(300 + 0.1 * (k % 7)) : std::nullopt, 1); }),
      0);
  EXPECT_EQ(adaptive.failure(), SensorFailure::silent);
}

}  // namespace test_cycle
}  // namespace leadscrew::servo::testing
