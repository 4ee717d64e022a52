#include <cmath>
#include <limits>
#include <numbers>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_arcs {

using base::Axis;

Move arc_of(std::string_view text) {
  const Reading reading = read_well(text);
  EXPECT_EQ(reading.arcs().size(), 1u) << text;
  return reading.arcs().empty() ? Move{} : reading.arcs()[0];
}

void expect_both_ends_on_circle(const Move& arc) {
  const double a = arc.start[base::index(first_axis(arc.plane))] - arc.center_first;
  const double b = arc.start[base::index(second_axis(arc.plane))] - arc.center_second;
  const double c = arc.end[base::index(first_axis(arc.plane))] - arc.center_first;
  const double d = arc.end[base::index(second_axis(arc.plane))] - arc.center_second;
  EXPECT_NEAR(std::hypot(a, b), std::hypot(c, d), 16 * std::numeric_limits<double>::epsilon() * 500);
}

TEST(ArcByCentre, IsExactWhereTheProgramIs) {
  const Move arc = arc_of("G0 X10 Y0\nG3 X0 Y10 I-10 J0 F60\nM2\n");
  EXPECT_EQ(arc.plane, Plane::XY);
  EXPECT_EQ(arc.turns, 1);
  EXPECT_EQ(arc.center_first, 0);
  EXPECT_EQ(arc.center_second, 0);
  EXPECT_EQ(xyz(arc.start), (Point{10, 0, 0}));
  EXPECT_EQ(xyz(arc.end), (Point{0, 10, 0}));
  EXPECT_EQ(arc.feed.value, 1);
}

// A whole circle ends where it begins: it is a move of linear axes all the same, and F is in inches under G20.
TEST(ArcByCentre, ClosedIsFedInUnitsOfLength) {
  EXPECT_EQ(arc_of("G20\nG2 I1 F60\nM2\n").feed.value, 25.4);
}

TEST(ArcByCentre, MayBeOffByAThousandthOfItsRadiusAndNoMore) {
  // About a centre 0.05 or 0.06 mm off, the radii of 100 mm differ by twice that.
  EXPECT_EQ(arc_of("G0 X100\nG3 X-100 I-99.951 F60\nM2\n").turns, 1);
  EXPECT_EQ(read("G0 X100\nG3 X-100 I-99.94 F60\nM2\n").problems(), "2:1 arc-radius; ");
  // Of small arcs, by 0.028 mm: LinuxCNC's 2√2·0.01.
  EXPECT_EQ(arc_of("G0 X1\nG3 X-1 I-0.987 F60\nM2\n").turns, 1);
  EXPECT_EQ(read("G0 X1\nG3 X-1 I-0.98 F60\nM2\n").problems(), "2:1 arc-radius; ");
}

TEST(ArcByCentre, TurnsClockwiseWithG2) {
  EXPECT_EQ(arc_of("G0 X10\nG2 X0 Y10 I-10 F60\nM2\n").turns, -1);
}

TEST(ArcByCentre, TakesAbsoluteCentres) {
  const Move arc = arc_of("G10 L2 P1 X100 Y50\nG90.1 G0 X10 Y0\nG3 X0 Y10 I0 J0 F60\nM2\n");
  EXPECT_EQ(arc.center_first, 100);
  EXPECT_EQ(arc.center_second, 50);
}

TEST(ArcByCentre, ScalesInches) {
  const Move arc = arc_of("G20\nF60\nG3 X2 Y0 I1 J0\nM2\n");
  EXPECT_EQ(arc.center_first, 25.4);
  EXPECT_EQ(at(arc.end, Axis::X), 50.8);
}

TEST(ArcByCentre, WhoseEndsCoincideIsAFullCircle) {
  const Move arc = arc_of("G2 I5 F60\nM2\n");
  EXPECT_EQ(arc.start, arc.end);
  EXPECT_EQ(arc.turns, -1);
  EXPECT_EQ(arc.center_first, 5);
}

TEST(ArcByCentre, CountsTurnsWithP) {
  EXPECT_EQ(arc_of("G3 I5 P3 F60\nM2\n").turns, 3);
  EXPECT_EQ(arc_of("G2 X10 I5 P2 F60\nM2\n").turns, -2);
}

// An end that rounding leaves beside the start closes the circle, whichever side of it that is.
TEST(ArcByCentre, ClosesWhereRoundingLeavesItsEndBesideItsStart) {
  for (const std::string start : {"[-2.2883-[-8.71]+-8.71]", "-2.28830000000001", "-2.28829999999999"}) {
    for (const std::string code : {"G2", "G3", "G2 P2", "G3 P3"}) {
      const std::string text =
          "G0 X" + start + " Y1.2779\n" + code + " X-2.2883 Y1.2779 I0.979241 J-0.542969 F60\nM2\n";
      const Reading reading = read_well(text);
      ASSERT_EQ(reading.arcs().size(), 1u) << text;
      EXPECT_EQ(reading.arcs()[0].start, reading.arcs()[0].end) << text;
      EXPECT_EQ(reading.lines().size(), 1u) << text;
    }
  }
}

TEST(ArcByCentre, NeedsNoCodeInEveryBlock) {
  EXPECT_EQ(read_well("G3 X10 I5 F60\nX0 I-5\nI5\nM2\n").arcs().size(), 3u);
}

TEST(Helix, MovesTheOtherAxesAlong) {
  const Move arc = arc_of("G3 X10 I5 Z-2 A90 U3 F60\nM2\n");
  EXPECT_EQ(at(arc.end, Axis::Z), -2);
  EXPECT_EQ(at(arc.end, Axis::A), 90);
  EXPECT_EQ(at(arc.end, Axis::U), 3);
}

// G18: Z is the first axis and X the second. Seen from +Y, Z turns towards X with G3.
TEST(ArcInZX, TurnsZTowardsXWithG3) {
  const Move arc = arc_of("G18 G0 Z10\nG3 Z0 X10 I0 K-10 F60\nM2\n");
  EXPECT_EQ(arc.plane, Plane::ZX);
  EXPECT_EQ(arc.turns, 1);
  EXPECT_EQ(arc.center_first, 0);
  EXPECT_EQ(arc.center_second, 0);
  EXPECT_EQ(xyz(arc.end), (Point{10, 0, 0}));
  const Move away = arc_of("G18 G0 X1 Z2\nG2 X3 Z2 I1 K0 F60\nM2\n");
  EXPECT_EQ(away.center_first, 2);   // Z
  EXPECT_EQ(away.center_second, 2);  // X
}

TEST(ArcInYZ, TurnsYTowardsZWithG3) {
  const Move arc = arc_of("G19 G0 Y10\nG3 Y0 Z10 J-10 K0 F60\nM2\n");
  EXPECT_EQ(arc.plane, Plane::YZ);
  EXPECT_EQ(arc.center_first, 0);
  EXPECT_EQ(arc.center_second, 0);
  EXPECT_EQ(xyz(arc.end), (Point{0, 0, 10}));
}

TEST(ArcByRadius, TakesTheShortWay) {
  const Move arc = arc_of("G3 X10 Y10 R10 F60\nM2\n");  // from 0,0: the centre lies to the left
  EXPECT_NEAR(arc.center_first, 0, 1e-14);
  EXPECT_NEAR(arc.center_second, 10, 1e-14);
  const Move clockwise = arc_of("G2 X10 Y10 R10 F60\nM2\n");
  EXPECT_NEAR(clockwise.center_first, 10, 1e-14);
  EXPECT_NEAR(clockwise.center_second, 0, 1e-14);
  EXPECT_EQ(clockwise.turns, -1);
}

TEST(ArcByRadius, NegativeRadiusTakesTheLongWay) {
  const Move arc = arc_of("G3 X10 Y10 R-10 F60\nM2\n");
  EXPECT_NEAR(arc.center_first, 10, 1e-14);
  EXPECT_NEAR(arc.center_second, 0, 1e-14);
  EXPECT_EQ(arc.turns, 1);
}

TEST(ArcByRadius, ThatIsSlightlyShortIsASemicircle) {
  const Move arc = arc_of("G3 X10 R4.999 F60\nM2\n");
  EXPECT_EQ(arc.center_first, 5);
  EXPECT_EQ(arc.center_second, 0);
}

TEST(ArcByRadius, MustReachItsEnd) {
  const Reading reading = read("G3 X10 R4.9 F60\nM2\n");
  EXPECT_EQ(reading.problems(), "1:1 arc-radius; ");
  EXPECT_EQ(reading.diagnostics[0].message, "arc radius is too small by 0.1 mm to reach its end");
}

TEST(ArcCentre, MovesToTheBisectorWithinTheTolerance) {
  const Reading reading = read_well("G0 X10\nG3 X0 Y10.02 I-10 J0 F60\nM2\n");
  const Move arc = reading.arcs().at(0);
  EXPECT_EQ(reading.lines().size(), 1u);  // the rapid alone
  expect_both_ends_on_circle(arc);
  EXPECT_EQ(xyz(arc.end), (Point{0, 10.02, 0}));
  // The nearest point of the bisector: from 0,0 along the chord.
  const double along = arc.center_first * (0 - 10) + arc.center_second * 10.02;
  EXPECT_NEAR(std::hypot(arc.center_first, arc.center_second), std::fabs(along) / std::hypot(10, 10.02), 1e-15);
  EXPECT_LT(std::hypot(arc.center_first, arc.center_second), 0.02);
}

TEST(ArcCentre, MayBeOffByAThousandthOfALargeRadius) {
  expect_both_ends_on_circle(arc_of("G0 X400\nG3 X0 Y400.3 I-400 J0 F60\nM2\n"));
  EXPECT_EQ(read("G0 X10\nG3 X0 Y10.3 I-10 J0 F60\nM2\n").problems(), "2:1 arc-radius; ");
}

TEST(ArcCentre, BeyondTheToleranceIsAnErrorThatSaysByHowMuch) {
  const Reading reading = read("G0 X10\nG3 X0 Y10.31 I-10 J0 F60\nM2\n");
  ASSERT_EQ(reading.problems(), "2:1 arc-radius; ");
  EXPECT_EQ(reading.diagnostics[0].message, "arc radius differs by 0.31 mm at its ends");
  EXPECT_TRUE(reading.arcs().empty());
}

TEST(ArcCentre, IsNeverOffByMoreThanAHundredTolerances) {
  EXPECT_EQ(read("F60\nG3 X1 Y100 I-4000 J0\nM2\n").problems(), "");
  EXPECT_EQ(read("F60\nG3 X2 Y100 I-4000 J0\nM2\n").problems(), "2:1 arc-radius; ");
}

TEST(ArcCentre, HasMoreRoomInInches) {
  EXPECT_EQ(read("G20\nF60\nG0 X0.4\nG3 X0 Y0.402 I-0.4 J0\nM2\n").problems(), "");
  EXPECT_EQ(read("F60\nG0 X10.16\nG3 X0 Y10.2108 I-10.16 J0\nM2\n").problems(), "3:1 arc-radius; ");
}

// A full circle whose end is a rounding off its start: moving the centre to the bisector would shrink it to nothing.
TEST(ArcThatNearlyCloses, KeepsItsCentreAndEndsInAShortLine) {
  const Reading reading = read_well("G0 X10\nG3 X10.01 Y0 I-10 J0 F60\nM2\n");
  ASSERT_EQ(reading.arcs().size(), 1u);
  const Move arc = reading.arcs()[0];
  EXPECT_EQ(arc.center_first, 0);
  EXPECT_EQ(arc.center_second, 0);
  EXPECT_EQ(arc.end, arc.start);
  const Move line = reading.lines().back();
  EXPECT_EQ(line.start, arc.end);
  EXPECT_EQ(xyz(line.end), (Point{10.01, 0, 0}));
  EXPECT_EQ(line.feed.value, 1);
}

TEST(ArcThatNearlyCloses, KeepsItsSpeedInInverseTime) {
  const Reading reading = read_well("G93 G0 X10\nG3 X10.01 Y0 I-10 J0 F60\nM2\n");
  const Move line = reading.lines().back();
  EXPECT_EQ(line.feed.mode, Feed::Mode::units_per_second);
  EXPECT_NEAR(line.feed.value, 2 * std::numbers::pi * 10, 1e-9);
}

TEST(Arc, OfNoRadiusIsAnError) {
  EXPECT_EQ(read("G2 I0 J0 F60\nM2\n").problems(), "1:1 arc-radius; ");
  EXPECT_EQ(read("G2 X1 I1 F60\nM2\n").problems(), "1:1 arc-radius; ");
  EXPECT_EQ(read("G2 X1 R0 F60\nM2\n").problems(), "1:1 arc-radius; ");
  EXPECT_EQ(read("G2 R5 F60\nM2\n").problems(), "1:1 arc-radius; ");
}

TEST(Arc, TurnsWithTheCoordinateSystem) {
  const Move arc = arc_of("G10 L2 P1 R90\nG0 X10\nG3 X0 Y10 I-10 J0 F60\nM2\n");
  EXPECT_NEAR(arc.center_first, 0, 1e-15);
  EXPECT_NEAR(arc.center_second, 0, 1e-15);
  EXPECT_EQ(xyz(arc.start), (Point{0, 10, 0}));
  EXPECT_EQ(xyz(arc.end), (Point{-10, 0, 0}));
  EXPECT_EQ(arc.turns, 1);
}

}  // namespace test_arcs
}  // namespace leadscrew::gcode
