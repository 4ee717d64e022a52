// Fanuc's lathes, G-code system A: where cycles lead is computed by hand.

#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_fanuc_lathes {

Conditions lathe() {
  return in_dialect(Dialect::fanuc_lathe);
}

double rounded(double value) {
  return std::round(value * 1e4) / 1e4 + 0.0;
}

// "r24,1 f10,0 a10,-5+ t9,-5@2 x": rapids, feeds, arcs and cuts in step with the spindle, to X (a radius) and Z, from the
// move `first` on.
std::string story(const Reading& reading, std::size_t first = 0) {
  std::ostringstream out;
  double lead = 0;
  for (const Move& move : reading.moves) {
    if (move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::spindle_in_step)
      lead = move.event.value;
    if (move.kind != Move::Kind::line && move.kind != Move::Kind::arc) continue;
    if (first > 0) {
      --first;
      continue;
    }
    const bool rapid = move.feed.mode == Feed::Mode::rapid;
    out << (lead > 0                       ? 't'
            : rapid                        ? 'r'
            : move.kind == Move::Kind::arc ? 'a'
                                           : 'f')
        << rounded(at(move.end, base::Axis::X)) << ',' << rounded(at(move.end, base::Axis::Z));
    if (move.kind == Move::Kind::arc) out << (move.turns > 0 ? '+' : '-');
    if (lead > 0) out << '@' << rounded(lead);
    out << ' ';
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

std::string story(const std::string& text, std::size_t first = 0) {
  return story(read_well(text, lathe()), first);
}

std::string problems(const std::string& text) {
  return read(text, lathe()).problems();
}

const std::string head = "G97 S600 M3\n";

TEST(LathesOfFanuc, ProgramDiametersAndRevolutions) {
  const Reading reading =
      read_well(head + "G0 X20. Z2.\nG1 X16. Z-4. F0.2\nG98 G1 Z-8. F120.\nG99 G1 Z-9. F0.1\nM30\n", lathe());
  EXPECT_EQ(story(reading), "r10,2 f8,-4 f8,-8 f8,-9");
  const std::vector<Move> lines = reading.lines();
  EXPECT_NEAR(lines[1].feed.value, 0.2 * 600 / 60, 1e-12);
  EXPECT_NEAR(lines[2].feed.value, 2, 1e-12);
  EXPECT_NEAR(lines[3].feed.value, 1, 1e-12);
}

TEST(LathesOfFanuc, HaveDistancesAlongXAndZ) {
  EXPECT_EQ(story(head + "G0 X20. Z2.\nU-4. W-1.\nG1 U-2. F0.2\nX10. W-3.\nG3 U4. W-2. R2.\nM30\n"),
            "r10,2 r8,1 f7,1 f5,-2 a7,-4+");
  EXPECT_EQ(story(head + "G0 X20. Z2.\nG28 U0 W0\nM30\n"), "r10,2 r0,0");
  EXPECT_EQ(story(head + "G0 X20. Z2.\nG4 U1.\nM30\n"), "r10,2");
}

TEST(LathesOfFanuc, ArcsAreOfZAndX) {
  EXPECT_EQ(story(head + "G0 X0 Z0\nG3 X20. Z-10. I0 K-10. F0.1\nG2 X30. Z-15. R5.\nM30\n"), "a10,-10+ a15,-15-");
}

TEST(LathesOfFanuc, ShiftCoordinatesByG50) {
  EXPECT_EQ(story("G50 X200. Z100.\nG0 X100. Z50.\nM30\n"), "r-50,-50");
  const Reading reading = read_well("G50 S1000\nG96 S300 M3\nG0 X10. Z1.\nM30\n", lathe());
  EXPECT_EQ(reading.events().back().value, 0);
  double fastest = 0;
  for (const base::Event& event : reading.events()) {
    if (event.kind == base::Event::Kind::spindle_speed) fastest = std::max(fastest, event.value);
  }
  EXPECT_EQ(fastest, 1000);
}

TEST(LathesOfFanuc, ChangeToolsAndOffsetsByT) {
  Conditions conditions = lathe();
  machine::Tool tool;
  tool.number = 7;
  tool.offset[base::index(base::Axis::X)] = 3;
  tool.offset[base::index(base::Axis::Z)] = 40;
  conditions.tools = machine::ToolTable({tool});
  const Reading reading = read_well("G0 X20. Z1.\nT0207\nX20. Z1.\nT0200\nX20. Z1.\nM30\n", conditions);
  EXPECT_EQ(story(reading), "r10,1 r13,41 r10,1");
  std::vector<double> changes;
  for (const base::Event& event : reading.events()) {
    if (base::changes_tool(event.kind)) changes.push_back(event.value);
  }
  EXPECT_EQ(changes, std::vector<double>{2});
  EXPECT_EQ(read("T0205\nM30\n", conditions).problems(), "1:1 unknown-tool; ");
  EXPECT_EQ(problems("T0101\nT0202\nM30\n"), "1:1 no-tool-table; ");
  EXPECT_EQ(problems("T-1\nM30\n"), "1:1 bad-value; ");
}

TEST(TurningCycle, CutsAndComesBack) {
  EXPECT_EQ(story(head + "G0 X50. Z2.\nG90 X46. Z-30. F0.2\nX42.\nU-16. W-12.\nG0 X60.\nM30\n", 1),
            "r23,2 f23,-30 f25,-30 r25,2 r21,2 f21,-30 f25,-30 r25,2 r17,2 f17,-10 f25,-10 r25,2 r30,2");
}

TEST(TurningCycle, CutsCones) {
  EXPECT_EQ(story(head + "G0 X50. Z2.\nG90 X40. Z-30. R-4. F0.2\nX36.\nM30\n", 1),
            "r16,2 f20,-30 f25,-30 r25,2 r14,2 f18,-30 f25,-30 r25,2");
}

TEST(FacingCycle, CutsAndComesBack) {
  EXPECT_EQ(story(head + "G0 X50. Z2.\nG94 X20. Z-1. F0.2\nZ-2. R-3.\nM30\n", 1),
            "r25,-1 f10,-1 f10,2 r25,2 r25,-5 f10,-2 f10,2 r25,2");
}

TEST(ThreadingCycle, CutsInStep) {
  EXPECT_EQ(story(head + "G0 X24. Z4.\nG92 X19. Z-20. F2.\nX18.\nM30\n", 1),
            "r9.5,4 t9.5,-20@2 r12,-20 r12,4 r9,4 t9,-20@2 r12,-20 r12,4");
  // On a cone of 3 in 24 the lead is that along Z.
  EXPECT_EQ(story(head + "G0 X40. Z4.\nG92 X30. Z-20. R-3. F2.\nM30\n", 1),
            "r12,4 t15,-20@" + text(rounded(2 * std::hypot(1, 3.0 / 24))) + " r20,-20 r20,4");
}

TEST(Threading, GoesOnAtItsLead) {
  EXPECT_EQ(story(head + "G0 X20. Z2.\nG32 Z-10. F1.5\nX22. Z-12.\nM30\n", 1),
            "t10,-10@1.5 t11,-12@" + text(rounded(1.5 * std::hypot(2, 1) / 2)));
}

const std::string step = "N10 G0 X20.\nG1 Z-10. F0.1\nX28.\nZ-20. F0.2\nN40 X40.\n";

// Levels of 4 mm count from C, 0.3 above and 0.1 before the start; the last is the contour's.
TEST(StockRemoval, CutsAlongZ) {
  EXPECT_EQ(story(head + "G0 X40. Z2.\nG71 U4. R1.\nG71 P10 Q40 U0.6 W0.1 F0.25\n" + step + "G0 X60.\nM30\n", 1),
            "r20.3,2.1 r16.3,2.1 f16.3,-19.9 r17.3,-18.9 r17.3,2.1 "
            "r12.3,2.1 f12.3,-9.9 r13.3,-8.9 r13.3,2.1 "
            "r10.3,2.1 f10.3,-9.9 f14.3,-9.9 f14.3,-19.9 f20.3,-19.9 r20,2 r30,2");
}

// The depth of a cut is a length, whatever unit holds when the cycle comes.
TEST(StockRemoval, TakesTheDepthInTheUnitOfItsBlock) {
  const std::string cycle = "G71 P10 Q40 U0 F0.25\n" + step + "G0 X60.\nM30\n";
  const auto first_cut = [&](const std::string& depth) {
    return story(head + "G0 X40. Z2.\n" + depth + cycle, 1).substr(0, 8);
  };
  EXPECT_EQ(first_cut("G20 G71 U0.1 R0.01\nG21\n"), first_cut("G71 U2.54 R0.254\n"));
  EXPECT_NE(first_cut("G71 U0.1 R0.01\n"), first_cut("G71 U2.54 R0.254\n"));
}

TEST(StockRemoval, CutsAlongX) {
  EXPECT_EQ(
      story(
          head +
              "G0 X40. Z2.\nG72 W4. R1.\nG72 P10 Q30 U0.4 W0.1 F0.25\nN10 G0 Z-10.\nG1 X30.\nX20. Z-5.\nN30 Z2.\nM30\n",
          1),
      "r20.2,2.1 r20.2,-1.9 f10.2,-1.9 r11.2,-0.9 r20.2,-0.9 "
      "r20.2,-5.9 f11.2,-5.9 r12.2,-4.9 r20.2,-4.9 "
      "r20.2,-9.9 f15.2,-9.9 f10.2,-4.9 f10.2,2.1 r20,2");
}

// From the inside outwards, with an allowance inwards.
TEST(StockRemoval, CutsBores) {
  EXPECT_EQ(
      story(
          head + "G0 X20. Z2.\nG71 U4. R0.5\nG71 P10 Q30 U-0.4 W0 F0.25\nN10 G0 X36.\nG1 Z-10.\nX28.\nN30 Z-20.\nM30\n",
          1),
      "r9.8,2 r13.8,2 f13.8,-10 r13.3,-9.5 r13.3,2 r17.8,2 f17.8,-10 f13.8,-10 f13.8,-20 f9.8,-20 r10,2");
}

TEST(StockRemoval, TakesPocketsWhereTheyAre) {
  EXPECT_EQ(story(head + "G0 X40. Z2.\nG71 U5. R0\nG71 P10 Q50 U0 W0 F0.25\nN10 G0 X30. Z2.\nG1 Z-5.\nX24.\nZ-10.\nN50 "
                         "X40.\nM30\n",
                  1),
            "r15,2 f15,-5 f15,-10 r15,-5 f12,-5 f12,-10 f20,-10 r20,2");
}

TEST(PatternRepeating, ComesNearer) {
  EXPECT_EQ(
      story(head + "G0 X40. Z2.\nG73 U4. W2. R3\nG73 P10 Q20 U1. W0.5 F0.25\nN10 G0 X20. Z0\nG1 Z-10.\nN20 X40.\nM30\n",
            1),
      "r24.5,4.5 r14.5,2.5 f14.5,-7.5 f24.5,-7.5 "
      "r22.5,3.5 r12.5,1.5 f12.5,-8.5 f22.5,-8.5 "
      "r20.5,2.5 r10.5,0.5 f10.5,-9.5 f20.5,-9.5 r20,2");
}

// In a bore with a pocket both of its walls are moved alike: by W0.12 one is left, and one is cut so deep into.
TEST(PatternRepeating, MovesTheContourAsAWhole) {
  const auto bore = [](const std::string& left, const std::string& farthest) {
    return story(head + "G0 X20. Z2.\nG73 " + farthest + " R2\nG73 P10 Q20 " + left +
                     " F0.25\nN10 G0 X40.\nG1 Z-10. F0.1\n" + "X46. Z-10.1\nZ-20.\nX36. Z-24.\nN20 X22.\nM30\n",
                 1);
  };
  EXPECT_EQ(bore("U-0.2 W0.12", "U-1. W0"),
            "r8.9,2.12 r18.9,2.12 f18.9,-9.88 f21.9,-9.98 f21.9,-19.88 f16.9,-23.88 f9.9,-23.88 "
            "r9.9,2.12 r19.9,2.12 f19.9,-9.88 f22.9,-9.98 f22.9,-19.88 f17.9,-23.88 f10.9,-23.88 r10,2");
  EXPECT_EQ(bore("U-0.2", "U-1. W-0.5"),
            "r8.9,1.5 r18.9,1.5 f18.9,-10.5 f21.9,-10.6 f21.9,-20.5 f16.9,-24.5 f9.9,-24.5 "
            "r9.9,2 r19.9,2 f19.9,-10 f22.9,-10.1 f22.9,-20 f17.9,-24 f10.9,-24 r10,2");
}

TEST(Finishing, GoesAlongTheContourAtItsFeeds) {
  const Reading reading = read_well(head + "G0 X40. Z2.\nG70 P10 Q40\nG0 X60.\nM30\n" + step, lathe());
  EXPECT_EQ(story(reading, 1), "r10,2 f10,-10 f14,-10 f14,-20 f20,-20 r20,2 r30,2");
  EXPECT_NEAR(reading.lines()[2].feed.value, 0.1 * 600 / 60, 1e-12);
  EXPECT_NEAR(reading.lines()[4].feed.value, 0.2 * 600 / 60, 1e-12);
}

// The same contour is roughed where it stands and finished from behind it.
TEST(Finishing, LooksBack) {
  const std::string roughed = head + "G0 X40. Z2.\nG71 U10. R0\nG71 P10 Q40 U0 W0 F0.25\n" + step;
  EXPECT_EQ(story(roughed + "G70 P10 Q40\nG0 X60.\nM30\n", 1),
            story(roughed + "M30\n", 1) + " r10,2 f10,-10 f14,-10 f14,-20 f20,-20 r20,2 r30,2");
}

TEST(Finishing, HasArcsAndCorners) {
  EXPECT_EQ(story(head + "G0 X40. Z2.\nG70 P1 Q5\nM30\nN1 G0 X10. Z0\nG1 Z-10. R2. F0.1\nX30. C1.\nG1 W-5.\nG2 U4. "
                         "W-2. R2.\nN5 G1 X40.\n",
                  1),
            "r5,0 f5,-8 a7,-10- f14,-10 f15,-11 f15,-15 a17,-17- f20,-17 r20,2");
}

// Feeds of a revolution follow the spindle, and that follows X.
TEST(Finishing, FollowsTheSpindle) {
  const Reading reading = read_well("G96 S120 M3\nG0 X60. Z2.\nG70 P10 Q40\nM30\n" + step, lathe());
  double speed = 0;
  int checked = 0;
  for (const Move& move : reading.moves) {
    if (move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::spindle_speed) speed = move.event.value;
    if (move.kind != Move::Kind::line || move.feed.mode == Feed::Mode::rapid) continue;
    const double radius = at(move.start, base::Axis::X);
    EXPECT_NEAR(speed, 120'000 / (2 * M_PI * radius), 1e-6);
    EXPECT_NEAR(move.feed.value, (checked < 2 ? 0.1 : 0.2) * speed / 60, 1e-9);
    ++checked;
  }
  EXPECT_EQ(checked, 4);
}

TEST(ThreadOfTwoBlocks, CutsByEqualAreas) {
  // Depths 0.5·√n to 0.9, then twice 1; the tip's 0 degrees go straight in.
  const std::string text = head + "G0 X24. Z5.\nG76 P020000 Q50 R0.1\nG76 X18. Z-14. P1000 Q500 F2.\nM30\n";
  std::ostringstream expected;
  for (const double depth : {0.5, 0.5 * std::sqrt(2), 0.5 * std::sqrt(3), 0.9, 1.0, 1.0}) {
    const double x = rounded(10 - depth);
    expected << "r" << x << ",5 t" << x << ",-14@2 r12,-14 r12,5 ";
  }
  EXPECT_EQ(story(text, 1) + " ", expected.str());
}

TEST(ThreadOfTwoBlocks, CutsNoLessThanQ) {
  const std::string text = head + "G0 X24. Z5.\nG76 P010000 Q300 R0\nG76 X18. Z-14. P1000 Q500 F2.\nM30\n";
  std::ostringstream expected;
  for (const double depth : {0.5, 0.8, 1.0, 1.0}) {
    const double x = rounded(10 - depth);
    expected << "r" << x << ",5 t" << x << ",-14@2 r12,-14 r12,5 ";
  }
  EXPECT_EQ(story(text, 1) + " ", expected.str());
}

TEST(ThreadOfTwoBlocks, GoesInAlongTheFlankAndOutByAChamfer) {
  // One cut of 1 mm at half of 60 degrees, and a chamfer of half the lead.
  const std::string text = head + "G0 X24. Z5.\nG76 P010560 Q0 R1.\nG76 X18. Z-14. P1000 Q1000 F2.\nM30\n";
  EXPECT_EQ(story(text, 1), "r9," + gcode::text(rounded(5 - std::tan(M_PI / 6))) + " t9,-13@2 t10,-14@" +
                                gcode::text(rounded(2 * std::sqrt(2))) + " r12,-14 r12,5");
}

TEST(ThreadOfTwoBlocks, CutsInsideAndOnCones) {
  EXPECT_EQ(story(head + "G0 X14. Z5.\nG76 P010000 Q0 R1.\nG76 X18. Z-15. P1000 Q1000 F2.\nM30\n", 1),
            "r9,5 t9,-15@2 r7,-15 r7,5");
  EXPECT_EQ(story(head + "G0 X24. Z5.\nG76 P010000 Q0 R1.\nG76 X18. Z-15. R-1. P1000 Q1000 F2.\nM30\n", 1),
            "r8,5 t9,-15@" + text(rounded(2 * std::hypot(1, 1.0 / 20))) + " r12,-15 r12,5");
}

TEST(CyclesOfLathes, AreRefusedWhereTheyCannotBeCut) {
  const auto roughing = [](const std::string& cycle, const std::string& contour = step) {
    return problems(head + "G0 X40. Z2.\n" + cycle + "\n" + contour + "M30\n");
  };
  EXPECT_EQ(roughing("G71 P10 Q40 F0.2"), "");
  EXPECT_EQ(roughing("G71 P10 F0.2"), "3:1 missing-word; ");
  EXPECT_EQ(roughing("G71 P10 Q41 F0.2"), "3:9 missing-label; ");
  EXPECT_EQ(roughing("G71 P40 Q10 F0.2"), "3:9 bad-contour; ");
  EXPECT_EQ(roughing("G71 P10 Q40 R1. F0.2"), "3:13 unused-word; ");
  EXPECT_EQ(roughing("G71 P10 Q40"), "3:1 missing-feed; ");
  EXPECT_EQ(roughing("G71 P10 Q40 X1. F0.2"), "3:13 unused-word; ");
  EXPECT_EQ(roughing("G71 P10 Q40 I1. F0.2"), "3:13 unused-word; ");
  EXPECT_EQ(roughing("G71 U0"), "3:5 bad-value; ");
  EXPECT_EQ(roughing("G71 U1. R-1."), "3:9 bad-value; ");
  EXPECT_EQ(roughing("G71 W1."), "3:5 unused-word; ");
  EXPECT_EQ(roughing("G73 U1. R0"), "3:9 bad-value; ");
  EXPECT_EQ(roughing("G17 G71 P10 Q40 F0.2"), "3:5 bad-plane; ");
  EXPECT_EQ(roughing("G71 U0.0001 R0\nG71 P10 Q40 F0.2"), "4:1 too-many-passes; ");
  EXPECT_EQ(roughing("G71 P10 Q40 F0.2", "N10 G0 X20.\nG1 Z-10.\nX28. Z-5.\nZ-20.\nN40 X40.\n"), "3:1 bad-contour; ");
  EXPECT_EQ(roughing("G71 P10 Q40 F0.2", "N10 G0 X20.\nG1 Z-600.\nN40 X40.\n"), "3:1 travel; ");
  EXPECT_EQ(roughing("G70 P10 Q40 F0.2", "M30\nN10 G0 X20.\nG1 Z-10.\nGOTO 50\nN40 X40.\nN50 Z-30.\n"),
            "10:1 bad-contour; 5:1 unmatched-o-word; ");
  const auto thread = [](const std::string& blocks) { return problems(head + "G0 X24. Z5.\n" + blocks + "\nM30\n"); };
  EXPECT_EQ(thread("G76 X18. Z-14. P1000 F2."), "3:1 missing-word; ");
  EXPECT_EQ(thread("G76 X18. Z-14. P1000 Q0 F2."), "3:22 bad-value; ");
  EXPECT_EQ(thread("G76 X18. Z5. P1000 Q100 F2."), "3:10 bad-value; ");
  EXPECT_EQ(thread("G76 X18. Z-14. P4000 Q100 F2."), "3:16 bad-value; ");
  EXPECT_EQ(thread("G76 P1 Q100"), "3:5 bad-value; ");
  EXPECT_EQ(thread("G76 P019900\nG76 X18. Z3. P1000 Q100 F2."), "4:1 bad-value; ");
  EXPECT_EQ(thread("G76 X18. Z-14. P1000 Q1 F2."), "3:1 too-many-passes; ");
  EXPECT_EQ(thread("M5\nG76 X18. Z-14. P1000 Q100 F2."), "4:1 spindle-stands; ");
  EXPECT_EQ(thread("S60000\nG92 X18. Z-14. F2."), "4:1 thread-too-fast; ");
  EXPECT_EQ(thread("G90 X18. Z-14. Y2. F0.2"), "3:16 unused-word; ");
}

// A cycle whose contour stands before it goes on behind itself, and not round and round.
TEST(CyclesOfLathes, GoOnBehindTheirBlock) {
  EXPECT_EQ(story(head + "G0 X60. Z2.\nGOTO 50\n" + step + "N50 G71 P10 Q40 U0 W0 F0.2\nG0 X70.\nM30\n").substr(0, 5),
            "r30,2");
}

// What stands between a cycle and its contour is passed over, which is told; but a contour behind the program's end is none
// to go on behind.
TEST(CyclesOfLathes, TellWhatTheyPassOver) {
  const std::string cycle = head + "G0 X60. Z2.\nG71 U2. R1.\nG71 P10 Q40 U0.4 W0.1 F0.2\n";
  EXPECT_EQ(problems(cycle + "(the contour)\n\n" + step + "G70 P10 Q40\nM30\n"), "");
  EXPECT_EQ(problems(cycle + "G0 X70.\n" + step + "M30\n"), "4:1 passed-over; ");
  const std::string last = "G70 P10 Q40\nM30\n";
  EXPECT_EQ(problems(cycle + last + step), "");
  EXPECT_EQ(story(cycle + last + step), story(cycle + step + last));
}

// The moves of a roughing cycle stay off the contour.
RC_GTEST_PROP(StockRemoval, NeverCutsIntoTheContour, ()) {
  std::vector<Point> contour = {{10, 0, 2}};
  std::string blocks = "N10 G0 X20.\nG1 Z0\n";
  contour.push_back({10, 0, 0});
  const int pieces = *rc::gen::inRange(2, 9);
  for (int i = 0; i < pieces; ++i) {
    const double up = i + 1 < pieces ? *rc::gen::inRange(-3000, 5000) / 1000.0 : 30;
    const double along = *rc::gen::inRange(100, 6000) / 1000.0;
    contour.push_back({std::max(1.0, contour.back().x + up), 0, contour.back().z - along});
    blocks +=
        (i + 1 == pieces ? "N90 " : "") + ("X" + text(2 * contour.back().x)) + " Z" + text(contour.back().z) + "\n";
  }
  double top = 0;
  for (const Point& point : contour) top = std::max(top, point.x);
  const double depth = *rc::gen::inRange(200, 3000) / 1000.0;
  const Reading reading = read(head + "G0 X" + text(2 * top) + " Z2.\nG71 U" + text(depth) +
                                   " R0.3\nG71 P10 Q90 U0 W0 F0.2\n" + blocks + "M30\n",
                               lathe());
  RC_ASSERT(reading.problems().empty());
  const auto height = [&](double z) {
    double found = -1e9;
    for (std::size_t i = 1; i < contour.size(); ++i) {
      const Point &a = contour[i - 1], &b = contour[i];
      if (z > a.z || z < b.z) continue;
      found = std::max(found, a.x + (b.x - a.x) * (a.z - z) / (a.z - b.z));
    }
    return found;
  };
  std::vector<Move> lines = reading.lines();
  lines.erase(lines.begin());
  RC_ASSERT(lines.size() > 3);
  for (const Move& move : lines) {
    for (int k = 0; k <= 20; ++k) {
      const auto between = [&](base::Axis axis) {
        return at(move.start, axis) + k / 20.0 * (at(move.end, axis) - at(move.start, axis));
      };
      RC_ASSERT(between(base::Axis::X) > height(between(base::Axis::Z)) - 1e-5);
    }
  }
}

}  // namespace test_fanuc_lathes
}  // namespace leadscrew::gcode
