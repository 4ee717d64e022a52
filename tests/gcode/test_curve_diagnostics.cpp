// Every diagnostic of a curve at its exact place; and one problem makes one diagnostic.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_curve_diagnostics {

struct Row {
  const char* text;
  const char* problems;
};

void expect_problems(std::initializer_list<Row> rows) {
  for (const Row& row : rows) {
    EXPECT_EQ(read(std::string(row.text) + "\nM2\n").problems(), row.problems) << row.text;
  }
}

TEST(CurveDiagnostics, OfG5StandAtTheirPlace) {
  expect_problems({
      {"F60 G5 X9 P1 Q1", "1:5 missing-word; "},
      {"F60 G5 X9 I1 P1 Q1", "1:5 missing-word; "},
      {"F60 G5 X9 I1 J1", "1:5 missing-word; "},
      {"F60 G5 X9 I1 J1 P1", "1:5 missing-word; "},
      {"F60 G5 X9 I1 J1 P1 Q1\nG1 X10\nG5 X12 P1 Q1", "3:1 missing-word; "},
      {"F60 G5 X9 I1 J1 P1 Q1\nG28\nG5 X12 P1 Q1", "3:1 missing-word; "},
      {"F60 G18 G5 X9 I1 J1 P1 Q1", "1:9 bad-plane; "},
      {"F60 G19 G5.1 X9 I1 J1", "1:9 bad-plane; "},
      {"F60 G5.1 X9", "1:5 missing-word; "},
      {"F60 G5.1 X9 I0 J0", "1:5 missing-word; "},
      {"F60 G5.1 X9 I1 J1 P1", "1:19 unused-word; "},
      {"F60 G5 X9 I1 J1 K1 P1 Q1", "1:17 unused-word; "},
      {"F60 G5 X9 I1 J1 P1 Q1 R1", "1:23 unused-word; "},
      {"G5 X9 I1 J1 P1 Q1", "1:1 missing-feed; "},
      {"G93 G5 X9 I1 J1 P1 Q1", "1:5 missing-feed; "},
      {"F60 G5 G53 X9 I1 J1 P1 Q1", "1:8 bad-g53; "},
      {"F60 G5 G4 X9 I1 J1 P1 Q1", "1:20 ambiguous-word; "},
      {"F60 G1 X1 G5.1", "1:11 modal-conflict; "},
      {"F60 G6 X1", "1:5 unknown-code; "},
  });
}

TEST(CurveDiagnostics, OfG52StandAtTheirPlace) {
  expect_problems({
      {"F60 G5.2 X1 Y1\nX2 Y2 P0\nG5.3", "2:7 bad-weight; "},
      {"F60 G5.2 X1 Y1 P-1\nX2 Y2 P0\nG5.3", "1:16 bad-weight; 2:7 bad-weight; "},
      {"F60 G5.2 P0\nX1 Y1\nX2 Y2\nG5.3", "1:10 bad-weight; "},
      {"F60 G5.2 X1 Y1\nX2\nG5.3", "2:1 missing-word; "},
      {"F60 G5.2 X1 Y1\nY2\nG5.3", "2:1 missing-word; "},
      {"F60 G5.2 L2 X1 Y1\nX2 Y2\nG5.3", "1:10 bad-value; "},
      {"F60 G5.2 L7 X1 Y1\nX2 Y2\nG5.3", "1:10 bad-value; "},
      {"F60 G5.2 L3.5 X1 Y1\nX2 Y2\nG5.3", "1:10 bad-value; "},
      {"F60 G5.2 L4 X1 Y1\nX2 Y2\nG5.3", "3:1 too-few-points; "},
      {"F60 G5.2\nG5.3", "2:1 too-few-points; "},
      {"F60 G5.2 X1 Y1\nG5.2 P3\nX2 Y2\nG5.3", "2:6 unused-word; "},
      {"F60 G5.2 X1 Y1\nP3\nX2 Y2\nG5.3", "2:1 unused-word; "},
      {"F60 G5.2 X1 Y1\nX2 Y2\nG5.3 X3 Y3", "3:6 unused-word; 3:9 unused-word; "},
      {"F60 G5.2 X1 Y1 I1\nX2 Y2\nG5.3", "1:16 unused-word; "},
      {"F60 G5.3", "1:5 missing-curve; "},
      {"G5.2 X1 Y1\nX2 Y2\nG5.3", "1:1 missing-feed; "},
      {"G93 G5.2 X1 Y1\nX2 Y2\nG5.3", "3:1 missing-feed; "},
      {"F60 G5.2 X1 Y1\nX2 Y2\nG1 X3\nX4", "3:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nX2 Y2\n", "4:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nX2 Y2\n%", "3:1 bad-character; "},
      {"F60 G5.2 X1 Y1\nX2 Y2\nM8\nX3 Y3\nG5.3\nG1 X4", "3:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nG4 P1\nX2 Y2\nG5.3", "2:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nT1\nX2 Y2\nG5.3", "2:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nG91 X2 Y2\nG5.3", "2:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nG92 X0\nX2 Y2\nG5.3", "2:1 unfinished-curve; "},
      {"F60 G5.2 X1 Y1\nX2 Y2 ?\nG5.3", "2:7 bad-character; "},
      {"F60 G5.2 X1 Y1\n?\nG5.3", "2:1 bad-character; "},
  });
}

TEST(CurveDiagnostics, OfG62StandAtTheirPlace) {
  expect_problems({
      {"F60 G6.2 K0\nK0 X5\nK1\nK1", "1:5 missing-word; "},
      {"F60 G6.2 P1 K0\nK0 X5\nK1\nK1", "1:10 bad-value; "},
      {"F60 G6.2 P7 K0\nK0 X5\nK1\nK1", "1:10 bad-value; "},
      {"F60 G6.2 P2.5 K0\nK0 X5\nK1\nK1", "1:10 bad-value; "},
      {"F60 G6.2 P2\nK0 X5\nK1\nK1", "1:5 missing-word; "},
      {"F60 G6.2 P2 K0\nX5\nK1\nK1", "2:1 missing-word; "},
      {"F60 G6.2 P2 K0\nK0 X5 R0\nK1\nK1", "2:7 bad-weight; "},
      {"F60 G6.2 P2 K0\nK0 X5 R-1\nK1\nK1", "2:7 bad-weight; "},
      {"F60 G6.2 P2 K0\nK0 X5 R0.0000000001\nK1\nK1", "2:7 bad-weight; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK1 X6\nK0.5\nK2", "4:1 knot-order; "},
      {"F60 G6.2 P2 K0\nX5 K-1\nK1\nK1", "2:4 knot-order; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK0 X6\nK1\nK1", "3:1 knot-multiplicity; "},
      {"F60 G6.2 P3 K0\nK0 X5\nK0 X6\nK1 X7\nK1 X8\nK1 X9\nK2\nK2\nK2", "6:1 knot-multiplicity; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK0\nK0", "3:1 knot-multiplicity; "},
      {"F60 G6.2 P3 K0\nK1 X0\nK2 X6\nK2\nK3\nK4", "6:1 knot-order; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK0.00000000000001 X6\nK1\nK1", "5:1 knot-order; "},
      {"F60 G6.2 P3 K0\nK0 X5\nK1\nK1\nK1\nG0 X1", "3:1 too-few-points; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK1\nK1\nK1", "5:1 knot-count; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK1\nK1 X6\nK2\nK2", "4:1 knot-count; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK1\nG0 X1\nX2", "4:1 unfinished-curve; "},
      {"F60 G6.2 P2 K0\nK0 X5\nG6.2 P2 K0\nK0 X6\nK1\nK1", "3:1 unfinished-curve; "},
      {"F60 G6.2 P2 K0\nK0 X5\nK1", "4:1 unfinished-curve; "},
      {"F60 G6.2 P2 K0\nK0 X5\nM3\nK1\nK1", "3:1 unfinished-curve; "},
      {"F60 G6.2 P2 K0\nK0 X5\nG5.3", "3:1 unfinished-curve; "},
      {"F60 G6.2 P2 K0 X1\nK0 X5\nK1\nK1", "4:1 curve-start; "},
      {"G6.2 P2 K0\nK0 X5\nK1\nK1", "1:1 missing-feed; "},
      {"G93 G6.2 P2 K0\nK0 X5\nK1\nK1", "4:1 missing-feed; "},
      {"F60 G6.2 P2 K0\nK0 X5 P3\nK1\nK1", "2:7 unused-word; "},
      {"F60 G6.2 P2 K0\nK0 X5 L3\nK1\nK1", "2:7 unused-word; "},
      {"F60 G6.2 P2 K0\nK0 I5\nK1\nK1", "2:4 unused-word; "},
  });
}

TEST(CurveDiagnostics, SayWhatIsUnfinishedAtTheEndOfTheText) {
  EXPECT_EQ(read("F60 G5.2 X1 Y1\nX2 Y2").problems(), "2:1 unfinished-curve; ");
  EXPECT_EQ(read("F60 G6.2 P2 K0\nK0 X2\nK1\n").problems(), "3:1 unfinished-curve; ");
  EXPECT_EQ(read("%\nF60 G5.2 X1 Y1\nX2 Y2\n%\n").problems(), "4:1 unfinished-curve; ");
  EXPECT_EQ(read("F60 G5.2 X1 Y1\nX2 Y2 ?").problems(), "2:7 bad-character; ");
  const base::Diagnostic d = read("F60 G6.2 P3 K0\nK0 X2\nK0 X3\nK1\nM2\n").diagnostics.at(0);
  EXPECT_EQ(d.message, "the curve of line 1 lacks 2 of its last knots");
}

TEST(CurveDiagnostics, LeaveNoMove) {
  for (const char* text : {"G5 X9 I1 J1", "G5.2 X1 Y1 P0\nX2 Y2\nG5.3", "G6.2 P2 K0\nK0 X5\nK1\nK0\nG80",
                           "G5.2 X1 Y1\nX2 Y2\nM8\nX3 Y3\nG5.3", "G6.2 P2 K0 R0\nK0 X5\nK1\nK1"}) {
    const Reading reading = read(std::string("F60 ") + text + "\n");
    EXPECT_EQ(reading.errors, 1) << text;
    EXPECT_EQ(reading.moves.size(), 1u) << text;
  }
}

TEST(CurveDiagnostics, LeaveThePositionAtTheLastPoint) {
  for (const char* text : {"G5.2 X1 Y1 P0\nX9 Y2\nG5.3\n", "G5.2 X1 Y1\nX9 Y2\n", "G6.2 P3 K0\nK0 X9 Y2\nK1\n",
                           "G6.2 P2 K0 X1\nK0 X9 Y2\nK1\nK1\n"}) {
    const Reading reading = read(std::string("F60 ") + text + "G1 X50 Q1\nG1 X10\nM2\n");
    ASSERT_EQ(reading.lines().size(), 1u) << text;
    EXPECT_EQ(xyz(reading.lines()[0].start), (Point{50, 2, 0})) << text;
  }
}

TEST(CurveDiagnostics, NameAnAxisThatTheMachineLacks) {
  Conditions conditions;
  conditions.machine = machine::mill3();
  EXPECT_EQ(read("F60 G5.2 X1 Y1 A3\nX2 Y2 A4\nG5.3\nM2\n", conditions).problems(), "1:16 unknown-axis; ");
  EXPECT_EQ(read("F60 G6.2 P2 K0\nK0 A5\nK1\nK1\nG1 X1\nM2\n", conditions).problems(), "2:4 unknown-axis; ");
  EXPECT_EQ(read("F60 G5 X9 I1 J1 P1 Q1 B4\nM2\n", conditions).problems(), "1:23 unknown-axis; ");
  conditions.machine.axes[base::index(base::Axis::Y)].reset();
  EXPECT_EQ(read("F60 G5 X9 I1 J1 P1 Q1\nM2\n", conditions).problems(), "1:14 unknown-axis; 1:20 unknown-axis; ");
}

TEST(CurveDiagnostics, EndACurveOfTooManyPoints) {
  std::string points;
  for (std::size_t i = 1; i < most_control_points; ++i) points += "X" + std::to_string(i % 2) + " Y1\n";
  EXPECT_EQ(read("F60 G5.2 P1\n" + points + "G5.3\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G5.2 P1\n" + points + "X1 Y1\nX2 Y2\nG5.3\nM2\n").problems(), "4097:1 too-many-points; ");
}

// The curve counts, not its control points.
TEST(Travel, HoldsTheBulgeOfACurve) {
  // A parabola reaches half as high as its control point.
  EXPECT_EQ(read("F60 G0 Y490\nG5.1 X10 I5 J20\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G0 Y490\nG5.1 X10 I5 J20.00001\nM2\n").problems(), "2:1 travel; ");
  EXPECT_EQ(read("F60 G0 Y-490\nG5.1 X10 I5 J-20.00001\nM2\n").problems(), "2:1 travel; ");
  // A cubic with both inner points at h: three quarters of h.
  EXPECT_EQ(read("F60 G0 Y470\nG5 X10 I1 J40 P1 Q40\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G0 Y470\nG5 X10 I1 J40.00001 P1 Q40.00001\nM2\n").problems(), "2:1 travel; ");
  const base::Diagnostic d = read("F60 G0 Y470\nG5 X10 I1 J60 P1 Q60\nM2\n").diagnostics.at(0);
  EXPECT_EQ(d.message, "axis Y would be at 515 mm, outside its travel");
}

TEST(Travel, HoldsTheEndOfACurve) {
  EXPECT_EQ(read("F60 G5.1 X501 I5 J1\nM2\n").problems(), "1:10 travel; ");
  EXPECT_EQ(read("F60 G6.2 P2 K0\nK0 Z501\nK1\nK1\nG0 X2\nM2\n").problems(), "4:1 travel; ");
  EXPECT_EQ(read("F60 G5.2 X1 Y1\nX501 Y1\nX2 Y1\nG5.3\nM2\n").problems(), "");
  EXPECT_EQ(read("F60 G5.2 X1 Y1\nX501 Y1 P9999\nX2 Y1\nG5.3\nM2\n").problems(), "4:1 travel; ");
}

}  // namespace test_curve_diagnostics
}  // namespace leadscrew::gcode
