// What clocks, times and machines are refused.

#include <gtest/gtest.h>

#include <leadscrew/stepping/step_generator.hpp>

#include "stepping_support.hpp"

namespace leadscrew::stepping::testing {
namespace {

std::string_view refusal(const machine::Machine& machine, const StepTiming& timing) {
  const auto problems = validate(timing, machine);
  const auto made = StepGenerator::create(machine, timing);
  EXPECT_EQ(made.has_value(), problems.empty());
  if (problems.empty()) return "";
  EXPECT_EQ(made.error().message, problems.front().message);
  return problems.front().code;
}

TEST(StepTiming, TakesTheRateThatStepsJustAllow) {
  const StepTiming timing{.clock_hz = 1'000'000, .step_length_ns = 2000, .step_space_ns = 2500};  // every 5 ticks
  EXPECT_EQ(refusal(mill_with(200, 0.001), timing), "");
  EXPECT_EQ(refusal(mill_with(200.001, 0.001), timing), "step-rate");
}

TEST(StepTiming, NamesEveryAxisThatIsTooFast) {
  machine::Machine machine = mill_with(200, 0.001);
  machine.axes[1]->blu = 0.01;
  const auto problems = validate({.clock_hz = 100'000}, machine);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].message,
            "axis X makes 2e+05 steps/s at its greatest velocity; a clock of 100000 Hz gives 50000, a step every "
            "2 ticks");
  EXPECT_NE(problems[1].message.find("axis Z"), std::string::npos);
}

TEST(StepTiming, RefusesClocksAndTimesOutOfRange) {
  const machine::Machine machine = mill_with(1, 0.01);
  EXPECT_EQ(refusal(machine, {.clock_hz = 10'000}), "");
  EXPECT_EQ(refusal(machine, {.clock_hz = 10'000'000}), "");
  EXPECT_EQ(refusal(machine, {.clock_hz = 9'999}), "step-clock");
  EXPECT_EQ(refusal(machine, {.clock_hz = 10'000'001}), "step-clock");
  EXPECT_EQ(refusal(machine, {.step_length_ns = 0}), "step-time");
  EXPECT_EQ(refusal(machine, {.step_space_ns = 1'000'000'001}), "step-time");
  EXPECT_EQ(refusal(machine, {.direction_setup_ns = -1}), "step-time");
  EXPECT_EQ(refusal(machine, {.direction_hold_ns = -1}), "step-time");
}

TEST(StepTiming, RefusesTravelThatDoublesCannotTellApart) {
  EXPECT_EQ(refusal(mill_with(1e-6, 1e-7), {}), "step-range");
}

TEST(StepTiming, RoundsTimesUpToTicks) {
  const StepTicks ticks = in_ticks({.clock_hz = 3'000'000,
                                    .step_length_ns = 1000,
                                    .step_space_ns = 1001,
                                    .direction_setup_ns = 0,
                                    .direction_hold_ns = 1});
  EXPECT_EQ(ticks.length, 3);
  EXPECT_EQ(ticks.space, 4);
  EXPECT_EQ(ticks.setup, 0);
  EXPECT_EQ(ticks.hold, 1);
  EXPECT_EQ(ticks.reversal(), 7);
}

}  // namespace
}  // namespace leadscrew::stepping::testing
