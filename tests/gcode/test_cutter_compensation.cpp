// Cutter compensation by hand: where the tool's middle goes, what waits with it, what is refused.

#include <cmath>
#include <sstream>

#include "reading.hpp"
#include "trunnion.hpp"

namespace leadscrew::gcode {
namespace test_cutter_compensation {

// Ends of moves to 1e-4, and what happens between: "f10,1,0 d s100 a…". f feed, r rapid, a arc, R arc at rapid.
std::string way(const Reading& reading) {
  std::ostringstream out;
  const auto round = [](double value) { return std::round(value * 1e4) / 1e4 + 0.0; };
  for (const Move& move : reading.moves) {
    const bool is_rapid = move.feed.mode == Feed::Mode::rapid, is_arc = move.kind == Move::Kind::arc;
    if (move.kind == Move::Kind::dwell) out << "d ";
    if (move.kind == Move::Kind::event && move.event.kind != base::Event::Kind::program_end)
      out << "e" << base::number(move.line) << ' ';
    if (move.kind != Move::Kind::line && !is_arc) continue;
    const Point end = xyz(move.end);
    out << (is_arc ? (is_rapid ? 'R' : 'a') : is_rapid ? 'r' : 'f') << round(end.x) << ',' << round(end.y);
    if (end.z != 0) out << ',' << round(end.z);
    out << ' ';
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

std::string way(const std::string& text, const Conditions& conditions = {}) {
  return way(read_well("F600\n" + text + "\nM2\n", conditions));
}

std::string problems(const std::string& text, const Conditions& conditions = {}) {
  return read("F600\n" + text + "\nM2\n", conditions).problems();
}

Conditions with_tool(double diameter, Dialect dialect = Dialect::leadscrew) {
  Conditions conditions = in_dialect(dialect);
  machine::Tool tool;
  tool.number = 7;
  tool.diameter = diameter;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

TEST(CutterCompensation, GoesBesideLines) {
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nX20\nG40 Y30"), "f10,1 f20,1 f20,30");
  EXPECT_EQ(way("G42.1 D2\nG1 X10\nX20\nG40 Y30"), "f10,-1 f20,-1 f20,30");
  EXPECT_EQ(way("G42.1 D-2\nG1 X10\nX20\nG40 Y30"), "f10,1 f20,1 f20,30");
}

TEST(CutterCompensation, EndsWaysWhereTheyMeetAtInnerCorners) {
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nY10\nX0\nG40 Y30"), "f9,1 f9,9 f0,9 f0,30");
  // An arc and a line, a line and an arc, two arcs: each at the same distance from both.
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nX20\nG2 X30 I5\nG40 G1 X40"), "f10,1 f19.0839,1 a31,0 f40,0");
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nY20\nG3 X0 I-5\nG1 X3\nG40 Y21"), "f9,1 f9,20 a1.127,21 f3,21");
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nG2 X20 I5\nG2 X30 I5\nG40 G1 X40"), "f9.0839,1 a20,3.3166 a31,0 f40,0");
}

TEST(CutterCompensation, GoesRoundOuterCorners) {
  const Reading reading = read_well("F600\nG42.1 D2\nG1 X10 F300\nX20\nY10 F120\nG40 X30\nM2\n");
  EXPECT_EQ(way(reading), "f10,-1 f20,-1 a21,0 f21,10 f30,10");
  const std::vector<Move> arcs = reading.arcs();
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].center_first, 20);
  EXPECT_EQ(arcs[0].center_second, 0);
  EXPECT_EQ(arcs[0].turns, 1);
  EXPECT_DOUBLE_EQ(arcs[0].feed.value, 2);
  EXPECT_EQ(way("G42.1 D2\nG1 X10\nG0 X20\nY10\nG40 X30"), "f10,-1 r20,-1 R21,0 r21,10 r30,10");
}

TEST(CutterCompensation, KeepsArcsAboutTheirCentres) {
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nG3 X15 Y5 J5\nG1 Y10\nG40 X0"), "f10,1 a14,5 f14,10 f0,10");
  EXPECT_EQ(way("G42.1 D2\nG1 X10\nG3 X15 Y5 J5\nG1 Y10\nG40 X0"), "f10,-1 a16,5 f16,10 f0,10");
  const std::vector<Move> whole = read_well("F600\nG41.1 D2\nG1 X10\nG3 J5 P3 Z3\nG40 G1 X0\nM2\n").arcs();
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].turns, 3);
  EXPECT_EQ(whole[0].start[0], whole[0].end[0]);
  EXPECT_EQ(whole[0].end[2], 3);
}

// Of a helix whose end an inner corner cuts off, and of one of more turns than one.
TEST(CutterCompensation, CutsHelicesAndKeepsTheirLevels) {
  const Reading reading = read_well("F600\nG41.1 D2\nG1 X10\nG3 J5 P2 Z3\nG3 X10 Y10 J5 P2 Z4\nG1 Y5\nG40 X0\nM2\n");
  const std::vector<Move> arcs = reading.arcs();
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].turns, 2);
  EXPECT_EQ(arcs[1].turns, 2);
  EXPECT_EQ(arcs[1].end[2], 4);
  EXPECT_NEAR(arcs[1].end[0], 11, 1e-12);
  EXPECT_NEAR(arcs[1].end[1], 5 + std::sqrt(15), 1e-12);
}

TEST(CutterCompensation, KeepsWhatStandsBetweenAtItsPlace) {
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nZ-1\nS100 M3\nG4 P1\nY10\nM8\nX20\nG40 X30"),
            "f9,1 f9,1,-1 e5 e5 d f9,10,-1 e8 a10,11,-1 f20,11,-1 f30,10,-1");
}

TEST(CutterCompensation, CountsFromTheProgrammedPlace) {
  EXPECT_EQ(way("G91 G41.1 D2\nG1 X10\nY10\nX-10\nG40 Y20"), "f9,1 f9,9 f0,9 f0,30");
  EXPECT_EQ(way("#1=[#<_ccomp>]\nG41.1 D2\nG1 X[#1/40]\n#2=#<_ccomp>\nG40 Y[#2/41]"), "f10,1 f10,10");
}

TEST(CutterCompensation, ComesBackWithTheLineBehindG40) {
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nX20\nG40\nZ5\nX0"), "f10,1 f20,1 f20,0,5 f0,0,5");
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nX20\nG40\nM8\nG1 X20"), "f10,1 f20,1 e6 f20,0");
  EXPECT_EQ(way("G41.1 D2\nG1 X10\nX20"), "f10,1 f20,1");
  EXPECT_EQ(way("G41.1 D2\nG40\nG2 X10 I5"), "a10,0");
}

// Whatever stands between G40 and the line, each move begins where the last has ended. First moves are those from where the
// program stands, as LinuxCNC has them.
TEST(CutterCompensation, GoesOnFromBesideTheContourWhereNoMoveIsBehindG40) {
  const std::string aside = "G41.1 D6\nG1 X20\nY20\nG40\n";
  const auto behind = [&](const std::string& text) {
    const Reading reading = read_well("F600\n" + aside + text + "\nM2\n");
    base::AxisVector at{};
    for (const Move& move : reading.moves) {
      EXPECT_EQ(move.start, at) << text << ", line " << base::number(move.line);
      at = move.end;
    }
    return way(reading).substr(std::string("f17,3 f17,20 ").size());
  };
  EXPECT_EQ(behind("G41.1 D6\nG40\nX30"), "f30,20");
  EXPECT_EQ(behind("G41.1 D6\nM8\nG40\nG41.1 D0\nG40\nG0 X30"), "e7 r30,20");
  EXPECT_EQ(behind("G41.1 D4\nX40 Y33\nX60\nG40 X80"), "f38.91,34.6769 a40,35 f60,35 f80,33");
  EXPECT_EQ(behind("G18\nG41.1 D4\nX40 Z-30\nZ-50\nG40 X60"), "f38,20,-30.6056 f38,20,-50 f60,20,-50");
  EXPECT_EQ(behind("G18\nG41.1 D0\nX40 Z-30\nG40 X60"), "f40,20,-30 f60,20,-30");
  // A line to where the program stands is no first move.
  EXPECT_EQ(behind("G41.1 D2\nX20 Y20\nX50\nX80\nG40"), "f20,20 f50,21 f80,21");
  EXPECT_EQ(behind("G93\nG41.1 D2\nX20 Y20 F60\nG40"), "f20,20");
  EXPECT_EQ(behind("G0\nG1 Z-3"), "r20,20 f20,20,-3");
  EXPECT_EQ(behind("G80 G1\nZ-3"), "f20,20 f20,20,-3");
  EXPECT_EQ(behind("G0\nG2 X30 I5"), "r20,20 a30,20");
  EXPECT_EQ(behind("G28"), "r20,20 r0,0");
  EXPECT_EQ(behind("G30 Y20"), "r20,20 r20,0");
}

// Nothing moves the contour while it is on: no system of Fanuc's and Haas' further ones, no T of their lathes; D is no other.
TEST(CutterCompensation, IsNotMovedByWordsOfFanucsFamily) {
  const std::string haas = "G154 P1\nG41 D7\nG1 X10.\nX20.\n", mill = "G54.1 P1\nG41 D7\nG1 X10.\nX20.\n";
  EXPECT_EQ(problems(haas + "G10 L20 P1 Y5.", with_tool(4, Dialect::haas)), "6:1 cutter-compensation; ");
  EXPECT_EQ(problems(mill + "G10 L20 P1 Y5.", with_tool(4, Dialect::fanuc)), "6:1 cutter-compensation; ");
  EXPECT_EQ(problems(mill + "G10 L20 P2 Y5.\nG10 L2 P1 Y5.", with_tool(4, Dialect::fanuc)), "");
  EXPECT_EQ(problems(mill + "G10 L2 P0 Y5.", with_tool(4, Dialect::fanuc)), "6:1 cutter-compensation; ");
  EXPECT_EQ(problems(mill + "X30. D7", with_tool(4, Dialect::fanuc)), "");
  EXPECT_EQ(problems(mill + "X30. D2", with_tool(4, Dialect::fanuc)), "6:6 unused-word; ");
  const std::string lathe = "T0707\nG98 G0 X60. Z5.\nG42 G1 X40. Z2. F200.\nZ-10.\n";
  EXPECT_EQ(problems(lathe + "T0700", with_tool(4, Dialect::fanuc_lathe)), "6:1 cutter-compensation; ");
}

// What a cycle plans as a whole begins where the program stands, too: a rapid leads there, whatever its first move is.
TEST(CutterCompensation, ComesBackBeforeCyclesOfLathesPeck) {
  const auto behind = [](const std::string& cycle) {
    const std::string aside = "G98 F600\nT0707\nG0 X80. Z0\nG41 X70.\nG1 X60. Z-5.\nZ-40.\nG40\n";
    std::ostringstream out;
    for (const Move& move : read_well(aside + cycle + "\nM30\n", with_tool(4, Dialect::fanuc_lathe)).lines()) {
      if (base::number(move.line) < 8) continue;
      out << (move.feed.mode == Feed::Mode::rapid ? " r" : " f") << at(move.end, base::Axis::X) << ','
          << at(move.end, base::Axis::Z);
    }
    return out.str();
  };
  EXPECT_EQ(behind("G74 R1.\nG74 Z-45. Q5000"), " r30,-40 f30,-45 r30,-40");
  EXPECT_EQ(behind("G75 R1.\nG75 X50. P5000"), " r30,-40 f25,-40 r30,-40");
}

// LinuxCNC changes planes, tools and overrides before G40 of the same block, others behind it.
TEST(CutterCompensation, EndsBeforeOrBehindWhatElseItsBlockSays) {
  const std::string within = "G41.1 D6\nG1 X20\nY20\n";
  for (const std::string block : {"G40 G18", "G40 M6 T7", "G40 M66 P0 L0", "G40 M62 P0", "G40 M48"}) {
    EXPECT_EQ(problems(within + block, with_tool(4, Dialect::linuxcnc)), "5:5 cutter-compensation; ") << block;
    EXPECT_EQ(problems(within + block, with_tool(4)), "") << block;
  }
  for (const std::string block : {"G40 G17", "G40 G20", "G40 G55", "G40 G43.1 Z5", "G40 G92.1", "G40 G98"})
    EXPECT_EQ(problems(within + block, with_tool(4, Dialect::linuxcnc)), "") << block;
}

// M70 to M73 keep that it is off; what they kept while it was on does not switch it on again.
TEST(CutterCompensation, EndsWhereModesComeBackThatWereKeptWithoutIt) {
  EXPECT_EQ(way("M70\nG41.1 D2\nG1 X10\nX20\nM72\nG1 X30"), "f10,1 f20,1 f30,0");
  EXPECT_EQ(way("G41.1 D2\nM70\nG1 X10\nX20\nG91\nM72\nX30\nY9\nG40 X0"), "f10,1 f20,1 f29,1 f29,9 f0,9");
  const std::string call = "o1 sub\nM73\nG91\nG41.1 D2\nG1 X10\nX10\no1 endsub\no1 call\n";
  EXPECT_EQ(way(call + "G1 X30\nY10"), "f10,1 f20,1 f30,0 f30,10");
  EXPECT_EQ(way("M70\nG41.1 D0\nG1 X10\nM72\nG1 X30"), "f10,0 f30,0");
  EXPECT_EQ(problems("G41.1 D2\nM70\nG1 X10\nX20\nG40\nM72"), "7:1 cutter-compensation; ");
  const std::string again = "G41.1 D2\nM70\nG1 X10\nX20\nG40\nG1 X0 Y0\n";
  EXPECT_EQ(problems(again + "G42.1 D2\nM72"), "9:1 cutter-compensation; ");
  EXPECT_EQ(problems(again + "G18 G41.1 D2\nM72"), "9:1 cutter-compensation; ");
  EXPECT_EQ(problems(again + "G55\nG41.1 D2\nM72"), "10:1 cutter-compensation; ");
  EXPECT_EQ(problems(again + "G43.1 Z5\nG41.1 D2\nM72"), "10:1 cutter-compensation; ");
  EXPECT_EQ(problems(again + "G41.1 D2\nM72\nG1 X10\nG40"), "");
}

// A plane that comes back with the end of a call comes back behind the contour in the plane before.
TEST(CutterCompensation, IsInThePlaneThatComesBackNoMore) {
  const std::string text = "o1 sub\nM73\nG18\nG42.1 D4\nG1 X10\nZ10\no1 endsub\no1 call\n";
  EXPECT_EQ(way(text + "G1 X20\nX30 Z20"), "f8,0,2 f8,0,10 f20,0,10 f30,0,20");
  EXPECT_EQ(problems(text + "G3 X20 Y10 J10"), "10:1 cutter-exit; ");
  EXPECT_EQ(problems(text + "G1 X20", in_dialect(Dialect::linuxcnc)), "10:1 cutter-compensation; ");
}

// By the feed of linear axes, in any unit, as the tool moves aside alone.
TEST(CutterCompensation, ComesBackAtTheFeedOfLinearAxes) {
  for (const char* const line : {"G1 X2 Y1", "G1", "G1 A0", "G1 X2"}) {
    const Reading reading = read_well("G20\nF20\nG42.1 D0.1\nG1 X2 Y1\nG40\n" + std::string(line) + "\nM2\n");
    const std::vector<Move> lines = reading.lines();
    ASSERT_EQ(lines.size(), 2u) << line;
    EXPECT_DOUBLE_EQ(lines[1].feed.value, 20 * 25.4 / 60) << line;
    EXPECT_NEAR(lines[1].end[0], 50.8, 1e-12) << line;
  }
}

// D0 beside a contour is on as any other.
TEST(CutterCompensation, IsOnWithARadiusOfNothing) {
  const std::string aside = "G41.1 D6\nG1 X20 F600\nY20\nG40\nG41.1 D0\n";
  EXPECT_EQ(problems(aside + "X30\nG41.1 D4"), "8:1 cutter-compensation; ");
  EXPECT_EQ(problems(aside + "G43.1 Z5"), "7:1 cutter-compensation; ");
  EXPECT_EQ(problems(aside + "G18"), "7:1 cutter-compensation; ");
  EXPECT_EQ(problems(aside + "G81 Z-5 R1"), "7:1 cutter-compensation; ");
}

TEST(CutterCompensation, TakesTheRadiusOfATool) {
  EXPECT_EQ(way("G41 D7\nG1 X10\nX20\nG40 Y30", with_tool(4)), "f10,2 f20,2 f20,30");
  EXPECT_EQ(way("T7 M6\nG42\nG1 X10\nX20\nG40 Y30", with_tool(4)), "e2 e2 f10,-2 f20,-2 f20,30");
  EXPECT_EQ(way("T7 M6\nG42 D0\nG1 X10\nX20\nG40 Y30", with_tool(4)), "e2 e2 f10,-2 f20,-2 f20,30");
  EXPECT_EQ(way("G20 G41.1 D0.1\nG1 X1\nX2\nG40 Y1"), "f25.4,1.27 f50.8,1.27 f50.8,25.4");
  // D0 of Fanuc's family is no radius; a D without a code before is that of the next.
  EXPECT_EQ(way("G41 D0\nG1 X10.\nX20.\nG40 Y30.", with_tool(4, Dialect::fanuc)), "f10,0 f20,0 f20,30");
  EXPECT_EQ(way("G0 Z5. D7\nG41\nG1 X10.\nX20.\nG40 Y30.", with_tool(4, Dialect::haas)),
            "r0,0,5 f10,2,5 f20,2,5 f20,30,5");
  EXPECT_EQ(problems("G41 D8\nG1 X10", with_tool(4)), "2:5 unknown-tool; ");
  EXPECT_EQ(problems("G41 D1\nG1 X10"), "2:5 no-tool-table; ");
  EXPECT_EQ(problems("G41 D1.5\nG1 X10", with_tool(4)), "2:5 bad-value; ");
  EXPECT_EQ(problems("G41.1\nG1 X10"), "2:1 missing-word; ");
}

TEST(CutterCompensation, WorksInEveryPlane) {
  const auto ends = [](const std::string& text) { return read_well("F600\n" + text + "\nM2\n").lines(); };
  const std::vector<Move> zx = ends("G18 G41.1 D2\nG1 Z10\nZ20\nG40 X5");
  EXPECT_EQ(xyz(zx[1].end), (Point{1, 0, 20}));
  const std::vector<Move> yz = ends("G19 G41.1 D2\nG1 Y10\nY20\nG40 Z5");
  EXPECT_EQ(xyz(yz[1].end), (Point{0, 20, 1}));
  EXPECT_EQ(problems("G19 G41.1 D2\nG1 Y10", in_dialect(Dialect::linuxcnc)), "2:5 cutter-compensation; ");
  // Orientation 2 of a lathe tool: its radius is at more X and more Z than the place that is programmed.
  const std::vector<Move> lathe = ends("G18 G41.1 D2 L2\nG1 Z10\nZ20\nG40 X5");
  EXPECT_EQ(xyz(lathe[1].end), (Point{0, 0, 19}));
  EXPECT_EQ(problems("G41.1 D2 L2\nG1 X10"), "2:10 cutter-compensation; ");
  EXPECT_EQ(problems("G18 G41.1 D2 L10\nG1 X10"), "2:14 bad-value; ");
}

TEST(CutterCompensation, TakesSideAndOrientationOfATool) {
  EXPECT_EQ(way("G41 D7\nG1 X10\nX20\nG40 Y30", with_tool(-4)), "f10,-2 f20,-2 f20,30");
  Conditions lathe = with_tool(2);
  machine::Tool tool = *lathe.tools.find(7);
  tool.orientation = 2;
  lathe.tools.set(tool);
  const std::vector<Move> moves = read_well("F600\nG18 G41 D7\nG1 Z10\nZ20\nG40 X5\nM2\n", lathe).lines();
  EXPECT_EQ(xyz(moves[1].end), (Point{0, 0, 19}));
  EXPECT_EQ(problems("G41 D7\nG1 X10", lathe), "2:1 cutter-compensation; ");
  EXPECT_EQ(problems("G10 L1 P7 Q9\nG41 D7\nG1 X10\nG40 Y9", lathe), "");
  EXPECT_EQ(problems("G10 L1 P7 Q10", lathe), "2:11 bad-value; ");
}

TEST(CutterCompensation, IsOnTheProgramsSideWhereItIsTurnedOrMirrored) {
  EXPECT_EQ(way("G68 X0 Y0 R90\nG41.1 D2\nG1 X10\nX20\nG40 Y30"), "f-1,10 f-1,20 f-30,20");
  EXPECT_EQ(way("G51.1 X0\nG41.1 D2\nG1 X10\nX20\nG40 Y30"), "f-10,1 f-20,1 f-20,30");
  EXPECT_EQ(problems("G51 X0 Y0 I2 J3 K1\nG41.1 D2\nG1 X10"), "3:1 cutter-compensation; ");
}

TEST(CutterCompensation, KeepsTheDurationOfAProgrammedBlock) {
  const std::vector<Move> lines = read_well("G93 G41.1 D2\nG1 X10 F6\nX20 F3\nY10 F6\nG40 X30 F6\nM2\n").lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].feed.mode, Feed::Mode::units_per_second);
  EXPECT_DOUBLE_EQ(lines[1].feed.value, 0.5);
  EXPECT_DOUBLE_EQ(lines[2].feed.value, 1);
}

TEST(CutterCompensation, RefusesWhatTheToolDoesNotFitInto) {
  const Reading reading = read("F600\nG41.1 D4\nG1 X10\nX30\nY10\nX29\nY0\nG40 X0\nM2\n");
  EXPECT_EQ(reading.problems(), "6:1 cutter-gouge; 7:1 cutter-gouge; ");
  EXPECT_NE(reading.diagnostics[0].message.find("line 5 and that of line 6"), std::string::npos);
  // An arc of the tool's radius from inside, one beyond it, a step that is lower than the radius.
  EXPECT_EQ(problems("G41.1 D10\nG1 X10\nG3 X10 Y10 J5\nG40 G1 X0"), "4:1 cutter-gouge; ");
  EXPECT_EQ(problems("G41.1 D9.8\nG1 X10\nG3 X10 Y10 J5\nG40 G1 X0"), "");
  EXPECT_EQ(problems("G41.1 D4\nG1 X10\nX20\nY1\nX30\nG40 Y9"), "5:1 cutter-gouge; ");
}

// On different levels neighbours do not hinder one another.
TEST(CutterCompensation, LooksForGougesOnOneLevel) {
  const std::string begin = "G42.1 D2\nG1 X10\nX30\n", end = "G3 X22 Y-2.4721 I-5 J2\nG40 G1 Y-30";
  EXPECT_EQ(problems(begin + end), "5:1 cutter-gouge; ");
  EXPECT_EQ(problems(begin + "Z5\n" + end), "");
  EXPECT_EQ(problems(begin + "Z5\nZ0\n" + end), "7:1 cutter-gouge; ");
}

// To beside its end, in its direction there: from (0, 0) to (11, 10), tangent to X = 11.
TEST(CutterCompensation, BeginsWithAnArc) {
  const std::vector<Move> moves = read_well("F600\nG42.1 D2\nG3 X10 Y10 J10\nG1 Y20\nG40 X30\nM2\n").moves;
  EXPECT_EQ(moves[0].kind, Move::Kind::arc);
  EXPECT_EQ(xyz(moves[0].end), (Point{11, 10, 0}));
  EXPECT_NEAR(moves[0].center_first, 11 - 221.0 / 22, 1e-9);
  EXPECT_NEAR(moves[0].center_second, 10, 1e-9);
  EXPECT_EQ(xyz(moves[1].end), (Point{11, 20, 0}));
  EXPECT_EQ(problems("G41.1 D22\nG3 X10 Y10 J10\nG1 Y20"), "3:1 cutter-entry; ");
  EXPECT_EQ(problems("G41.1 D2\nG2 X10 Y-3 I5 J-1.5\nG1 X20"), "");
}

// It is told, and goes on, where LinuxCNC does not look for it, and where somebody allows it.
TEST(CutterCompensation, MayGougeWhereThatIsAllowed) {
  const std::string text = "F600\nG41.1 D4\nG1 X0 Y40\nY30\nY20\nX-10\nY0\nX13\nY20\nX3\nY30\nY40\nG40 X20\nM2\n";
  const Reading reading = read(text, in_dialect(Dialect::linuxcnc));
  ASSERT_FALSE(reading.diagnostics.empty());
  for (const base::Diagnostic& told : reading.diagnostics) {
    EXPECT_EQ(told.code, "cutter-gouge");
    EXPECT_EQ(told.severity, base::Severity::warning);
  }
  EXPECT_EQ(reading.lines().size(), 11u);
}

// By the arc round the corner at which the way in ends.
TEST(CutterCompensation, LooksForGougesOnTheWayIn) {
  EXPECT_EQ(problems("G41.1 D1.6\nG1 X30 Y0\nX29.508 Y-0.087\nX31.857 Y0.768\nX31.563 Y0.364\nG40 Y70"),
            "5:1 cutter-gouge; ");
}

// A cavity with a neck, through which the tool fits or not.
TEST(CutterCompensation, LooksForGougesBeyondNeighbours) {
  const std::string begin = "G1 X0 Y40\nY30\nY20\nX-10\nY0\nX13\nY20\nX3\nY30\nY40\n", end = "G40 X20";
  const Reading reading = read("F600\nG41.1 D4\n" + begin + end + "\nM2\n");
  EXPECT_EQ(reading.problems(), "10:1 cutter-gouge; 11:1 cutter-gouge; 12:1 cutter-gouge; ");
  EXPECT_NE(reading.diagnostics[1].message.find("and that of line 11"), std::string::npos);
  EXPECT_EQ(problems("G41.1 D3\n" + begin + end), "");
  // Behind a move that leaves the level, or at rapid, it is another contour.
  EXPECT_EQ(problems("G41.1 D4\nG1 X0 Y40\nY30\nY20\nX-10\nY0\nX13\nZ5\nY20\nX3\nY30\nY40\n" + end), "");
  EXPECT_EQ(problems("G41.1 D4\nG1 X0 Y40\nY30\nY20\nX-10\nG0 Y0\nG1 X13\nY20\nX3\nY30\nY40\n" + end), "");
}

// The tool goes across arcs by which it came and will leave, or along the first of the contour again.
TEST(CutterCompensation, TakesNoLeadInForAGouge) {
  const std::string begin = "G41.1 D6\nG1 X5 Y-5\nG3 X10 Y0 J5\nX0 Y10 I-10\nX-10 Y0 J-10\nX0 Y-10 I10\nX10 Y0 J10\n";
  EXPECT_EQ(problems(begin + "X5 Y5 I-5\nG40 G1 X0 Y0"), "");
  EXPECT_EQ(problems(begin + "X7.07107 Y7.07107 I-10\nG40 G1 X0 Y0"), "");
  EXPECT_EQ(problems("G41.1 D6\nG1 X5 Y-5\nG3 X10 Y0 J5\nX10 Y0 I-10\nX5 Y5 I-5\nG40 G1 X0 Y0"), "");
  EXPECT_EQ(
      problems("G41.1 D6\nG1 X3 Y-5\nX6\nG3 X10 Y-1 J4\nG1 Y20\nX-10\nY-20\nX10\nY-1\nG3 X6 Y3 I-4\nG40 G1 X0 Y0"), "");
}

TEST(CutterCompensation, BeginsWithALineThatIsLongEnough) {
  EXPECT_EQ(problems("G41.1 D20\nG1 X10\nX20"), "3:1 cutter-entry; ");
  EXPECT_EQ(problems("G41 D7\nG2 X10. I5.\nG1 X20.", with_tool(2, Dialect::fanuc)), "3:1 cutter-entry; ");
  EXPECT_EQ(problems("G41.1 D2\nG1 Z5\nX20\nX30\nG40 Y9"), "");
  EXPECT_EQ(problems("G41.1 D2\nG1 Z5\nX20", in_dialect(Dialect::linuxcnc)), "3:1 cutter-entry; ");
  EXPECT_EQ(problems("G41.1 D2\nG1 X10\nX20\nG40\nG2 X30 I5"), "6:1 cutter-exit; ");
}

TEST(CutterCompensation, IsLeftByALine) {
  const std::string aside = "S100 M3 F600\nG0 Z5\nG41.1 D2\nG1 X10\nX20\nG40\n";
  for (const char* const block : {"G33 Z-5 K1", "G33.1 Z-5 K1", "G38.3 X25 F60"})
    EXPECT_EQ(problems(aside + block), "8:1 cutter-exit; ") << block;
  EXPECT_EQ(problems(aside + "S200\nM8\nG1 X30\nG33.1 Z-5 K1"), "");
}

// Radius 0 leads the tool back, as no compensation does: each move begins where the last has ended.
TEST(CutterCompensation, LeadsBackWhereItBeginsAgainWithoutARadius) {
  const Reading reading = read("G0 Z5\nG41.1 D6\nG1 X20 F600\nY20\nG40\nG41.1 D0\nG1 X30\nG40 X40\nM2\n");
  EXPECT_EQ(reading.problems(), "");
  base::AxisVector at{};
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::line) continue;
    EXPECT_EQ(move.start, at) << base::number(move.line);
    at = move.end;
  }
  EXPECT_EQ(at[0], 40);
}

TEST(CutterCompensation, TellsThatNoToolIsLoaded) {
  EXPECT_EQ(problems("G41\nG1 X10 F600\nX20\nG40 Y9"), "2:1 cutter-compensation; ");
  EXPECT_EQ(problems("G41.1 D0\nG1 X10 F600\nX20\nG40 Y9"), "");
}

// A hole where the program stands is drilled there, not from where the tool stands.
TEST(CutterCompensation, ComesBackBeforeACycle) {
  for (const char* const cycle : {"G81 X20 Y20 Z-5 R5", "G81 X20 Y20 Z-5 R2", "G91 G81 Z-5 R0", "G84 X20 Y20 Z-5 R5"}) {
    const Reading reading =
        read("G98 S100 M3 F600\nG0 Z5\nG41.1 D6\nG1 X20\nY20\nG40\n" + std::string(cycle) + "\nG80\nG0 X30\nM2\n");
    EXPECT_EQ(reading.problems(), "") << cycle;
    bool is_back = false;
    int holes = 0;
    for (const Move& move : reading.moves) {
      if (move.kind != Move::Kind::line || base::number(move.line) < 7 || base::number(move.line) > 7) continue;
      is_back |=
          move.feed.mode == Feed::Mode::rapid && at(move.end, base::Axis::Z) == 5 && at(move.end, base::Axis::X) == 20;
      if (at(move.end, base::Axis::Z) == at(move.start, base::Axis::Z)) continue;
      EXPECT_TRUE(is_back);
      EXPECT_EQ(at(move.start, base::Axis::X), 20);
      EXPECT_EQ(at(move.end, base::Axis::X), 20);
      ++holes;
    }
    EXPECT_GE(holes, 2) << cycle;
  }
  // Below R the rise leads back.
  const Reading below = read("G98 F600\nG41.1 D6\nG1 X20 Z-3\nY20\nG40\nG81 X20 Y20 Z-8 R2\nG80\nM2\n");
  for (const Move& move : below.moves) {
    const bool is_sideways = move.start[2] == -3 && move.end[2] == -3;
    EXPECT_FALSE(move.feed.mode == Feed::Mode::rapid && is_sideways) << base::number(move.line);
  }
}

Reading on_trunnion(const std::string& text, Dialect dialect = Dialect::leadscrew) {
  Conditions conditions = in_dialect(dialect);
  conditions.machine = testing_support::trunnion();
  return read(text, conditions);
}

// Wherever the plane lies, and rounding leaves the place where the cycle begins.
TEST(CutterCompensation, ComesBackBeforeACycleInATiltedPlane) {
  const auto check = [](const std::string& plane, const std::string& cycle) {
    const Reading reading =
        on_trunnion("G98 S100 M3 F600\nG0 Z5\nG41.1 D6\nG1 X20\nY20\nG40\n" + plane + '\n' + cycle + "\nG80\nM2\n");
    int holes = 0;
    for (const Move& move : reading.moves) {
      if (move.kind != Move::Kind::line || base::number(move.line) != 8 || move.start[2] == move.end[2]) continue;
      const bool is_fed = move.feed.mode != Feed::Mode::rapid;
      EXPECT_TRUE(!is_fed || std::hypot(move.start[0] - move.end[0], move.start[1] - move.end[1]) < 1e-8)
          << plane << ' ' << cycle;
      holes += is_fed;
    }
    EXPECT_EQ(reading.problems(), "") << plane << ' ' << cycle;
    EXPECT_GE(holes, 1) << plane << ' ' << cycle;
  };
  check("G68.2 X0 Y0 Z0 I0 J0 K30", "G91 G81 Z-5 R0");
  for (const char* const z : {"0", "0.1", "0.7", "1.1"}) {
    const std::string plane = std::string("G68.2 X0 Y0 Z") + z + " I0 J0 K";
    const std::string level = " R" + std::to_string(5 - std::stod(z));
    for (const char* const code : {"G81", "G85", "G84"}) check(plane + '0', std::string(code) + " Y20 Z-5" + level);
  }
}

// Where the tool stands has been told by axes.
TEST(CutterCompensation, IsLeftBeforeTipControl) {
  const std::string aside = "G90 F600\nG0 A30 C40\nG41.1 D6\nG1 X20\nY20\n";
  EXPECT_EQ(on_trunnion(aside + "G40\nG43.4\nG1 X60\nM2\n").problems(), "7:1 cutter-exit; ");
  EXPECT_EQ(on_trunnion(aside + "G40\nM428\nG1 X60\nM2\n", Dialect::linuxcnc).problems(), "7:1 cutter-exit; ");
  EXPECT_EQ(on_trunnion(aside + "G40 G43.4\nG1 X60\nM2\n").problems(), "6:5 cutter-exit; ");
  EXPECT_EQ(on_trunnion(aside + "G41.1 D0 G43.4\nG1 X60\nM2\n").problems().substr(0, 4), "6:1 ");
  EXPECT_EQ(on_trunnion(aside + "G40\nG68.2 X0 Y0 Z0 I90 J30 K0\nG53.1\nM2\n").problems(), "8:1 cutter-exit; ");
  EXPECT_EQ(on_trunnion(aside + "G40\nG1 X30\nG43.4\nX60\nM2\n").problems(), "");
}

TEST(CutterCompensation, RefusesWhatCannotStandBetween) {
  const auto between = [](const std::string& block, Dialect dialect = Dialect::leadscrew) {
    return problems("G41.1 D2\nG1 X10\nX20\n" + block + "\nG40\nG1 X30", in_dialect(dialect));
  };
  const std::string refused = "5:1 cutter-compensation; ";
  for (const char* const block : {"G18", "G55", "G49", "G43.1 Z1", "T1 M6", "G41.1 D2", "G28", "G28.1", "G92 X0",
                                  "G52 X1", "G38.3 X25", "G5.1 X25 Y1 I2 J2", "G81 X25 Z-1 R1", "G33 Z-5 K1",
                                  "M66 P0 L0", "G10 L2 P1 X1", "G68 X0 Y0 R30", "G51 X0 Y0 P2"}) {
    const std::string found = between(block);
    EXPECT_NE(found.find("cutter-compensation"), std::string::npos) << block << ": " << found;
  }
  for (const char* const block : {"G61", "G98", "M48", "M62 P0"}) {
    EXPECT_EQ(between(block), "") << block;
    EXPECT_EQ(between(block, Dialect::linuxcnc), refused) << block;
  }
  for (const char* const block : {"G17", "G20", "G91", "M0", "G4 P1", "F100", "M8", "G10 L2 P2 X1", "T1", "G95 S100"})
    EXPECT_EQ(between(block).find("cutter-compensation"), std::string::npos) << block;
}

TEST(CutterCompensation, JudgesTheTravelOfTheToolsMiddle) {
  EXPECT_EQ(problems("G41.1 D2\nG1 Y500 X0\nX10\nG40 Y0"), "4:1 travel; ");
  EXPECT_EQ(problems("G42.1 D4\nG1 Y501\nX10\nG40 Y0"), "");
  EXPECT_EQ(problems("G41.1 D2\nG1 Y10\nY501\nG40 Y0"), "4:1 travel; ");
}

// What waits is bounded.
TEST(CutterCompensation, DoesNotWaitForEver) {
  std::string text = "G41.1 D2\nG1 X10\n";
  for (int i = 0; i < 1001; ++i) text += i % 2 ? "Z1\n" : "Z0.5\n";
  EXPECT_EQ(problems(text + "X20\nG40 Y9"), "1003:1 cutter-compensation; ");
}

}  // namespace test_cutter_compensation
}  // namespace leadscrew::gcode
