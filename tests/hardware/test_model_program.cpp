#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <leadscrew/hardware/model_program.hpp>
#include <leadscrew/machine/machine.hpp>
#include <memory>
#include <string>
#include <vector>

// Programs for the hardware: what it refuses, and its steps beside those of nc/. Tests of
// ModelInTheCommand are run where the model is built in.

namespace leadscrew::hardware {
namespace test_model_program {

struct Conditions {
  machine::Machine machine = machine::mill3();
  machine::ToolTable tools;
  nc::PulseOptions options;

  Conditions() {
    options.method = nc::PulseMethod::bresenham;
    options.clock_pps = 100'000;
  }
};

/// "3 hardware-helix; ": lines and codes.
std::string problems_of(const std::string& text, const Conditions& conditions = {}) {
  std::string problems;
  const std::int64_t errors = nc::check_pulses(
      gcode::text_source(text), conditions.machine, conditions.tools, {}, conditions.options,
      [&](const base::Diagnostic& found) {
        if (found.severity == base::Severity::error)
          problems += std::to_string(found.place.line) + " " + std::string(found.code) + "; ";
      },
      [] { return true; }, model_check(conditions.machine));
  EXPECT_EQ(errors > 0, !problems.empty());
  return problems;
}

TEST(ModelProgram, RefusesWhatTheHardwareCannotMake) {
  EXPECT_EQ(problems_of("G1 X10 Y-3 Z2 F600\nG2 X10 Y3 J3\nG4 P1\n"), "");
  EXPECT_EQ(problems_of("F600\nG2 X10 I5 Z1\nG1 X0\n"), "2 hardware-helix; ");
  Conditions fine;
  fine.machine.axes[0]->blu = fine.machine.axes[1]->blu = 1e-5;
  fine.options.clock_pps = 10'000'000;
  EXPECT_EQ(problems_of("G1 X160 F600\n", fine), "");
  EXPECT_EQ(problems_of("G1 X170 F600\n", fine), "1 hardware-register; ");
  EXPECT_EQ(problems_of("G1 X1 F600\nG3 X1 Y0 I-100\n", fine), "2 hardware-register; ");
  Conditions nine;
  for (auto& axis : nine.machine.axes) axis = machine::AxisLimits{-2000, 2000, 200, 1000, 20000, 0.001};
  EXPECT_EQ(problems_of("G1 X1 C2 F600\n", nine), "");
  EXPECT_EQ(problems_of("G1 X1 C2 F600\nG1 U3\n", nine), "2 hardware-axes; ");
}

/// What nc::check_pulses() refuses too.
TEST(ModelProgram, RefusesWhatTheFeedCannotBe) {
  EXPECT_EQ(problems_of("G1 X10 F6100\n"), "1 pulse-rate; ");
  EXPECT_EQ(problems_of("G1 X10\n"), "1 missing-feed; ");
}

template <typename Program>
std::vector<steps::StepEvent> steps_of(Program& program) {
  std::vector<steps::StepEvent> all;
  std::array<steps::StepEvent, 64> buffer;
  for (auto steps = program.next(buffer); !steps.empty(); steps = program.next(buffer))
    all.insert(all.end(), steps.begin(), steps.end());
  return all;
}

/// Lines of all axes, arcs of all quadrants in three planes, tiny ones, whole turns, a dwell, a curve of many chords.
constexpr const char* program_of_all_kinds =
    "G64 P0.001 F600\n"
    "G1 X10 Y4 Z-2\nG1 X10.001\nG1 X10.003 Y4.001\n"
    "G2 X10 Y0 I0 J-2\nG3 X10 Y0 I3 J1\nG3 X10.004 Y0 I0.002\nG2 X10.004 Y0 I-0.001 J0.001\n"
    "G4 P0.013\n"
    "G18 G2 X12 Z-1 R3\nG19 G3 Y2 Z-3 R-2\nG17\n"
    "G5 X20 Y3 I3 J1 P-1 Q-2\nG0 X0 Y0 Z0\nG2 I1.5 J-0.7\n";

TEST(ModelProgram, IsMissingWhereItWasNotBuiltIn) {
  const auto missing = missing_model();
  EXPECT_EQ(missing ? missing->code : "", make_motion_model({}) ? "" : "hardware-model");
}

TEST(ModelInTheCommand, StepsAsTheSoftwareDoes) {
  ASSERT_EQ(problems_of(program_of_all_kinds), "");
  const Conditions conditions;
  const auto no_errors = [](const base::Diagnostic& found) { EXPECT_NE(found.severity, base::Severity::error); };
  nc::PulseProgram software(gcode::text_source(program_of_all_kinds), conditions.machine, conditions.tools, {},
                            conditions.options, no_errors);
  ModelProgram hardware(gcode::text_source(program_of_all_kinds), conditions.machine, conditions.tools, {},
                        conditions.options, no_errors, std::nullopt);
  const auto expected = steps_of(software);
  EXPECT_GT(expected.size(), 50'000U);
  EXPECT_EQ(steps_of(hardware), expected);
  EXPECT_EQ(hardware.ticks(), software.ticks());
  EXPECT_GT(hardware.clocks(), hardware.ticks());
}

/// The file of waveforms has its name once the program is at its end, and is gone where it does not come there.
TEST(ModelInTheCommand, WritesWaveformsWholeOrNotAtAll) {
  const std::filesystem::path waves = std::filesystem::path(testing::TempDir()) / "leadscrew_model_waves.fst";
  const std::filesystem::path part = waves.string() + ".part";
  std::filesystem::remove(waves);
  const Conditions conditions;
  const auto moves = [&](const std::string& path) {
    return std::make_unique<ModelProgram>(
        gcode::text_source("G1 X0.1 F600\n"), conditions.machine, conditions.tools, gcode::ReaderOptions{},
        conditions.options, [](const base::Diagnostic&) {}, path);
  };
  auto program = moves(waves.string());
  EXPECT_TRUE(std::filesystem::exists(part));
  program.reset();
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_FALSE(std::filesystem::exists(waves));
  program = moves(waves.string());
  EXPECT_EQ(steps_of(*program).size(), 100U);
  EXPECT_FALSE(program->source_failure());
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_GT(std::filesystem::file_size(waves), 1000U);
  std::filesystem::remove(waves);
  program = moves("/no/such/folder/x.fst");
  EXPECT_TRUE(steps_of(*program).empty());
  ASSERT_TRUE(program->source_failure());
  EXPECT_EQ(program->source_failure()->code, "io-open");
}

}  // namespace test_model_program
}  // namespace leadscrew::hardware
