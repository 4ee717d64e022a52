// Blocks of curves as moves: their control points, weights and knots, their feeds and ends.

#include <gtest/gtest.h>

#include <cmath>

#include "curve_promises.hpp"
#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_curves {

using base::Axis;
using Knots = std::vector<double>;

Move curve_of(std::string_view text, const Conditions& conditions = {}) {
  const Reading reading = read_well(text, conditions);
  EXPECT_EQ(reading.of(Move::Kind::nurbs).size(), 1u) << text;
  if (reading.of(Move::Kind::nurbs).empty()) return {};
  const Move move = reading.of(Move::Kind::nurbs)[0];
  EXPECT_TRUE(keeps_promises_of_curve(move)) << text;
  return move;
}

std::vector<Point> points_of(const Move& move) {
  std::vector<Point> points;
  for (const ControlPoint& point : move.curve.points) points.push_back(xyz(point.position));
  return points;
}

std::vector<double> weights_of(const Move& move) {
  std::vector<double> weights;
  for (const ControlPoint& point : move.curve.points) weights.push_back(point.weight);
  return weights;
}

void expect_near(const Point& a, const Point& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// G5 ---------------------------------------------------------------------------------------------------------------

// LinuxCNC's documentation of G5: a curvy N, and another that goes on smoothly.
TEST(CubicSpline, IsTheOneOfTheDocumentation) {
  const Reading reading = read_well("F60 G90 G17\nG0 X0 Y0\nG5 I0 J3 P0 Q-3 X1 Y1\nG5 P0 Q-3 X2 Y2\nM2\n");
  const std::vector<Move> curves = reading.of(Move::Kind::nurbs);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(points_of(curves[0]), (std::vector<Point>{{0, 0, 0}, {0, 3, 0}, {1, -2, 0}, {1, 1, 0}}));
  EXPECT_EQ(points_of(curves[1]), (std::vector<Point>{{1, 1, 0}, {1, 4, 0}, {2, -1, 0}, {2, 2, 0}}));
  for (const Move& curve : curves) {
    EXPECT_EQ(curve.curve.degree, 3);
    EXPECT_EQ(curve.curve.knots, (Knots{0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(weights_of(curve), (std::vector<double>{1, 1, 1, 1}));
  }
}

TEST(CubicSpline, NeedsNoCodeInEveryBlock) {
  EXPECT_EQ(read_well("F60 G5 I1 J1 P1 Q1 X9\nP1 Q1 X20\nI1 J1 P1 Q1\nM2\n").of(Move::Kind::nurbs).size(), 3u);
}

TEST(CubicSpline, GoesOnBehindWhatIsNoMotion) {
  const Reading reading = read_well("F60 G5 I1 J1 P-2 Q-3 X9\nM8\nG4 P1\nP1 Q1 X20\nM2\n");
  EXPECT_EQ(points_of(reading.of(Move::Kind::nurbs).at(1)).at(1), (Point{11, 3, 0}));
}

TEST(CubicSpline, HoldsForItsBlockAloneInLinuxCnc) {
  const Conditions linuxcnc = in_dialect(Dialect::linuxcnc);
  const Reading reading = read_well("G21 F60 G1 X1\nG5 X3 Y3 I1 J1 P1 Q1\nG5 X5 Y5 P0 Q1\nX9\nM2\n", linuxcnc);
  EXPECT_EQ(points_of(reading.of(Move::Kind::nurbs).at(1)).at(1), (Point{2, 2, 0}));
  EXPECT_EQ(reading.lines().at(1).end[0], 9);
  EXPECT_EQ(read("F60 G5 X3 Y3 I1 J1 P1 Q1\nX9\nM2\n", linuxcnc).problems(), "2:1 axis-without-motion; ");
  EXPECT_EQ(read("F60 G5 X3 I1 J1 P1 Q1\nG0 X3\nX9\nG5 X4 P1 Q1\nM2\n", linuxcnc).problems(), "4:1 missing-word; ");
}

TEST(CubicSpline, TakesNoOtherAxesInLinuxCnc) {
  const Conditions linuxcnc = in_dialect(Dialect::linuxcnc);
  EXPECT_EQ(read("F60 G5 X3 Z3 I1 J1 P1 Q1\nM2\n", linuxcnc).problems(), "1:5 unused-word; ");
  EXPECT_EQ(read("F60 G5.1 X3 I1\nM2\n", linuxcnc).problems(), "1:5 missing-word; ");
}

TEST(CubicSpline, MayCloseInItself) {
  const Move loop = curve_of("F60 G5 I10 J10 P-10 Q10\nM2\n");
  EXPECT_EQ(points_of(loop), (std::vector<Point>{{0, 0, 0}, {10, 10, 0}, {-10, 10, 0}, {0, 0, 0}}));
  EXPECT_EQ(loop.feed.value, 1);
}

// x(u) of all other axes is linear in u: its points are at thirds.
TEST(CubicSpline, TakesTheOtherAxesAlongInProportion) {
  const Move curve = curve_of("F60 G0 Z3 A10\nG5 I1 J1 P1 Q1 X9 Z-6 A100 B3 C6 U9 V12 W15\nM2\n");
  const auto at_third = curve.curve.points.at(1).position, at_two = curve.curve.points.at(2).position;
  EXPECT_EQ(at(at_third, Axis::Z), 0);
  EXPECT_EQ(at(at_two, Axis::Z), -3);
  EXPECT_EQ(at(at_third, Axis::A), 40);
  EXPECT_EQ(at(at_two, Axis::A), 70);
  EXPECT_EQ(at(at_third, Axis::B), 1);
  EXPECT_EQ(at(at_two, Axis::C), 4);
  EXPECT_EQ(at(at_third, Axis::U), 3);
  EXPECT_EQ(at(at_two, Axis::V), 8);
  EXPECT_EQ(at(curve.end, Axis::W), 15);
}

// G5.1 -------------------------------------------------------------------------------------------------------------

// LinuxCNC's documentation of G5.1: the parabola y = x² from -2 to 2.
TEST(QuadraticSpline, IsTheParabolaOfTheDocumentation) {
  const Move curve = curve_of("F60 G0 X-2 Y4\nG5.1 X2 I2 J-8\nM2\n");
  EXPECT_EQ(points_of(curve), (std::vector<Point>{{-2, 4, 0}, {0, -4, 0}, {2, 4, 0}}));
  EXPECT_EQ(curve.curve.degree, 2);
  EXPECT_EQ(curve.curve.knots, (Knots{0, 0, 0, 1, 1, 1}));
  for (int i = 0; i <= 10; ++i) {
    const auto point = point_of(curve.curve, i / 10.0);
    EXPECT_NEAR(static_cast<double>(point[1]), static_cast<double>(point[0] * point[0]), 1e-15);
  }
}

TEST(QuadraticSpline, TakesWhatIsNotGivenAsNone) {
  EXPECT_EQ(points_of(curve_of("F60 G5.1 X4 Y4 J5\nM2\n")).at(1), (Point{0, 5, 0}));
  EXPECT_EQ(points_of(curve_of("F60 G5.1 X4 Y4 I5\nM2\n")).at(1), (Point{5, 0, 0}));
}

TEST(QuadraticSpline, TakesTheOtherAxesAlongInProportion) {
  const Move curve = curve_of("F60 G5.1 X4 Y4 I5 Z-2 A90\nM2\n");
  EXPECT_EQ(at(curve.curve.points.at(1).position, Axis::Z), -1);
  EXPECT_EQ(at(curve.curve.points.at(1).position, Axis::A), 45);
}

// G5.2 -------------------------------------------------------------------------------------------------------------

// LinuxCNC's documentation of G5.2.
TEST(NurbsBlock, IsTheOneOfTheDocumentation) {
  const Reading reading = read_well("G0 X0 Y0\nF10\nG5.2 P1 L3\nX0 Y1 P1\nX2 Y2 P1\nX2 Y0 P1\nX0 Y0 P2\nG5.3\nM2\n");
  ASSERT_EQ(reading.moves.size(), 2u);
  const Move& move = reading.moves[0];
  EXPECT_TRUE(keeps_promises_of_curve(move));
  EXPECT_EQ(move.line, base::Line{3});
  EXPECT_EQ(move.curve.degree, 2);
  EXPECT_EQ(points_of(move), (std::vector<Point>{{0, 0, 0}, {0, 1, 0}, {2, 2, 0}, {2, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(weights_of(move), (std::vector<double>{1, 1, 1, 1, 2}));
  EXPECT_EQ(move.curve.knots, (Knots{0, 0, 0, 1, 2, 3, 3, 3}));
}

TEST(NurbsBlock, IsOfOrderThreeAndWeightOneUnlessToldOtherwise) {
  const Move plain = curve_of("F60 G5.2 X1 Y1\nX2 Y0\nG5.3\nM2\n");
  EXPECT_EQ(plain.curve.degree, 2);
  EXPECT_EQ(weights_of(plain), (std::vector<double>{1, 1, 1}));
  const Move told = curve_of("F60 G5.2 P2.5 L4\nX1 Y1 P0.5\nX2 Y0\nX3 Y3 P4\nX4 Y4\nG5.3\nM2\n");
  EXPECT_EQ(told.curve.degree, 3);
  EXPECT_EQ(weights_of(told), (std::vector<double>{2.5, 0.5, 1, 4, 1}));
  EXPECT_EQ(told.curve.knots, (Knots{0, 0, 0, 0, 1, 2, 2, 2, 2}));
}

TEST(NurbsBlock, MayRepeatItsCodeAndSetItsFeedAnywhere) {
  const Move move = curve_of("F60 G5.2 X1 Y1 P1\nG5.2 X2 Y0 P1 F120\n(remark)\n#1=3\nN9\nG5.2 X3 Y0\nG5.3\nM2\n");
  EXPECT_EQ(move.curve.points.size(), 4u);
  EXPECT_EQ(move.feed.value, 2);
}

TEST(NurbsBlock, HoldsPointsOfAllAxes) {
  const Move move = curve_of("F60 G5.2 X1 Y1 Z1 A10\nX2 Y0 W5\nZ7\nG5.3\nM2\n");
  ASSERT_EQ(move.curve.points.size(), 4u);
  EXPECT_EQ(points_of(move), (std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {2, 0, 1}, {2, 0, 7}}));
  EXPECT_EQ(at(move.curve.points[2].position, Axis::A), 10);
  EXPECT_EQ(at(move.curve.points[3].position, Axis::W), 5);
}

// In LinuxCNC the position does not change before G5.3.
TEST(NurbsBlock, SeesIncrementsFromItsStart) {
  const Move move = curve_of("F60 G0 X10 Y20\nG91 G5.2 X1 Y1 Z1\nX2 Y0\nX3 Y3\nG5.3\nM2\n");
  EXPECT_EQ(points_of(move), (std::vector<Point>{{10, 20, 0}, {11, 21, 1}, {12, 20, 1}, {13, 23, 1}}));
}

TEST(NurbsBlock, LeavesNoMotionInForce) {
  EXPECT_EQ(read("F60 G5.2 X1 Y1\nX2 Y0\nG5.3\nX5\nM2\n").problems(), "4:1 axis-without-motion; ");
}

// G6.2 -------------------------------------------------------------------------------------------------------------

// A quarter circle of radius 10 about the origin (Piegl and Tiller, ex. 7.1): weights 1, √½, 1.
TEST(NurbsWithKnots, DrawsAQuarterCircle) {
  const Move move =
      curve_of("G0 X10\nG6.2 P3 K0 X10 Y0 R1 F600\nK0 X10 Y10 R[SQRT[0.5]]\nK0 X0 Y10 R1\nK1\nK1\nK1\nG0 Z5\nM2\n");
  EXPECT_EQ(move.curve.degree, 2);
  EXPECT_EQ(move.curve.knots, (Knots{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(move.line, base::Line{2});
  EXPECT_EQ(move.feed.value, 10);
  for (int i = 0; i <= 20; ++i) {
    const auto point = point_of(move.curve, i / 20.0);
    EXPECT_NEAR(static_cast<double>(std::hypot(point[0], point[1])), 10, 1e-14);
  }
}

TEST(NurbsWithKnots, BeginsWhereTheToolStands) {
  const Move move = curve_of("F60 G0 X10 Y5\nG6.2 P2 K0 R3\nK0 X20\nK1\nK1\nM2\n");
  EXPECT_EQ(points_of(move), (std::vector<Point>{{10, 5, 0}, {20, 5, 0}}));
  EXPECT_EQ(weights_of(move), (std::vector<double>{3, 1}));
  EXPECT_EQ(move.curve.degree, 1);
}

TEST(NurbsWithKnots, TakesItsStartFromWithinTheToleranceOfArcs) {
  const Move move = curve_of("F60 G0 X10\nG6.2 P2 K0 X10.028\nK0 X20\nK1\nK1\nM2\n");
  EXPECT_EQ(points_of(move), (std::vector<Point>{{10, 0, 0}, {20, 0, 0}}));
  EXPECT_EQ(read("F60 G0 X10\nG6.2 P2 K0 X10.029\nK0 X20\nK1\nK1\nM2\n").problems(), "5:1 curve-start; ");
  EXPECT_EQ(read("G20\nF60 G0 X1\nG6.2 P2 K0 X1.0028\nK0 X2\nK1\nK1\nM2\n").problems(), "");
  EXPECT_EQ(read("G20\nF60 G0 X1\nG6.2 P2 K0 X1.0029\nK0 X2\nK1\nK1\nM2\n").problems(), "6:1 curve-start; ");
}

TEST(NurbsWithKnots, KeepsTheCoordinatesThatAreNotGiven) {
  const Move move = curve_of("F60 G0 Z4\nG6.2 P3 K0\nK0 X5\nK0 Y3 Z8\nK0.5 A30\nK1\nK1\nK1\nM2\n");
  EXPECT_EQ(points_of(move), (std::vector<Point>{{0, 0, 4}, {5, 0, 4}, {5, 3, 8}, {5, 3, 8}}));
  EXPECT_EQ(at(move.end, Axis::A), 30);
  EXPECT_EQ(move.curve.knots, (Knots{0, 0, 0, 0.5, 1, 1, 1}));
}

TEST(NurbsWithKnots, SeesIncrementsFromThePointBefore) {
  const Move move = curve_of("F60 G0 X10\nG91 G6.2 P3 K0\nK0 X5\nK0 X5 Y5\nK1\nK1\nK1\nM2\n");
  EXPECT_EQ(points_of(move), (std::vector<Point>{{10, 0, 0}, {15, 0, 0}, {20, 5, 0}}));
}

// Uniform quadratic: a piece between two knots is the Bézier curve of the middles and the point between them.
TEST(NurbsWithKnots, ClampsWhatIsNot) {
  const Move move = curve_of("F60 G6.2 P3 K0 X-1 Y-1\nK1 X1 Y1\nK2 X3 Y-1\nK3 X5 Y1\nK4\nK5\nK6\nG1 X5\nM2\n");
  EXPECT_EQ(move.curve.knots, (Knots{2, 2, 2, 3, 4, 4, 4}));
  EXPECT_EQ(points_of(move), (std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {3, -1, 0}, {4, 0, 0}}));
}

TEST(NurbsWithKnots, BeginsWhereItsCurveDoesNotWhereItsFirstPointIs) {
  EXPECT_EQ(read("F60 G6.2 P3 K0 X0 Y0\nK1 X1 Y1\nK2 X3 Y-1\nK3\nK4\nK5\nM2\n").problems(), "6:1 curve-start; ");
  EXPECT_EQ(read("F60 G6.2 P3 K0 X0 Y0\nK1 X0 Y0\nK2 X3 Y-1\nK3\nK4\nK5\nM2\n").problems(), "");
}

TEST(NurbsWithKnots, EndsWithItsLastKnot) {
  // A curve, and another at once; then what was in force before has to be said again.
  const char* const curve = "G6.2 P2 K0\nK0 X5\nK1\nK1\n";
  EXPECT_EQ(read_well(std::string("F60 ") + curve + "G6.2 P2 K0\nK0 X9\nK1\nK1\nM8\nG1 X1\nM2\n").moves.size(), 5u);
  EXPECT_EQ(read(std::string("F60 ") + curve + "X7\nX8\nK9\nG1 X9\nM2\n").problems(), "5:1 knot-count; ");
}

TEST(NurbsWithKnots, AreOfDegreesOneToFive) {
  for (int order = 2; order <= 6; ++order) {
    std::string text = "F60 G6.2 P" + std::to_string(order) + " K0\n";
    for (int i = 1; i < order; ++i) text += "K0 X" + std::to_string(i) + "\n";
    for (int i = 0; i < order; ++i) text += "K1\n";
    EXPECT_EQ(curve_of(text + "M2\n").curve.degree, order - 1);
  }
}

// All curves -------------------------------------------------------------------------------------------------------

TEST(Curve, IsReadInInches) {
  EXPECT_EQ(points_of(curve_of("G20\nF60 G5 I1 J2 P-1 Q3 X2\nM2\n")).at(2), (Point{25.4, 3 * 25.4, 0}));
  const Move move = curve_of("G20\nF60 G6.2 P2 K0\nK0 X2 A90\nK1\nK1\nM2\n");
  EXPECT_EQ(at(move.end, Axis::X), 50.8);
  EXPECT_EQ(at(move.end, Axis::A), 90);
  EXPECT_EQ(move.curve.knots, (Knots{0, 0, 1, 1}));
  EXPECT_EQ(at(curve_of("G20\nF60 G5.2 X1 Y1\nX2 Y0\nG5.3\nM2\n").end, Axis::X), 50.8);
}

TEST(Curve, TakesAllOffsets) {
  Conditions conditions;
  conditions.tools = machine::ToolTable(std::vector<machine::Tool>{{1, 0, {0, 0, 7}, 0, {}}});
  const std::string offsets = "F60 G10 L2 P2 X100 Y50\nG55 G43 H1\nG0 X0 Y0 Z0\nG92 X1\n";
  for (const char* text :
       {"G5 I1 J1 P0 Q1 X9 Y2 Z3\n", "G5.2 X5 Y5 Z3\nX9 Y2\nG5.3\n", "G6.2 P2 K0 X1 Y0 Z0\nK0 X9 Y2 Z3\nK1\nK1\n"}) {
    EXPECT_EQ(xyz(curve_of(offsets + text + "M2\n", conditions).end), (Point{108, 52, 10})) << text;
  }
}

TEST(Curve, TurnsWithTheCoordinateSystem) {
  const std::string turned = "F60 G10 L2 P1 R90\n";
  const Move cubic = curve_of(turned + "G5 I1 J2 P3 Q4 X10 Y0\nM2\n");
  const std::vector<Point> points = points_of(cubic);
  expect_near(points[1], {-2, 1, 0}, 1e-15);
  expect_near(points[2], {-4, 13, 0}, 1e-15);
  expect_near(points[3], {0, 10, 0}, 1e-15);
  expect_near(points_of(curve_of(turned + "G5.2 X1 Y2\nX3 Y4\nG5.3\nM2\n"))[1], {-2, 1, 0}, 1e-15);
  const Move knots = curve_of(turned + "G91 G6.2 P3 K0\nK0 X1\nK0 Y2\nK1\nK1\nK1\nM2\n");
  expect_near(points_of(knots)[1], {0, 1, 0}, 1e-15);
  expect_near(points_of(knots)[2], {-2, 1, 0}, 1e-15);
}

TEST(Curve, MovesByIncrements) {
  EXPECT_EQ(xyz(curve_of("F60 G0 X5\nG91 G5 I1 J1 P1 Q1 X3 Y4\nM2\n").end), (Point{8, 4, 0}));
}

TEST(Curve, HasAFeed) {
  const Move linear = curve_of("F120 G5.1 X4 I2 J2\nM2\n");
  EXPECT_EQ(linear.feed.mode, Feed::Mode::units_per_second);
  EXPECT_EQ(linear.feed.value, 2);
  // Degrees a second where no linear axis moves, whatever the units.
  const Move rotary = curve_of("G20\nF120\nG6.2 P2 K0\nK0 A90\nK1\nK1\nM2\n");
  EXPECT_EQ(rotary.feed.value, 2);
  EXPECT_EQ(curve_of("G20\nF120\nG6.2 P2 K0\nK0 A90 X1\nK1\nK1\nM2\n").feed.value, 2 * 25.4);
}

TEST(Curve, LastsItsTimeInInverseTime) {
  const char* const programs[] = {"G93 G5 I1 J1 P1 Q1 X9 F30\n", "G93 G5.1 X9 J1 F30\n",
                                  "G93 G5.2 X1 Y1\nX9 Y1 F30\nG5.3\n", "G93 G5.2 X1 Y1\nX9 Y1\nG5.3 F30\n",
                                  "G93 G6.2 P2 K0 F30\nK0 X9\nK1\nK1\n"};
  for (const char* program : programs) {
    const Move move = curve_of(std::string(program) + "M2\n");
    EXPECT_EQ(move.feed.mode, Feed::Mode::per_second) << program;
    EXPECT_EQ(move.feed.value, 0.5) << program;
  }
}

TEST(Curve, OfNoLengthMovesNothing) {
  for (const char* text : {"G5 I0 J0 P0 Q0\n", "G5.2 X0 Y0\nX0 Y0\nG5.3\n", "G6.2 P2 K0\nK0 X0\nK1\nK1\n"}) {
    EXPECT_EQ(read_well(std::string("F60 ") + text + "M2\n").moves.size(), 1u) << text;
  }
}

TEST(Curve, LeavesTheToolAtItsEnd) {
  const Reading reading = read_well("F60 G5.2 X1 Y1\nX9 Y1\nG5.3\n#1=#5420\nG91 G1 X#1\nM2\n");
  EXPECT_EQ(xyz(reading.lines().at(0).start), (Point{9, 1, 0}));
  EXPECT_EQ(xyz(reading.lines().at(0).end), (Point{18, 1, 0}));
}

TEST(Curve, CarriesThePathMode) {
  const Move move = curve_of("F60 G64 P0.5 Q0.25\nG5 I1 J1 P1 Q1 X9\nM2\n");
  EXPECT_EQ(move.path_mode, PathMode::blend);
  EXPECT_EQ(move.tolerance, 0.5);
  EXPECT_EQ(move.naive_cam_tolerance, 0.25);
}

TEST(Curve, LeavesNoTraceInTheMovesBehind) {
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  Reader reader(text_source("F60 G5 I1 J1 P1 Q1 X9\nG1 X1\nG2 X2 R5\nM2\n"), machine, tools, {}, {});
  Move move;
  while (reader.next(move)) EXPECT_TRUE(keeps_promises_of_curve(move));
}

}  // namespace test_curves
}  // namespace leadscrew::gcode
