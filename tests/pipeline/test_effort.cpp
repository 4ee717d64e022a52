#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/planner/effort.hpp>
#include <random>
#include <string>

#include "worst_ratios.hpp"

// Planning takes no more work than so much for each second of the motion that comes of it, whatever the machine.

namespace test_effort {

using namespace leadscrew;
using planner::Effort;
using testing_support::worst_planned;

machine::Machine random_machine(std::minstd_rand& random, double least_jerk, double greatest_jerk) {
  machine::Machine machine = machine::mill3();
  const auto logarithmic = [&](double from, double to) {
    return from * std::pow(to / from, std::uniform_real_distribution<double>(0, 1)(random));
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    machine::AxisLimits& limits = *machine.axes[base::index(axis)];
    limits.velocity = least_jerk < 1e14 ? logarithmic(1, 1e4) : logarithmic(1, 20);
    limits.acceleration = least_jerk < 1e14 ? logarithmic(10, 1e5) : logarithmic(1e4, 1e5);
    limits.jerk = logarithmic(least_jerk, greatest_jerk);
  }
  return machine;
}

struct Planned {
  double effort = 0, seconds = 0, length = 0, worst = 0;  // worst: ratio of any limit
  std::int64_t simplified = 0;
  bool has_warning = false;
};

/// What motion has earned, what is there from the beginning, and one window that goes beyond it.
double most_effort(double seconds) {
  return Effort::units_per_second * seconds + 1.2 * Effort::greatest_balance + Effort::most_of_a_window;
}

/// Without words: chunk by chunk, as long as motion does not go on for longer than this, s.
Planned plan(const std::string& text, const machine::Machine& machine, double longest = 30) {
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
  Planned planned;
  constraints::LimitRatios ratios{};
  while (planned.seconds < longest && source.planner().effort() <= most_effort(longest)) {
    const std::optional<planner::Chunk> chunk = source.next();
    if (!chunk) break;
    planned.seconds += chunk->duration.value();
    planned.length += chunk->length;
    planner::raise_limit_ratios(*chunk, machine, ratios);
  }
  planned.effort = source.planner().effort();
  planned.simplified = source.planner().simplified_sections();
  const std::optional<base::Diagnostic> warning = source.warning();
  planned.has_warning = warning && warning->code == "planning-simplified";
  planned.worst = worst_planned(ratios);
  return planned;
}

const char* const curves[] = {
    "G21 G90 G17\nG3 X0 Y0 I10 J0 F2.5\nM2\n",
    "G21 G90 G17\nG3 X0 Y0 I10 J0 F6000\nM2\n",
    "G21 G90 G17\nG3 X0 Y0 Z5 I1 J0 F100000\nM2\n",
    "G21 G90 G17\nG5 X10 Y10 I5 J0 P0 Q-5 F600\nM2\n",
    "G21 G90 G17 G64 P0.05\nG1 X10 F1000\nG1 Y10\nG1 X0 Z3\nG1 Y0\nM2\n",
};

void expect_bounded(double least_jerk, double greatest_jerk, int machines) {
  std::minstd_rand random(7);
  for (int k = 0; k < machines; ++k) {
    const machine::Machine machine = random_machine(random, least_jerk, greatest_jerk);
    const Planned planned = plan(curves[static_cast<std::size_t>(k) % std::size(curves)], machine, 2);
    SCOPED_TRACE(k);
    EXPECT_GT(planned.seconds, 0);
    EXPECT_LE(planned.effort, most_effort(planned.seconds));
    EXPECT_LE(planned.worst, 1.001);
    EXPECT_EQ(planned.has_warning, planned.simplified > 0);
  }
}

TEST(Effort, IsBoundedWithLimitsOverFourDecades) {
  expect_bounded(1e2, 1e6, 10);
}
TEST(LongEffort, IsBoundedWithLimitsOverFourDecades) {
  expect_bounded(1e2, 1e6, 100);
}
TEST(LongEffort, IsBoundedWithoutAnyPracticalLimitOfJerk) {
  expect_bounded(1e14, 1.01e14, 10);
}

/// Speeds of a few mm/s, accelerations of tens of m/s²: a window of close knots is over within microseconds. It took
/// minutes of a processor; and is planned now with limits that are lower, but all the way to its end.
TEST(Effort, GivesWayToLowerLimitsWhereTheOptimumTakesTooMuch) {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
    machine::AxisLimits& limits = *machine.axes[base::index(axis)];
    limits.velocity = axis == base::Axis::X ? 8 : 9;
    limits.acceleration = 5e4;
    limits.jerk = 1e14;
  }
  const Planned planned = plan("G21 G90 G17\nG3 X0 Y0 I10 J0 F6000\nG1 X10\nM2\n", machine);
  EXPECT_LE(planned.effort, most_effort(planned.seconds));
  EXPECT_EQ(planned.simplified, 1);
  EXPECT_TRUE(planned.has_warning);
  EXPECT_LE(planned.worst, 1.001);
  EXPECT_NEAR(planned.length, 2 * 3.14159265358979 * 10 + 10, 0.05);
  // Hardly slower: a rise takes 20 ms more.
  EXPECT_LT(planned.seconds, 2 * 3.15 * 10 / 8 + 10 / 8.0 + 2);
}

TEST(Effort, IsFarFromItsBoundOnOrdinaryMotion) {
  for (const char* const text : curves) {
    const Planned planned = plan(text, machine::mill3());
    EXPECT_EQ(planned.simplified, 0) << text;
    EXPECT_LT(planned.effort, Effort::units_per_second * planned.seconds / 5 + Effort::greatest_balance / 80) << text;
  }
}

TEST(Effort, EndsWhenAskedToInsideOneWindow) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source("G21 G90 G17\nG3 X0 Y0 I10 J0 F6000\nG3 X0 Y0 I10 J0\nM2\n"), machine,
                            tools, {}, nullptr);
  int questions = 0;
  program.stop_when([&] { return ++questions == 3; });
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  EXPECT_EQ(questions, 3);
  ASSERT_TRUE(program.failure());
  EXPECT_EQ(program.failure()->code, "interrupted");
  EXPECT_EQ(words.back().state, base::MotionState::rest);
  EXPECT_LT(words.back().path_length, 2 * 2 * 3.14 * 10);
}

}  // namespace test_effort
