// LinuxCNC's lathe cycles. Where roughing cuts end is derived from the contour by hand; what comes off the contour by
// the distance D is measured; the whole of some programs was seen of rs274 of LinuxCNC 2.9 to be the same (tests/peer).

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_lathe_cycles {

const std::string head = "G21 G90 G18 F100 S500 M3\n";

std::string sub(const std::string& blocks) {
  return "O100 sub\n" + blocks + "O100 endsub\n";
}

double x_of(const base::AxisVector& position) {
  return std::round(at(position, base::Axis::X) * 1e4) / 1e4 + 0.0;
}
double z_of(const base::AxisVector& position) {
  return std::round(at(position, base::Axis::Z) * 1e4) / 1e4 + 0.0;
}

// "r24,1 f10,0 a10,-5,1": rapids, feeds, and arcs with their direction, to X and Z, from the move `first` on.
std::string story(const Reading& reading, std::size_t first = 0) {
  std::ostringstream out;
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::line && move.kind != Move::Kind::arc) continue;
    if (first > 0) {
      --first;
      continue;
    }
    const bool arc = move.kind == Move::Kind::arc;
    out << (arc ? 'a' : move.feed.mode == Feed::Mode::rapid ? 'r' : 'f') << x_of(move.end) << ',' << z_of(move.end);
    if (arc) out << ',' << move.turns;
    out << ' ';
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

std::string story(const std::string& text, std::size_t first = 0) {
  return story(read_well(text), first);
}

// A step: from X10 to Z-10, up to X14.
const std::string step = sub("G1 X10 Z0\nZ-10\nX14\n");

TEST(LatheRoughing, CutsLevelByLevelAndThenAlongTheContour) {
  EXPECT_EQ(story(head + step + "G0 X14 Z2\nG71 Q100 I2 R0.5\nM2\n", 1),
            "f14,-10 r14.5,-9.5 r14.5,1.5 r14,2 "        // a cut at the start's level
            "r12,1 f12,-10 r12.5,-9.5 r12.5,0.5 r12,1 "  // on the way to the first point
            "r10,0 f10,-10 f14,-10");
}

// From beside a contour the tool first comes back to where the program stands.
TEST(LatheRoughing, BeginsWhereTheProgramStandsBehindG40) {
  const std::string aside = "G0 X20 Z9\nG42.1 D2\nG1 X14 Z8\nZ2\nG40\n";
  const std::string moves = story(head + step + aside + "G71 Q100 I2 R0.5\nM2\n");
  EXPECT_NE(moves.find(" f15,2 r14,2 f14,-10 r14.5,-9.5 "), std::string::npos) << moves;
}

TEST(LatheRoughing, ArcsEndCuts) {
  // A quarter of radius 4 about X14 Z-6: the cut at X12 ends where (X − 14)² + (Z + 6)² = 16.
  const std::string text = head + sub("G1 X10 Z0\nZ-6\nG2 X14 Z-10 I4\n") + "G0 X14 Z2\nG71 Q100 I2 R0\nM2\n";
  const double z = std::round((-6 - std::sqrt(16.0 - 4)) * 1e4) / 1e4;
  std::ostringstream expected;
  expected << "f14,-10 r14,2 r12,1 f12," << z << " r12,1 r10,0 f10,-6 a14,-10,-1";
  EXPECT_EQ(story(text, 1), expected.str());
}

// With the first point on the outside the same happens mirrored.
TEST(LatheRoughing, MirroredContoursAreCutAlike) {
  const auto mirrored = [](double mx, double mz) {
    const auto word = [](char letter, double value) { return letter + text(value) + " "; };
    const std::string contour = sub("G1 " + word('X', 100 + mx * 10) + word('Z', 0) + "\n" + word('Z', mz * -10) +
                                    "A1\n" + word('X', 100 + mx * 14) + word('Z', mz * -14) + "\n");
    return read_well(head + contour + "G0 " + word('X', 100 + mx * 16) + word('Z', mz * 2) +
                     "\nG71 Q100 I1.5 D0.3\nM2\n");
  };
  const Reading plain = mirrored(1, 1);
  ASSERT_GT(plain.lines().size(), 15);
  for (const auto& [mx, mz] : {std::pair{-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}) {
    const Reading other = mirrored(mx, mz);
    ASSERT_EQ(other.moves.size(), plain.moves.size());
    for (std::size_t i = 0; i < plain.moves.size(); ++i) {
      if (plain.moves[i].kind == Move::Kind::event) continue;
      EXPECT_NEAR(mx * (at(other.moves[i].end, base::Axis::X) - 100), at(plain.moves[i].end, base::Axis::X) - 100,
                  1e-9);
      EXPECT_NEAR(mz * at(other.moves[i].end, base::Axis::Z), at(plain.moves[i].end, base::Axis::Z), 1e-9);
      EXPECT_EQ(other.moves[i].turns, static_cast<int>(mx * mz) * plain.moves[i].turns);
    }
  }
}

// G72 does with X and Z what G71 does with Z and X.
TEST(LatheRoughing, FacesAlongX) {
  EXPECT_EQ(story(head + sub("G1 X20 Z-4\nX10\nZ0\n") + "G0 X22 Z0\nG72 Q100 I2 R0.5\nM2\n", 1),
            "f10,0 r10.5,0.5 r21.5,0.5 r22,0 r21,-2 f10,-2 r10.5,-1.5 r20.5,-1.5 r21,-2 r20,-4 f10,-4 f10,0");
}

const std::string pocket = sub("G1 X10 Z0\nZ-5\nX6 Z-7\nZ-9\nX12 Z-15\n");

TEST(LatheRoughing, TakesPocketsAsTheyCome) {
  EXPECT_EQ(story(head + pocket + "G0 X12 Z2\nG71 Q100 I2 R0\nM2\n", 1),
            "f12,-15 r12,2 r10,0 f10,-5 "  // the level X10 is the contour's own
            "f10,-13 r10,-5 f8,-6 f8,-11 r8,-6 f6,-7 f6,-9 f12,-15");
}

TEST(LatheRoughing, PassesOverPockets) {
  EXPECT_EQ(story(head + pocket + "G0 X12 Z2\nG71.1 Q100 I2 R0\nM2\n", 1),
            "f12,-15 r12,2 r10,0 f10,-5 f10,-13 f12,-15");
}

TEST(LatheRoughing, TakesPocketsOnly) {
  EXPECT_EQ(story(head + pocket + "G0 X12 Z2\nG71.2 Q100 I2 R0\nM2\n", 1),
            "r10,0 f10,-5 f10,-13 r10,-5 f8,-6 f8,-11 r8,-6 f6,-7 f6,-9 f12,-15");
}

// D is the distance of every point of the last way along the contour from the contour: lines, and arcs about corners.
TEST(LatheRoughing, LeavesTheDistance) {
  const std::vector<Move> lines =
      read_well(head + sub("G1 X10 Z0\nX12 Z-10\nX18 Z-12\n") + "G0 X20 Z2\nG71 Q100 I3 D0.4\nM2\n").lines();
  const Move& last_but_one = lines[lines.size() - 3];
  const auto off = [](const base::AxisVector& p, double x, double z, double dx, double dz) {
    return ((at(p, base::Axis::X) - x) * -dz + (at(p, base::Axis::Z) - z) * dx) / std::hypot(dx, dz);
  };
  EXPECT_NEAR(off(last_but_one.start, 10, 0, 2, -10), 0.4, 1e-9);
  EXPECT_NEAR(off(last_but_one.end, 10, 0, 2, -10), 0.4, 1e-9);
  EXPECT_NEAR(off(last_but_one.end, 12, -10, 6, -2), 0.4, 1e-9);
}

// An outer corner becomes an arc of radius D about it.
TEST(LatheRoughing, GoesRoundOuterCorners) {
  const std::vector<Move> arcs =
      read_well(head + sub("G1 X10 Z0\nX14\nZ-10\nX16\n") + "G0 X16 Z2\nG71 Q100 I3 D0.5\nM2\n").arcs();
  ASSERT_EQ(arcs.size(), 1);
  EXPECT_NEAR(arcs[0].center_second, 14, 1e-9);
  EXPECT_NEAR(arcs[0].center_first, 0, 1e-9);
  EXPECT_EQ(arcs[0].turns, 1);
}

// X of a contour of lines, which is its greatest where it goes straight up.
double height(const std::vector<Point>& contour, double z) {
  double found = -1e9;
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    const Point &a = contour[i], &b = contour[i + 1];
    if (z > a.z || z < b.z) continue;
    found = std::max(found, a.z == b.z ? std::max(a.x, b.x) : a.x + (b.x - a.x) * (a.z - z) / (a.z - b.z));
  }
  return found;
}

// Sampled moves stay above the contour, and the last ends where it does.
RC_GTEST_PROP(LatheRoughing, NeverCutsIntoTheContour, ()) {
  std::vector<Point> contour = {{10, 0, 0}};
  std::string blocks = "G1 X10 Z0\n";
  const int pieces = *rc::gen::inRange(2, 9);
  for (int i = 0; i < pieces; ++i) {
    // At last above the first point: that tells the outside from the inside.
    const double up = i + 1 < pieces ? *rc::gen::inRange(-3000, 5000) / 1000.0 : 30;
    const double along = *rc::gen::inRange(100, 6000) / 1000.0;
    contour.push_back({std::max(1.0, contour.back().x + up), 0, contour.back().z - along});
    blocks += "X" + text(contour.back().x) + " Z" + text(contour.back().z) + "\n";
  }
  double top = 0;
  for (const Point& point : contour) top = std::max(top, point.x);
  const double depth = *rc::gen::inRange(200, 3000) / 1000.0;
  const std::string method = *rc::gen::element<std::string>("G71", "G71.1", "G71.2");
  const Reading reading =
      read(head + sub(blocks) + "G0 X" + text(top + 1) + " Z1\n" + method + " Q100 I" + text(depth) + " R0.3\nM2\n");
  RC_ASSERT(reading.problems().empty());
  std::size_t feeds = 0;
  std::vector<Move> lines = reading.lines();
  lines.erase(lines.begin());  // to the start
  for (const Move& move : lines) {
    feeds += move.feed.mode != Feed::Mode::rapid;
    for (int k = 0; k <= 20; ++k) {
      const auto between = [&](base::Axis axis) {
        return at(move.start, axis) + k / 20.0 * (at(move.end, axis) - at(move.start, axis));
      };
      RC_ASSERT(between(base::Axis::X) > height(contour, between(base::Axis::Z)) - 1e-5);
    }
  }
  RC_ASSERT(feeds > 0);
  RC_ASSERT(std::fabs(at(lines.back().end, base::Axis::Z) - contour.back().z) < 1e-9);
}

TEST(LatheFinishing, ComesNearerPassByPass) {
  EXPECT_EQ(story(head + step + "G0 X16 Z2\nG70 Q100 D1 P2\nM2\n", 1),
            "r10.5,0 f10.5,-9.5 f14,-9.5 r16,2 r10,0 f10,-10 f14,-10");
}

// The tool stands where the contour's last side leads to, inside a bore: passes are inside as well.
TEST(LatheFinishing, StaysAtTheSideOfTheTool) {
  EXPECT_EQ(story(head + sub("G1 X21 Z0\nZ8\nX16\n") + "G0 X14 Z8\nG70 Q100 D1 P2\nM2\n", 1),
            "r21,8 r20.5,0 f20.5,7.5 f16,7.5 r21,8 r21,0 f21,8 f16,8");
}

// Fillets touch both sides; the chamfer has the same ends.
TEST(LatheFinishing, RoundsCorners) {
  EXPECT_EQ(story(head + sub("G1 X10 Z0\nZ-10 A2\nX20 A3\nZ-20\n") + "G0 X22 Z2\nG70 Q100\nM2\n", 1),
            "r10,0 f10,-8 a12,-10,-1 f17,-10 a20,-13,1 f20,-20");
  EXPECT_EQ(story(head + sub("G1 X10 Z0\nZ-10 C2\nX20 C3\nZ-20\n") + "G0 X22 Z2\nG70 Q100\nM2\n", 1),
            "r10,0 f10,-8 f12,-10 f17,-10 f20,-13 f20,-20");
}

TEST(LatheContours, AreWrittenInManyWays) {
  const std::string cycle = "G90 G0 X16 Z2\nG70 Q100\nM2\n";
  const std::string same = "r10,0 f10,-4 a12,-6,-1 f14,-10";
  for (const std::string blocks :
       {"G0 X10 Z0\nZ-4\nG2 X12 Z-6 I2\nG1 X14 Z-10\n", "X10 Z0\nW-4\nG2 U2 W-2 R2\nG1 U2 W-4\n",
        "#1=4\nG1 X10 Z0\nO1 if [#1 GT 3]\nZ-#1\nO1 endif\nG2 X12 Z-6 R2\nG1 X14 Z-10\n"}) {
    EXPECT_EQ(story(head + sub(blocks) + cycle, 1), same) << blocks;
  }
  EXPECT_EQ(story(head + "G90.1\n" + sub("X10 Z0\nZ-4\nG2 X12 Z-6 I12 K-4\nG1 X14 Z-10\n") + cycle, 1), same);
  EXPECT_EQ(story(head + sub("X-6 Z-2\nZ-4\nG2 X2 Z-2 I2\nG1 X2 Z-4\n") + "G0 X16 Z2\nG91 G70 Q100\nM2\n", 1), same);
  EXPECT_EQ(story(head + sub("X20 Z0\nZ-4\nG2 X24 Z-6 I2\nG1 U4 Z-10\n") + "G0 X16 Z2\nG7 G70 Q100\nM2\n", 1), same);
}

// The next block with axis words alone goes on as the cycle ended.
TEST(LatheContours, LeaveTheMotionOfTheirLastMove) {
  const std::vector<Move> lines = read_well(head + step + "G0 X16 Z2\nG70 Q100\nX30\nM2\n").lines();
  EXPECT_EQ(lines.back().feed.mode, Feed::Mode::units_per_second);
}

// Nothing but where they lead counts of their blocks.
TEST(LatheContours, TellWhatDoesNothingInThem) {
  const std::string blocks = "X10 Z0\nG42 Z-4\nG20 M8\nT1\nX14 Z-10 F30\n";
  EXPECT_EQ(read(head + sub(blocks) + "G0 X16 Z2\nG70 Q100\nM2\n").problems(),
            "4:1 bad-contour; 5:1 bad-contour; 5:5 bad-contour; 6:1 bad-contour; ");
}

TEST(LatheContours, AreRefusedWhereTheyCannotBeCut) {
  const auto problems = [](const std::string& blocks, const std::string& cycle = "G71 Q100 X20 Z2") {
    return read(head + sub(blocks) + cycle + "\nM2\n").problems();
  };
  const std::string sound = "X10 Z0\nZ-4\nX14\n";  // lines 2 to 6
  EXPECT_EQ(problems(sound), "");
  EXPECT_EQ(problems(sound, "G71 X20 Z2"), "7:1 missing-word; ");
  EXPECT_EQ(problems(sound, "G71 Q101"), "7:1 missing-sub; ");
  EXPECT_EQ(problems(sound, "G17 G71 Q100"), "7:5 bad-plane; ");
  EXPECT_EQ(problems(sound, "G71 Q100 I0"), "7:10 bad-value; ");
  EXPECT_EQ(problems(sound, "G71 Q100 R-1"), "7:10 bad-value; ");
  EXPECT_EQ(problems(sound, "G70 Q100 P0.5"), "7:10 bad-value; ");
  EXPECT_EQ(problems(sound, "G93 G71 Q100 F1"), "7:5 bad-feed-mode; ");
  EXPECT_EQ(problems(sound, "G71 Q100 X20 Z2 I0.000001"), "7:1 too-many-passes; ");
  EXPECT_EQ(problems(sound, "G10 L2 P1 R30\nG71 Q100 X20 Z2"), "8:1 unsupported-rotation; ");
  EXPECT_EQ(problems("X10 Z0\nZ-4\nX14 Z-2\nZ-8\n"), "8:1 bad-contour; ");
  EXPECT_EQ(problems("X10 Z0\nG33 Z-4 K1\nG1 X14\n"), "4:1 bad-contour; ");
  EXPECT_EQ(problems("X10 Z0\nG2 X14 Z-4\n"), "4:1 missing-word; ");
  EXPECT_EQ(problems("X10 Z0\nG2 X14 Z-4 I1 R3\n"), "4:1 ambiguous-word; ");
  EXPECT_EQ(problems("X10 Z0\nG2 X14 Z-4 R1\n"), "4:1 arc-radius; ");
  EXPECT_EQ(problems("X10 Z0\nU1 X11\nZ-4\n"), "4:1 ambiguous-word; ");
  EXPECT_EQ(problems("X10 Z0\nZ-4 A1 C1\nX14\n"), "4:8 ambiguous-word; ");
  EXPECT_EQ(problems("X10 Z0\nZ-4 A3\nX12\nZ-9\n"), "8:1 bad-contour; ");
  EXPECT_EQ(problems("X10 Z0\nZ-600\nX14\n"), "7:1 travel; ");
}

// The program goes on where the cycle would have ended, and nothing of it moves.
TEST(LatheContours, OfManyPiecesAreRefused) {
  const Reading reading =
      read(head + sub("X10 Z0\nO1 while [#1 LT 2000]\n#1=[#1+1]\nZ[-#1/10]\nO1 endwhile\n") + "G71 Q100 X20 Z2\nM2\n");
  EXPECT_EQ(reading.problems(), "9:1 bad-contour; ");
}

TEST(LatheContours, ThatDoNotEndAreReported) {
  EXPECT_EQ(read(head + "O100 sub\nX10 Z0\n").problems(), "2:1 unmatched-o-word; ");
}

}  // namespace test_lathe_cycles
}  // namespace leadscrew::gcode
