#include <Vmotion_core.h>
#include <gtest/gtest.h>

#include <random>

#include "core_bench.hpp"

// Step and direction signals of rtl/motion_core.sv: never shorter than set, and the same steps as were decided.

namespace leadscrew::hardware {
namespace test_step_shaper {

using Core24 = Core<Vmotion_core, 24, 40>;

struct Times {
  std::int64_t length = 1, space = 1, setup = 0, hold = 0;  ///< clocks
};

/// The signals of one axis, clock by clock.
class Signals {
 public:
  explicit Signals(const Times& times) : times_(times) {}

  void see(bool step, bool direction) {
    ++clock_;
    if (direction != direction_) {
      EXPECT_TRUE(!has_stepped_ || clock_ - fallen_ >= times_.hold);
      EXPECT_TRUE(!step_ || !step) << "turns in a step";
      turned_ = clock_;
    }
    direction_ = direction;
    if (step && !step_) {
      EXPECT_TRUE(!has_stepped_ || clock_ - fallen_ >= times_.space);
      EXPECT_GE(clock_ - turned_, times_.setup);
      risen_ = clock_;
      has_stepped_ = true;
      position_ += direction ? -1 : 1;
    }
    if (!step && step_) {
      EXPECT_EQ(clock_ - risen_, times_.length);
      fallen_ = clock_;
    }
    step_ = step;
  }
  std::int64_t position() const { return position_; }

 private:
  Times times_;
  bool step_ = false, direction_ = false, has_stepped_ = false;
  std::int64_t clock_ = 0, risen_ = 0, fallen_ = 0, turned_ = -1'000'000, position_ = 0;
};

void set(std::uint64_t& port, std::size_t axis, std::int64_t time) {
  port |= static_cast<std::uint64_t>(time) << (16 * axis);
}

/// Lines and arcs to and fro, at every tick.
std::vector<CoreCommand> moves_of(std::mt19937_64& random) {
  std::vector<CoreCommand> commands;
  std::uniform_int_distribution<std::int64_t> distance(-20, 20);
  for (int i = 0; i < 12; ++i) {
    const CoreVector delta{distance(random), distance(random), distance(random)};
    if (delta != CoreVector{}) commands.push_back(line_command(delta));
    push_arc(commands, {{3 + i, i}, {3 + i, i}, pulse::Direction::clockwise}, 0, 1);
  }
  for (CoreCommand& command : commands) command.feed = command.feed_straight = Core24::every_tick;
  commands.back().final = true;
  return commands;
}

std::vector<CorePulse> pulses_without_waiting(const std::vector<CoreCommand>& commands) {
  Core24 core;
  std::vector<CorePulse> pulses;
  core.run(commands, 100'000, [&](const CorePulse& pulse) {
    if (pulse != CorePulse{}) pulses.push_back(pulse);
  });
  return pulses;
}

TEST(StepShaper, KeepsTheTimesOfEachDriveAndEveryStep) {
  std::mt19937_64 random(31);
  std::uniform_int_distribution<std::int64_t> time(0, 9);
  for (int round = 0; round < 40; ++round) {
    Core24 core;
    std::array<Times, core_axes> times;
    std::vector<Signals> signals;
    std::uint64_t length = 0, space = 0, setup = 0, hold = 0;
    for (std::size_t axis = 0; axis < core_axes; ++axis) {
      times[axis] = {1 + time(random), 1 + time(random), time(random), time(random)};
      signals.emplace_back(times[axis]);
      set(length, axis, times[axis].length);
      set(space, axis, times[axis].space);
      set(setup, axis, times[axis].setup);
      set(hold, axis, times[axis].hold);
    }
    core->step_length = length;
    core->step_space = space;
    core->direction_setup = setup;
    core->direction_hold = hold;
    const std::vector<CoreCommand> commands = moves_of(random);
    std::vector<CorePulse> pulses;
    std::size_t pushed = 0;
    for (std::int64_t clock = 0; clock < 200'000 && (pushed < commands.size() || core->busy); ++clock) {
      core.offer_nothing();
      if (pushed < commands.size() && !core->fifo_full) core.offer(commands[pushed++]);
      const CorePulse pulse = core.pulse();
      if (pulse != CorePulse{}) pulses.push_back(pulse);
      for (std::size_t axis = 0; axis < core_axes; ++axis)
        signals[axis].see(core->step >> axis & 1, core->direction >> axis & 1);
      core.clock();
    }
    EXPECT_EQ(pulses, pulses_without_waiting(commands));
    for (std::size_t axis = 0; axis < core_axes; ++axis) EXPECT_EQ(signals[axis].position(), core.position(axis));
    EXPECT_EQ(core->error, 8) << "it has waited, and says so";
  }
}

/// No axis waits longer than step_timing.hpp's StepTicks say: pitch() from step to step, reversal() where it turns.
TEST(StepShaper, WaitsNoLongerThanItMust) {
  Core24 core;
  core.for_all_times(3, 4, 5, 6);
  std::vector<CoreCommand> commands{line_command({4, 0, 0}), line_command({-3, 0, 0})};
  for (CoreCommand& command : commands) command.feed = command.feed_straight = Core24::every_tick;
  commands.back().final = true;
  std::vector<std::int64_t> steps;
  std::int64_t clock = 0;
  core.run(commands, 1000, [&](const CorePulse& pulse) {
    ++clock;
    if (pulse.step[0] != 0) steps.push_back(clock);
  });
  ASSERT_EQ(steps.size(), 7u);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_EQ(steps[i] - steps[i - 1], i == 4 ? 3 + 6 + 5 : 3 + 4);
}

}  // namespace test_step_shaper
}  // namespace leadscrew::hardware
