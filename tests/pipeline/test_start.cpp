#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <vector>

// Motion begun at a place of the path: the rest of the program, from rest.

namespace test_start {

using namespace leadscrew;

const std::string part =
    "G21 G90 G94 G17 F3000\nT1 M6\nM3 S1000\nM8\nG64 P0.05\nG1 X30\nY10\nG2 X50 Y-10 I20 J0\nG4 P0.02\nM9\nG61\nG1 "
    "X60\nM3 "
    "S2000\nX90\nG1 Y-40\nM2\n";

std::vector<base::Word> whole() {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools(std::vector<machine::Tool>{{.number = 1}});
  pipeline::Program program(gcode::text_source(part), machine, tools, {}, nullptr);
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  return words;
}

struct Rest {
  std::vector<base::Word> words;
  std::vector<base::Event> events;
};

Rest from(const base::Word& place) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools(std::vector<machine::Tool>{{.number = 1}});
  pipeline::MotionSource source(gcode::text_source(part), machine, tools, {}, nullptr);
  source.planner().start_at(place.path_length, place.line);
  interpolator::Controller controller(machine.period, place.position, 8, place.path_length);
  Rest rest;
  bool all = false;
  while (!all || !controller.idle()) {
    while (!all && controller.seconds_ahead() < 0.1) {
      auto chunk = source.next();
      all = !chunk;
      if (all) break;
      rest.events.insert(rest.events.end(), chunk->events.begin(), chunk->events.end());
      EXPECT_EQ(controller.offer(*chunk), interpolator::Controller::Offer::accepted);
    }
    rest.words.push_back(controller.next());
  }
  return rest;
}

TEST(Start, GoesOnFromAnyWordOfTheProgram) {
  const std::vector<base::Word> words = whole();
  const base::Word& last = words.back();
  for (std::size_t k = 0; k < words.size(); k += 23) {
    const Rest rest = from(words[k]);
    const base::Word &first = rest.words.front(), &end = rest.words.back();
    EXPECT_EQ(first.speed, 0) << k;
    EXPECT_NEAR(first.path_length, words[k].path_length, 1e-9) << k;
    EXPECT_NEAR(end.path_length, last.path_length, 1e-9) << k;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(first.position[i], words[k].position[i], 1e-9) << k;
      EXPECT_NEAR(end.position[i], last.position[i], 1e-9) << k;
    }
    EXPECT_GE(rest.words[1].path_length, words[k].path_length - 1e-12) << k;
  }
}

TEST(Start, TellsWhereThatIs) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools(std::vector<machine::Tool>{{.number = 1}});
  const auto place = [&](double path_length) {
    pipeline::MotionSource source(gcode::text_source(part), machine, tools, {}, nullptr);
    source.planner().start_at(path_length, base::Line{0});
    source.next();
    return source.planner().started_at();
  };
  const std::vector<base::Word> words = whole();
  for (std::size_t k = 0; k < words.size(); k += 101) {
    const auto at = place(words[k].path_length);
    ASSERT_TRUE(at) << k;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*at)[i], words[k].position[i], 1e-9) << k;
  }
  const double length = words.back().path_length;
  ASSERT_TRUE(place(length));
  EXPECT_NEAR((*place(length))[1], -40, 1e-12);
  EXPECT_FALSE(place(length + 1e-6));
}

TEST(Start, PutsSpindleAndCoolantInForceAgain) {
  using Kind = base::Event::Kind;
  const std::vector<base::Word> words = whole();
  const auto place = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.position[0] > 70; });
  ASSERT_NE(place, words.end());
  const Rest rest = from(*place);
  std::vector<Kind> kinds;
  for (const base::Event& event : rest.events) kinds.push_back(event.kind);
  const auto count = [&](Kind kind) { return std::count(kinds.begin(), kinds.end(), kind); };
  EXPECT_EQ(count(Kind::spindle_clockwise), 1);
  EXPECT_EQ(count(Kind::tool_change), 1);
  EXPECT_EQ(count(Kind::coolant_flood), 0);
  EXPECT_EQ(count(Kind::coolant_off), 1);
  EXPECT_EQ(count(Kind::program_end), 1);
  EXPECT_EQ(rest.events.back().kind, Kind::program_end);
}

/// The spindle that M6 has stopped, though a turret has turned since.
TEST(Start, KeepsTheSpindleStopped) {
  using Kind = base::Event::Kind;
  machine::Machine machine = machine::mill3();
  machine.dialect = machine::Dialect::fanuc_lathe;
  gcode::ReaderOptions options;
  options.dialect = machine.dialect;
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source("G97 S600 M3\nT0200 M6\nT0300\nG98 G1 X60. Z-50. F300\nM30\n"),
                                machine, tools, options, nullptr);
  source.planner().start_at(20, base::Line{4});
  const auto chunk = source.next();
  ASSERT_TRUE(chunk);
  std::vector<Kind> kinds;
  for (const base::Event& event : chunk->events) kinds.push_back(event.kind);
  const auto on = std::ranges::find(kinds, Kind::spindle_clockwise), off = std::ranges::find(kinds, Kind::tool_change);
  EXPECT_LT(on, off);
  EXPECT_LT(off, std::ranges::find(kinds, Kind::turret_indexing));
  EXPECT_NE(std::ranges::find(kinds, Kind::turret_indexing), kinds.end());
}

/// What goes in step with the spindle is told again where motion goes on in it, and overrides do not count there.
TEST(Start, GoesOnInStepWithTheSpindle) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source("G21 G90\nS300 M3\nG33 Z-20 K1.5\nG1 X5 F100\nM2\n"), machine, tools,
                                {}, nullptr);
  source.planner().start_at(10, base::Line{3});
  source.planner().override_feed(0.5);
  const auto chunk = source.next();
  ASSERT_TRUE(chunk);
  const auto in_step = std::ranges::find(chunk->events, base::Event::Kind::spindle_in_step, &base::Event::kind);
  ASSERT_NE(in_step, chunk->events.end());
  EXPECT_EQ(in_step->value, 1.5);
  EXPECT_TRUE(source.planner().allowed_overrides().in_step);
  double fastest = 0;
  for (const planner::Segment& segment : chunk->segments) fastest = std::max(fastest, segment.v0.value());
  EXPECT_NEAR(fastest, 7.5, 1e-6);
}

TEST(Start, StaysHeldInStepWithTheSpindle) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source("G21 G90\nS300 M3\nG33 Z-20 K1.5\nG1 X5 F100\nM2\n"), machine, tools,
                                {}, nullptr);
  source.planner().start_at(10, base::Line{3});
  source.planner().override_feed(0);
  EXPECT_FALSE(source.next());
  source.planner().override_feed(1);
  EXPECT_TRUE(source.next());
}

}  // namespace test_start
