#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <trunnion.hpp>
#include <utility>

#include "five_axes.hpp"
#include "random_programs.hpp"

// What is told of a program before it moves.

namespace test_surveys {

using namespace leadscrew;

void look(pipeline::Survey& survey, const machine::Machine& machine, const std::string& text) {
  const machine::ToolTable tools = testing_support::two_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, {});
  gcode::Move move;
  while (reader.next(move)) survey.observe(move);
  survey.finish();
}

// The quick bound is below that of the tool path with its blends and fits, and both know where the path ends.
RC_GTEST_PROP(Surveys, TheQuickBoundIsTheLesser, ()) {
  const machine::Machine machine = testing_support::random_machine();
  const std::string text = testing_support::RandomProgram::make();
  pipeline::PathSurvey whole(machine, {});
  pipeline::QuickSurvey quick(machine, {});
  look(whole, machine, text);
  look(quick, machine, text);
  RC_LOG() << text << testing_support::limits_of(machine) << quick.bound_seconds() << " " << whole.bound_seconds();
  RC_ASSERT(quick.bound_seconds() <= whole.bound_seconds() * (1 + 1e-9));
}

RC_GTEST_PROP(Surveys, TheQuickBoundIsTheLesserOnFiveAxes, ()) {
  const machine::Machine machine = testing_support::five_axes();
  const std::string text = testing_support::FiveAxisProgram(machine).make(testing_support::any(1, 8));
  pipeline::PathSurvey whole(machine, {});
  pipeline::QuickSurvey quick(machine, {});
  look(whole, machine, text);
  look(quick, machine, text);
  RC_LOG() << text << testing_support::limits_of(machine) << quick.bound_seconds() << " " << whole.bound_seconds();
  RC_ASSERT(quick.bound_seconds() <= whole.bound_seconds() * (1 + 1e-9));
}

// Where rotary axes alone go, with and without tool centre point control, rounded or not: by their feed, or as fast as they may.
TEST(Surveys, CountTheTimeOfRotaryAxesAlone) {
  const machine::Machine machine = testing_support::trunnion();
  for (const char* const mode : {"G61\n", "G64 P0.01 E0.1\n", "G61 G43.4\n", "G64 P0.01 E0.1 G43.4\n"}) {
    for (const auto& [line, seconds] : {std::pair("G1 C360 F3000\nG1 A90\n", 9.0), {"G0 C360\nG0 A90\n", 1.5}}) {
      pipeline::PathSurvey whole(machine, {});
      pipeline::QuickSurvey quick(machine, {});
      look(whole, machine, std::string("G21 ") + mode + line + "M2\n");
      look(quick, machine, std::string("G21 ") + mode + line + "M2\n");
      EXPECT_NEAR(quick.bound_seconds(), seconds, 0.01 * seconds) << mode << line;
      EXPECT_LE(quick.bound_seconds(), whole.bound_seconds()) << mode << line;
    }
  }
}

// Lines that are short in X, Y and Z while a rotary axis goes far.
TEST(Surveys, CountNoDegreesAsLength) {
  machine::Machine machine = machine::mill3();
  machine.axes[base::index(base::Axis::A)] = {-1000, 1000, 120, 80, 500, 0.001};
  const std::string text = "G21 G64 P0.007 F600\nG1 Z0.001 A-200\nG1 Y-0.001 Z0\nM2\n";
  pipeline::PathSurvey whole(machine, {});
  pipeline::QuickSurvey quick(machine, {});
  look(whole, machine, text);
  look(quick, machine, text);
  EXPECT_GT(whole.bound_seconds(), 1);
  EXPECT_LE(quick.bound_seconds(), whole.bound_seconds());
}

// The curve turns back within 1e-6 mm, inside a step of the bound: slow there alone.
TEST(Surveys, AreNotAboveAMotionThroughANearCusp) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(
      gcode::text_source("G21 G90 F120\nG0 X100 Y15\nG5 X1 Y20 I-1 J-5 P-5 Q0.5\nG1 X15 Y100\nM2\n"), machine, tools,
      {}, nullptr);
  while (program.prepare()) program.cycle();
  EXPECT_LE(program.summary().bound_s, program.summary().time_s);
  EXPECT_GE(program.summary().bound_s, program.summary().time_s - 0.1);
}

// As fast as a spindle that is followed may turn: F and S say little.
TEST(Surveys, LeaveThreadsToTheSpindle) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 5000, .wander = 0.2, .wander_period = 1000, .seed = 3};
  const std::string text = "S600 M3\nG0 Z100\nG33 Z-400 K1\nG33 Z100 K1\nG0 X10\nM2\n";
  pipeline::PathSurvey whole(machine, {});
  pipeline::QuickSurvey quick(machine, {});
  look(whole, machine, text);
  look(quick, machine, text);
  EXPECT_LE(quick.bound_seconds(), whole.bound_seconds());
  EXPECT_NEAR(quick.bound_seconds(), (100 + 500 + 500 + 10) / 200.0, 1e-3);
  machine = testing_support::trunnion();
  machine.spindle = machine::Spindle{.acceleration = 30'000, .wander = 0.2, .wander_period = 100, .seed = 6};
  for (const char* const block : {"G33 Z-100 K1", "G95 F1\nG1 Z-100"}) {
    pipeline::PathSurvey of_path(machine, {});
    pipeline::QuickSurvey of_moves(machine, {});
    look(of_path, machine, "S600 M3\nG43.4\n" + std::string(block) + "\nM2\n");
    look(of_moves, machine, "S600 M3\nG43.4\n" + std::string(block) + "\nM2\n");
    EXPECT_LE(of_moves.bound_seconds(), of_path.bound_seconds()) << block;
  }
}

TEST(Surveys, TakeShortLinesTogether) {
  std::string text = "G21 G64 P0.01 F1000\n";
  for (int i = 1; i <= 10'000; ++i) text += "G1 X" + std::to_string(i * 0.001) + "\n";
  const machine::Machine mill = machine::mill3();
  pipeline::QuickSurvey quick(mill, {});
  look(quick, mill, text + "M2\n");
  EXPECT_NEAR(quick.bound_seconds(), 0.6, 0.6 * 0.06);
  EXPECT_LE(quick.bound_seconds(), 0.6);
  EXPECT_NEAR(quick.greatest()[0], 10, 1e-9);
}

}  // namespace test_surveys
