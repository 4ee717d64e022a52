// Koren's NC program: its published rates, its path beside the bare interpolators of room pulse/, the override, and
// what an interrupt costs.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "blocks.hpp"

namespace leadscrew::nc {
namespace test_nc_program {

using pulse::Direction;
using testing::arc;
using testing::line;
using testing::source;

/// To its end; returns the interrupts.
std::int64_t travel(NcProgram& program, std::int64_t most = 100'000'000) {
  std::int64_t interrupts = 0;
  for (; !program.done() && interrupts < most; ++interrupts) program.interrupt();
  EXPECT_TRUE(program.done());
  return interrupts;
}

constexpr double blu_in = 0.0001;

TEST(KorenNcProgram, GivesOneCommandAnInterruptAt30InchesAMinute) {
  const NcOptions options;
  EXPECT_EQ(NcProgram::feed_word(30), options.feed_capacity);
  EXPECT_EQ(options.clock_pps, 30 / 60.0 / blu_in);              // 5000 pulses/s
  EXPECT_EQ(1e6 / static_cast<double>(options.clock_pps), 200);  // µs
  NcProgram program(options, source({line({5000}, NcProgram::feed_word(30))}));
  EXPECT_EQ(travel(program), 5000);  // half an inch in a second
}

TEST(KorenNcProgram, GivesTwelvePoint34InchesAMinuteByTheWord1234) {
  EXPECT_EQ(NcProgram::feed_word(12.34), 1234);
  constexpr std::int64_t distance = 1'234'000;  // BLU: ten minutes
  NcProgram program({}, source({line({distance}, 1234)}));
  const std::int64_t interrupts = travel(program);
  EXPECT_EQ(program.position()[0], distance);
  const double pps = 5000.0 * static_cast<double>(distance) / static_cast<double>(interrupts);
  EXPECT_NEAR(pps, 2056.67, 0.005);
  EXPECT_NEAR(pps * blu_in * 60, 12.34, 1e-4);
}

TEST(KorenNcProgram, GoesRoundACircleOfTenThousand) {
  constexpr std::int64_t radius = 10'000;
  NcProgram program({}, source({arc({{radius, 0}, {radius, 0}, Direction::counterclockwise}, 3000)}));
  double worst = 0;
  std::int64_t interrupts = 0, x = radius, y = 0;
  while (!program.done() && interrupts < 10 * radius) {
    const AxisPulse pulse = program.interrupt();
    ++interrupts;
    x += pulse.step[0];
    y += pulse.step[1];
    worst = std::max(worst, std::abs(std::hypot(static_cast<double>(x), static_cast<double>(y)) - radius));
  }
  EXPECT_EQ(x, radius);
  EXPECT_EQ(y, 0);
  EXPECT_LT(worst, 0.9655);  // bound of eq. 27 with half-full registers
  EXPECT_NEAR(static_cast<double>(interrupts), 2 * std::numbers::pi * radius, 4);
}

/// The same pulses as interpolator and feed DDA of room pulse/, interrupt by interrupt.
template <typename Bare>
void expect_same(NcProgram& program, pulse::FeedDda feed, Bare bare) {
  while (!bare.done()) {
    ASSERT_FALSE(program.done());
    const auto expected = feed.step() ? bare.step() : pulse::Pulse<2>{};
    const AxisPulse made = program.interrupt();
    ASSERT_EQ(made.step[0], expected.step[0]);
    ASSERT_EQ(made.step[1], expected.step[1]);
  }
  EXPECT_TRUE(program.done());
}

RC_GTEST_PROP(KorenNcProgram, MakesThePulsesOfTheBareInterpolators, ()) {
  const auto word = *rc::gen::inRange<std::int64_t>(1, 3001);
  const auto a = *rc::gen::inRange<std::int64_t>(-400, 401), b = *rc::gen::inRange<std::int64_t>(1, 401);
  NcProgram straight({}, source({line({a, b}, word)}));
  expect_same(straight, {3000, word},
              pulse::LinearDda<2>({a, b}, pulse::capacity_for(a * a + b * b), pulse::Preload::half));
  // To an end on an axis: others are stepped out, where the bare DDA waits.
  const auto k = *rc::gen::inRange<std::int64_t>(1, 200);
  const pulse::Arc turn{*rc::gen::element(pulse::Point{3 * k, 4 * k}, pulse::Point{-4 * k, -3 * k}),
                        *rc::gen::element(pulse::Point{5 * k, 0}, pulse::Point{0, -5 * k}),
                        *rc::gen::element(Direction::clockwise, Direction::counterclockwise)};
  NcProgram round({}, source({arc(turn, word)}));
  expect_same(round, {3000, word}, pulse::CircularDda(turn));
}

TEST(NcProgram, KeepsItsShareOfACommandFromBlockToBlock) {
  std::vector<Block> blocks(300, line({7}, 1000));
  NcProgram program({}, source(blocks));
  EXPECT_EQ(travel(program), 300 * 7 * 3);
  EXPECT_EQ(program.position()[0], 300 * 7);
}

TEST(NcProgram, TakesFeedFromTheAdaptiveControl) {
  const auto interrupts_at = [](int thousandths, std::int64_t word) {
    NcProgram program({}, source({line({3000}, word)}));
    program.override_feed(thousandths);
    return travel(program);
  };
  EXPECT_EQ(interrupts_at(1000, 1000), 9000);
  EXPECT_EQ(interrupts_at(500, 1000), 18000);
  EXPECT_EQ(interrupts_at(2000, 1000), 4500);
  EXPECT_EQ(interrupts_at(5000, 1000), 4500);  // no factor beyond 2
  EXPECT_EQ(interrupts_at(2000, 2000), 3000);  // the register holds no more
}

TEST(NcProgram, StandsAtAnOverrideOfZero) {
  NcProgram program({}, source({line({100}, 3000)}));
  for (int i = 0; i < 10; ++i) program.interrupt();
  program.override_feed(0);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(program.interrupt(), AxisPulse{});
  program.override_feed(full_override);
  EXPECT_EQ(travel(program), 90);
  EXPECT_EQ(program.position()[0], 100);
}

TEST(NcProgram, ClampsAnOverrideAtTheBlocksGreatestWord) {
  Block block = line({1500}, 1000);
  block.greatest_word = 1500;
  NcProgram program({}, source({block}));
  program.override_feed(2000);
  EXPECT_EQ(travel(program), 3000);
}

TEST(NcProgram, MovesAxesPointToPointEachForItself) {
  Block block;
  block.kind = Block::Kind::point_to_point;
  block.delta = {30, -100, 7};
  NcProgram program({}, source({testing::with_word(block, 3000)}));
  for (int i = 0; i < 30; ++i) program.interrupt();
  EXPECT_EQ(program.position(), (LatticeVector{30, -30, 7}));
  EXPECT_EQ(travel(program), 70);
  EXPECT_EQ(program.position(), (LatticeVector{30, -100, 7}));
}

TEST(NcProgram, WaitsAndPassesOverBlocksWithoutSteps) {
  Block dwell;
  dwell.kind = Block::Kind::dwell;
  dwell.dwell_clocks = 50;
  NcProgram program({}, source({line({10}, 3000), dwell, line({}, 3000), line({0, 10}, 3000)}));
  EXPECT_EQ(travel(program), 70);
  EXPECT_EQ(program.position(), (LatticeVector{10, 10}));
}

// What 85 instructions, 170 of 200 µs, are in the paper.
TEST(NcProgram, CountsLessThanThePapersInstructions) {
  NcProgram program({}, source({arc({{10000, 0}, {10000, 0}, Direction::counterclockwise}, 1234)}));
  travel(program);
  const OperationCount& count = program.operations();
  // Feed 5 with the test for a dwell 6; kind 1; two axes of 2 tests, 4 for the integrator, 4 for an overflow; output 2,
  // position 3 each; two tests at last.
  EXPECT_EQ(count.worst, 6 + 1 + 2 * (6 + 4) + 2 * 5 + 2);
  EXPECT_LE(count.worst, 85);
  EXPECT_EQ(count.interrupts, program.interrupts());
  // Without a command an interrupt is 5 of them.
  EXPECT_GT(count.mean(), 5);
  EXPECT_LT(count.mean(), static_cast<double>(count.worst));
  EXPECT_EQ(program.initiations().interrupts, 1);
}

}  // namespace test_nc_program
}  // namespace leadscrew::nc
