#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>

#include "live_program.hpp"
#include "random_program.hpp"
#include "worst_ratios.hpp"

// Tool centre point control: the tip stays within P of its path and the rotary axes within E, at the programmed feed, and
// every axis within its limits, by the referee's own kinematics.

namespace test_five_axes {

using namespace leadscrew;
using testing_support::any;
using testing_support::Intervention;
using testing_support::limits_of;
using testing_support::LiveProgram;
using testing_support::logarithmic;
using testing_support::worst_judged;
using testing_support::worst_planned;

double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}

machine::Vector place() {
  return {between(-80, 80), between(-80, 80), between(-80, 80)};
}

/// A preset with its axes anywhere, or nutating; limits over two decades.
machine::Machine five_axes() {
  machine::Machine machine;
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = place();
    axis.sign = any(0, 2) == 0 ? 1 : -1;
  }
  if (any(0, 4) == 0) chain.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  chain.tool_zero = place();
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  const auto give = [&](base::Axis axis) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(10, 500), logarithmic(100, 1e4), logarithmic(2000, 1e6), 0.001};
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) give(axis);
  for (const machine::RotaryAxis& axis : chain.axes) give(axis.axis);
  machine.period = {1'000'000};
  return machine;
}

class FiveAxisProgram {
 public:
  explicit FiveAxisProgram(const machine::Machine& machine) {
    for (std::size_t k = 0; k < 2; ++k) letters_[k] = base::letter(machine.rotary_chain->axes[k].axis);
  }

  std::string make(int blocks) {
    text_ = "G21 G90 G94 G17 F1200\n";
    path_mode();
    begin();
    for (int k = 0; k < blocks; ++k) block();
    return text_ + "M2\n";
  }

 private:
  void word(char letter, double value) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.3f", letter, value);
    text_ += word;
  }
  void begin() { text_ += "G43.4 H1\n"; }
  void path_mode() {
    if (any(0, 5) == 0) {
      text_ += "G61\n";
      return;
    }
    text_ += "G64";
    word('P', logarithmic(2e-3, 0.2));
    if (any(0, 2) == 0) word('E', logarithmic(2e-3, 1));
    text_ += '\n';
  }
  void angles(double most) {
    for (std::size_t k = 0; k < 2; ++k) word(letters_[k], angle_[k] += between(-most, most));
  }
  void line(const char* code, double most, double turn) {
    text_ += code;
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], at_[i] += between(-most, most));
    if (any(0, 3) > 0) angles(turn);
    text_ += '\n';
  }
  void block() {
    switch (any(0, 12)) {
      case 0:
        return line("G0", 30, 40);
      case 1:
        text_ += "G1";
        angles(60);
        text_ += '\n';
        return;
      case 2:
        return arc();
      case 3:
        text_ += "F" + std::to_string(any(100, 6000)) + "\n";
        return;
      case 4:
        text_ += "G4 P0.01\n";
        return;
      case 5:
        return path_mode();
      case 6:
        text_ += any(0, 2) == 0 ? "G49\nG43.4 H2\n" : "G43.4 H1\n";
        return;
      case 7:
      case 8:
        for (int k = any(3, 10); k > 0; --k) line("G1", 0.6, 1.2);
        return;
      default:
        return line("G1", 15, 25);
    }
  }
  /// Half a circle in XY, with the rotary axes going along.
  void arc() {
    const double radius = between(0.3, 8);
    line("G1", 1, 1);
    text_ += any(0, 2) == 0 ? "G2" : "G3";
    word('X', at_[0] += 2 * radius);
    word('Y', at_[1]);
    word('I', radius);
    word('J', 0);
    if (any(0, 2) == 0) angles(20);
    text_ += '\n';
  }

  std::string text_;
  std::array<char, 2> letters_{};
  std::array<double, 2> angle_{};
  std::array<double, 3> at_{};
};

machine::ToolTable two_tools() {
  machine::Tool first, second;
  first.number = 1;
  first.offset[2] = 73.25;
  second.number = 2;
  second.offset = {1.5, -2, 41};
  return machine::ToolTable({first, second});
}

struct Judged {
  pipeline::Summary summary;
  referee::Verdict verdict;
  int errors = 0;
};

Judged judge(const std::string& text, const machine::Machine& machine) {
  Judged outcome;
  const machine::ToolTable tools = two_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error) ++outcome.errors;
  });
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  outcome.summary = program.summary();
  outcome.verdict = referee.conclude();
  return outcome;
}

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

}  // namespace test_five_axes
