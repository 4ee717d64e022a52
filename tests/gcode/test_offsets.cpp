#include <cmath>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_offsets {

using base::Axis;

Point last_end(std::string_view text, const Conditions& conditions = {}) {
  return xyz(read_well(text, conditions).lines().back().end);
}

void expect_near(const Point& a, const Point& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

Conditions with_tool() {
  Conditions conditions;
  conditions.tools = machine::ToolTable(std::vector<machine::Tool>{{.number = 5, .offset = {1, 0, 40}}});
  return conditions;
}

TEST(CoordinateSystems, AreNine) {
  const char* codes[] = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  std::string text;
  for (int i = 1; i <= 9; ++i) text += "G10 L2 P" + std::to_string(i) + " X" + std::to_string(10 * i) + "\n";
  for (int i = 1; i <= 9; ++i) EXPECT_EQ(last_end(text + codes[i - 1] + "\nG0 X1\nM2\n").x, 10 * i + 1) << codes[i - 1];
}

TEST(CoordinateSystems, BeginWithTheFirst) {
  EXPECT_EQ(last_end("G10 L2 P1 X10\nG0 X1\nM2\n").x, 11);
}

TEST(CoordinateSystems, DoNotMoveTheMachine) {
  EXPECT_EQ(last_end("G0 X5\nG10 L2 P2 X100 Y100\nG55 G0 Y1\nM2\n"), (Point{5, 101, 0}));
}

TEST(G10L0, ReloadsTheTableOfToolsInLinuxCnc) {
  EXPECT_EQ(last_end("G10 L0\nG10 L2 P1 X10\nG0 X1\nM2\n").x, 11);
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas, Dialect::mach3, Dialect::grbl})
    EXPECT_EQ(read("G10 L0\nM30\n", in_dialect(dialect)).problems(), "1:1 missing-word; ");
}

TEST(G10L2, LeavesAxesThatItDoesNotName) {
  EXPECT_EQ(last_end("G10 L2 P1 X10 Y20\nG10 L2 P1 Y30\nG0 X0 Y0 Z1\nM2\n"), (Point{10, 30, 1}));
}

TEST(G10L2, WithP0SetsTheSystemInForce) {
  EXPECT_EQ(last_end("G55\nG10 L2 P0 X10\nG54\nG55 G0 X1\nM2\n").x, 11);
}

// Haas' page of G10: "G10 L2 P1 G91 X60. moves offset G54 X-axis 60 mm to the right". LinuxCNC's sets what is given.
TEST(G10L2, AddsUnderG91WithFanucAndHaas) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const std::string further = dialect == Dialect::haas ? "G154 P3" : "G54.1 P3";
    const std::string twice = "G10 L2 P1 X100. Y5.\nG91 G10 L2 P1 X6.\nG10 P1 L2 X-2.\nG90\n";
    EXPECT_EQ(last_end(twice + "G0 X0 Y0\nM30\n", in_dialect(dialect)), (Point{104, 5, 0}));
    EXPECT_EQ(last_end("G55\n" + twice + "G54 G0 X0 Y0\nM30\n", in_dialect(dialect)), (Point{104, 5, 0}));
    EXPECT_EQ(
        last_end("G10 L20 P3 X8.\nG91 G10 L20 P3 X1. Z2.\nG90 " + further + "\nG0 X0 Z0\nM30\n", in_dialect(dialect)),
        (Point{9, 0, 2}));
  }
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::leadscrew, Dialect::grbl, Dialect::mach3})
    EXPECT_EQ(last_end("G10 L2 P1 X100\nG91 G10 L2 P1 X6\nG90 G0 X0\nM2\n", in_dialect(dialect)).x, 6);
}

// Fanuc's external offset is its own; Haas' is what G52 sets.
TEST(G10L2, WithP0ShiftsAllSystemsOfFanucAndHaas) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas, Dialect::fanuc_lathe}) {
    const Conditions conditions = in_dialect(dialect);
    const bool is_haas = dialect == Dialect::haas;
    const auto z_at = [&](const std::string& blocks) { return last_end(blocks + "\nM30\n", conditions).z; };
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG54 G0 Z0"), 7);
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG55 G0 Z0"), 7);
    EXPECT_EQ(z_at("G55\nG10 L2 P0 Z7.\nG0 Z0"), 7);
    EXPECT_EQ(z_at("G10 L2 P1 Z100.\nG10 L2 P0 X0 Y0 Z0\nG0 Z0"), 100);
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG10 L2 P1 Z100.\nG0 Z0"), 107);
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG10 L20 P4 Z100.\n" + std::string(is_haas ? "G154 P4" : "G54.1 P4") + "\nG0 Z0"),
              107);
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG53 G0 Z3."), 3);
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG52 Z2.\nG0 Z0"), is_haas ? 2 : 9);
    EXPECT_EQ(z_at("G52 Z2.\nG10 L2 P0 Z0\nG0 Z1."), is_haas ? 1 : 3);
    const std::string two_more = dialect == Dialect::fanuc_lathe ? "G10 L2 P0 W2.\n" : "G91 G10 L2 P0 Z2.\nG90\n";
    EXPECT_EQ(z_at("G10 L2 P0 Z7.\nG10 L2 P1 Z50.\n" + two_more + "G0 Z0"), 59);
    EXPECT_EQ(read("G10 L2 P0 Z7. R5.\nM30\n", conditions).problems(), "1:15 unused-word; ");
    const Reading none = read("G10 L2 P10 Z7.\nM30\n", conditions);
    ASSERT_EQ(none.problems(), "1:8 bad-value; ");
    EXPECT_EQ(none.diagnostics.front().hint, "1 to 6 for G54 to G59, 0 for the offset that shifts all of them");
  }
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::grbl, Dialect::mach3})
    EXPECT_EQ(last_end("G10 L2 P0 X7\nG55 G0 X0 Y1\nM2\n", in_dialect(dialect)), (Point{0, 1, 0}));
}

TEST(G10L2, IsInTheUnitsInForce) {
  EXPECT_EQ(last_end("G20\nG10 L2 P1 X1\nG21\nG0 X1\nM2\n").x, 26.4);
}

TEST(G10L20, MakesThePositionTheCoordinatesGiven) {
  EXPECT_EQ(last_end("G0 X50 Y7\nG10 L20 P1 X2\nG0 X0\nM2\n"), (Point{48, 7, 0}));
  EXPECT_EQ(last_end("G0 X50 Y7\nG92 X10\nG10 L20 P1 X2\nG0 X0\nM2\n"), (Point{48, 7, 0}));
}

TEST(G10L2, RotatesAboutZ) {
  expect_near(last_end("G10 L2 P1 X100 Y10 R90\nG0 X5 Y2 Z1\nM2\n"), {98, 15, 1});
  expect_near(last_end("G10 L2 P1 R30\nG0 X10\nM2\n"), {5 * std::sqrt(3.0), 5, 0});
}

TEST(Rotation, KeepsTheCoordinateThatIsNotNamed) {
  expect_near(last_end("G10 L2 P1 R90\nG0 X5 Y2\nX7\nM2\n"), {-2, 7, 0});
}

TEST(Rotation, TurnsIncrements) {
  expect_near(last_end("G10 L2 P1 R90\nG0 X5 Y2\nG91 X1\nM2\n"), {-2, 6, 0});
}

TEST(Rotation, TurnsTheShiftOfG92) {
  // At machine 0,10 the program stands at 10,0; G92 calls that 0,0.
  expect_near(last_end("G10 L2 P1 R90\nG0 X10\nG92 X0\nG0 X1\nM2\n"), {0, 11, 0});
}

TEST(Rotation, LetsG10L20SetTheOrigin) {
  expect_near(last_end("G10 L2 P1 R90\nG0 X10 Y4\nG10 L20 P1 X0 Y0\nG0 X1 Y2\nM2\n"), {-6, 11, 0});
  expect_near(last_end("G10 L2 P1 R90\nG0 X10 Y4\nG10 L20 P1 X0\nG0 X1\nM2\n"), {-4, 11, 0});
}

TEST(Rotation, TakesNoCyclesOfOtherPlanes) {
  EXPECT_EQ(read("G10 L2 P1 R10\nF60 G19 G81 X-10 R5\nM2\n").problems(), "2:9 unsupported-rotation; ");
}

TEST(G92, CallsThePositionWhatItIsGiven) {
  EXPECT_EQ(last_end("G0 X10 Y20\nG92 X1\nG0 X0 Y0\nM2\n"), (Point{9, 0, 0}));
  EXPECT_EQ(last_end("G0 X10\nG92 X1\nG92 X2\nG0 X0\nM2\n").x, 8);
}

TEST(G92, AppliesInEverySystem) {
  EXPECT_EQ(last_end("G10 L2 P2 X100\nG92 X-5\nG55 G0 X1\nM2\n").x, 106);
}

TEST(G92, IsCancelledForGoodByG92_1) {
  EXPECT_EQ(last_end("G92 X10\nG92.1\nG92.3\nG0 X1\nM2\n").x, 1);
}

TEST(G92, IsSuspendedByG92_2AndRestoredByG92_3) {
  EXPECT_EQ(last_end("G92 X10\nG92.2\nG0 X1\nM2\n").x, 1);
  EXPECT_EQ(last_end("G92 X10\nG92.2\nG92.3\nG0 X1\nM2\n").x, -9);
}

TEST(ToolLength, IsThatOfTheToolLoaded) {
  EXPECT_EQ(last_end("T5 M6\nG43\nG0 X0 Z1\nM2\n", with_tool()), (Point{1, 0, 41}));
  EXPECT_EQ(last_end("G43\nG0 Z1\nM2\n", with_tool()).z, 1);
}

TEST(ToolLength, IsThatOfTheToolNamed) {
  EXPECT_EQ(last_end("G43 H5\nG0 Z1\nM2\n", with_tool()).z, 41);
  EXPECT_EQ(last_end("G43 H5\nG43 H0\nG0 Z1\nM2\n", with_tool()).z, 1);
}

// LinuxCNC manual, G Codes, "G43": H0 is the tool in the spindle. With Fanuc it is no offset.
TEST(ToolLength, OfH0IsThatOfTheSpindle) {
  Conditions conditions = with_tool();
  EXPECT_EQ(last_end("T5 M6\nG43 H0\nG0 Z1\nM2\n", conditions).z, 41);
  conditions.options.dialect = Dialect::fanuc;
  EXPECT_EQ(last_end("T5 M6\nG43 H0\nG0 Z1\nM2\n", conditions).z, 1);
}

TEST(ToolLength, IsGivenByG43_1AndCancelledByG49) {
  EXPECT_EQ(last_end("G43.1 Z3\nG0 Z1\nM2\n").z, 4);
  EXPECT_EQ(last_end("G20\nG43.1 Z1\nG21\nG0 Z1\nM2\n").z, 26.4);
  EXPECT_EQ(last_end("G43.1 Z3\nG49\nG0 Z1\nM2\n").z, 1);
}

TEST(G28, PassesTheIntermediatePoint) {
  const std::vector<Move> lines = read_well("G0 X10 Y10 Z10\nG28.1\nG0 X20 Y20 Z20\nG91 G28 Z5\nM2\n").lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(xyz(lines[2].end), (Point{20, 20, 25}));
  EXPECT_EQ(xyz(lines[3].end), (Point{20, 20, 10}));
  EXPECT_EQ(lines[3].feed.mode, Feed::Mode::rapid);
}

TEST(G28, WithoutAxesTakesAllOfThem) {
  EXPECT_EQ(last_end("G0 X1 Y2 Z3\nG28.1\nG0 X9 Y9 Z9\nG28\nM2\n"), (Point{1, 2, 3}));
}

TEST(G30, HasAPlaceOfItsOwn) {
  EXPECT_EQ(last_end("G0 X1\nG28.1\nG0 X2\nG30.1\nG0 X9\nG30\nM2\n").x, 2);
  EXPECT_EQ(last_end("G0 X1\nG28.1\nG0 X2\nG30.1\nG0 X9\nG28\nM2\n").x, 1);
}

TEST(G28, GoesToAPlaceOfTheMachine) {
  EXPECT_EQ(last_end("G0 X5\nG28.1\nG92 X100\nG0 X101\nG28\nM2\n").x, 5);
}

TEST(G28, LeavesTheMotionInForce) {
  EXPECT_EQ(read_well("F60 G1 X1\nG28 X2\nX3\nM2\n").lines().back().feed.mode, Feed::Mode::units_per_second);
}

}  // namespace test_offsets
}  // namespace leadscrew::gcode
