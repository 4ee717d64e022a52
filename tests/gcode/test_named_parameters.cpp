#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_named_parameters {

// The value of a parameter behind a few blocks, as the end of a move along X.
double value_after(const std::string& blocks, const std::string& parameter, const Conditions& conditions = {}) {
  const Reading reading =
      read_well(blocks + "#<result>=" + parameter + "\nG90 G21 G53 G0 X[#<result> / 10 + 0.25]\nM2\n", conditions);
  return (at(reading.lines().back().end, base::Axis::X) - 0.25) * 10;
}

struct Row {
  const char* blocks;
  const char* parameter;
  double value;
};

TEST(PredefinedNames, TellTheModes) {
  const Row rows[] = {
      {"", "#<_vmajor>", 2.9},
      {"", "#<_line>", 1},
      {"G0 X1\n", "#<_line>", 2},
      {"", "#<_motion_mode>", 800},
      {"G0 X1\n", "#<_motion_mode>", 0},
      {"F10 G1 X1\n", "#<_motion_mode>", 10},
      {"", "#<_plane>", 170},
      {"G18\n", "#<_plane>", 180},
      {"G19\n", "#<_plane>", 190},
      {"", "#<_ccomp>", 400},
      {"", "#<_metric>", 1},
      {"G20\n", "#<_metric>", 0},
      {"G20\n", "#<_imperial>", 1},
      {"", "#<_absolute>", 1},
      {"G91\n", "#<_absolute>", 0},
      {"G91\n", "#<_incremental>", 1},
      {"", "#<_inverse_time>", 0},
      {"G93\n", "#<_inverse_time>", 1},
      {"", "#<_units_per_minute>", 1},
      {"G93\n", "#<_units_per_minute>", 0},
      {"", "#<_units_per_rev>", 0},
      {"", "#<_coord_system>", 540},
      {"G59\n", "#<_coord_system>", 590},
      {"G59.3\n", "#<_coord_system>", 593},
      {"", "#<_tool_offset>", 0},
      {"G43.1 Z3\n", "#<_tool_offset>", 1},
      {"G98\n", "#<_retract_r_plane>", 0},
      {"G99\n", "#<_retract_r_plane>", 1},
      {"G98\n", "#<_retract_old_z>", 1},
      {"G90.1\n", "#<_ijk_absolute_mode>", 1},
      {"", "#<_ijk_absolute_mode>", 0},
      {"", "#<_task>", 0},
      {"", "#<_call_level>", 0},
      {"", "#<_value>", 0},
      {"", "#<_value_returned>", 0},
  };
  for (const Row& row : rows) EXPECT_NEAR(value_after(row.blocks, row.parameter), row.value, 1e-9) << row.parameter;
}

TEST(PredefinedNames, TellTheFeedAsItWasWritten) {
  EXPECT_NEAR(value_after("", "#<_feed>"), 0, 1e-9);
  EXPECT_NEAR(value_after("F254\nG20\n", "#<_feed>"), 254, 1e-9);
  EXPECT_NEAR(value_after("F254\nG93\nG1 F7 X1\n", "#<_feed>"), 254, 1e-9);
  EXPECT_NEAR(value_after("F254\nG93\nG94\n", "#<_feed>"), 0, 1e-9);
}

TEST(PredefinedNames, TellSpindleCoolantAndTools) {
  EXPECT_NEAR(value_after("S1200\n", "#<_rpm>"), 1200, 1e-9);
  EXPECT_NEAR(value_after("S1200 M3\n", "[#<_spindle_on> + 10 * #<_spindle_cw>]"), 11, 1e-9);
  EXPECT_NEAR(value_after("S1200 M4\n", "[#<_spindle_on> + 10 * #<_spindle_cw>]"), 1, 1e-9);
  EXPECT_NEAR(value_after("S1200 M4\nM5\n", "#<_spindle_on>"), 0, 1e-9);
  EXPECT_NEAR(value_after("M7\nM8\n", "[#<_mist> + 10 * #<_flood>]"), 11, 1e-9);
  EXPECT_NEAR(value_after("M7\nM9\nM8\n", "[#<_mist> + 10 * #<_flood>]"), 10, 1e-9);
  Conditions conditions;
  conditions.tools = machine::ToolTable({{.number = 3, .pocket = 8, .offset = {0, 0, 25.4}, .diameter = 12.7}});
  EXPECT_NEAR(value_after("", "#<_selected_tool>", conditions), -1, 1e-9);
  EXPECT_NEAR(value_after("T3\n", "[#<_selected_tool> * 100 + #<_selected_pocket>]", conditions), 308, 1e-9);
  EXPECT_NEAR(value_after("T3\n", "#<_current_tool>", conditions), 0, 1e-9);
  EXPECT_NEAR(value_after("T3 M6\n", "[#<_current_tool> * 100 + #<_current_pocket>]", conditions), 308, 1e-9);
  EXPECT_NEAR(value_after("T3 M6\n", "[#5400 + #5403 + #5410]", conditions), 3 + 25.4 + 12.7, 1e-9);
  EXPECT_NEAR(value_after("T3 M6\nG20\n", "[#5403 + #5410]", conditions), 1.5, 1e-9);
  EXPECT_NEAR(value_after("T3 M6\nG43 H3\n", "#5083", conditions), 25.4, 1e-9);
  EXPECT_NEAR(
      value_after("G10 L1 P3 R-4 I91 J32 Q6\nT3 M6\n", "[#5410 + #5411 * 2 + #5412 * 3 + #5413 * 5]", conditions),
      -8 + 182 + 96 + 30, 1e-9);
}

TEST(PredefinedNames, TellThePosition) {
  EXPECT_NEAR(value_after("G10 L2 P1 X5\nG0 X3 A7\n", "#<_x>"), 3, 1e-9);
  EXPECT_NEAR(value_after("G10 L2 P1 X5\nG0 X3 A7\n", "#<_abs_x>"), 8, 1e-9);
  EXPECT_NEAR(value_after("G10 L2 P1 X5\nG0 X3 A7\n", "#5021"), 8, 1e-9);
  EXPECT_NEAR(value_after("G20\nG10 L2 P1 X5\nG0 X3 A7\n", "[#<_abs_x> + 100 * #<_abs_a>]"), 708, 1e-9);
  EXPECT_NEAR(value_after("G0 Y1 Z2 B3 C4 U5 V6 W7\n",
                          "[#<_y> + #<_z> * 2 + #<_b> * 4 + #<_c> * 8 + #<_u> * 16 + #<_v> * 32 + #<_w> * 64]"),
              1 + 4 + 12 + 32 + 80 + 192 + 448, 1e-9);
}

TEST(PredefinedNames, ExistAndCannotBeSet) {
  EXPECT_NEAR(value_after("", "[EXISTS[#<_x>] + 10 * EXISTS[#<_ini[a]b>]]"), 1, 1e-9);
  for (const char* const text : {"#<_x>=1", "#<_VMajor>=1", "#<_ini[setup]x>=1", "#<_hal[motion.pin]>=1", "#<_value>=1",
                                 "#5400=1", "#5410=1", "#5420=1", "#5428=1", "#5021=1", "#5083=1"}) {
    EXPECT_EQ(read(std::string(text) + "\nM2\n").problems(), "1:1 read-only-parameter; ") << text;
  }
}

TEST(PredefinedNames, DoNotKeepOthersFromBeingSet) {
  EXPECT_NEAR(value_after("#<_xx>=3 #<x>=4\n", "[#<_xx> + #<x>]"), 7, 1e-9);
  EXPECT_NEAR(value_after("#5061=3 #5070=1 #5399=2 #5211=4 #5600=5 #5601=6\n",
                          "[#5061 + #5070 + #5399 + #5211 + #5600 + #5601]"),
              21, 1e-9);
}

TEST(NumberedParameters, AreZeroBeforeTheyAreSet) {
  EXPECT_NEAR(value_after("", "[#1 + #31 + #5061 + #5070 + #5399 + #5601]"), 0, 1e-9);
  EXPECT_NEAR(value_after("", "#5599"), 1, 1e-9);
  EXPECT_EQ(read("#5602=1\nM2\n").problems(), "1:1 bad-parameter; ");
  EXPECT_EQ(read("#0=1\nM2\n").problems(), "1:1 bad-parameter; ");
}

TEST(NumberedParameters, SayWhereSettingThemHasNoEffect) {
  const Reading reading = read("#5220=2\nG0 X1\nM2\n");
  EXPECT_EQ(reading.problems(), "1:1 parameter-without-effect; ");
  EXPECT_EQ(reading.errors, 0);
}

TEST(NumberedParameters, AreFoundIndirectly) {
  EXPECT_NEAR(value_after("#7=8 #8=9 #9=10\n", "##7"), 9, 1e-9);
  EXPECT_NEAR(value_after("#7=8 #8=9 #9=10\n", "###7"), 10, 1e-9);
  EXPECT_NEAR(value_after("#7=8 #8=9 #9=10\n", "#[#7 + 1]"), 10, 1e-9);
}

}  // namespace test_named_parameters
}  // namespace leadscrew::gcode
