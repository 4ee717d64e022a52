#include <Vmotion_core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "core_program.hpp"

// rtl/motion_core.sv as a whole: feed and dwells, the queue, hold, abort, watchdog, positions.

namespace leadscrew::hardware {
namespace test_motion_core {

using Core24 = Core<Vmotion_core, 24, 40>;
enum Error : int { overflow = 1, underflow = 2, watchdog = 4, stretched = 8, empty = 16 };

CoreCommand final_line(const CoreVector& delta, std::uint64_t feed) {
  CoreCommand command = with_feed(line_command(delta), feed);
  command.final = true;
  return command;
}

std::vector<Step> steps_of(Core24& core, const std::vector<CoreCommand>& commands) {
  std::vector<Step> steps;
  std::int64_t tick = 0;
  core.run(commands, 10'000'000, [&](const CorePulse& pulse) {
    ++tick;
    if (pulse != CorePulse{}) steps.push_back({tick, pulse});
  });
  return steps;
}

void expect_positions(Core24& core, const std::vector<Step>& steps) {
  for (std::size_t axis = 0; axis < core_axes; ++axis) {
    const std::int64_t sum =
        std::accumulate(steps.begin(), steps.end(), std::int64_t{0},
                        [&](std::int64_t so_far, const Step& step) { return so_far + step.pulse.step[axis]; });
    EXPECT_EQ(core.position(axis), sum);
  }
}

TEST(MotionCore, MakesWholeProgramsTickByTick) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Core24 core;
    const RandomProgram program(seed);
    EXPECT_EQ(steps_of(core, program.commands), program.steps) << "seed " << seed;
    EXPECT_EQ(core->error, 0);
    EXPECT_EQ(core->commands_done, program.commands.size());
    expect_positions(core, program.steps);
  }
}

TEST(MotionCore, PassesATickEachSoManyClocks) {
  const RandomProgram program(100);
  Core24 core;
  core->prescale = 4;
  std::vector<Step> steps = steps_of(core, program.commands);
  ASSERT_EQ(steps.size(), program.steps.size());
  const std::int64_t first = steps[0].tick - 5 * program.steps[0].tick;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ASSERT_EQ(steps[i].tick, 5 * program.steps[i].tick + first);
    ASSERT_EQ(steps[i].pulse, program.steps[i].pulse);
  }
}

TEST(MotionCore, RefusesWhatTheFullQueueCannotHold) {
  Core24 core;
  core->hold = 1;
  const std::int64_t depth = 16;
  for (std::int64_t i = 0; i < depth + 3; ++i) {
    EXPECT_EQ(core->fifo_full, i >= depth);
    core.offer(final_line({1 << std::min<std::int64_t>(i, 18), 0, -1}, Core24::every_tick));
    core.clock();
    EXPECT_EQ(core->fifo_level, std::min(i + 1, depth));
    EXPECT_EQ(core->error, i >= depth ? overflow : 0);
  }
  core.offer_nothing();
  core->hold = 0;
  core->error_clear = overflow;
  core.clock();
  core->error_clear = 0;
  steps_of(core, {});
  EXPECT_EQ(core.position(0), (1 << depth) - 1);
  EXPECT_EQ(core.position(2), -depth);
  EXPECT_EQ(core->error, 0);
}

TEST(MotionCore, TellsWhereTheQueueRunsDryAndGoesOn) {
  Core24 core;
  const CoreCommand line = with_feed(line_command({5, -3, 2}), Core24::every_tick);
  EXPECT_EQ(steps_of(core, {line}).size(), 5u);
  EXPECT_EQ(core->error, underflow);
  EXPECT_EQ(steps_of(core, {line, line}).size(), 10u);
  EXPECT_EQ(core->error, underflow);
  core->error_clear = underflow;
  core.clock();
  core->error_clear = 0;
  EXPECT_EQ(steps_of(core, {line, final_line({0, 0, 1}, Core24::every_tick)}).size(), 6u);
  EXPECT_EQ(core->error, 0);
  EXPECT_EQ(core.position(0), 20);
  EXPECT_EQ(core.position(1), -12);
  EXPECT_EQ(core.position(2), 9);
}

TEST(MotionCore, RefusesACommandWithoutSteps) {
  Core24 core;
  CoreCommand nothing = final_line({1, 0, 0}, Core24::every_tick);
  nothing.count = 0;
  EXPECT_TRUE(steps_of(core, {nothing}).empty());
  EXPECT_EQ(core->error, empty);
  EXPECT_EQ(core->fifo_level, 0);
}

TEST(MotionCore, HoldStopsWithinAStepAndLosesNone) {
  const RandomProgram program(7);
  Core24 core;
  std::mt19937_64 random(8);
  std::size_t pushed = 0, seen = 0;
  for (std::int64_t clock = 0; clock < 200'000 && (pushed < program.commands.size() || core->busy); ++clock) {
    if (random() % 30 == 0) core->hold = !core->hold;
    core.offer_nothing();
    if (pushed < program.commands.size() && !core->fifo_full) core.offer(program.commands[pushed++]);
    const CorePulse pulse = core.pulse();
    if (pulse != CorePulse{}) {
      ASSERT_EQ(core->hold, 0);
      ASSERT_LT(seen, program.steps.size());
      ASSERT_EQ(pulse, program.steps[seen++].pulse);
    }
    core.clock();
  }
  EXPECT_EQ(seen, program.steps.size());
  EXPECT_EQ(core->error, 0);
}

TEST(MotionCore, AbortDropsAllAndKeepsThePosition) {
  Core24 core;
  core.for_all_times(7, 7, 0, 0);
  const CoreCommand line = with_feed(line_command({1000, 400, -100}), Core24::every_tick / 16);
  for (int i = 0; i < 3; ++i) {
    core.offer(line);
    core.clock();
  }
  core.offer_nothing();
  std::int64_t steps = 0;
  while (steps < 50) {
    steps += core.pulse().step[0];
    core.clock();
  }
  ASSERT_EQ(core->step & 1, 1);
  core->abort_now = 1;
  core.clock();
  core->abort_now = 0;
  EXPECT_EQ(core->running, 0);
  EXPECT_EQ(core->fifo_level, 0);
  int high = 2;  // clocks so far: the decision's and the abort's
  for (; core->step & 1; ++high) core.clock();
  EXPECT_EQ(high, 1 + 7);
  for (int clock = 0; clock < 1000; ++clock) {
    EXPECT_EQ(core.pulse(), CorePulse{});
    core.clock();
  }
  EXPECT_EQ(core.position(0), 50);
  EXPECT_EQ(core->busy, 0);
  EXPECT_EQ(steps_of(core, {final_line({-50, 0, 0}, Core24::every_tick / 16)}).size(), 50u);
  EXPECT_EQ(core.position(0), 0);
}

TEST(MotionCore, StopsWhereTheWatchdogIsNotKicked) {
  Core24 core;
  core->watchdog_period = 50;
  core.offer(final_line({1000, 0, 0}, Core24::every_tick));
  for (int clock = 0; clock < 200; ++clock) {
    core->watchdog_kick = clock % 50 == 0;
    core.clock();
    core.offer_nothing();
  }
  EXPECT_EQ(core->error, 0);
  core->watchdog_kick = 0;
  for (int clock = 0; clock < 60; ++clock) core.clock();
  EXPECT_EQ(core->error, watchdog);
  const std::int64_t stopped = core.position(0);
  EXPECT_GT(stopped, 190);
  EXPECT_LT(stopped, 260);
  for (int clock = 0; clock < 60; ++clock) core.clock();
  EXPECT_EQ(core.position(0), stopped);
  core->watchdog_period = 0;
  core->error_clear = watchdog;
  core.clock();
  core->error_clear = 0;
  steps_of(core, {});
  EXPECT_EQ(core.position(0), 1000);
  EXPECT_EQ(core->error, 0);
}

TEST(MotionCore, InterruptsAtTheWatermark) {
  Core24 core;
  core->watermark = 2;
  core->interrupt_enable = 1;
  core->hold = 1;
  core->eval();
  EXPECT_EQ(core->irq, 1);
  for (int i = 1; i <= 4; ++i) {
    core.offer(final_line({10, 0, 0}, Core24::every_tick));
    core.clock();
    EXPECT_EQ(core->irq, i <= 2);
  }
  core.offer_nothing();
  core->hold = 0;
  std::int64_t clocks = 0;
  for (; !core->irq && clocks < 100; ++clocks) core.clock();
  EXPECT_EQ(core->fifo_level, 2);
  core->interrupt_enable = 2;
  core->eval();
  EXPECT_EQ(core->irq, 0);
  steps_of(core, {});
  EXPECT_EQ(core->irq, 1);
}

TEST(MotionCore, LatchesPositionsAtTheProbe) {
  Core24 core;
  core->position_set = 0b101;
  core->position_set_value = static_cast<std::uint32_t>(-7);
  core.clock();
  core->position_set = 0;
  EXPECT_EQ(core.position(0), -7);
  EXPECT_EQ(core.position(1), 0);
  EXPECT_EQ(core.position(2), -7);
  core.offer(final_line({100, 50, -25}, Core24::every_tick));
  core.clock();
  core.offer_nothing();
  core->probe_enable = 1;
  for (int clock = 0; clock < 40; ++clock) core.clock();
  EXPECT_EQ(core->latched, 0);
  const std::int64_t before = core.position(0);
  core->probe = 1;
  for (int clock = 0; clock < 10; ++clock) core.clock();
  EXPECT_EQ(core->latched, 1);
  EXPECT_EQ(core.latched_position(0), before + 2);  // the flip-flops
  EXPECT_EQ(core.latched_position(1), std::llround((core.latched_position(0) + 7) / 2.0 - 0.25));
  core->latch_clear = 1;
  core.clock();
  core->latch_clear = 0;
  for (int clock = 0; clock < 10; ++clock) core.clock();
  EXPECT_EQ(core->latched, 0) << "the probe still touches";
  core->latch = 1;
  const std::int64_t now = core.position(0);
  core.clock();
  core->latch = 0;
  EXPECT_EQ(core.latched_position(0), now);
}

constexpr double feed_of_arcs = 0.05;  // steps a tick

/// The least and the greatest speed over so many steps of a quarter of a circle, over the feed.
std::pair<double, double> speeds_of_a_quarter(std::int64_t radius, Cut cut, std::size_t steps_of_window) {
  Core24 core;
  std::vector<CoreCommand> commands;
  for (Octants octants({{radius, 0}, {0, radius}}, cut); !octants.done();) {
    const Octant octant = octants.next();
    commands.push_back(octant_command(octant, 0, 1));
    const double word = feed_of_arcs * octant.pace.feed, unit = static_cast<double>(Core24::every_tick) / Pace::one;
    commands.back().feed = static_cast<std::uint64_t>(word * unit);
    commands.back().feed_straight = static_cast<std::uint64_t>((word + octant.pace.head_start) * unit);
  }
  commands.back().final = true;
  std::vector<std::pair<double, double>> way{{0, 0}};  // tick, angle
  auto x = static_cast<double>(radius), y = 0.0;
  for (const Step& step : steps_of(core, commands)) {
    x += step.pulse.step[0];
    y += step.pulse.step[1];
    way.emplace_back(static_cast<double>(step.tick), std::atan2(y, x));
  }
  EXPECT_EQ(core.position(1), radius);
  double least = 1e9, greatest = 0;
  for (std::size_t i = steps_of_window; i < way.size(); ++i) {
    const auto& [from_tick, from] = way[i - steps_of_window];
    const double speed =
        static_cast<double>(radius) * (way[i].second - from) / (way[i].first - from_tick) / feed_of_arcs;
    least = std::min(least, speed);
    greatest = std::max(greatest, speed);
  }
  return {least, greatest};
}

/// With evenly spaced steps the speed is 1/max(|cos|, |sin|) times that along an axis, up to √2.
TEST(MotionCore, GoesAroundACircleUnevenlyByEvenSteps) {
  const auto [least, greatest] = speeds_of_a_quarter(2000, Cut::octants, 200);
  EXPECT_GT(least, 0.99);
  EXPECT_GT(greatest, 1.35);
}

/// octants.hpp promises speeds of 1 − 0.0005 to 1 in pieces of R/16 steps; single steps weigh less in a long window, here a
/// third of a piece.
TEST(MotionCore, GoesAroundACircleEvenlyInPieces) {
  const auto [least, greatest] = speeds_of_a_quarter(200'000, Cut::pieces, 4000);
  EXPECT_GT(least, 1 - 0.0006);
  EXPECT_LT(greatest, 1 + 0.0001);
}

}  // namespace test_motion_core
}  // namespace leadscrew::hardware
