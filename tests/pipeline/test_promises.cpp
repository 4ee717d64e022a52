#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// The promises of the whole, judged by the referee: limits, geometry and end points on random programs and on the
// examples.

namespace test_promises {

using namespace leadscrew;
using testing_support::any;
using testing_support::limits_of;
using testing_support::logarithmic;
using testing_support::random_machine;
using testing_support::RandomProgram;
using testing_support::worst_judged;
using testing_support::worst_planned;

struct Outcome {
  pipeline::Summary summary;
  referee::Verdict verdict;
  std::vector<base::Diagnostic> diagnostics;
  std::vector<base::AxisVector> positions;  ///< of the words, when kept
};

enum class Keep { nothing, positions };

Outcome run(const std::string& text, const machine::Machine& machine, const machine::ToolTable& tools = {},
            Keep keep = Keep::nothing) {
  Outcome outcome;
  pipeline::Program program(gcode::text_source(text), machine, tools, {},
                            [&](const base::Diagnostic& problem) { outcome.diagnostics.push_back(problem); });
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) {
    const base::Word word = program.cycle();
    referee.observe(word.position);
    if (keep == Keep::positions) outcome.positions.push_back(word.position);
  }
  outcome.summary = program.summary();
  outcome.verdict = referee.conclude();
  return outcome;
}

/// Rejected text would make a property true of nothing.
bool has_error(const Outcome& outcome) {
  return std::any_of(outcome.diagnostics.begin(), outcome.diagnostics.end(),
                     [](const base::Diagnostic& problem) { return problem.severity == base::Severity::error; });
}

/// A period between 10 µs and 20 ms that keeps the train of words below a hundred thousand.
base::Period affordable_period(double seconds) {
  const double least = std::max(10e-6, seconds / 1e5);
  const double period = least * std::pow(20e-3 / least, any(0, 1001) / 1000.0);
  return {std::clamp<std::int64_t>(static_cast<std::int64_t>(period * 1e9), 10'000, 20'000'000)};
}

constexpr int most_blocks = 10;  // of a random program: more of them take longer and show no more

void keep_every_limit_and_every_point() {
  const std::string text = RandomProgram::make(most_blocks);
  machine::Machine machine = random_machine();
  RC_LOG() << text << limits_of(machine);
  machine.period = base::longest_period;
  const Outcome coarse = run(text, machine);
  RC_ASSERT(!has_error(coarse));
  machine.period = affordable_period(coarse.summary.time_s);
  RC_LOG() << "period " << machine.period.nanoseconds << " ns";
  const Outcome fine = run(text, machine);
  for (const Outcome* outcome : {&coarse, &fine}) {
    RC_ASSERT(worst_planned(outcome->summary.plan) <= 1 + 1e-9);
    RC_ASSERT(worst_judged(outcome->verdict) <= 1.001);
    RC_ASSERT(outcome->verdict.feed_max_ratio <= 1.001);
    RC_ASSERT(outcome->verdict.deviation_mm <= outcome->verdict.tolerance_mm + 1e-6);
    RC_ASSERT(outcome->verdict.start_error_mm == 0);
    RC_ASSERT(outcome->verdict.end_error_mm <= 1e-9);
    RC_ASSERT(outcome->verdict.violation_count == 0);
    RC_ASSERT(outcome->summary.bound_s <= outcome->summary.time_s * (1 + 1e-6));
  }
}

RC_GTEST_PROP(RandomPrograms, KeepEveryLimitAndEveryPoint, ()) {
  keep_every_limit_and_every_point();
}
RC_GTEST_PROP(LongRandomPrograms, KeepEveryLimitAndEveryPoint, ()) {
  constexpr int programs = 2;  // a case
  for (int k = 0; k < programs; ++k) keep_every_limit_and_every_point();
}

/// Where two pieces of a curve's table of arc length meet, q‴ has a step, and jerk with it, that no look at a segment
/// need see.
TEST(RandomPrograms, KeepTheLimitOfJerkWhereATableHasSteps) {
  machine::Machine machine;
  machine.period = {2'000'000};
  machine.axes[0] = machine::AxisLimits{-1e5, 1e5, 10.913398266040286, 499.64811662562903, 894.57133625521305, 0.001};
  machine.axes[1] = machine::AxisLimits{-1e5, 1e5, 305.27272565054642, 21906.361730787969, 2941.8274468126997, 0.001};
  const Outcome outcome =
      run("G21 G90 G94 G17 F600\nG6.2 P5 K0 X0 Y0\nK0 X-0.160 Y0.403\nK0 X-0.579 Y0.465 R1.233\n"
          "K0 X-0.960 Y0.270 R1.677\nK0 X-1.009 Y-0.179\nK1 X-0.678 Y-0.470\nK1.5 X-0.278 Y-0.400\n"
          "K2 X-0.025 Y-0.093\nK4.5 X-0.104 Y0.318 R0.887\nK5.5 X-0.489 Y0.473 R1.526\n"
          "K6.5\nK6.5\nK6.5\nK6.5\nK6.5\nM2\n",
          machine);
  ASSERT_FALSE(has_error(outcome));
  EXPECT_LE(worst_planned(outcome.summary.plan), 1);
}

/// Where full acceleration is reached in a hundred-thousandth of a second, knots that resolve that reach nowhere.
TEST(RandomPrograms, RefuseNoWindowWhereJerkIsNextToNoLimit) {
  machine::Machine machine;
  machine.axes[0] = machine::AxisLimits{-1e5, 1e5, 212.97371390868437, 15470.104762413324, 338057.3792169519, 0.001};
  machine.axes[1] = machine::AxisLimits{-1e5, 1e5, 220.56266690038743, 30.597733290444094, 1564527.8770710172, 0.001};
  const Outcome outcome = run(
      "G21 G90 G94 G17 F2831\nG3 X10.000 Y-10.000 I10.000 J-0.000\nG3 X20.000 Y0.000 I0.000 J10.000\nM2\n", machine);
  ASSERT_FALSE(has_error(outcome));
  EXPECT_LE(worst_planned(outcome.summary.plan), 1);
  EXPECT_LE(outcome.summary.time_s, 1.05 * outcome.summary.bound_s);
}

RC_GTEST_PROP(RandomPrograms, GiveTheSameBitsEveryTime, ()) {
  const std::string text = RandomProgram::make(most_blocks);
  machine::Machine machine = random_machine();
  machine.period = base::longest_period;
  RC_ASSERT(run(text, machine, {}, Keep::positions).positions == run(text, machine, {}, Keep::positions).positions);
}

// ---------------------------------------------------------------------------------------------------------------------

std::string file_text(const std::string& name) {
  std::ifstream file(std::string(LEADSCREW_SOURCE_DIR) + "/examples/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The built-in mill with rotary axes added, as in machines/mill6.toml.
machine::Machine mill_with_rotary_axes() {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-36000, 36000, 90, 500, 5000, 0.001};
  }
  return machine;
}

class Examples : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Examples, KeepEveryLimitAndEveryPoint) {
  const auto& [name, microseconds] = GetParam();
  machine::Machine machine = mill_with_rotary_axes();
  machine.period = {microseconds * 1000LL};
  const auto tools = gcode::read_tool_table(file_text("tools.tbl"), "tools.tbl");
  ASSERT_TRUE(tools.diagnostics.empty());
  const Outcome outcome = run(file_text(name), machine, tools.table);
  ASSERT_FALSE(has_error(outcome)) << outcome.diagnostics[0].place.line << ": " << outcome.diagnostics[0].message;
  EXPECT_GT(outcome.summary.moves, 0);
  EXPECT_LE(worst_planned(outcome.summary.plan), 1 + 1e-9);
  EXPECT_LE(worst_judged(outcome.verdict), 1.001);
  EXPECT_LE(outcome.verdict.feed_max_ratio, 1.001);
  EXPECT_LE(outcome.verdict.deviation_mm, outcome.verdict.tolerance_mm + 1e-6);
  EXPECT_LE(outcome.verdict.end_error_mm, 1e-9);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, Examples,
    testing::Combine(testing::Values("01-plate.ngc", "02-helical-bore.ngc", "03-arcs-in-three-planes.ngc",
                                     "04-square.ngc", "05-finishing.ngc", "06-drilling.ngc", "07-rotary.ngc",
                                     "08-work-offsets.ngc", "09-butterfly.ngc", "10-cubic.ngc", "11-splines.ngc"),
                     testing::Values(100, 1000, 20000)));

// ---------------------------------------------------------------------------------------------------------------------

struct Square {
  int feed;
  double acceleration, jerk, time;
};
class SquareProgram : public testing::TestWithParam<Square> {};

TEST_P(SquareProgram, TakesThePublishedTimeWithinOnePeriod) {
  const auto& [feed, acceleration, jerk, time] = GetParam();
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->acceleration = acceleration, axis->jerk = jerk;
  }
  const Outcome outcome = run("G21 G90 G61.1\nG1 X10 F" + std::to_string(feed) + "\nY10\nX0\nY0\nM2\n", machine);
  EXPECT_NEAR(outcome.summary.time_s, time, 0.001);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
}

INSTANTIATE_TEST_SUITE_P(Figures, SquareProgram,
                         testing::Values(Square{600, 1000, 20000, 4.1789}, Square{6000, 1000, 20000, 1.0246},
                                         Square{600, 200, 5000, 4.3600}, Square{6000, 200, 5000, 1.9560}));

TEST(Program, HandsOverEventsInOrderAndCountsDwells) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source("G21 G90 S1000 M3\nG1 X1 F600\nG4 P0.25\nM8\nX2\nM5 M9\nM2\n"), machine,
                            tools, {}, [](const base::Diagnostic&) {});
  std::vector<base::Event::Kind> kinds;
  program.on_event([&](const base::Event& event) { kinds.push_back(event.kind); });
  while (program.prepare()) program.cycle();
  using Kind = base::Event::Kind;
  const std::vector<Kind> expected = {Kind::spindle_speed, Kind::spindle_clockwise, Kind::coolant_flood,
                                      Kind::spindle_stop,  Kind::coolant_off,       Kind::program_end};
  EXPECT_EQ(kinds, expected);
  EXPECT_EQ(program.summary().dwell_s, 0.25);
  EXPECT_EQ(program.summary().moves, 2);
  EXPECT_DOUBLE_EQ(program.summary().length_mm, 2);
}

TEST(Program, OfNothingMakesOneWordAtTheStart) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source("M2\n"), machine, tools, {.start = {1, 2, 3}},
                            [](const base::Diagnostic&) {});
  ASSERT_TRUE(program.prepare());
  EXPECT_EQ(program.cycle().position, (base::AxisVector{1, 2, 3}));
  EXPECT_FALSE(program.prepare());
  EXPECT_EQ(program.summary().words, 0);
}

}  // namespace test_promises
