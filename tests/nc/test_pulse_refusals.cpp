// What is refused of programs as pulses: while they run, and in the check before.

#include <gtest/gtest.h>

#include <string>

#include "pulses.hpp"

namespace leadscrew::nc {
namespace test_pulse_refusals {

using testing::Conditions;
using testing::pulse;

TEST(PulseProgram, RefusesWhatItCannotGive) {
  Conditions conditions;
  const auto problems = [&](const std::string& text) { return pulse(text, conditions).problems; };
  EXPECT_EQ(problems("G61 G1 X10 F12000\n"), "");
  EXPECT_EQ(problems("G61 G1 X10 F12010\n"), "1 pulse-velocity; ");
  EXPECT_EQ(problems("G61 G1 X10 Y10 F16900\n"), "");  // 200 mm/s of each axis
  EXPECT_EQ(problems("G61\nG2 X10 I5 F12100\n"), "2 pulse-velocity; ");
  conditions.options.shape = Shape::accelerate;
  EXPECT_EQ(problems("G61\nG2 X10 I5 F12100\n"), "");
  conditions.options.shape = Shape::constant;
  conditions.options.step_clocks = 10;
  EXPECT_EQ(problems("G61 G1 X10 F5990\n"), "");
  EXPECT_EQ(problems("G61 G1 X10 F6010\n"), "1 pulse-step-length; ");
  EXPECT_EQ(problems("G61 G0 X10\n"), "");  // as fast as can be
  conditions.options.step_clocks = 1;
  conditions.options.clock_pps = 100'000;
  EXPECT_EQ(problems("G61 G1 X10 F6010\n"), "1 pulse-rate; ");
  conditions.options.feed_capacity = 3000;
  EXPECT_EQ(problems("G61 G1 X10 F0.5\n"), "1 pulse-feed-word; ");
  conditions.machine.axes[1]->blu = 0.002;
  EXPECT_EQ(problems("G61 G1 X10 Y10 F600\n"), "");
  EXPECT_EQ(problems("G61 F600 G2 X10 I5\n"), "1 pulse-arc-units; ");
  conditions.machine = testing::nine_axes(1e-6);
  EXPECT_EQ(problems("G61 G1 X1900 F0.1\n"), "1 pulse-register; ");
}

/// In short lines as in long ones, and in arcs.
TEST(PulseProgram, RefusesAFeedHoweverShortItsBlocksAre) {
  const auto problem_of = [](const std::string& text) { return pulse(text).problems; };
  for (const std::string step : {"0.001", "0.002", "0.01", "0.1"}) {
    EXPECT_EQ(problem_of("G61 G91 F12010\nG1 X" + step + "\n"), "2 pulse-velocity; ") << step;
    EXPECT_EQ(problem_of("G61 G91 F11990\nG1 X" + step + "\n"), "") << step;
    EXPECT_EQ(problem_of("G61 G91 F16950\nG1 X" + step + " Y" + step + "\n"), "") << step;
    EXPECT_EQ(problem_of("G61 G91 F17000\nG1 X" + step + " Y" + step + "\n"), "2 pulse-velocity; ") << step;
  }
  EXPECT_EQ(problem_of("G61 F12100\nG2 X0.006 Y0 I0.003\n"), "2 pulse-velocity; ");
  EXPECT_EQ(problem_of("G61 F11900\nG2 X0.006 Y0 I0.003\n"), "");
}

struct Checked {
  std::int64_t errors = 0;
  std::string problems;  ///< "1:5 pulse-rate; "
};

Checked check(const std::string& text, const Conditions& conditions) {
  Checked checked;
  checked.errors = check_pulses(
      gcode::text_source(text), conditions.machine, conditions.tools, {}, conditions.options,
      [&](const base::Diagnostic& d) {
        checked.problems +=
            std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + std::string(d.code) + "; ";
      },
      [] { return true; });
  return checked;
}

/// Its places are none of the axes', which go in no lines and arcs there.
TEST(PulseProgram, RefusesTheTipsMoves) {
  Conditions conditions;
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    conditions.machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  const std::string tip = "G61 F600\nG1 X1\nG43.4\nG1 X10 A10 C30\nX20\nG2 X22 I1\n";
  const auto made = pulse(tip, conditions);
  EXPECT_EQ(made.problems, "4 pulse-tip-control; ");
  EXPECT_EQ(check(tip + "G49\nG1 X1 F13000\nM2\n", conditions).problems, "4:1 pulse-tip-control; 8:1 pulse-velocity; ");
  EXPECT_EQ(pulse("G61 F600\nG43.4\nG49\nG1 X10 A10 C30\nG2 X12 I1\n", conditions).problems, "");
}

TEST(PulseProgram, ChecksAProgramFromEndToEndFirst) {
  const Checked checked = check("G61 G1 X10 F13000\nX0 F100\n (up) Y10 F14000\nM2\n", {});
  EXPECT_EQ(checked.errors, 2);
  EXPECT_EQ(checked.problems, "1:1 pulse-velocity; 3:7 pulse-velocity; ");
}

/// Y is slow: did line 4 not begin where the one before would have ended, it would move Y by more than 1 mm.
TEST(PulseProgram, ChecksWhatTheReaderLeavesOfAProgram) {
  Conditions conditions;
  conditions.machine.axes[1]->velocity = 10;
  const Checked checked = check("G61 F6000\nG1 X10\nY10 X[1/0]\nX20 Y9\nY0\nX9999\nM2\n", conditions);
  EXPECT_EQ(checked.errors, 3);
  EXPECT_EQ(checked.problems, "3:8 division-by-zero; 5:1 pulse-velocity; 6:1 travel; ");
}

TEST(PulseProgram, IsCheckedUpToAHundredErrors) {
  std::string text = "G61 F13000\n";
  for (int i = 0; i < 300; ++i) text += i % 2 == 0 ? "G1 X1\n" : "G1 X0\n";
  EXPECT_EQ(check(text, {}).errors, 101);
}

/// Within one move too: each turn is a block.
TEST(PulseProgram, IsCheckedOnlyAsLongAsThatIsWanted) {
  const Conditions conditions;
  int asked = 0;
  const std::int64_t errors = check_pulses(
      gcode::text_source("G61 G3 X0 Y0 I10 P100000 F1000\nG1 X10 F13000\nM2\n"), conditions.machine, conditions.tools,
      {}, conditions.options, [](const base::Diagnostic&) {}, [&] { return ++asked < 10; });
  EXPECT_EQ(errors, 0);
  EXPECT_LE(asked, 12);
}

}  // namespace test_pulse_refusals
}  // namespace leadscrew::nc
