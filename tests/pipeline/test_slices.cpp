#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <vector>

#include "live_program.hpp"
#include "random_programs.hpp"

// A controller gets its motion in slices of 20 ms, so that it can be changed soon. While nobody changes it, its words
// are those of the whole motion.

namespace test_slices {

using namespace leadscrew;
using testing_support::LiveProgram;

std::vector<base::Word> words_of(const std::string& text, const machine::Machine& machine, std::size_t most) {
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Word> words;
  while (words.size() < most && program.prepare()) words.push_back(program.cycle());
  return words;
}

bool has_same_bits(const base::Word& a, const base::Word& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  for (std::size_t i = 0; i < a.position.size(); ++i) {
    if (!same(a.position[i], b.position[i])) return false;
  }
  return a.tick == b.tick && a.line == b.line && a.state == b.state && same(a.path_length, b.path_length) &&
         same(a.speed, b.speed) && same(a.feed, b.feed);
}

std::size_t first_difference(const std::string& text, const machine::Machine& machine) {
  constexpr std::size_t most = 20'000;
  const std::vector<base::Word> whole = words_of(text, machine, most);
  LiveProgram live(text, machine);
  live.run({}, most);
  std::size_t k = 0;
  while (k < whole.size() && k < live.words.size() && has_same_bits(whole[k], live.words[k])) ++k;
  return k < whole.size() ? k : most + 1;
}

RC_GTEST_PROP(Slices, MakeTheSameWords, ()) {
  machine::Machine machine = testing_support::random_machine();
  machine.period = {1'000'000};
  const std::string text = testing_support::RandomProgram::make(12);
  RC_LOG() << text << testing_support::limits_of(machine);
  RC_ASSERT(first_difference(text, machine) > 20'000U);
}

TEST(Slices, MakeTheSameWordsOnLongLinesAtRoundFigures) {
  EXPECT_GT(first_difference(
                "G21 G90 G94\nG1 X100 F6000\nX150\nG1 Y50\nG4 P0.5137\nG0 X0 Y0\nG64 P0.1\nG1 X10 F600\nG1 Y10\nM2\n",
                machine::mill3()),
            20'000U);
}

/// A hold asked for in a dwell stops its clock; nothing moves before it has ended.
TEST(Slices, HoldADwell) {
  const machine::Machine machine = machine::mill3();
  LiveProgram live("G21 G90 G94\nG1 X5 F6000\nG4 P2\nG1 X10\nM2\n", machine);
  EXPECT_TRUE(live.run({{1000, 0, 0}, {4000, 1, 0}}, 10'000));
  const auto at_five =
      std::count_if(live.words.begin(), live.words.end(), [](const base::Word& word) { return word.position[0] == 5; });
  EXPECT_GE(at_five, 4900);
  EXPECT_LE(at_five, 5100);
  EXPECT_EQ(live.words.back().position[0], 10);
}

/// Wherever the planner falls silent: mostly as soon as a stop along a line takes, v/a + a/J = 0.1 s here, or √(4v/J)
/// where that does not come to a; nowhere later than in some such times.
TEST(Slices, StopSoon) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  const std::string text =
      "G21 G90 G94 G17 F3000\nG64 P0.05\nG1 X30\nG1 X5 Y8\nG1 X20 Y18\nG3 X20 Y38 I0 J10\nG1 X0\nG5 I10 J0 P0 Q-10 X30 "
      "Y0\nG2 X30 Y0 I-8 J0\nM2\n";
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
  source.planner().slice(0.02);
  std::vector<double> stops;
  while (const auto chunk = source.next()) {
    if (chunk->stop_tail.empty()) continue;
    const planner::Segment& last = chunk->stop_tail.back();
    stops.push_back((last.begin + last.duration - chunk->end()).value());
  }
  ASSERT_GT(stops.size(), 150U);
  std::sort(stops.begin(), stops.end());
  EXPECT_LE(stops[stops.size() * 9 / 10], 0.2);
  EXPECT_LE(stops.back(), 0.4);
}

}  // namespace test_slices
