// Modes and offsets beyond the commonest: what moves and parameters become under them. Figures were seen in `rs274 -g`
// of LinuxCNC 2.9 where it has the code.

#include <cmath>
#include <numbers>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_modes {

Conditions in(Dialect dialect) {
  Conditions conditions;
  conditions.options.dialect = dialect;
  return conditions;
}

Conditions with_tools() {
  Conditions conditions;
  machine::Tool short_one, long_one;
  short_one.number = 1;
  short_one.offset[2] = 2;
  long_one.number = 2;
  long_one.offset[2] = 5;
  conditions.tools = machine::ToolTable({short_one, long_one});
  return conditions;
}

Point end_of(const Reading& reading) {
  return reading.lines().empty() ? Point{} : xyz(reading.lines().back().end);
}

Point end_of(std::string_view text, const Conditions& conditions = {}) {
  return end_of(read_well(text, conditions));
}

TEST(Diameters, AreHalvedWhateverXBelongsTo) {
  EXPECT_EQ(end_of("G7 G0 X10\nM2\n"), (Point{5, 0, 0}));
  EXPECT_EQ(end_of("G7\nG8 G0 X10\nM2\n"), (Point{10, 0, 0}));
  EXPECT_EQ(end_of("G0 X1\nG7\nG91 X4\nM2\n"), (Point{3, 0, 0}));
  EXPECT_EQ(end_of("G7\nG10 L2 P1 X8\nG0 X0\nM2\n"), (Point{4, 0, 0}));
  EXPECT_EQ(end_of("G0 X12\nG7 G92 X10\nX12\nM2\n"), (Point{13, 0, 0}));
}

TEST(Diameters, LeaveCentresAndParametersAsRadii) {
  const Reading reading = read_well("G18 G7 G0 X20\nG2 X16 Z2 I-2 K0 F100\n#1=#5420\nG0 Y#1\nM2\n");
  ASSERT_EQ(reading.arcs().size(), 1u);
  EXPECT_NEAR(at(reading.arcs()[0].end, base::Axis::X), 8, 1e-12);
  EXPECT_NEAR(end_of(reading).y, 8, 1e-12);
}

TEST(FeedPerRevolution, FollowsTheSpindle) {
  const std::vector<Move> lines = read_well("G95 F0.1 S600 M3\nG1 X1\nS1200\nX2\nM2\n").lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].feed.value, 1, 1e-12);
  EXPECT_NEAR(lines[1].feed.value, 2, 1e-12);
  EXPECT_NEAR(read_well("G20 G95\nF0.01 S60\nG1 X1\nM2\n").lines()[0].feed.value, 0.254, 1e-12);
}

TEST(FeedPerRevolution, NeedsASpeedAndAFeedOfItsOwn) {
  EXPECT_EQ(read("G95 F0.1\nG1 X1\nM2\n").problems(), "2:1 spindle-stands; ");
  EXPECT_EQ(read("G95 F0.1 S100\nG1 X1\nG94 X4\nM2\n").problems(), "3:1 missing-feed; ");
}

// Beside a simulated spindle, whose speed the feed goes by.
TEST(FeedPerRevolution, IsToldOfASpindleThatStands) {
  Conditions simulated;
  simulated.machine.spindle = machine::Spindle{};
  const auto problems = [&](const std::string& text) { return read(text + "M2\n", simulated).problems(); };
  EXPECT_EQ(problems("G95 F0.1 S100\nG1 X1\nX2\n"), "2:1 spindle-stands; ");  // once
  EXPECT_EQ(read("G95 F0.1 S100\nG1 X1\nM2\n", simulated).errors, 0);
  EXPECT_EQ(problems("G95 F0.1 S100 M3\nG1 X1\nM5\nG0 X0\nG1 X1\nM4\nG1 X2\nM19\nG1 X3\n"),
            "5:1 spindle-stands; 9:1 spindle-stands; ");
  EXPECT_EQ(problems("G95 F0.1 S100\nM3 G1 X1\nG2 X3 I1\n"), "");
  EXPECT_EQ(problems("G95 F0.1 S100\nG2 X2 I1\nG94 F100\nG1 X1\nG95 F0.1\nG1 X2\n"),
            "2:1 spindle-stands; 6:1 spindle-stands; ");
  EXPECT_EQ(problems("G7 G18 G0 X10\nG96 S50 D2000 M3\nG95 F0.1 G1 X5\nM5\nX4\n"), "5:1 spindle-stands; ");
  // What the program decides.
  for (const bool turns : {true, false}) {
    const std::string begin = std::string("#1=") + (turns ? '1' : '0') + "\nG95 F0.1 S100\n";
    EXPECT_EQ(problems(begin + "O1 IF [#1 GT 0]\nM3\nO1 ENDIF\nG1 X1\n"), turns ? "" : "6:1 spindle-stands; ");
  }
  // At rapid, per minute and in inverse time it does not matter.
  EXPECT_EQ(problems("G95 F0.1 S100\nG0 X1\nG94 F100\nG1 X2\nG93 G1 X3 F10\n"), "");
  // Fanuc's tapping cycles turn a spindle that stands.
  simulated.options.dialect = Dialect::fanuc;
  EXPECT_EQ(problems("S100\nG95 G98 G84 X1 Z-20 R-5 F1\n"), "");
  EXPECT_EQ(problems("S100\nG95 G98 G81 X1 Z-20 R-5 F1\n"), "2:9 spindle-stands; ");
  // Feed goes by S where none is simulated.
  EXPECT_EQ(read("G95 F0.1 S100\nG1 X1\nM2\n").problems(), "");
}

// Speeds of the events after the first.
std::vector<double> speeds(std::string_view text, const Conditions& conditions = {}) {
  std::vector<double> result;
  for (const base::Event& event : read_well(text, conditions).events()) {
    if (event.kind == base::Event::Kind::spindle_speed) result.push_back(event.value);
  }
  return result;
}

TEST(ConstantSurfaceSpeed, IsThatOfTheCircleTheToolStandsOn) {
  const std::vector<double> found = speeds("G0 X10\nG96 S100 D2000 M3\nG1 X5 F10\nX0\nG97 S300\nX5\nM2\n");
  const double at_10 = 100'000 / (2 * std::numbers::pi * 10);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0], at_10, 1e-9);
  EXPECT_EQ(found[1], 2000);  // twice that of X10 would be more
  EXPECT_EQ(found[2], 300);
}

TEST(ConstantSurfaceSpeed, IsBoundedByG50OfLathes) {
  EXPECT_EQ(speeds("G50 S1500\nG0 X1\nG96 S200 M3\nM30\n", in(Dialect::fanuc)), std::vector<double>{1500});
  EXPECT_EQ(read("G96\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("G96 S1 D0\nM2\n").problems(), "1:8 bad-value; ");
}

TEST(LocalSystem, IsTheShiftOfG92) {
  EXPECT_EQ(end_of("G0 X1 Y1\nG52 X10\nG0 X0 Y0\nM2\n"), (Point{10, 0, 0}));
  EXPECT_EQ(read("G52\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(end_of("G52 X10\nG52 Y3\nG0 X0 Y0\nM2\n"), (Point{10, 3, 0}));
  EXPECT_EQ(end_of("G0 X1\nG92 X5\nG52 X1\nG0 X1\nG0 Y#5211\nM2\n"), (Point{2, 1, 0}));
}

TEST(ToolTable, IsSetByG10) {
  EXPECT_EQ(end_of("T1 M6 G43\nG10 L1 P1 Z9\nG0 Z2\nG43 X1\nZ2\nM2\n", with_tools()), (Point{1, 0, 11}));
  EXPECT_EQ(end_of("G43 H1\nG0 Z1\nG10 L10 P2 Z4\nG43 H2\nG0 Z4 X1\nM2\n", with_tools()), (Point{1, 0, 3}));
  EXPECT_EQ(end_of("G10 L2 P9 Z10\nG92 Z7\nG0 Z8\nG10 L11 P2 Z1\nG92.1\nG43 H2\nG59.3 G0 Z1 X1\nM2\n", with_tools()),
            (Point{1, 0, 1}));
  EXPECT_EQ(read("G10 L1 P77 Z1\nM2\n", with_tools()).problems(), "1:8 unknown-tool; ");
}

TEST(ToolTable, IsSetInATurnedSystem) {
  const Reading reading =
      read_well("G10 L2 P1 R30 X7\nG0 X5 Y5\nG10 L10 P2 X2\nG43 H2\nG0 A#5420 B#5421\nM2\n", with_tools());
  EXPECT_NEAR(at(reading.lines().back().end, base::Axis::A), 2, 1e-9);
  EXPECT_NEAR(at(reading.lines().back().end, base::Axis::B), 5, 1e-9);
}

TEST(ToolTable, OfFanucIsRegisters) {
  const Conditions fanuc = in(Dialect::fanuc);
  EXPECT_EQ(end_of("G10 L10 P1 R50.\nG10 L11 P1 R-0.5\nG43 H1 G0 Z0\nM30\n", fanuc), (Point{0, 0, 49.5}));
  EXPECT_EQ(end_of("G10 L10 P1 R50.\nG44 H1 G0 Z0\nM30\n", fanuc), (Point{0, 0, -50}));
  EXPECT_EQ(end_of("G91 G10 L10 P1 R5.\nG10 L10 P1 R5.\nG10 L12 P1 R3.\nG90 G43 H1 G0 Z0\nM30\n", fanuc),
            (Point{0, 0, 10}));
}

// Haas' page of G10: "L1 or L11 Tool wear offset amount (for H code)".
TEST(ToolTable, OfFanucHasWearByL1) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const Conditions conditions = in(dialect);
    EXPECT_EQ(end_of("G10 L10 P1 R50.\nG10 L1 P1 R-0.5\nG43 H1 G0 Z0\nM30\n", conditions), (Point{0, 0, 49.5}));
    EXPECT_EQ(end_of("G10 L11 P1 R-0.5\nG91 G10 L1 P1 R-0.5\nG90 G43 H1 G0 Z0\nM30\n", conditions), (Point{0, 0, -1}));
  }
}

TEST(ToolLength, IsAdded) {
  EXPECT_EQ(end_of("G43 H1\nG43.2 H2\nG0 Z1\nM2\n", with_tools()), (Point{0, 0, 8}));
  EXPECT_EQ(read("G43.2\nM2\n", with_tools()).problems(), "1:1 missing-word; ");
}

TEST(FurtherSystems, AreSetAndChosenByNumber) {
  EXPECT_EQ(end_of("G10 L20 P48 X7.\nG54.1 P48\nG0 X0 Y1.\nM30\n", in(Dialect::fanuc)), (Point{7, 1, 0}));
  EXPECT_EQ(end_of("G10 L20 P2 X7.\nG154 P2\nG0 X0\nG54\nX1.\nM30\n", in(Dialect::haas)), (Point{1, 0, 0}));
  EXPECT_EQ(read("G154 P100\nM30\n", in(Dialect::haas)).problems(), "1:6 bad-value; ");
  EXPECT_EQ(read("G54.1\nM30\n", in(Dialect::fanuc)).problems(), "1:1 missing-word; ");
}

TEST(ExactStop, IsOfOneBlock) {
  const std::vector<Move> lines = read_well("G64 P0.1 F100\nG1 X1\nG9 X2\nX3\nM30\n", in(Dialect::fanuc)).lines();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].path_mode, PathMode::blend);
  EXPECT_EQ(lines[1].path_mode, PathMode::exact_stop);
  EXPECT_EQ(lines[2].path_mode, PathMode::blend);
}

TEST(ExactStop, IsG61OfFanuc) {
  EXPECT_EQ(read_well("G61\nG0 X1.\nM30\n", in(Dialect::fanuc)).lines()[0].path_mode, PathMode::exact_stop);
  EXPECT_EQ(read_well("G61\nG0 X1.\nM2\n").lines()[0].path_mode, PathMode::exact_path);
}

TEST(LookAheadCodes, MoveNothing) {
  EXPECT_EQ(end_of("G5.1 Q1\nG8 P1\nG5 P10000\nG0 X1.\nG5 P0\nM29 S500\nX2.\nM30\n", in(Dialect::fanuc)),
            (Point{2, 0, 0}));
  EXPECT_EQ(end_of("G103 P1\nG187 P3 E0.01\nG0 X1.\nM30\n", in(Dialect::haas)), (Point{1, 0, 0}));
}

TEST(KeptModes, ComeBack) {
  EXPECT_EQ(end_of("F60\nM70\nG20 G91 G18\nF7\nM72\nG0 X1\nG1 X2\nM2\n"), (Point{2, 0, 0}));
  EXPECT_NEAR(read_well("F60\nM70\nF7\nM72\nG1 X2\nM2\n").lines()[0].feed.value, 1, 1e-12);
  EXPECT_EQ(end_of("G10 L2 P2 X5\nM70\nG55\nM72\nG0 X1\nM2\n"), (Point{1, 0, 0}));
  EXPECT_EQ(read_well("G61\nM70\nG64\nM72\nG0 X1\nM2\n").lines()[0].path_mode, PathMode::exact_path);
  EXPECT_EQ(end_of("M70\nG7\nM72\nG0 X3\nM2\n"), (Point{3, 0, 0}));
}

TEST(KeptModes, AreToolLengthsToo) {
  EXPECT_EQ(end_of("G43 H2\nM70\nG49\nM72\nG0 Z1\nM2\n", with_tools()), (Point{0, 0, 6}));
  EXPECT_EQ(end_of("G43.1 Z3\nM70\nG49\nM72\nG0 Z1\nM2\n"), (Point{0, 0, 4}));
}

TEST(KeptModes, BringBackTheSpindleAndCoolant) {
  using Kind = base::Event::Kind;
  std::vector<Kind> kinds;
  for (const base::Event& event : read_well("S500 M3 M8\nM70\nM5 M9\nM72\nM2\n").events()) kinds.push_back(event.kind);
  const std::vector<Kind> expected = {Kind::spindle_speed, Kind::spindle_clockwise, Kind::coolant_flood,
                                      Kind::spindle_stop,  Kind::coolant_off,       Kind::spindle_clockwise,
                                      Kind::coolant_flood, Kind::program_end};
  EXPECT_EQ(kinds, expected);
}

TEST(KeptModes, AreEachCallsOwn) {
  EXPECT_EQ(end_of("o<a> sub\nM73\nG91\no<a> endsub\nG0 X1\no<a> call\nX1 Y1\nM2\n"), (Point{1, 1, 0}));
  // Also where another call begins before any block does.
  EXPECT_EQ(end_of("o<a> sub\nM73\nG91\no<a> endsub\no<b> sub\no<b> endsub\nG0 X1\no<a> call\no<b> call\nX1 Y1\nM2\n"),
            (Point{1, 1, 0}));
  // What a line says is read in them.
  EXPECT_EQ(end_of("o<a> sub\nM73\nG20\no<a> endsub\nG0 X10\no<a> call\nX[#5420+1]\nM2\n"), (Point{11, 0, 0}));
  EXPECT_EQ(
      end_of("o<a> sub\nM73\nG91\no<a> endsub\no<a> call\no<b> if [#<_incremental>]\nG0 X9\no<b> endif\nG0 Y1\nM2\n"),
      (Point{0, 1, 0}));
  EXPECT_EQ(
      read("F60\no<a> sub\nM70\nG5.2 X1 Y1 P1 L3\no<a> endsub\no<a> call\nX2 Y2 P1\nX3 Y1 P1\nG5.3\nM2\n").problems(),
      "");
  EXPECT_EQ(read("F60\no<a> sub\nM73\nG55\nG5.2 X10 Y10 P1\no<a> endsub\no<a> call\nX20 Y0\nG5.3\nM2\n")
                .problems()
                .substr(0, 22),
            "8:1 unfinished-curve; ");
  EXPECT_EQ(read("o<a> sub\nM72\no<a> endsub\nM70\no<a> call\nM2\n").problems(), "2:1 missing-modes; ");
  EXPECT_EQ(read("M72\nM2\n").problems(), "1:1 missing-modes; ");
  EXPECT_EQ(read("M70\nM71\nM72\nM2\n").problems(), "3:1 missing-modes; ");
}

// LinuxCNC 2.9 brings back whether a shift is in force, not how far it shifts.
TEST(KeptModes, BringBackWhetherAShiftIsInForce) {
  EXPECT_EQ(end_of("M70\nG92 X1\nM72\nG0 X10\nM2\n"), (Point{10, 0, 0}));
  EXPECT_EQ(end_of("M70\nG52 X5\nM72\nG0 X10\nM2\n"), (Point{10, 0, 0}));
  EXPECT_EQ(end_of("G92 X1\nM70\nG92.2\nM72\nG0 X10\nM2\n"), (Point{9, 0, 0}));
  EXPECT_EQ(end_of("G92 X1\nM70\nG92 X5\nM72\nG0 X10\nM2\n"), (Point{5, 0, 0}));
  EXPECT_EQ(end_of("o<a> sub\nM73\nG52 Y1\no<a> endsub\no<a> call\nG0 Y2\nM2\n"), (Point{0, 2, 0}));
}

// What M70 keeps in a call that M73 has kept modes of comes back where the call ends, as LinuxCNC has it.
TEST(KeptModes, OfM70BehindM73ComeBackByThemselves) {
  EXPECT_EQ(end_of("o<a> sub\nM73\nG91\nM70\nG90\no<a> endsub\no<a> call\nG0 X1\nX1\nM2\n"), (Point{2, 0, 0}));
  EXPECT_EQ(end_of("o<a> sub\nM73\nG91\nM71\no<a> endsub\no<a> call\nG0 X1\nX1\nM2\n"), (Point{2, 0, 0}));
}

// However many events a block, or calls that end at one, bring back.
TEST(KeptModes, AreBroughtBackByAnyNumberOfEvents) {
  const std::string some = "S1 M3 M8\nM7\nM49\nM52 P1\nM53 P0\n", others = "S2 M4 M9\nM48\nM52 P0\nM53 P1\n";
  std::string text;
  constexpr int depth = 6;
  for (int k = 0; k < depth; ++k) {
    const std::string name = "o" + std::to_string(k), inner = k > 0 ? "o" + std::to_string(k - 1) + " call\n" : "";
    text += name + " sub\nM73\n" + (k % 2 == 0 ? some : others) + inner + name + " endsub\n";
  }
  const std::vector<base::Event> events = read_well(text + some + "o5 call\nG0 X1\nM2\n").events();
  EXPECT_GT(events.size(), 8U * 2 * (depth - 1));
  EXPECT_EQ(read("S100 M3\nM70\nM52 P1\nM53 P0\nM72 S200 T1 M6 M4 M9 M49 M101 G33.1 Z-5 K1\nM2\n").problems(), "");
}

}  // namespace test_modes
}  // namespace leadscrew::gcode
