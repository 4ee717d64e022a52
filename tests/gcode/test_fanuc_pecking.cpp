// G74 and G75 of Fanuc's lathes: where pecks lead is computed by hand.

#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_fanuc_pecking {

// "r24,1 f10,0": rapids and feeds to X (a radius) and Z, behind the first rapid.
std::string story(const std::string& text) {
  std::ostringstream out;
  bool is_first = true;
  for (const Move& move : read_well("G97 S600 M3\n" + text + "M30\n", in_dialect(Dialect::fanuc_lathe)).lines()) {
    if (!is_first) {
      out << (move.feed.mode == Feed::Mode::rapid ? 'r' : 'f') << at(move.end, base::Axis::X) << ','
          << at(move.end, base::Axis::Z) << ' ';
    }
    is_first = false;
  }
  return out.str();
}

std::string problems(const std::string& text) {
  return read("G97 S600 M3\nG0 X40. Z2.\n" + text + "M30\n", in_dialect(Dialect::fanuc_lathe)).problems();
}

TEST(PeckingOnLathes, DrillsAlongTheAxis) {
  EXPECT_EQ(story("G0 X0 Z2.\nG74 R1.\nG74 Z-10. Q5000 F0.1\n"), "f0,-3 r0,-2 f0,-8 r0,-7 f0,-10 r0,2 ");
}

TEST(PeckingOnLathes, GroovesAFaceSideBySide) {
  // From radius 20 to 17 by 2, and off the wall by 0.5.
  EXPECT_EQ(story("G0 X40. Z1.\nG74 R0.5\nG74 X34. Z-3. P2000 Q2500 R0.5 F0.1\n"),
            "f20,-1.5 r20,-1 f20,-3 r20.5,-3 r20.5,1 r18,1 "
            "f18,-1.5 r18,-1 f18,-3 r18.5,-3 r18.5,1 r17,1 "
            "f17,-1.5 r17,-1 f17,-3 r17.5,-3 r17.5,1 r20,1 ");
}

TEST(PeckingOnLathes, GroovesADiameterSideBySide) {
  EXPECT_EQ(story("G0 X40. Z-10.\nG75 R0.2\nG75 X36. W-5. P1500 Q3000 F0.1\n"),
            "f18.5,-10 r18.7,-10 f18,-10 r20,-10 r20,-13 f18.5,-13 r18.7,-13 f18,-13 r20,-13 "
            "r20,-15 f18.5,-15 r18.7,-15 f18,-15 r20,-15 r20,-10 ");
}

// A whole number is thousandths, one with a point is millimetres.
TEST(PeckingOnLathes, TakesStepsWithAPoint) {
  const std::string begin = "G0 X0 Z2.\nG74 R0.5\nG74 Z-4. F0.1 ";
  EXPECT_EQ(story(begin + "Q3.\n"), story(begin + "Q3000\n"));
}

TEST(PeckingOnLathes, NeedsABottomAndSteps) {
  EXPECT_EQ(problems("G74 X30. P2000 Q1000 F0.1\n"), "3:1 missing-word; ");
  EXPECT_EQ(problems("G74 Z-5. F0.1\n"), "3:1 missing-word; ");
  EXPECT_EQ(problems("G75 X30. Z-5. P1000 F0.1\n"), "3:1 missing-word; ");
  EXPECT_EQ(problems("G75 X30. P0 F0.1\n"), "3:10 bad-value; ");
  EXPECT_EQ(problems("G74 R-1.\n"), "3:5 bad-value; ");
  EXPECT_EQ(problems("G74 Z-5. Q1000\n"), "3:1 missing-feed; ");
}

TEST(PeckingOnLathes, IsBounded) {
  EXPECT_EQ(problems("G74 Z-400. Q1 F0.1\n"), "3:1 too-many-passes; ");
}

}  // namespace test_fanuc_pecking
}  // namespace leadscrew::gcode
