// Compensation for the nose of a lathe's tool along the contours of G70 (Fanuc's lathes). Where it leads is computed by hand:
// the nose, of radius 0.4, touches the contour, and the place that is programmed is 0.4 below and 0.4 left of its middle.

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_nose_compensation {

Conditions lathe(double diameter = 0.8) {
  Conditions conditions = in_dialect(Dialect::fanuc_lathe);
  machine::Tool tool;
  tool.number = 4;
  tool.diameter = diameter;
  tool.orientation = 2;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

// "r24.6,4.2 f10,-10 a…": X (a radius) and Z of the ends of rapids, feeds and arcs.
std::string way(const Reading& reading) {
  std::ostringstream out;
  const auto round = [](double value) { return std::round(value * 1e4) / 1e4 + 0.0; };
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::line && move.kind != Move::Kind::arc) continue;
    out << (move.feed.mode == Feed::Mode::rapid ? 'r'
            : move.kind == Move::Kind::arc      ? 'a'
                                                : 'f')
        << round(at(move.end, base::Axis::X)) << ',' << round(at(move.end, base::Axis::Z)) << ' ';
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

const std::string head = "T0404\nG97 S600 M3\n";

std::string way(const std::string& text) {
  return way(read_well(head + text, lathe()));
}

Reading read_lathe(const std::string& text, double diameter = 0.8) {
  return read(head + text, lathe(diameter));
}

std::string problems(const std::string& text) {
  return read_lathe(text).problems();
}

std::string first_hint(const std::string& text) {
  const Reading reading = read_lathe(text);
  return reading.diagnostics.empty() ? "" : reading.diagnostics.front().hint;
}

// From X20 along a taper of 1 in 2 to X40; the blocks P and Q hold what is given.
std::string taper(const std::string& first = "", const std::string& last = "") {
  return "N10 G0 " + first + " X20.\nG1 Z-10. F0.1\nX30. Z-20. F0.2\nN40 " + last + " G1 X40.\n";
}

// The nose touches X10 and the taper at once 0.3056 behind the corner, the taper and Z-20 at X14.8472.
const std::string along_taper = "f10,-10.3056 f14.8472,-20 ";
// Where G40 stands behind it the nose goes on until it touches the taper's end.
const std::string along_free_taper = "f10,-10.3056 f14.9578,-20.2211 ";

TEST(NoseCompensation, IsOnBeforeG70) {
  const std::string before = "G0 X70. Z5.\nG42 G0 X50.\n", behind = "G40 G0 X100. Z50.\nM30\n";
  EXPECT_EQ(way(before + "G70 P10 Q40\n" + behind + taper()),
            "r35,5 r24.6,4.2 r10,4.2 " + along_taper + "f19.2721,-20 r24.2078,4.6784 r50,50");
  EXPECT_EQ(way(before + "G70 P10 Q40\n" + behind + taper()), way(before + taper() + "G0 X50. Z5.\n" + behind));
}

// The first move of the contour is then that by which the tool comes to it.
TEST(NoseCompensation, IsSwitchedOnInTheBlockOfG70) {
  EXPECT_EQ(way("G0 X50. Z5.\nG42 G70 P10 Q40\nG40 G0 X100. Z50.\nM30\n" + taper()),
            "r25,5 r10,4.2 " + along_taper + "f19.2721,-20 r24.2078,4.6784 r50,50");
}

TEST(NoseCompensation, HoldsInTheContour) {
  const std::string before = "G0 X50. Z5.\n", behind = "G0 X80.\nM30\n";
  const std::string finished = "r25,5 r10,4.2 " + along_free_taper + "f20,-20 r25,5 r40,5";
  EXPECT_EQ(way(before + "G70 P10 Q40\n" + behind + taper("G42", "G40")), finished);
  EXPECT_EQ(way(before + taper("G42", "G40") + "G0 X50. Z5.\n" + behind), finished);
}

TEST(NoseCompensation, EndsBeforeTheWayBack) {
  const std::string finished = "r25,5 r10,4.2 " + along_taper + "f19.6,-20 r25,5 r40,5";
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q40\nG0 X80.\nM30\n" + taper("G42")), finished);
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q50\nG0 X80.\nM30\n" + taper("G42") + "N50 G40\n"), finished);
}

// Where the contour ends at its start there is no way back: the next line leads off it.
TEST(NoseCompensation, EndsBehindTheContour) {
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q20\nG0 X80.\nM30\nN10 G0 G42 X20.\nG1 Z-10. F0.1\nX50.\nN20 G0 Z5.\n"),
            "r25,5 r10,4.2 f10,-10 f24.2,-10 r24.2,4.6 r40,5");
}

// G40 of the last block ends what was on before the cycle.
TEST(NoseCompensation, EndsInTheContour) {
  EXPECT_EQ(way("G0 X70. Z5.\nG42 G0 X50.\nG70 P10 Q40\nG0 X80.\nM30\n" + taper("", "G40")),
            "r35,5 r24.6,4.2 r10,4.2 " + along_free_taper + "f20,-20 r25,5 r40,5");
}

// The corner where the contour begins is gone round: the contour's G40 is none of the block that is read behind it.
TEST(NoseCompensation, GoesRoundTheCornerToTheContour) {
  const std::string before = "G0 X50. Z25.\nG42 G0 Z5.\n", behind = "G0 X80.\nM30\n";
  const std::string finished = way(before + "G70 P10 Q40\n" + behind + taper("", "G40"));
  EXPECT_EQ(finished, way(before + taper("", "G40") + "G0 X50. Z5.\n" + behind));
  EXPECT_EQ(finished.substr(0, 29), "r25,25 r25,4.6 r24.6,4.2 r10,");
}

// A fillet is of the block that it stands in: an arc about X18 Z-18 that is 0.4 smaller.
TEST(NoseCompensation, EndsBehindTheCornerBeforeTheLastBlock) {
  const std::string blocks = "N10 G0 G42 X20.\nG1 Z-20. R2. F0.1\nN40 G40 X40.\n";
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q40\nM30\n" + blocks), "r25,5 r10,4.2 f10,-18.4 a11.6,-20 f20,-20 r25,5");
}

TEST(NoseCompensation, MayBeginInABlockWithoutMotion) {
  const std::string blocks = "N5 G42\n" + taper();
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P5 Q40\nM30\n" + blocks), way("G0 X50. Z5.\nG70 P10 Q40\nM30\n" + taper("G42")));
}

TEST(NoseCompensation, ComesWithEachCycle) {
  const std::string once = way("G0 X50. Z5.\nG70 P10 Q40\nM30\n" + taper("G42", "G40"));
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q40\nG70 P10 Q40\nM30\n" + taper("G42", "G40")), once + once.substr(5));
}

// Feeds are those of the blocks, and S of G96 follows X.
TEST(NoseCompensation, KeepsFeeds) {
  const Reading reading = read_lathe("G0 X50. Z5.\nG70 P10 Q40\nM30\n" + taper("G42", "G40"));
  const std::vector<Move> lines = reading.lines();
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_NEAR(lines[2].feed.value, 1, 1e-12);
  EXPECT_NEAR(lines[3].feed.value, 2, 1e-12);
  EXPECT_EQ(way(read_well("T0404\nG96 S120 M3\nG0 X50. Z5.\nG70 P10 Q40\nM30\n" + taper("G42", "G40"), lathe())),
            way(reading));
}

TEST(NoseCompensation, IsNoneOfRoughing) {
  for (const std::string cycle : {"G71 U2. R1.\nG71", "G72 W2. R1.\nG72", "G73 U4. W1. R3\nG73"}) {
    const std::string before = "G0 X50. Z5.\n" + cycle + " P10 Q40 U0.4 W0.1 F0.2\n";
    EXPECT_EQ(way(before + taper("G42", "G40") + "M30\n"), way(before + taper() + "M30\n"));
    const std::string refused = "G42 G0 X60.\nZ4.\n" + before + "M30\n" + taper();
    EXPECT_EQ(problems(refused), "6:1 cutter-compensation; 7:1 cutter-compensation; ") << cycle;
    EXPECT_EQ(first_hint(refused), "G40 in a block before it; G42 in the first block of the contour holds for G70");
  }
}

TEST(NoseCompensation, IsRefusedWhereItDoesNotBelong) {
  const auto finished = [](const std::string& contour, const std::string& before = "") {
    return "G0 X50. Z5.\n" + before + "G70 P10 Q40\nG42 G0 X60.\nG40 X70.\nM30\n" + contour;
  };
  const std::string later = "N10 G0 X20.\nG1 G42 Z-10. F0.1\nN40 X40.\n";
  EXPECT_EQ(problems(finished(later)), "9:4 bad-contour; ");
  EXPECT_EQ(first_hint(finished(later)), "G42 in the first block of the contour, or before G70");
  const std::string twice = "N10 G0 G42 X20.\nG1 G41 Z-10. F0.1\nN40 X40.\n";
  EXPECT_EQ(problems(finished(twice)), "9:4 bad-contour; ");
  const std::string early = "N10 G0 G42 X20.\nG40 G1 Z-10. F0.1\nN40 X40.\n";
  EXPECT_EQ(problems(finished(early)), "9:1 bad-contour; ");
  EXPECT_EQ(first_hint(finished(early)), "G40 in the last block of the contour, or behind G70");
  EXPECT_EQ(problems(finished("N10 G0 G40 X20.\nG1 Z-10. F0.1\nN40 X40.\n")), "");
  EXPECT_EQ(problems("G0 X70. Z5.\nG42 X50.\nG70 P10 Q40\nG40 G0 X60.\nM30\n" + taper("G42")),
            "8:8 cutter-compensation; ");
}

// What does not fit is told where the contour has it; behind the cycle compensation is off all the same.
TEST(NoseCompensation, TellsWhichBlocksItDoesNotFit) {
  const std::string groove = "N10 G0 G42 X30.\nG1 Z-10. F0.1\nX20.\nZ-13.\nX30.\nZ-20.\nN40 G40 X40.\n";
  const std::string text = "G0 X50. Z5.\nG70 P10 Q40\nG42 G0 X60.\nG40 X70.\nM30\n" + groove;
  EXPECT_EQ(problems(text), "");
  const Reading reading = read_lathe(text, 4);
  EXPECT_EQ(reading.problems(), "12:1 cutter-gouge; ");
  EXPECT_NE(reading.diagnostics.front().message.find("line 11 and that of line 12"), std::string::npos)
      << reading.diagnostics.front().message;
  EXPECT_EQ(problems("G0 X20.2 Z5.\nG70 P10 Q40\nM30\n" + taper("G42")), "6:5 cutter-entry; ");
}

// The nose touches the last face and the way back at once, radius · tan(a / 2) ahead of the face's end.
TEST(NoseCompensation, TellsWhereTheWayBackCutsTheLastPieceShort) {
  const auto finish = [](const std::string& start, const std::string& last) {
    return "G0 X70. Z5.\nG42 G0 " + start + "\nG70 P10 Q40\nG40 G0 X100. Z50.\nM30\nN10 G0 X20.\nG1 Z-10. F0.1\n" +
           "X30. Z-20. F0.2\nN40 G1 " + last + "\n";
  };
  const Reading reading = read_lathe(finish("X40.", "X50."));
  EXPECT_EQ(reading.problems(), "11:5 cutter-return; ");
  const double face_end = at(reading.lines()[5].end, base::Axis::X) + 0.4;
  EXPECT_NEAR(face_end, 25 - 0.4 * std::tan(std::atan2(25, -5) / 2), 1e-9);
  EXPECT_EQ(
      reading.diagnostics.front().message,
      "the nose leaves the contour 0.488 mm before its end: there the way back of G70 turns back on the side of the "
      "tool");
  EXPECT_EQ(reading.diagnostics.front().hint,
            "start the cycle at or above the last X of the contour, or G40 in its last block");
  EXPECT_EQ(problems(finish("X50.", "X50.")), "");
  EXPECT_EQ(problems(finish("X52.", "X50.")), "");
  EXPECT_EQ(problems(finish("X40.", "G40 X50.")), "");
  const std::string cylinder = finish("X40.", "Z-40.");
  EXPECT_EQ(problems(cylinder), "11:5 cutter-return; ");
  EXPECT_EQ(first_hint(cylinder), "G40 in the last block of the contour, or a last block that leads off the work");
  EXPECT_EQ(problems("G0 X40. Z5.\nG70 P10 Q40\nM30\n" + taper("G42")), "");
}

TEST(NoseCompensation, TellsTheSameOfBores) {
  const auto finish = [](const std::string& start) {
    return read("G10 P10007 R0.4 Q2\nT0707\nG97 S600 M3\nG0 X10. Z5.\nG41 G0 " + start +
                    "\nG70 P10 Q40\nG40 G0 Z50.\nM30\nN10 G0 X40.\nG1 Z-20. F0.1\nN40 G1 X20.\n",
                lathe());
  };
  const Reading reading = finish("X24.");
  EXPECT_EQ(reading.problems(), "11:5 cutter-return; ");
  EXPECT_EQ(reading.diagnostics.front().hint,
            "start the cycle at or below the last X of the contour, or G40 in its last block");
  EXPECT_EQ(finish("X20.").problems(), "");
  EXPECT_EQ(finish("X18.").problems(), "");
}

// A contour with an error is not gone along, and does not leave compensation on.
TEST(NoseCompensation, IsNoneOfContoursThatFail) {
  EXPECT_EQ(problems("G0 X50. Z5.\nG70 P10 Q40\nG42 G0 X60.\nG40 X70.\nM30\nN10 G0 G42 X20.\nG2 Z-10. R1. F0.1\n"
                     "N40 G1 X40.\n"),
            "9:1 arc-radius; ");
  EXPECT_EQ(way("G0 X50. Z5.\nG70 P10 Q10\nG0 X80.\nM30\nN10 G0 G42 X20.\n"), "r25,5 r40,5");
  Conditions mill = lathe();
  mill.tools = machine::ToolTable({machine::Tool{.number = 5}});
  EXPECT_EQ(read("T0505\nG97 S600 M3\nG0 X50. Z5.\nG70 P10 Q40\nG0 X80.\nM30\n" + taper("G42 D6"), mill).problems(),
            "7:12 unknown-tool; ");
}

// Travel is that of the place which follows the nose, and that of the program from where compensation ends.
TEST(NoseCompensation, StaysInTravel) {
  const auto to = [](const std::string& x, const std::string& last) {
    return problems("G0 X50. Z5.\nG70 P10 Q40\nG0 X80.\nM30\nN10 G0 G42 X20.\nG1 Z-10. F0.1\nN40 " + last + " X" + x +
                    "\n");
  };
  EXPECT_EQ(to("1000.5", ""), "");
  EXPECT_EQ(to("1000.5", "G40"), "4:1 travel; ");
  EXPECT_EQ(to("1001.", ""), "9:1 travel; ");
}

// In a corner of X20 and Z-20 the middle of the nose is 0.4 off both; the place that is programmed is off the middle by 0.4
// in the direction that Fanuc's number says.
TEST(ToolNoses, HaveFanucsNumbers) {
  constexpr int along_x[] = {0, 1, 1, -1, -1, 0, 1, 0, -1, 0}, along_z[] = {0, 1, -1, -1, 1, 1, 0, -1, 0, 0};
  for (int nose = 0; nose <= 9; ++nose) {
    const std::string set = "G10 L1 P4 R0.4 Q" + std::to_string(nose) + "\n";
    const std::vector<Move> lines =
        read_lathe("G0 X40. Z5.\n" + set + "G42 G0 X20.\nG1 Z-20. F0.1\nX40.\nG40 G0 X60.\nM30\n", 5).lines();
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_NEAR(at(lines[2].end, base::Axis::X), 10.4 + 0.4 * along_x[nose], 1e-9) << nose;
    EXPECT_NEAR(at(lines[2].end, base::Axis::Z), -19.6 + 0.4 * along_z[nose], 1e-9) << nose;
  }
}

TEST(ToolNoses, AreSetAsTheHintSays) {
  const Reading reading = read_lathe("G10 R0.4 Q3\nM30\n");
  EXPECT_EQ(reading.problems(), "3:1 missing-word; ");
  EXPECT_EQ(reading.diagnostics.front().message, "G10 lacks P");
  const std::string hint = reading.diagnostics.front().hint;
  const std::string tool = "G10 P10004 R0.4 Q3", wear = "G10 P4 X0.1", coordinates = "G10 L2 P1 X0 Z0";
  EXPECT_EQ(hint, tool + " for a tool, " + wear + " for its wear, " + coordinates + " for coordinates");
  EXPECT_EQ(problems(tool + "\n" + wear + "\n" + coordinates + "\nM30\n"), "");
}

// The last two digits of T say whose nose it is, and 00 none.
TEST(ToolNoses, AreThoseOfTheOffset) {
  Conditions conditions = lathe();
  conditions.tools = machine::ToolTable({machine::Tool{.number = 2, .diameter = 0.8, .orientation = 2},
                                         machine::Tool{.number = 7, .diameter = 1.6, .orientation = 2}});
  const auto end_of_taper = [&](const std::string& tool) {
    const std::vector<Move> lines =
        read_well(tool + "\n" + head.substr(6) + "G0 X50. Z5.\nG42 G0 X20.\nG1 Z-10. F0.1\nX30. Z-20.\nG40 X40.\nM30\n",
                  conditions)
            .lines();
    return at(lines[2].end, base::Axis::Z);
  };
  const double behind_corner = 3 - std::sqrt(5.0);  // of a nose of radius 1
  EXPECT_NEAR(end_of_taper("T0202"), -10 - 0.4 * behind_corner, 1e-9);
  EXPECT_NEAR(end_of_taper("T0207"), -10 - 0.8 * behind_corner, 1e-9);
  EXPECT_NEAR(end_of_taper("T0200"), -10, 1e-9);
}

}  // namespace test_nose_compensation
}  // namespace leadscrew::gcode
