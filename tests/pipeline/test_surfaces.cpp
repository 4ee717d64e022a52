// Surfaces in programs, judged: every axis within its limits, the tip and the tool's direction on their way, the feed as programmed.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>

#include "five_axes.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

namespace test_surfaces {

using namespace leadscrew;
using testing_support::any;
using testing_support::between;
using testing_support::Judged;
using testing_support::worst_judged;
using testing_support::worst_planned;

machine::ToolTable shaped_tools() {
  machine::Tool ball, bull;
  ball.number = 1;
  ball.diameter = 10;
  ball.corner_radius = 5;
  ball.offset[2] = 60;
  bull.number = 2;
  bull.diameter = 8;
  bull.corner_radius = 1;
  bull.offset[2] = 45;
  return machine::ToolTable({ball, bull});
}

Judged judge(const std::string& text, const machine::Machine& machine) {
  Judged outcome;
  const machine::ToolTable tools = shaped_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity != base::Severity::error) return;
    ++outcome.errors;
    RC_LOG() << problem.code << ": " << problem.message << "\n";
  });
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  outcome.summary = program.summary();
  outcome.verdict = referee.conclude();
  return outcome;
}

/// Some surfaces bend too much for the tool, or lead too near to a pole: that is said before anything moves.
bool is_read(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools = shaped_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  for (gcode::Move move; reader.next(move);) {
  }
  return reader.errors() == 0;
}

/// A biquadratic or bicubic net over about 12 by 8 mm.
std::string random_surface(double roughness) {
  const int order = any(3, 5), along = order + any(0, 2), across = order;
  char line[80];
  std::snprintf(line, sizeof line, "G6.4 D1 P%d Q%d I%d J%d\n", order, order, along, across);
  std::string text = line;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < along; ++i) {
      std::snprintf(line, sizeof line, "X%.3f Y%.3f Z%.3f\n", 12.0 * i / (along - 1) + between(-0.5, 0.5),
                    8.0 * j / (across - 1) + between(-0.5, 0.5), between(-roughness, roughness));
      text += line;
    }
  }
  return text;
}

void expect_kept(const Judged& outcome) {
  RC_ASSERT(outcome.errors == 0);
  for (const referee::Violation& each : outcome.verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << " line "
             << base::number(each.line) << "\n";
  RC_ASSERT(worst_planned(outcome.summary.plan) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(outcome.verdict) <= 1.001);
  RC_ASSERT(outcome.verdict.feed_max_ratio <= 1.001);
  RC_ASSERT(outcome.verdict.violation_count == 0);
}

RC_GTEST_PROP(Surfaces, InThreeAxesKeepEveryLimit, ()) {
  machine::Machine machine = machine::mill3();
  const std::string text = "G21 G90 G94 F" + std::to_string(any(1500, 8000)) + "\n" + random_surface(0.4) +
                           "G0 Z20\nG6.5 D1 T1 H" + (any(0, 2) == 0 ? "0.05" : "0.2") + " L" +
                           std::to_string(any(1, 3)) + " S" + std::to_string(any(1, 3)) + " P" +
                           std::to_string(any(1, 5)) + (any(0, 3) == 0 ? " K1" : "") + "\nM2\n";
  RC_LOG() << text;
  RC_PRE(is_read(text, machine));
  expect_kept(judge(text, machine));
}

RC_GTEST_PROP(Surfaces, InFiveAxesKeepEveryLimit, ()) {
  const machine::Machine machine = testing_support::five_axes();
  char words[80];
  std::snprintf(words, sizeof words, "G6.5 D1 T%d Q%.3f S%d A%.3f B%.3f%s\nM2\n", any(1, 3), between(1, 2.5), any(1, 3),
                between(3, 20), between(-8, 8), any(0, 3) == 0 ? " K1" : "");
  const std::string text =
      "G21 G90 G94 F" + std::to_string(any(1500, 8000)) + "\n" + random_surface(0.4) + "G43.4 H1\nG0 Z30\n" + words;
  RC_LOG() << machine.kinematics << "\n" << text << testing_support::limits_of(machine);
  RC_PRE(is_read(text, machine));
  const Judged outcome = judge(text, machine);
  expect_kept(outcome);
  if (outcome.verdict.tip_deviation_mm) {
    RC_ASSERT(*outcome.verdict.tip_deviation_mm <= outcome.verdict.tolerance_mm + 1e-6);
    RC_ASSERT(*outcome.verdict.orientation_deviation_deg <= outcome.verdict.orientation_tolerance_deg + 1e-6);
  }
}

/// On the exact path there is no tolerance to use up: passes and links are one section without a stop.
TEST(Surfaces, AreRunThroughWithoutAStop) {
  const std::string text =
      "G21 G90 G94 G61 F3000\nG6.4 D1 P3 Q3 I3 J3\nX0 Y0 Z0\nX12 Z2\nX24 Z0\nX0 Y8 Z1\nX12 Z3\nX24 Z1\nX0 Y16 Z0\nX12 "
      "Z2\nX24 "
      "Z0\nG0 Z20\nG6.5 D1 T1 Q1\nM2\n";
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools = shaped_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  std::size_t rests = 0, words = 0;
  base::MotionState before = base::MotionState::rest;
  while (program.prepare()) {
    const base::Word word = program.cycle();
    if (base::number(word.line) != 13) continue;
    ++words;
    if (word.state == base::MotionState::rest && before != base::MotionState::rest) ++rests;
    before = word.state;
  }
  EXPECT_GT(words, 5000u);
  EXPECT_LE(rests, 4u);  // over the first place, on it, behind the last, at the clearance
}

/// A surface of very many passes takes no more memory than one of few: moves are made as they are asked for.
TEST(Surfaces, AreReadOneMoveAtATime) {
  const std::string text =
      "G21 G90 F3000\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y10\nX20\nG0 Z20\nG6.5 D1 T1 Q0.01\nM2\n";
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools = shaped_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  std::size_t passes = 0, greatest = 0;
  for (gcode::Move move; reader.next(move);) {
    passes += reader.machined().surface && reader.machined().part == gcode::MachinedMove::Part::pass;
    greatest = std::max(greatest, move.curve.points.size());
  }
  EXPECT_EQ(passes, 1'001u);
  EXPECT_LE(greatest, 100u);
}

}  // namespace test_surfaces
