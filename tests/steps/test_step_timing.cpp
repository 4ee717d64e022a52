// What clocks, times and machines are refused.

#include <gtest/gtest.h>

#include <leadscrew/steps/step_generator.hpp>

#include "steps_support.hpp"

namespace leadscrew::steps::testing {
namespace test_step_timing {

std::string_view refusal(const machine::Machine& machine, std::int64_t clock_hz = 1'000'000) {
  const auto problems = validate(clock_hz, machine);
  const auto made = StepGenerator::create(machine, clock_hz);
  EXPECT_EQ(made.has_value(), problems.empty());
  if (problems.empty()) return "";
  EXPECT_EQ(made.error().message, problems.front().message);
  return problems.front().code;
}

machine::Machine with_times(machine::Machine machine, const machine::StepTimes& times) {
  for (auto& axis : machine.axes) {
    if (axis) axis->step_times = times;
  }
  return machine;
}

TEST(StepTiming, TakesTheRateThatStepsJustAllow) {
  const machine::StepTimes times{.step_length = 2000, .step_space = 2500};  // every 5 ticks
  EXPECT_EQ(refusal(with_times(mill_with(200, 0.001), times)), "");
  EXPECT_EQ(refusal(with_times(mill_with(200.001, 0.001), times)), "step-rate");
}

TEST(StepTiming, NamesEveryAxisThatIsTooFast) {
  machine::Machine machine = mill_with(200, 0.001);
  machine.axes[1]->blu = 0.01;
  const auto problems = validate(100'000, machine);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].message,
            "axis X makes 2e+05 steps/s at its greatest velocity; a clock of 100000 Hz gives 50000, a step every "
            "2 ticks");
  EXPECT_NE(problems[1].message.find("axis Z"), std::string::npos);
}

/// A slow drive is asked for no more than it can follow; the others go on as they are.
TEST(StepTiming, IsThatOfEachDrive) {
  machine::Machine machine = mill_with(200, 0.001);
  machine.axes[1]->step_times.step_length = 5000;
  const auto problems = validate(1'000'000, machine);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message.substr(0, 6), "axis Y");
  machine.axes[1]->velocity = 160;
  EXPECT_EQ(refusal(machine), "");
  EXPECT_EQ(longest_reversal(machine, 1'000'000).ticks, 7);
  EXPECT_EQ(longest_reversal(machine, 1'000'000).axis, base::Axis::Y);
}

TEST(StepTiming, RefusesClocksOutOfRange) {
  const machine::Machine machine = mill_with(1, 0.01);
  EXPECT_EQ(refusal(machine, 10'000), "");
  EXPECT_EQ(refusal(machine, 10'000'000), "");
  EXPECT_EQ(refusal(machine, 9'999), "step-clock");
  EXPECT_EQ(refusal(machine, 10'000'001), "step-clock");
}

TEST(StepTiming, RefusesTravelThatDoublesCannotTellApart) {
  EXPECT_EQ(refusal(mill_with(1e-6, 1e-7)), "step-range");
}

/// At 1000 mm/s² from rest to a summit `beyond` a step, passed after 40 periods of 1 ms, and back to rest. BLU.
std::vector<double> over_a_summit(double beyond) {
  std::vector<double> positions;
  double at = 0.5 + beyond - 400, speed = 0;  // BLU, and BLU a period
  for (int k = 0; k <= 80; ++k) {
    const double change = k < 20 || k >= 60 ? 1 : -1;
    positions.push_back(at);
    at += speed + change / 2;
    speed += change;
  }
  return positions;
}

/// Where the longest turn that is taken keeps steps from following, they are less than a BLU behind: the place is that
/// of the parabola, and just before each step they are furthest from it.
TEST(StepTiming, TakesTurnsThatCostLessThanABlu) {
  const auto with_setup = [](std::int64_t nanoseconds) {
    return with_times(mill_with(200, 0.001), {.direction_setup = nanoseconds});
  };
  EXPECT_EQ(refusal(with_setup(996'000)), "");
  EXPECT_EQ(refusal(with_setup(997'000)), "step-turn");
  double worst = 0;
  for (const double beyond : {1e-4, 1e-3, 0.01, 0.2}) {
    const Made made = steps_of(words_along_x(over_a_summit(beyond), 0.001), with_setup(996'000), 1'000'000);
    double count = -400 + std::round(0.5 + beyond);
    for (const StepEvent event : made.events) {
      const double since = static_cast<double>(event.tick()) / 1000 - 40;  // the summit, ms
      if (std::abs(since) < 10) worst = std::max(worst, std::abs(count - (0.5 + beyond - since * since / 2)));
      count += event.direction();
    }
    EXPECT_EQ(made.report.postponed > 0, beyond < 0.2) << beyond;
  }
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.95);
}

TEST(StepTiming, RoundsTimesUpToTicks) {
  const StepTicks ticks =
      in_ticks({.step_length = 1000, .step_space = 1001, .direction_setup = 0, .direction_hold = 1}, 3'000'000);
  EXPECT_EQ(ticks.length, 3);
  EXPECT_EQ(ticks.space, 4);
  EXPECT_EQ(ticks.setup, 0);
  EXPECT_EQ(ticks.hold, 1);
  EXPECT_EQ(ticks.reversal(), 7);
}

}  // namespace test_step_timing
TEST(StepTiming, TellsWhichTimesLimit) {
  using Places = std::vector<std::size_t>;
  EXPECT_EQ((StepTicks{2, 9, 1, 1}).limiting(), (Places{0, 1}));
  EXPECT_EQ((StepTicks{2, 3, 4, 5}).limiting(), (Places{0, 3, 2}));
  EXPECT_EQ((StepTicks{2, 3, 1, 2}).limiting(), (Places{0, 1, 3, 2}));
}

}  // namespace leadscrew::steps::testing
