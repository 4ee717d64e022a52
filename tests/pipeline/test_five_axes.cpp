#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <trunnion.hpp>
#include <vector>

#include "five_axes.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Tool centre point control: the tip stays within P of its path and the rotary axes within E, at the programmed feed, and
// every axis within its limits, by the referee's own kinematics.

namespace test_five_axes {

using namespace leadscrew;
using testing_support::any;
using testing_support::five_axes;
using testing_support::FiveAxisProgram;
using testing_support::judge;
using testing_support::Judged;
using testing_support::limits_of;
using testing_support::two_tools;
using testing_support::worst_judged;
using testing_support::worst_planned;

RC_GTEST_PROP(FiveAxes, KeepEveryLimitAndEveryPoint, ()) {
  const machine::Machine machine = five_axes();
  const std::string text = FiveAxisProgram(machine).make(any(1, 8));
  RC_LOG() << machine.kinematics << "\n" << text << limits_of(machine);
  const Judged outcome = judge(text, machine);
  RC_ASSERT(outcome.errors == 0);
  RC_ASSERT(worst_planned(outcome.summary.plan) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(outcome.verdict) <= 1.001);
  RC_ASSERT(outcome.verdict.feed_max_ratio <= 1.001);
  for (const referee::Violation& each : outcome.verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << " line "
             << base::number(each.line) << "\n";
  RC_ASSERT(outcome.verdict.violation_count == 0);
  if (outcome.verdict.tip_deviation_mm) {
    RC_ASSERT(*outcome.verdict.tip_deviation_mm <= outcome.verdict.tolerance_mm + 1e-6);
    RC_ASSERT(*outcome.verdict.orientation_deviation_deg <= outcome.verdict.orientation_tolerance_deg + 1e-6);
  }
  RC_ASSERT(outcome.summary.bound_s <= outcome.summary.time_s * (1 + 1e-6));
}

/// All axes as slow as can be drawn, at the corner of where they can lie.
machine::Machine slow_machine(const char* preset, bool is_nutating) {
  machine::Machine machine;
  machine.kinematics = preset;
  machine.rotary_chain = machine::preset_chain(preset);
  machine.rotary_chain->tool_zero = {-80, -80, -80};
  for (machine::RotaryAxis& axis : machine.rotary_chain->axes) {
    axis.point = {-80, -80, -80};
    machine.axes[base::index(axis.axis)] = machine::AxisLimits{-1e5, 1e5, 5, 50, 1000, 0.001};
  }
  if (is_nutating) machine.rotary_chain->axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e5, 1e5, 5, 50, 1000, 0.001};
  machine.period = {1'000'000};
  return machine;
}

/// Where neither axis is across the other, the tool turns by more than both do by Pythagoras' sum.
TEST(FiveAxes, KeepTheDirectionOfNutatingHeadsAndTables) {
  for (const char* const preset : {"table-table-bc", "head-head-bc"}) {
    const machine::Machine machine = slow_machine(preset, true);
    const Judged outcome = judge(
        "G21 G90 G94 G17 F1200\nG64 P0.002 E0.002\nG43.4 H1\nG1 B5.078 C-10.458\nG1 X-0.6 Y-0.6 Z-0.6\n"
        "G1 X-1.2 Y-1.2 Z-1.2\nG1 X-1.8 Y-1.8 Z-1.8\nG1 X0 B5.2 C-10\nG1 X3 B5 C-10.2\nG1 X0 B5.1 C-10.3\nM2\n",
        machine);
    EXPECT_EQ(outcome.errors, 0);
    EXPECT_EQ(outcome.verdict.violation_count, 0);
    EXPECT_LE(outcome.verdict.orientation_deviation_deg.value(), 0.002 + 1e-6);
  }
}

/// The space in which P and E are kept is that of the first move that travels, for the referee as for motion.
TEST(FiveAxes, AreJudgedByTheTolerancesOfWhatTravels) {
  for (const char* const standing : {"G64 P0.002 E0.002\nG4 P0.01\n", "G64 P0.0001 E0.002\nG1 X1\n"}) {
    const Judged outcome =
        judge("G21 G90 G94 G17 F300\nG43.4 H1\n" + std::string(standing) +
                  "G64 P0.002 E0.02\nG1 X-0.6 Y-0.6 Z-0.6\nG1 X-1.2 Y-1.2 Z-1.2 A-1.2 B-1.2\nG1 X-1.8 Y-1.8 Z-1.8\n"
                  "G2 X-1.2 Y-1.8 I0.3 A-20 B-20\nG1 X-3 Y-1.2 A-21\nM2\n",
              slow_machine("head-b-table-a", false));
    EXPECT_EQ(outcome.errors, 0);
    EXPECT_EQ(outcome.verdict.violation_count, 0) << standing;
  }
}

/// Words are differenced three times: at so short a period nothing may be left of rounding in turning.
TEST(FiveAxes, KeepJerkAtTheShortestPeriod) {
  machine::Machine machine = testing_support::trunnion(5);
  machine.period = {10'000};
  const std::string far =
      "G21 G90 G94 G17 G61\nG0 A20 C30\nG43.4\nG0 X150 Z50\nG1 X-120 Y80 Z20 A60 C200 F9000\n"
      "G1 X80 Y-120 Z0 A-40 C-160\nG3 X60 Y-100 I-10 J10 C60 F3000\nM2\n";
  for (const std::string& text : {far, testing_support::blade_program("P0.02 E0.1", 2, 80)}) {
    const Judged outcome = judge(text, machine);
    EXPECT_EQ(outcome.errors, 0);
    EXPECT_LE(worst_judged(outcome.verdict), 1.001);
    EXPECT_EQ(outcome.verdict.violation_count, 0);
  }
}

/// Both tolerances may be used up: where only rotary axes have corners, a greater one of the direction is faster whatever that
/// of the tip is.
TEST(FiveAxes, UseTheToleranceOfTheDirectionApart) {
  const machine::Machine machine = testing_support::trunnion();
  std::string corners = "G0 A20 C0\nG43.4\nG0 X40 Y0 Z0\nF3000\n";
  for (int k = 1; k <= 30; ++k)
    corners += "G1 X" + std::to_string(40 - 2 * k) + " A" + std::to_string(20 + k % 2) + "\n";
  double before = 0;
  for (const char* const tolerances : {"P0.02 E0.5", "P0.02 E0.1", "P0.02 E0.02"}) {
    const Judged outcome = judge("G21 G90 G94 G17 G64 " + std::string(tolerances) + "\n" + corners + "M2\n", machine);
    EXPECT_EQ(outcome.errors, 0);
    EXPECT_EQ(outcome.verdict.violation_count, 0) << tolerances;
    EXPECT_GT(outcome.summary.time_s, 1.02 * before) << tolerances;
    before = outcome.summary.time_s;
  }
}

/// Without a tool and with all rotary axes at 0, tool centre point control changes nothing.
TEST(FiveAxes, MoveAsThreeWhereNothingTurns) {
  machine::Machine machine = machine::mill3();
  const std::string lines = "G1 X20 Y5 F2000\nG3 X25 Y10 I0 J5\nG1 Z-3\nG2 X20 Y10 I-2.5\nM2\n";
  const auto plain = judge("G21 G90 G64 P0.01\n" + lines, machine);
  machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  const auto controlled = judge("G21 G90 G64 P0.01\nG43.4\n" + lines, machine);
  EXPECT_EQ(controlled.errors, 0);
  EXPECT_NEAR(controlled.summary.time_s, plain.summary.time_s, 1e-3 * plain.summary.time_s);
  EXPECT_EQ(controlled.verdict.violation_count, 0);
}

/// The tip stands while the table turns under it: the linear axes follow a circle.
TEST(FiveAxes, HoldTheTipWhileTheTableTurns) {
  machine::Machine machine = machine::mill3();
  machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  const std::string text = "G21 G90 G61\nG0 X40 Y0 Z0\nG43.4\nG1 C90 F1800\nM2\n";
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  base::AxisVector last{};
  double least = 1e9, greatest = 0;
  while (program.prepare()) {
    last = program.cycle().position;
    if (last[5] <= 0) continue;
    least = std::min(least, std::hypot(last[0], last[1]));
    greatest = std::max(greatest, std::hypot(last[0], last[1]));
  }
  EXPECT_NEAR(least, 40, 1e-12);
  EXPECT_NEAR(greatest, 40, 1e-12);
  EXPECT_NEAR(last[0], 0, 1e-12);
  EXPECT_NEAR(std::abs(last[1]), 40, 1e-12);
  EXPECT_EQ(last[5], 90);
}

/// Where axes and tip go differently fast, words tell the feed of the tip, as programmed.
TEST(FiveAxes, TellTheFeedOfTheTip) {
  machine::Machine machine = machine::mill3();
  machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  const std::string text = "G21 G90 G61\nG0 X40 Y0 Z0\nG43.4\nG1 X20 C90 F600\nM2\n";
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  double greatest = 0;
  std::size_t at_feed = 0;
  while (program.prepare()) {
    const base::Word word = program.cycle();
    if (base::number(word.line) != 4) continue;
    greatest = std::max(greatest, word.feed);
    if (std::abs(word.feed - 10) <= 1e-6) ++at_feed;
  }
  EXPECT_LE(greatest, 10 * (1 + 1e-9));
  EXPECT_GE(at_feed, 1000U);
}

/// A degree counts no less than a 64th of what it usually does: of the second E 2.6e-4 mm would be left.
TEST(FiveAxes, KeepALesserToleranceOfTheDirectionBehindAGreaterOne) {
  machine::Machine machine = machine::mill3();
  machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  const Judged outcome = judge(
      "G21 G90 G94 G17 F1200\nG64 P0.002 E0.273\nG43.4 H1\nG1 X9.351 Y0.577 Z-0.872 A0.755 C0.894\n"
      "G1 A42.550 C-42.745\nG64 P0.023 E0.036\nG1 X9.327 Y0.934 Z-0.657\nG1 X20.096 Y0.934 A41.649 C-45.562\nM2\n",
      machine);
  EXPECT_EQ(outcome.errors, 0);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
  EXPECT_LE(worst_judged(outcome.verdict), 1.001);
}

/// A hold just before coordinates change is none of the rest in which they do: motion goes on from it.
TEST(FiveAxes, MayStandALittleBeforeCoordinatesChange) {
  const Judged outcome = judge(
      "G21 G90 G17 G61\nG0 A-94.6671468354118 C69.7893608066499\nG4 P0.1\nG0 A-94.6672 C69.7894\nG43.4 H1\n"
      "G0 X0 Y0 Z0\nG4 P0.01\nM2\n",
      testing_support::trunnion(5));
  EXPECT_EQ(outcome.errors, 0);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
}

/// Where control begins anew the tip's place is computed from the axes; told once more it differs in its last digits, by less
/// than the axes do.
TEST(FiveAxes, RestWhereTheyAreToldOfWhereTheyAre) {
  const machine::Machine machine = testing_support::trunnion(5);
  for (const char* const mode : {"G61", "G64 P0.01"}) {
    for (int k = 0; k < 40; ++k) {
      char place[100];
      std::snprintf(place, sizeof place, "G0 X%.3f Y%.3f Z%.3f A%.3f C%.3f\n", 38.273 - 1.7 * k, -32.751 + 0.93 * k,
                    1.376 + 0.19 * k, 19.311 + k, 25.902 + 7.3 * k);
      const std::string there = std::string("G21 G90 ") + mode + "\nG43 H1\nM428\n" + place;
      const Judged once = judge(there + "M2\n", machine);
      const Judged twice = judge(there + "M429\nM428\n" + place + "M2\n", machine);
      EXPECT_EQ(twice.errors, 0);
      EXPECT_EQ(twice.verdict.violation_count, 0) << place;
      EXPECT_LE(twice.summary.time_s, once.summary.time_s + 0.002) << place;  // two words
    }
  }
  // And behind a corner that cuts what there is of it.
  const Judged cut = judge(
      "G21 G90 G17 G94 F8000\nG64 P0.01 E0.05\nG43.4 H2\nG1 Y-0.9 A62.53 C-0.84\nG1 X-0.11 Z-5.23 A62.645 C-1.99\nG1 "
      "C-43.344\nG43.4 H2\nG0 X-0.11 Y-0.9 Z-5.23 A62.645 C-43.344\nM2\n",
      machine);
  EXPECT_EQ(cut.errors, 0);
  EXPECT_EQ(cut.verdict.violation_count, 0);
}

}  // namespace test_five_axes
