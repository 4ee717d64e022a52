// Canonical machining calls as LinuxCNC's rs274 -g prints them. Expected lines are those of rs274 of LinuxCNC 2.9.

#include <gtest/gtest.h>

#include <leadscrew/gcode/canon.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_canon {

machine::Machine six_axes() {
  machine::Machine machine = nine_axes();
  for (const base::Axis axis : {base::Axis::U, base::Axis::V, base::Axis::W}) machine.axes[base::index(axis)].reset();
  return machine;
}

// Its calls from the sixth on, without their numbers.
std::string calls(std::string_view program, const machine::Machine& machine = six_axes()) {
  std::vector<base::Diagnostic> problems;
  const machine::ToolTable tools;
  Reader reader(text_source(program), machine, tools, {}, [&](const base::Diagnostic& d) {
    if (d.severity != base::Severity::note) problems.push_back(d);
  });
  CanonWriter writer(machine.axis_set());
  std::string text;
  writer.begin(text);
  Move move;
  while (reader.next(move)) writer.write(move, reader.frame(), reader.system(), reader.modal(), text);
  EXPECT_TRUE(problems.empty()) << problems.front().message;
  std::string bare;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    EXPECT_EQ(std::stoi(line), ++number);
    EXPECT_EQ(line.substr(5, 8), " N..... ");
    if (number > 5) bare += line.substr(13) + "\n";
    begin = end + 1;
  }
  return bare;
}

std::string with_path_mode(const std::string& expected) {
  return "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n" + expected + "PROGRAM_END()\n";
}

TEST(Canon, TheSameNumberIsAnotherFeedInAnotherUnit) {
  EXPECT_EQ(calls("G20 G61\nG1 X1 F10\nG21\nF10 X2\nM2\n"),
            "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\n"
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
            "SET_FEED_RATE(10.0000)\n"
            "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
            "SET_FEED_RATE(10.0000)\n"
            "STRAIGHT_FEED(2.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "PROGRAM_END()\n");
}

// The arc round the corner of two arcs that are nearly tangent is of less than a micrometre.
TEST(Canon, ShortArcsAreNoCircles) {
  const std::string text = calls(
      "G21 F564\nG42.1 D-10\nG1 X45.3655 Y98.3126\nG2 X28.659 Y31.7078 I-14.639530177 J-31.725610643\n"
      "G3 X8.3071 Y16.1509 I-1.159959279 J-19.573379681\nG40\nG1 X37.762 Y-0.566\nM2\n");
  const std::string end = "ARC_FEED(28.3632, 26.7166, ";
  const std::size_t at = text.find(end);
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.find(end, at + 1), std::string::npos) << text;
  EXPECT_NE(text.find("ARC_FEED(13.2011, 15.1267, ", at), std::string::npos) << text;
}

// Circles end where they begin, and so, in four decimals, do arcs of all but a full turn.
TEST(Canon, CirclesAreTold) {
  const auto arcs = [](const std::string& program) {
    const std::string text = calls("G21 G61 F100\n" + program + "M2\n");
    std::string found;
    for (std::size_t at = text.find("ARC_FEED"); at != std::string::npos; at = text.find("ARC_FEED", at + 1))
      found += text.substr(at, text.find('\n', at) + 1 - at);
    return found;
  };
  const std::string circle = "ARC_FEED(0.0000, 0.0000, 10.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)\n";
  EXPECT_EQ(arcs("G3 X0 I10\n"), circle);
  EXPECT_EQ(arcs("G3 X0 Y0.00003 I10\n"), circle);
  EXPECT_EQ(arcs("G3 X0 Y-0.00003 I10\n"), "");
  EXPECT_EQ(arcs("G3 X0 Y-0.0004 I10\n"),
            "ARC_FEED(0.0000, -0.0004, 10.0000, -0.0002, 1, 0.0000, 0.0000, 0.0000, 0.0000)\n");
  EXPECT_EQ(arcs("G3 X0 Y-0.00003 Z1 I10\n"),
            "ARC_FEED(0.0000, 0.0000, 10.0000, 0.0000, 1, 1.0000, 0.0000, 0.0000, 0.0000)\n");
}

TEST(Canon, LinesStandInCoordinatesOfTheProgram) {
  EXPECT_EQ(calls("G21 G61\nG10 L2 P1 X1 Y2 Z3 R30\nG0 X4 Y1\nG92 X5\nG43.1 Z3\nG1 X4 A3 F300\nM2\n"),
            "SET_G5X_OFFSET(1, 1.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_XY_ROTATION(30.0000)\n"
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
            "STRAIGHT_TRAVERSE(4.0000, 1.0000, -3.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_G92_OFFSET(-1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "USE_TOOL_LENGTH_OFFSET(0.0000, 0.0000, 3.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_FEED_RATE(300.0000)\n"
            "STRAIGHT_FEED(4.0000, 1.0000, -6.0000, 3.0000, 0.0000, 0.0000)\n"
            "PROGRAM_END()\n");
}

TEST(Canon, ArcsOfEachPlane) {
  EXPECT_EQ(calls("G21 G61\nG2 X10 I5 J0 F100\nG3 X10 Y0 Z-2 I5 P2\nG18 G2 X20 Z-2 R5\nG19 G3 Y10 Z8 J10 K0\nM2\n"),
            with_path_mode("SET_FEED_RATE(100.0000)\n"
                           "ARC_FEED(10.0000, 0.0000, 5.0000, 0.0000, -1, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                           "ARC_FEED(10.0000, 0.0000, 15.0000, 0.0000, 2, -2.0000, 0.0000, 0.0000, 0.0000)\n"
                           "SELECT_PLANE(CANON_PLANE_XZ)\n"
                           "ARC_FEED(-2.0000, 20.0000, -2.0000, 15.0000, -1, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                           "SELECT_PLANE(CANON_PLANE_YZ)\n"
                           "ARC_FEED(10.0000, 8.0000, 10.0000, -2.0000, 1, 20.0000, 0.0000, 0.0000, 0.0000)\n"));
}

TEST(Canon, InchesAndInverseTime) {
  EXPECT_EQ(calls("G20 G61\nG1 X1 F30\nG93 G1 X3 F2\nG94 F20\nA90\nM2\n"),
            "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\n" +
                with_path_mode("SET_FEED_RATE(30.0000)\n"
                               "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                               "SET_FEED_RATE(4.0000)\n"
                               "STRAIGHT_FEED(3.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                               "SET_FEED_RATE(20.0000)\n"
                               "STRAIGHT_FEED(3.0000, 0.0000, 0.0000, 90.0000, 0.0000, 0.0000)\n"));
}

TEST(Canon, EventsAndDwells) {
  EXPECT_EQ(calls("S1000 T1 M3\nM6 M8\nM7\nG4 P1.5\nM62 P1\nM67 E2 Q3.5\nM65 P4\nM68 E0 Q1\nM5 M9\nM0\nM1\nM60\nM30\n"),
            "SET_SPINDLE_SPEED(0, 1000.0000)\nSELECT_TOOL(1)\nSTART_SPINDLE_CLOCKWISE(0)\n"
            "START_CHANGE()\nSTOP_SPINDLE_TURNING(0)\nCHANGE_TOOL(1)\nFLOOD_ON()\nMIST_ON()\nDWELL(1.5000)\n"
            "SET_MOTION_OUTPUT_BIT(1)\nSET_MOTION_OUTPUT_VALUE(2, 3.5000)\nCLEAR_AUX_OUTPUT_BIT(4)\n"
            "SET_AUX_OUTPUT_VALUE(0, 1.0000)\nSTOP_SPINDLE_TURNING(0)\nMIST_OFF()\nFLOOD_OFF()\nPROGRAM_STOP()\n"
            "OPTIONAL_PROGRAM_STOP()\nPALLET_SHUTTLE()\nPROGRAM_STOP()\nPROGRAM_END()\n");
}

TEST(Canon, FunctionsOfTheMachine) {
  EXPECT_EQ(calls("M19 R45 P1\nM19 R90 Q2\nM48\nM49\nM50\nM51 P0\nM52\nM53 P0\nM66 P0 L0\nM101 P1 Q2\nM2\n"),
            "ORIENT_SPINDLE(0, 45.0000, 1)\nORIENT_SPINDLE(0, 90.0000, 0)\nSPINDLE.0.WAIT_ORIENT_COMPLETE(2.0000)\n"
            "ENABLE_FEED_OVERRIDE()\nENABLE_SPEED_OVERRIDE(0)\nDISABLE_FEED_OVERRIDE()\nDISABLE_SPEED_OVERRIDE(0)\n"
            "ENABLE_FEED_OVERRIDE()\nDISABLE_SPEED_OVERRIDE(0)\nENABLE_ADAPTIVE_FEED()\nDISABLE_FEED_HOLD()\n"
            "M101(1.0000, 2.0000)\nPROGRAM_END()\n");
}

TEST(Canon, ThreadsAndTaps) {
  EXPECT_EQ(calls("G20 G18 G61 S100 M3\nG33 Z-1 K0.1\nG33.1 X0.5 Z-2 K.05 I2\nG0 X1 Z0\nG76 P.1 Z-1 I-.1 J.05 K.1 E.1 "
                  "L2\nM2\n"),
            "SET_SPINDLE_SPEED(0, 100.0000)\nSTART_SPINDLE_CLOCKWISE(0)\n"
            "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\nSELECT_PLANE(CANON_PLANE_XZ)\n"
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
            "START_SPEED_FEED_SYNC(0.100000,0)\n"
            "STRAIGHT_FEED(0.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)\nSTOP_SPEED_FEED_SYNCH()\n"
            "START_SPEED_FEED_SYNC(0.050000,0)\nRIGID_TAP(0.5000, 0.0000, -2.0000)\nSTOP_SPEED_FEED_SYNCH()\n"
            "STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "STRAIGHT_TRAVERSE(1.0500, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "STRAIGHT_TRAVERSE(0.8500, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "START_SPEED_FEED_SYNC(0.100000,0)\n"
            "STRAIGHT_FEED(0.8500, 0.0000, -0.9000, 0.0000, 0.0000, 0.0000)\n"
            "START_SPEED_FEED_SYNC(0.141421,0)\n"
            "STRAIGHT_FEED(0.9500, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)\nSTOP_SPEED_FEED_SYNCH()\n"
            "STRAIGHT_TRAVERSE(1.0500, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)\n"
            "STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "STRAIGHT_TRAVERSE(0.8000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "START_SPEED_FEED_SYNC(0.100000,0)\n"
            "STRAIGHT_FEED(0.8000, 0.0000, -0.9000, 0.0000, 0.0000, 0.0000)\n"
            "START_SPEED_FEED_SYNC(0.141421,0)\n"
            "STRAIGHT_FEED(0.9000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)\nSTOP_SPEED_FEED_SYNCH()\n"
            "STRAIGHT_TRAVERSE(1.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)\nPROGRAM_END()\n");
}

TEST(Canon, HasUVWWhereTheMachineHas) {
  EXPECT_EQ(
      calls("G21 G61\nG0 X1 W-0.00001\nM2\n", nine_axes()),
      with_path_mode("STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"));
}

TEST(Canon, SaysPathControlAndCurves) {
  EXPECT_EQ(calls("G21 G64 P0.1 Q0.05\nG0 X1\nG61.1\nG0 X2\nG1 F100\nG5.2 X3 Y1 P1\nX4 Y2 P1\nX5 Y0 P1\nG5.3\nM2\n"),
            "SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, 0.1000)\nSET_NAIVECAM_TOLERANCE(0.0500)\n"
            "STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)\n"
            "STRAIGHT_TRAVERSE(2.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_FEED_RATE(100.0000)\nNURBS_FEED(4, ...)\nPROGRAM_END()\n");
}

// What waits for the next motion in the plane is printed with the feed of its own block.
TEST(Canon, FeedTravelsWithCompensatedMoves) {
  EXPECT_EQ(
      calls("G21 G61 S100 M3 G95 F0.2\nG41.1 D2\nG1 X10\nX20 F0.3\nG94 F100\nX30\nG95 F0.4\nX40\nG40\nX50 Y1\nM2\n"),
      "SET_SPINDLE_SPEED(0, 100.0000)\n"
      "START_SPINDLE_CLOCKWISE(0)\n"
      "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
      "SET_FEED_MODE(0, 1)\n"
      "SET_FEED_RATE(0.2000)\n"
      "STRAIGHT_FEED(10.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
      "SET_FEED_RATE(0.3000)\n"
      "STRAIGHT_FEED(20.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
      "SET_FEED_MODE(0, 0)\n"
      "SET_FEED_RATE(100.0000)\n"
      "STRAIGHT_FEED(30.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
      "SET_FEED_MODE(0, 1)\n"
      "SET_FEED_RATE(0.4000)\n"
      "STRAIGHT_FEED(40.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
      "STRAIGHT_FEED(50.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
      "PROGRAM_END()\n");
}

TEST(Canon, FeedPerRevolutionStaysAsWritten) {
  EXPECT_EQ(calls("G21 G61 M3 S100 G95 F0.2\nG1 X1\nS200\nX2\nG94 F100 X3\nM2\n"),
            "SET_SPINDLE_SPEED(0, 100.0000)\n"
            "START_SPINDLE_CLOCKWISE(0)\n"
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
            "SET_FEED_MODE(0, 1)\n"
            "SET_FEED_RATE(0.2000)\n"
            "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_SPINDLE_SPEED(0, 200.0000)\n"
            "STRAIGHT_FEED(2.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_FEED_MODE(0, 0)\n"
            "SET_FEED_RATE(100.0000)\n"
            "STRAIGHT_FEED(3.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "PROGRAM_END()\n");
}

TEST(Canon, SurfaceSpeedStaysAsWritten) {
  EXPECT_EQ(calls("G21 G61 G0 X2\nG96 D2500 S250 M3\nG0 X10\nX5\nS100\nG97 S300\nX4\nM2\n"),
            "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
            "STRAIGHT_TRAVERSE(2.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_SPINDLE_MODE(0 2500.0000)\n"
            "SET_SPINDLE_SPEED(0, 250.0000)\n"
            "START_SPINDLE_CLOCKWISE(0)\n"
            "STRAIGHT_TRAVERSE(10.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "STRAIGHT_TRAVERSE(5.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "SET_SPINDLE_SPEED(0, 100.0000)\n"
            "SET_SPINDLE_MODE(0 0.0000)\n"
            "SET_SPINDLE_SPEED(0, 300.0000)\n"
            "STRAIGHT_TRAVERSE(4.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
            "PROGRAM_END()\n");
}

/// A move that compensation keeps back comes before an S that the program has behind it.
TEST(Canon, SurfaceSpeedComesInItsTurnBesideAContour) {
  const std::string text = calls("G21 G61 F600\nG96 S99 M3\nG42.1 D1\nG1 X10 Y8\nS100\nX30\nG40\nM2\n");
  const std::size_t line = text.find("STRAIGHT_FEED("), speed = text.find("SET_SPINDLE_SPEED(0, 100.0000)");
  ASSERT_NE(speed, std::string::npos) << text;
  EXPECT_LT(line, speed) << text;
  EXPECT_LT(speed, text.find("STRAIGHT_FEED(", line + 1)) << text;
}

/// Nor does the spindle's following of X on a move before, kept back as well, tell that S.
TEST(Canon, SurfaceSpeedWaitsForItsEventWhereXChangesBefore) {
  const std::string text =
      calls("G21 G61 G18 F600\nG96 S99 M3\nG0 X5 Z9\nG42.1 D1\nG0 X20 Z2\nG1 Y-4\nS100\nG1 Z-30\nG40\nM2\n");
  const std::size_t line = text.find("STRAIGHT_FEED("), speed = text.find("SET_SPINDLE_SPEED(0, 100.0000)");
  ASSERT_NE(speed, std::string::npos) << text;
  EXPECT_LT(line, speed) << text;
  EXPECT_LT(speed, text.find("STRAIGHT_FEED(", line + 1)) << text;
}

}  // namespace test_canon
}  // namespace leadscrew::gcode
