#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_travel {

TEST(Travel, EndsAtItsLimits) {
  EXPECT_EQ(read("G0 X500 Y-500\nM2\n").problems(), "");
  EXPECT_EQ(read("G0 X500.001\nM2\n").problems(), "1:4 travel; ");
  EXPECT_EQ(read("G0 Y-500.001\nM2\n").problems(), "1:4 travel; ");
  EXPECT_EQ(read("G20\nG0 X19.68503937007874016\nM2\n").problems(), "");
}

TEST(Travel, NamesAxisValueAndLimits) {
  const base::Diagnostic d = read("G0 A1 Z501.5\nM2\n").diagnostics.at(0);
  EXPECT_EQ(d.message, "axis Z would be at 501.5 mm, outside its travel");
  EXPECT_EQ(d.hint, "from -500 to 500 mm in machine coordinates");
  EXPECT_EQ(read("G0 A-3601\nM2\n").diagnostics.at(0).message, "axis A would be at -3601 degrees, outside its travel");
}

TEST(Travel, IsThatOfTheMachineNotOfTheProgram) {
  EXPECT_EQ(read("G10 L2 P1 X400\nG0 X101\nM2\n").problems(), "2:4 travel; ");
  EXPECT_EQ(read("G10 L2 P1 X-400\nG0 X600\nM2\n").problems(), "");
  EXPECT_EQ(read("G91 G0 X300\nX300\nM2\n").problems(), "2:1 travel; ");
  EXPECT_EQ(read("G10 L2 P1 R45\nG0 X600 Y600\nM2\n").problems(), "2:9 travel; ");
}

TEST(Travel, HoldsTheBulgeOfAnArc) {
  EXPECT_EQ(read("F60 G0 X490 Y-20\nG3 X490 Y20 I0 J20\nM2\n").problems(), "2:1 travel; ");
  EXPECT_EQ(read("F60 G0 X490 Y-20\nG2 X490 Y20 I0 J20\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G0 X480 Y-20\nG3 X480 Y20 I0 J20\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G0 Z-490\nG18 G3 X1 Z-490 P2 R30\nM2\n").problems(), "2:5 travel; ");
  EXPECT_EQ(read("F60 G0 Y490\nG19 G2 J5 K0 X9 P2\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G0 Y490\nG19 G2 J6 K0\nM2\n").problems(), "2:5 travel; ");
}

TEST(Travel, HoldsTheEndOfAHelix) {
  EXPECT_EQ(read("F60 G2 I5 Z501\nM2\n").problems(), "1:11 travel; ");
}

TEST(Travel, HoldsThePlacesOfG28) {
  EXPECT_EQ(read("#5161=501\nG28\nM2\n").problems(), "2:1 travel; ");
  EXPECT_EQ(read("G28 X501\nM2\n").problems(), "1:5 travel; ");
}

TEST(Travel, IsReportedAgainAfterComingBack) {
  EXPECT_EQ(read("G0 X501\nX502\nX0\nX501\nX-501\nM2\n").problems(), "1:4 travel; 4:1 travel; ");
}

TEST(Travel, IsNotLeftByWhatComesBackInSteps) {
  const Reading drilled = read("G0 X501\nG81 X3 Z-1 R1 F60\nX4\nM2\n");
  EXPECT_EQ(drilled.problems(), "1:4 travel; ");
  EXPECT_EQ(xyz(drilled.lines().at(0).start), (Point{3, 0, 1}));
  const Reading turned = read("F60 G0 X501\nG2 X499 I-1\nG0 X1\nM2\n");
  EXPECT_EQ(turned.problems(), "1:8 travel; ");
  EXPECT_EQ(xyz(turned.lines().at(0).start), (Point{499, 0, 0}));
}

TEST(Travel, MayBeEnteredFromAStartOutside) {
  Conditions conditions;
  conditions.options.start[2] = 510;
  EXPECT_EQ(read("G0 X1 Z500\nM2\n", conditions).lines().size(), 1u);
  const Reading reading = read("M3\nG0 X1\nX2\nZ0\nX3\nM2\n", conditions);
  EXPECT_EQ(reading.problems(), "2:1 travel; ");
  EXPECT_EQ(reading.lines().size(), 2u);
}

TEST(Travel, OutsideWhichNothingMoves) {
  const Reading reading = read("G0 X501\nX502\nY1\nX0\nX1\nM2\n");
  for (const Move& move : reading.lines()) EXPECT_LE(xyz(move.end).x, 500);
  EXPECT_EQ(reading.lines().size(), 2u);
}

}  // namespace test_travel
}  // namespace leadscrew::gcode
