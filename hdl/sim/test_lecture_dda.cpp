#include <Vlecture_dda.h>
#include <Vlecture_timer.h>
#include <Vup_down_counter.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/pulse/linear.hpp>
#include <random>

#include "clocked.hpp"

// The lectures' linear interpolator: feed DDA of 12 bits, axis DDAs of 16 bits, gates and counters.

namespace leadscrew::hardware {
namespace test_lecture_dda {

struct Line {
  int dx = 0, dy = 0, word = 0;
};

void load(Clocked<Vlecture_dda>& core, const Line& line, bool x_down, bool y_down) {
  core->rst = 0;
  core->S = static_cast<std::uint16_t>(line.word);
  core->dx = static_cast<std::uint16_t>(line.dx);
  core->dy = static_cast<std::uint16_t>(line.dy);
  core->pulses_x = static_cast<std::uint32_t>(line.dx);
  core->pulses_y = static_cast<std::uint32_t>(line.dy);
  core->x_down = x_down;
  core->y_down = y_down;
  core->encoder_x = core->encoder_y = 0;
  core->load = 1;
  core.clock();
  core->load = 0;
  core->eval();
}

/// (10 000, 5000) with S = 268: F = 2²⁸/600 = 447 392 pps, 2.2388 s.
TEST(LectureDda, Takes1001625ClocksForTheLineOfTheLecture) {
  Clocked<Vlecture_dda> core;
  load(core, {10'000, 5'000, 268}, false, false);
  pulse::FeedDda feed(1 << 12, 268);
  pulse::LinearDda<2> line({10'000, 5'000}, 1 << 16, pulse::Preload::none);
  std::int64_t clocks = 0, x = 0, y = 0;
  while (core->pdc_x != 0 || core->pdc_y != 0) {
    const bool is_command = feed.step();
    ASSERT_EQ(core->command, is_command);
    const auto expected = is_command ? line.step() : pulse::Pulse<2>{};
    core.clock();
    core->eval();
    ++clocks;
    ASSERT_EQ(core->x_pulse, expected.step[0]);
    ASSERT_EQ(core->y_pulse, expected.step[1]);
    x += core->x_pulse;
    y += core->y_pulse;
  }
  EXPECT_EQ(clocks, 1'001'625);
  EXPECT_EQ(x, 10'000);
  EXPECT_EQ(y, 5'000);
  EXPECT_EQ(core->busy, 0);
  EXPECT_EQ(core->udc_x, 10'000);  // no encoder has counted
  EXPECT_EQ(core->udc_y, 5'000);
  EXPECT_NEAR(static_cast<double>(clocks) / (static_cast<double>(1 << 28) / 600), 2.2388, 5e-5);
}

/// Both axes of random lines, one after the other, with pulses of encoders at random: PDC down to 0, UDC the difference.
TEST(LectureDda, CountsWhatPassesTheGateAndWhatTheEncoderSays) {
  Clocked<Vlecture_dda> core;
  core->rst = 1;
  core.clock();
  std::mt19937 random(1980);
  std::int64_t difference_x = 0, difference_y = 0;
  for (int round = 0; round < 40; ++round) {
    const Line drawn{static_cast<int>(random() % 60'000), static_cast<int>(random() % 60'000) + 1, 2400};
    const bool x_down = (random() & 1) != 0, y_down = (random() & 1) != 0;
    load(core, drawn, x_down, y_down);
    pulse::FeedDda feed(1 << 12, drawn.word);
    pulse::LinearDda<2> line({drawn.dx, drawn.dy}, 1 << 16, pulse::Preload::none);
    for (int clock = 0; clock < 5'000; ++clock) {
      const auto expected = feed.step() ? line.step() : pulse::Pulse<2>{};
      core->encoder_x = random() % 3 == 0;
      core->encoder_x_down = random() & 1;
      core->encoder_y = random() % 3 == 0;
      core->encoder_y_down = random() & 1;
      difference_x += (x_down ? -1 : 1) * expected.step[0] - core->encoder_x * (core->encoder_x_down ? -1 : 1);
      difference_y += (y_down ? -1 : 1) * expected.step[1] - core->encoder_y * (core->encoder_y_down ? -1 : 1);
      core.clock();
      core->eval();
      ASSERT_EQ(core->pdc_x, line.left(0));
      ASSERT_EQ(core->pdc_y, line.left(1));
      ASSERT_EQ(core->busy, !line.done());
      ASSERT_EQ(signed_of(core->udc_x, 16), difference_x);
      ASSERT_EQ(signed_of(core->udc_y, 16), difference_y);
    }
  }
}

TEST(LectureDda, LetsNoMorePulsesPassThanItsPositionDownCounterHolds) {
  Clocked<Vlecture_dda> core;
  load(core, {60'000, 60'000, 4'095}, false, false);
  core->pulses_x = 3;
  core->pulses_y = 0;
  core->load = 1;
  core.clock();
  core->load = 0;
  int x = 0;
  for (int clock = 0; clock < 1'000; ++clock) {
    core.clock();
    x += core->x_pulse;
    ASSERT_EQ(core->y_pulse, 0);
  }
  EXPECT_EQ(x, 3);
  EXPECT_EQ(core->busy, 0);
}

/// At its ends, as servo::PulseLoop's: the pulse is lost, the counter stays.
TEST(UpDownCounter, StaysAtItsEnds) {
  Clocked<Vup_down_counter> counter;
  counter->rst = 1;
  counter.clock();
  counter->rst = 0;
  std::mt19937 random(1980);
  std::int64_t count = 0, greatest = 0, least = 0;
  for (int clock = 0; clock < 20'000; ++clock) {
    const bool upwards = (clock / 100) % 2 == 0;
    counter->command = random() % 2;
    counter->command_down = random() % 8 == 0 ? upwards : !upwards;
    counter->encoder = random() % 2;
    counter->encoder_down = random() % 8 == 0 ? !upwards : upwards;
    const int change =
        counter->command * (counter->command_down ? -1 : 1) - counter->encoder * (counter->encoder_down ? -1 : 1);
    count = std::clamp<std::int64_t>(count + change, -8, 7);
    greatest = std::max(greatest, count);
    least = std::min(least, count);
    counter.clock();
    ASSERT_EQ(signed_of(counter->count, 4), count);
  }
  EXPECT_EQ(greatest, 7);
  EXPECT_EQ(least, -8);
}

/// The timer of 13 bits at 1024 pps: 8, 4 and 2 s for loads of 1, 2 and 4; the lecture's 3, 2.667 s.
TEST(LectureTimer, CarriesAfterTheDelaysOfTheLecture) {
  const auto first_carry = [](int word) {
    Clocked<Vlecture_timer> timer;
    timer->capacity = 1 << 13;
    timer->integrand = static_cast<std::uint16_t>(word);
    timer->preload = 0;
    timer->enable = 1;
    timer->load = 1;
    timer.clock();
    timer->load = 0;
    timer->eval();
    int clock = 1;
    for (; timer->overflow == 0; ++clock) {
      timer.clock();
      timer->eval();
    }
    return clock;
  };
  EXPECT_EQ(first_carry(1), 8192);
  EXPECT_EQ(first_carry(2), 4096);
  EXPECT_EQ(first_carry(4), 2048);
  EXPECT_EQ(first_carry(3), 2731);
  EXPECT_NEAR(first_carry(3) / 1024.0, 2.667, 5e-4);
}

}  // namespace test_lecture_dda
}  // namespace leadscrew::hardware
