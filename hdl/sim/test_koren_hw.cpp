#include <Vkoren_hw.h>
#include <Vkoren_hw_carry.h>
#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/pulse/linear.hpp>

#include "clocked.hpp"

// Koren's hardware interpolator beside pulse/: q = 120 000, q0 = 10 000, a clock of 2 MHz, 0.0001 in a BLU.

namespace leadscrew::hardware {
namespace test_koren_hw {

using pulse::Point;

constexpr std::int64_t q = 120'000, q0 = 10'000, clock_pps = 2'000'000;
constexpr std::uint32_t endless = 0x3ffff;

struct Load {
  bool is_arc = false, grows_1 = false;
  std::int64_t f = 0, begin_1 = 0, begin_2 = 0;
  std::uint32_t steps_x = endless, steps_y = endless;
};

template <typename Model>
void load(Clocked<Model>& core, const Load& values) {
  core->rst = 0;
  core->is_arc = values.is_arc;
  core->grows_1 = values.grows_1;
  core->f = static_cast<std::uint16_t>(values.f);
  core->begin_1 = static_cast<std::uint32_t>(values.begin_1);
  core->begin_2 = static_cast<std::uint32_t>(values.begin_2);
  core->steps_x = values.steps_x;
  core->steps_y = values.steps_y;
  core->load = 1;
  core.clock();
  core->load = 0;
  core->eval();
}

/// 2 in at 10 in/min along X: f = 600 V/L = 50, 10 000 commands a second, 12 s.
TEST(KorenLine, Of2InchesAt10InchesAMinuteTakes12Seconds) {
  Clocked<Vkoren_hw> core;
  load(core, {.f = 50, .begin_1 = 20'000, .steps_x = 20'000, .steps_y = 0});
  std::int64_t clocks = 0, commands = 0, steps = 0, first_second = 0;
  while (core->left_x != 0) {
    commands += core->command;
    core.clock();
    core->eval();
    steps += core->x_pulse;
    ASSERT_EQ(core->y_pulse, 0);
    if (++clocks == clock_pps) first_second = commands;
  }
  EXPECT_EQ(first_second, 10'000);
  EXPECT_EQ(steps, 20'000);
  // r > q: the last pulse takes one command more than q.
  EXPECT_NEAR(static_cast<double>(clocks) / clock_pps, 12.000, 5e-4);
}

/// Both axes at every command, in the sense of pulse::LinearDda that overflows where r ≥ q.
TEST(KorenLine, IsTheLinearDdaOfItsCapacity) {
  Clocked<Vkoren_hw_carry> core;
  for (const Point delta : {Point{20'000, 1}, Point{12'345, 6'789}, Point{1, 120'000}, Point{777, 0}}) {
    load(core, {.f = q0,
                .begin_1 = delta.x,
                .begin_2 = delta.y,
                .steps_x = static_cast<std::uint32_t>(delta.x),
                .steps_y = static_cast<std::uint32_t>(delta.y)});
    pulse::LinearDda<2> line({delta.x, delta.y}, q, pulse::Preload::none);
    while (!line.done()) {
      const auto expected = line.step();
      ASSERT_EQ(core->command, 1);
      core.clock();
      core->eval();
      ASSERT_EQ(core->x_pulse, expected.step[0]);
      ASSERT_EQ(core->y_pulse, expected.step[1]);
      ASSERT_EQ(core->left_x, line.left(0));
      ASSERT_EQ(core->left_y, line.left(1));
    }
    EXPECT_EQ(core->busy, 1);  // with the last pulse
    core.clock();
    EXPECT_EQ(core->busy, 0);
    EXPECT_EQ(core->x_pulse | core->y_pulse, 0);
  }
}

/// The circle of R = 1 in at 10 in/min: f = 600 V/R = 100, 20 000 commands a second; bare, as the circle of pulse/ is.
TEST(KorenCircle, OfOneInchPassesItsFirstQuarterIn188496Commands) {
  constexpr std::int64_t radius = 10'000;
  Clocked<Vkoren_hw> core;
  load(core, {.is_arc = true, .f = 100, .begin_1 = radius, .begin_2 = 0});
  pulse::FreeCircle circle({radius, 0}, q, -1, pulse::Order::parallel, pulse::Accumulation::sign_magnitude);
  std::int64_t commands = 0, clocks = 0;
  double error = 0;
  while (core->y1 != 0) {
    const bool is_command = core->command;
    core.clock();
    core->eval();
    ++clocks;
    const auto expected = is_command ? circle.step() : pulse::Pulse<2>{};
    commands += is_command;
    ASSERT_EQ(core->x_pulse, expected.step[0] != 0);
    ASSERT_EQ(core->y_pulse, expected.step[1] != 0);
    ASSERT_EQ((Point{core->y1, core->y2}), circle.at()) << commands;
    error = std::max(error, std::abs(std::hypot(double(core->y1), double(core->y2)) - double(radius)));
  }
  EXPECT_EQ(commands, 188'496);
  EXPECT_EQ(clocks, 100 * commands);  // 20 000 of 2 000 000
  EXPECT_EQ((Point{core->y1, core->y2}), (Point{0, 10'001}));
  EXPECT_NEAR(error, 1.231, 5e-4);
}

/// With counters, and overflow where r ≥ q: the circular DDA of fixed capacity, quarter for quarter and both ways.
TEST(KorenCircle, WithCountersIsTheCircularDdaOfItsCapacity) {
  Clocked<Vkoren_hw_carry> core;
  for (const std::int64_t radius : {1, 7, 100, 2'000, 10'000, 120'000}) {
    for (const bool grows_1 : {false, true}) {
      const Point start = grows_1 ? Point{0, radius} : Point{radius, 0}, end = {start.y, start.x};
      const pulse::Arc arc{start, end, grows_1 ? pulse::Direction::clockwise : pulse::Direction::counterclockwise};
      const auto steps = static_cast<std::uint32_t>(radius);
      load(core, {true, grows_1, q0, start.x, start.y, steps, steps});
      pulse::CircularDda dda(arc, {.order = pulse::Order::parallel, .preload = pulse::Preload::none, .capacity = q});
      while (!dda.done()) {
        const auto expected = dda.step();
        core.clock();
        core->eval();
        ASSERT_EQ(core->x_pulse, expected.step[0] != 0) << radius;
        ASSERT_EQ(core->y_pulse, expected.step[1] != 0) << radius;
        ASSERT_EQ((Point{core->y1, core->y2}), dda.at()) << radius;
        ASSERT_EQ(core->r1, dda.y().remainder()) << radius;
        ASSERT_EQ(core->r2, dda.x().remainder()) << radius;
      }
      EXPECT_EQ(core->left_x + core->left_y, 0u);
    }
  }
}

TEST(KorenHardware, IsEmptiedByReset) {
  Clocked<Vkoren_hw> core;
  load(core, {.f = q0, .begin_1 = q, .begin_2 = q, .steps_x = 9, .steps_y = 9});
  for (int clock = 0; clock < 4; ++clock) core.clock();
  core->rst = 1;
  core.clock();
  core->rst = 0;
  for (int clock = 0; clock < 4; ++clock) {
    core.clock();
    EXPECT_EQ(core->x_pulse | core->y_pulse | core->busy, 0);
    EXPECT_EQ(core->r1 | core->r2 | core->left_x | core->left_y, 0u);
  }
}

}  // namespace test_koren_hw
}  // namespace leadscrew::hardware
