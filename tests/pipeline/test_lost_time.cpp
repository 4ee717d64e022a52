#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/pipeline/lost_time.hpp>
#include <string>
#include <vector>

#include "blended.hpp"

// Time that is lost against feed words: sums are those of the motion, and the cause is the limit that is at work.

namespace test_lost_time {

using namespace leadscrew;
using pipeline::Cause;

struct Lost {
  double seconds = 0;
  pipeline::LostByCause by_cause;
  std::vector<pipeline::BlockTime> blocks;
  base::AxisVector least{}, greatest{};
};

Lost lost_of(const std::string& text, const machine::Machine& machine = testing_support::wide_mill()) {
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  Lost lost;
  pipeline::LostTime words(machine, [&](const pipeline::BlockTime& block) { lost.blocks.push_back(block); });
  program.on_move([&](const gcode::Move& move) { words.observe(move); });
  while (program.prepare()) words.observe(program.cycle());
  words.finish();
  lost.seconds = program.summary().time_s;
  lost.by_cause = words.by_cause();
  lost.least = words.least_position(), lost.greatest = words.greatest_position();
  return lost;
}

double sum(const pipeline::LostByCause& lost) {
  double all = 0;
  for (const auto& [cause, seconds] : lost) all += seconds;
  return all;
}

/// `exact`: of the path as it is programmed, where it is not blended.
void expect_sums(const Lost& lost, double programmed_seconds, double accuracy) {
  double seconds = 0, least = 0;
  for (const pipeline::BlockTime& block : lost.blocks) seconds += block.seconds, least += block.least_seconds;
  EXPECT_NEAR(seconds, lost.seconds, 1e-9 * lost.seconds);
  EXPECT_NEAR(sum(lost.by_cause), seconds - least, 1e-9 * lost.seconds);
  EXPECT_NEAR(least, programmed_seconds, accuracy * programmed_seconds);
}

TEST(LostTime, IsTheTimeLessLengthOverFeed) {
  const Lost lost = lost_of("G21 G90 G61 F6000\nG1 X10\nY10 F1200\nX0 F3000\nY0\nM2\n");
  // A period in which a block ends belongs to one of the two.
  expect_sums(lost, 10 / 100.0 + 10 / 20.0 + 20 / 50.0, 0.001);
  ASSERT_EQ(lost.blocks.size(), 4U);
  EXPECT_NEAR(lost.blocks[1].length, 10, 0.02);
  EXPECT_NEAR(lost.blocks[1].feed_asked, 20, 1e-12);
  EXPECT_NEAR(lost.blocks[1].feed_reached, 20, 1e-4);
  EXPECT_NEAR(lost.blocks[1].middle[0], 10, 1e-9);
  EXPECT_NEAR(lost.blocks[1].middle[1], 5, 0.02);
  EXPECT_EQ(lost.greatest[0], 10);
  EXPECT_EQ(lost.least[1], 0);
}

TEST(LostTime, OnBlendsIsWithinAHundredthOfTheProgrammedPath) {
  std::string text = testing_support::head;
  double length = 0;
  for (int k = 1; k <= 40; ++k) {
    const double x = 5 * k, y = k % 2 * 4.0;
    text += "G1" + testing_support::word('X', x, 4) + testing_support::word('Y', y, 4) + "\n";
    length += std::hypot(5, 4);
  }
  expect_sums(lost_of(text + "M2\n"), length / 100, 0.01);
}

TEST(LostTime, IsToldOfTheAxisThatTakesIt) {
  machine::Machine machine = testing_support::wide_mill();
  machine.axes[base::index(base::Axis::Z)]->acceleration = 10;
  const Lost lost = lost_of("G21 G90 F6000\nG1 X50 Z20\nX0 Z0\nX5\nM2\n", machine);
  const auto ranked = pipeline::ranked(lost.by_cause);
  ASSERT_FALSE(ranked.empty());
  EXPECT_EQ(pipeline::name(ranked[0].first), "acceleration Z");
  EXPECT_EQ(pipeline::name(lost.blocks[0].cause), "acceleration Z");
  EXPECT_GT(ranked[0].second, 0.9 * sum(lost.by_cause));
}

TEST(LostTime, OfRestsIsThatOfDwellsAndStops) {
  const Lost lost = lost_of("G21 G90 F6000\nG1 X10\nG4 P0.5\nX20\nM2\n");
  EXPECT_NEAR(lost.by_cause.at({Cause::Kind::dwell, base::Axis::X}), 0.5, 0.003);
  ASSERT_EQ(lost.blocks.size(), 3U);
  EXPECT_EQ(lost.blocks[1].feed_asked, 0);
  EXPECT_NEAR(lost.blocks[1].lost(), 0.5, 0.003);
}

TEST(LostTime, OfRapidsIsCountedFromTheVelocityOfTheAxes) {
  const Lost lost = lost_of("G21 G90\nG0 X100\nM2\n");
  ASSERT_EQ(lost.blocks.size(), 1U);
  EXPECT_TRUE(std::isinf(lost.blocks[0].feed_asked));
  EXPECT_NEAR(lost.blocks[0].least_seconds, 100 / machine::mill3().limits(base::Axis::X).velocity, 1e-6);
}

TEST(LostTime, IsToldMoveByMoveOfACycle) {
  const Lost lost = lost_of("G21 G90 G98 F600\nG0 Z5\nG81 X10 Y0 Z-5 R1\nX20\nG80\nM2\n");
  // Up; over, down to R, down, up; and again.
  ASSERT_GE(lost.blocks.size(), 7U);
  double drilled = 0;
  for (const pipeline::BlockTime& block : lost.blocks) {
    if (std::isfinite(block.feed_asked)) {
      EXPECT_NEAR(block.length, 6, 0.05);
      drilled += block.least_seconds;
    }
  }
  EXPECT_NEAR(drilled, 1.2, 0.02);
}

RC_GTEST_PROP(LostTime, OfAnyWordsSumsUp, ()) {
  std::string text = testing_support::head;
  const int blocks = *rc::gen::inRange(1, 20);
  for (int i = 0; i < blocks; ++i) {
    text += *rc::gen::element<std::string>("G1", "G1", "G0", "G4 P0.01\nG1") +
            testing_support::word('X', *rc::gen::inRange(0, 300) / 10.0, 4) +
            testing_support::word('Y', *rc::gen::inRange(0, 300) / 10.0, 4) + " F" +
            std::to_string(*rc::gen::inRange(60, 9000)) + "\n";
  }
  RC_LOG() << text;
  const Lost lost = lost_of(text + "M2\n");
  double seconds = 0, least = 0;
  for (const pipeline::BlockTime& block : lost.blocks) seconds += block.seconds, least += block.least_seconds;
  RC_ASSERT(std::abs(sum(lost.by_cause) - (lost.seconds - least)) < 1e-9 * (1 + lost.seconds) || lost.blocks.empty());
  RC_ASSERT(std::abs(seconds - lost.seconds) < 1e-9 * (1 + lost.seconds) || lost.blocks.empty());
}

}  // namespace test_lost_time
