// Tilted working planes: where the axes go is worked out by hand, for machines that turn the part, the tool, or both.

#include <cmath>
#include <leadscrew/gcode/nurbs.hpp>
#include <leadscrew/machine/rotary_chain.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_tilted_planes {

const double half_root_3 = std::sqrt(3.0) / 2;

/// Nine axes with a chain of that name. The tables' axes pass through (0, 0, 0); of heads, the second axis is 100 mm above
/// the gauge point.
Conditions on(std::string_view kinematics) {
  Conditions conditions;
  conditions.machine.kinematics = kinematics;
  conditions.machine.rotary_chain = machine::preset_chain(kinematics);
  for (machine::RotaryAxis& axis : conditions.machine.rotary_chain->axes) {
    if (axis.carries == machine::Carries::tool) axis.point = {0, 0, 100};
  }
  machine::Tool tool;
  tool.number = 1;
  tool.offset[2] = 40;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

void expect_place(const base::AxisVector& found, const std::vector<double>& xyzabc) {
  for (std::size_t i = 0; i < xyzabc.size(); ++i)
    EXPECT_NEAR(found[i], xyzabc[i], 1e-9) << base::letter(base::all_axes[i]);
}

/// Where the last line of the program ends.
base::AxisVector last_end(std::string_view text, const Conditions& conditions) {
  const Reading reading = read_well(text, conditions);
  EXPECT_FALSE(reading.lines().empty()) << text;
  return reading.lines().empty() ? base::AxisVector{} : reading.lines().back().end;
}

/// "1:2 code; "
std::string only(const char* place, const char* code) {
  return std::string(place) + " " + code + "; ";
}

// The plane's normal leans by 30 degrees towards X, its X is the workpiece's Y, its Y leans towards −X: (−√3/2, 0, 1/2).
constexpr const char* leaning = "G68.2 X10 Y20 Z5 I90 J30 K0\n";

TEST(TiltedPlane, TurnsTheTableUnderTheTool) {
  // C by 90 puts the normal (1/2, 0, √3/2) at (0, 1/2, √3/2), A by 30 at Z. So X of the plane is −X of the machine and Y
  // is −Y. The origin (10, 20, 5) goes to (−20, 10, 5), then to (−20, 10 √3/2 − 5/2, 5 + 5 √3/2).
  const Conditions conditions = on("table-table-ac");
  const std::string begin = std::string(leaning) + "G53.1\n";
  expect_place(last_end(begin + "G0 X0 Y0 Z0\nM2\n", conditions),
               {-20, 10 * half_root_3 - 2.5, 5 + 5 * half_root_3, 30, 0, 90});
  expect_place(last_end(begin + "G0 X3 Y4 Z7\nM2\n", conditions),
               {-23, 10 * half_root_3 - 6.5, 12 + 5 * half_root_3, 30, 0, 90});
}

TEST(TiltedPlane, TurnsTheToolOfAHead) {
  // B by 30. The pivot is 100 mm above the gauge point: it is over the tip by 100 along the normal, and the axes are zero
  // where it is 100 above.
  const Conditions conditions = on("head-head-bc");
  const std::string begin = std::string(leaning) + "G53.1\n";
  expect_place(last_end(begin + "G0 X0 Y0 Z0\nM2\n", conditions), {10 + 50, 20, 5 + 100 * half_root_3 - 100, 0, 30, 0});
  // (3, 4, 7) of the plane: 3 along Y, 4 along (−√3/2, 0, 1/2), 7 along the normal.
  expect_place(last_end(begin + "G0 X3 Y4 Z7\nM2\n", conditions),
               {60 - 4 * half_root_3 + 3.5, 23, 5 + 100 * half_root_3 - 100 + 2 + 7 * half_root_3, 0, 30, 0});
  // A tool of 40 mm lies along the normal too.
  expect_place(last_end(begin + "G43 H1 G0 X0 Y0 Z0\nM2\n", conditions),
               {10 + 70, 20, 5 + 140 * half_root_3 - 100, 0, 30, 0});
}

TEST(TiltedPlane, TurnsBothOnAMixedMachine) {
  // Euler angles 30, 40, 0: the normal is (sin 30 sin 40, −cos 30 sin 40, cos 40), held by B = 40 once C = 60 has brought it
  // into XZ. The origin, on C's axis, stays.
  const Conditions conditions = on("head-b-table-c");
  const double s = std::sin(40 * std::numbers::pi / 180), c = std::cos(40 * std::numbers::pi / 180);
  const std::string begin = "G68.2 Z5 I30 J40\nG53.1\n";
  expect_place(last_end(begin + "G0 X0 Y0 Z0\nM2\n", conditions), {100 * s, 0, 5 + 100 * c - 100, 0, 40, 60});
  // X of the plane, (cos 30, sin 30, 0), is turned to Y; Y of it to (−cos 40, 0, sin 40).
  expect_place(last_end(begin + "G0 X3 Y4 Z7\nM2\n", conditions),
               {107 * s - 4 * c, 3, 5 + 107 * c - 100 + 4 * s, 0, 40, 60});
}

TEST(TiltedPlane, LeavesLinearAxesWhereTheyAreWhileItTurns) {
  const Reading reading = read_well("G0 X1 Y2 Z30\n" + std::string(leaning) + "G53.1\nG91 G0 Z5\nG69\nG90 G0 X0\nM2\n",
                                    on("table-table-ac"));
  const auto lines = reading.lines();
  ASSERT_EQ(lines.size(), 4u);
  expect_place(lines[1].end, {1, 2, 30, 30, 0, 90});
  EXPECT_EQ(lines[1].path_mode, PathMode::exact_stop);
  expect_place(lines[2].end, {1, 2, 35, 30, 0, 90});
  EXPECT_EQ(lines[2].end[0], 1);  // exactly
  expect_place(lines[3].end, {0, 2, 35, 30, 0, 90});
}

TEST(TiltedPlane, LiesInTheCoordinateSystemInForce) {
  // Turned by 90, and its origin at (100, 0, 0): the plane's origin is at (100 − 20, 10, 5), its normal leans towards Y.
  const Conditions conditions = on("head-head-bc");
  expect_place(last_end("G10 L2 P1 X100 R90\n" + std::string(leaning) + "G53.1\nG0 X0 Y0 Z0\nM2\n", conditions),
               {80, 10 + 50, 5 + 100 * half_root_3 - 100, 0, 30, 90});
}

TEST(TiltedPlane, IsToldByTurnsAboutFixedAxes) {
  // About X by 90, then about Y by 90: the normal goes to −Y and stays there. The other way: to X and stays.
  const Conditions conditions = on("head-head-bc");
  expect_place(last_end("G68.2 P1 I90 J90\nG53.1\nG0 X1 Y0 Z0\nM2\n", conditions), {0, -100, -101, 0, 90, -90});
  expect_place(last_end("G68.2 P1 Q213 I90 J90\nG53.1\nG0 X1 Y0 Z0\nM2\n", conditions), {100, 1, -100, 0, 90, 0});
  Conditions haas = conditions;
  haas.options.dialect = Dialect::haas;
  expect_place(last_end("G268 I90 J90 Q213\nG253\nG0 X1. Y0. Z0.\nM2\n", haas), {100, 1, -100, 0, 90, 0});
  EXPECT_EQ(read("G268 I90 J90 Q213\nG10 L2 P0 X1.\nM2\n", haas).problems(), only("2:1", "tilted-plane"));
}

TEST(TiltedPlane, IsToldByPointsAndByVectors) {
  const Conditions conditions = on("head-head-bc");
  const std::vector<double> wanted = {60, 20 + 3, 5 + 100 * half_root_3 - 100, 0, 30, 0};
  const std::string points =
      "G68.2 P2 Q1 X10 Y20 Z5\nG68.2 P2 Q2 X10 Y27 Z5\nG68.2 P2 Q3 X[10-SQRT[0.75]] Y19 Z5.5\nG53.1\nG0 X3 Y0 Z0\nM2\n";
  expect_place(last_end(points, conditions), wanted);
  const std::string vectors = "G68.2 P3 Q1 X10 Y20 Z5 J2\nG68.2 P3 Q2 I0.5 K[SQRT[0.75]]\nG53.1\nG0 X3 Y0 Z0\nM2\n";
  expect_place(last_end(vectors, conditions), wanted);
}

/// Turned by 90 about Z and, in that plane, by 30 about its X, whose X is the workpiece's Y.
TEST(TiltedPlane, IsToldInAnotherPlane) {
  const Conditions conditions = on("table-table-ac");
  const std::string first = "G68.2 X10 Y18 Z6 I90\n", move = "G53.1\nG0 X3 Y4 Z7\nM2\n";
  const base::AxisVector wanted = last_end(leaning + move, conditions);
  const std::vector<double> places(wanted.begin(), wanted.begin() + 6);
  expect_place(last_end(first + "G68.4 X2 Y0 Z-1 J30\n" + move, conditions), places);
  expect_place(last_end(first + "G68.4 P1 X2 Y0 Z-1 I30\n" + move, conditions), places);
  expect_place(last_end(first + "G68.4 P3 Q1 X2 Z-1 I1\nG68.4 P3 Q2 J-0.5 K[SQRT[0.75]]\n" + move, conditions), places);
  expect_place(last_end(first + "G68.4 X2 Z-1 J10\nG68.4 J20\n" + move, conditions), places);
  expect_place(last_end(first + "G68.4 X2 Z-1 J10\nG69\n" + leaning + move, conditions), places);
}

TEST(TiltedPlane, KeepsArcsWhereTheTableIsTurned) {
  const Reading reading =
      read_well(std::string(leaning) + "G53.1\nG0 X0 Y0\nG3 X0 Y10 I0 J5 F600\nM2\n", on("table-table-ac"));
  ASSERT_EQ(reading.arcs().size(), 1u);
  const Move arc = reading.arcs()[0];
  EXPECT_EQ(arc.plane, Plane::XY);
  EXPECT_EQ(arc.turns, 1);
  EXPECT_NEAR(arc.center_first, -20, 1e-12);
  EXPECT_NEAR(arc.center_second, 10 * half_root_3 - 2.5 - 5, 1e-12);
  EXPECT_EQ(arc.end[2], arc.start[2]);
}

/// A point of a rational quadratic, by its pieces (Piegl and Tiller, "The NURBS Book", eq. 4.1).
std::vector<base::AxisVector> points_of(const NurbsCurve& curve) {
  std::vector<base::AxisVector> points;
  for (std::size_t k = 0; k + 2 < curve.points.size(); k += 2) {
    for (const double t : {0.0, 0.2, 0.5, 0.9}) {
      const double b[] = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
      base::AxisVector point{};
      double weight = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const ControlPoint& control = curve.points[k + i];
        weight += b[i] * control.weight;
        for (std::size_t a = 0; a < 9; ++a) point[a] += b[i] * control.weight * control.position[a];
      }
      for (double& each : point) each /= weight;
      points.push_back(point);
    }
  }
  return points;
}

TEST(TiltedPlane, MakesCurvesOfArcsUnderATurnedHead) {
  const Reading reading = read_well(std::string(leaning) + "G53.1\nG0 X5 Y0 Z0\nG3 I-5 F600\nM2\n", on("head-head-bc"));
  const auto curves = reading.of(Move::Kind::nurbs);
  ASSERT_EQ(curves.size(), 1u);
  ASSERT_EQ(curves[0].curve.degree, 2);
  for (const base::AxisVector& point : points_of(curves[0].curve)) {
    const double x = point[0] - 60, y = point[1] - 20, z = point[2] - (5 + 100 * half_root_3 - 100);
    EXPECT_NEAR(std::hypot(x, y, z), 5, 1e-12);
    EXPECT_NEAR(x / 2 + z * half_root_3, 0, 1e-12);
  }
  for (const ControlPoint& point : curves[0].curve.points) EXPECT_EQ(point.position[4], curves[0].start[4]);
}

TEST(TiltedPlane, DrillsAlongItsNormal) {
  const std::string text = std::string(leaning) + "G53.1\nG0 X0 Y0 Z20\nG99 G81 X3 Y4 Z-6 R2 F300\nX5\nG80\nM2\n";
  const auto lines = read_well(text, on("head-head-bc")).lines();
  ASSERT_EQ(lines.size(), 9u);
  const double top = 5 + 100 * half_root_3 - 100;
  const auto place = [&](double x, double y, double z) {
    return std::vector<double>{60 - y * half_root_3 + z / 2, 20 + x, top + y / 2 + z * half_root_3, 0, 30, 0};
  };
  const double steps[][3] = {{0, 0, 20}, {3, 4, 20}, {3, 4, 2},  {3, 4, -6},
                             {3, 4, 2},  {5, 4, 2},  {5, 4, -6}, {5, 4, 2}};
  expect_place(lines[1].end, place(0, 0, 20));
  for (std::size_t k = 1; k < 8; ++k) expect_place(lines[k + 1].end, place(steps[k][0], steps[k][1], steps[k][2]));
  EXPECT_EQ(lines[3].feed.mode, Feed::Mode::rapid);
  EXPECT_EQ(lines[4].feed.mode, Feed::Mode::units_per_second);
  for (const Move& line : lines) EXPECT_EQ(line.end[4], lines[0].end[4]);
}

// The level at which a series of holes began is one of its plane.
TEST(TiltedPlane, EndsASeriesOfHolesWhereItChanges) {
  const std::string holes = "G53.1\nG0 X0 Y0 Z20\nG98 G81 X3 Y4 Z-6 R2 F300\n", more = "X5\nG80\nM2\n";
  const auto problems = [&](const std::string& between) {
    return read(std::string(leaning) + holes + between + more, on("head-head-bc")).problems();
  };
  EXPECT_EQ(problems(""), "");
  EXPECT_NE(problems("G68.4 X0 Y0 Z-20 I0 J0 K0\n").find("missing-word"), std::string::npos);
}

TEST(TiltedPlane, DrillsStraightDownWhereTheTableIsTurned) {
  const std::string text = std::string(leaning) + "G53.1\nG0 X0 Y0 Z20\nG99 G81 X3 Y4 Z-6 R2 F300\nG80\nM2\n";
  const auto lines = read_well(text, on("table-table-ac")).lines();
  ASSERT_EQ(lines.size(), 6u);
  for (std::size_t k = 3; k < 6; ++k) {
    EXPECT_EQ(lines[k].end[0], lines[2].end[0]);
    EXPECT_EQ(lines[k].end[1], lines[2].end[1]);
  }
  EXPECT_NEAR(lines[4].end[2] - lines[3].end[2], -8, 1e-12);
}

TEST(TiltedPlane, HoldsWhereTheProgramTurnsTheAxesItself) {
  const Conditions conditions = on("table-table-ac");
  expect_place(last_end("G0 A30 C90\n" + std::string(leaning) + "G0 X3 Y4 Z7\nM2\n", conditions),
               {-23, 10 * half_root_3 - 6.5, 12 + 5 * half_root_3, 30, 0, 90});
  expect_place(last_end(std::string(leaning) + "G0 A30 C90\nG0 X3 Y4 Z7\nM2\n", conditions),
               {-23, 10 * half_root_3 - 6.5, 12 + 5 * half_root_3, 30, 0, 90});
  EXPECT_EQ(read_well("G0 A30 C90\n" + std::string(leaning) + "G53.1\nG0 X3\nM2\n", conditions).lines().size(), 2u);
}

TEST(TiltedPlane, IsOfTheTipUnderToolCentrePointControl) {
  // The tip's coordinates are those of the workpiece: origin and (3, 4, 7) of the plane.
  const std::string text = std::string(leaning) + "G43.4 H1\nG1 X3 Y4 Z7 A10 C20 F600\nM2\n";
  const auto lines = read_well(text, on("table-table-ac")).lines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_of_tip);
  expect_place(lines[0].end, {10 - 4 * half_root_3 + 3.5, 23, 5 + 2 + 7 * half_root_3, 10, 0, 20});
}

TEST(TiltedPlane, TakesTheNearestAnglesInsideTravel) {
  // Of normals that lean towards Y: A by 30 with C at 0, or A by −30 with C at 180. Towards −Y the other way.
  Conditions conditions = on("table-table-ac");
  const std::string plane = "G68.2 P1 I-30\n", end = "M2\n";
  expect_place(last_end(plane + "G53.1\n" + end, conditions), {0, 0, 0, 30, 0, 0});
  expect_place(last_end("G0 C200\n" + plane + "G53.1\n" + end, conditions), {0, 0, 0, -30, 0, 180});
  expect_place(last_end("G0 C1000\n" + plane + "G53.1 P1\n" + end, conditions), {0, 0, 0, 30, 0, 1080});
  expect_place(last_end(plane + "G53.1 P2\n" + end, conditions), {0, 0, 0, -30, 0, 180});
  auto& a = conditions.machine.axes[base::index(base::Axis::A)];
  a->travel_min = -45;
  a->travel_max = 10;
  expect_place(last_end(plane + "G53.1\n" + end, conditions), {0, 0, 0, -30, 0, 180});
  EXPECT_EQ(read(plane + "G53.1 P1\n" + end, conditions).problems(), only("2:1", "rotary-travel"));
  a->travel_min = -10;
  EXPECT_EQ(read(plane + "G53.1\n" + end, conditions).problems(), only("2:1", "rotary-travel"));
  // Without a lean C is free and stays.
  expect_place(last_end("G0 C77\nG68.2 I33\nG53.1\nG0 X1\nM2\n", conditions),
               {std::cos(110 * std::numbers::pi / 180), std::sin(110 * std::numbers::pi / 180), 0, 0, 0, 77});
}

TEST(TiltedPlane, SaysWhatTheMachineCannotHold) {
  Conditions conditions = on("head-head-bc");
  conditions.machine.rotary_chain->axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  EXPECT_EQ(read("G68.2 J80\nG53.1\nM2\n", conditions).problems(), "");
  EXPECT_EQ(read("G68.2 J100\nG53.1\nG0 X1\nM2\n", conditions).problems(), only("2:1", "pose-out-of-reach"));
}

TEST(TiltedPlane, IsRefusedWhereItsWordsMakeNone) {
  const Conditions ac = on("table-table-ac");
  const auto problems = [&](const std::string& text) { return read(text + "\nM2\n", ac).problems(); };
  EXPECT_EQ(read("G68.2 I30\nG53.1\nM2\n").problems(), only("1:1", "bad-tilted-plane"));  // no kinematics, said once
  EXPECT_EQ(problems("G53.1"), only("1:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 I30\nG68.2 I40"), only("2:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P4 I30"), only("1:7", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.4 I30"), only("1:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 I30\nG68.4 P2 Q1\nG68.2 P2 Q2 X1"), only("3:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 I30\nG68.4 P2 Q1\nG0 X1"), only("3:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P1 Q113 I30"), only("1:10", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 Q123 I30"), only("1:7", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68 R30\nG68.2 I30"), only("2:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P2 Q1\nG68.2 P2 Q2 X1\nG68.2 P2 Q3 X2"), only("3:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P2 Q1\nG68.2 P2 Q1"), only("2:10", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P2 Q0"), only("1:10", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P2 Q1\nG68.2 P3 Q2 K1"), only("2:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P2 Q1\nG0 X1"), only("2:1", "bad-tilted-plane"));
  EXPECT_EQ(problems("G68.2 P3 Q1 I1\nG68.2 P3 Q2 I1 K1"), only("2:1", "bad-tilted-plane"));
}

TEST(TiltedPlane, SaysWhatToWriteInPlaceOfWhatIsNotDone) {
  const auto hint_of = [](const char* text) {
    const Reading reading = read(std::string(text) + "\nM2\n", on("table-table-ac"));
    EXPECT_EQ(reading.diagnostics.size(), 1u) << text;
    return reading.diagnostics.empty() ? std::string() : reading.diagnostics[0].hint;
  };
  EXPECT_TRUE(hint_of("G68.3 X1 Y2 Z3").starts_with("G68.2 P3"));
  EXPECT_TRUE(hint_of("G53.6").starts_with("G53.1"));
  EXPECT_TRUE(hint_of("G68.2 P4 I30 J20").starts_with("P1"));
  EXPECT_EQ(hint_of("G60"),
            "a line past the point and one back: by how much and from where are parameters of its control");
}

TEST(TiltedPlane, RefusesWhatItCannotTell) {
  const Conditions ac = on("table-table-ac");
  const auto problems = [&](const std::string& text) {
    return read("F60 G68.2 I30 J20\n" + text + "\nM2\n", ac).problems();
  };
  EXPECT_EQ(problems("G92 X0"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G52 X0"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G10 L20 P1 X0"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G55"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G54"), "");
  EXPECT_EQ(problems("G0 X1 A1"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G2 X1 I0.5 A1"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G53 G0 X1 A1"), "");
  EXPECT_EQ(problems("G53.1 G0 X1"), only("2:1", "tilted-plane"));
  EXPECT_EQ(problems("G53.1 P3"), "2:7 bad-value; ");
  EXPECT_EQ(problems("G43.4\nG53.1"), "3:1 tip-control; ");
  EXPECT_EQ(problems("G81 X1 Z-1 R1"), only("2:1", "tool-not-along"));
  EXPECT_EQ(problems("G53.1\nG81 X1 Z-1 R1"), "");
  EXPECT_EQ(problems("G53.1\nG18 G81 X1 Y-1 R1"), only("3:5", "tool-not-along"));
}

/// Under M428 they leave out all offsets, that of the tool too, and rotary axes turn the part all the same (LinuxCNC's boat-xyzbc.ngc);
/// G49 in the block ends G43.4 before it moves.
TEST(ToolCentrePoint, TakesMachineCoordinatesOfLinuxCnc) {
  const Conditions conditions = on("table-table-ac");
  const auto lines =
      read_well("G10 L2 P1 X5 Z7\nG43 H1\nM428\nG0 X0 Y0 Z0 A30\nG53 Z100 C90\nG53 G49 Z50\nM2\n", conditions).lines();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[1].is_of_tip && lines[2].is_of_tip);
  expect_place(lines[1].end, {5, 0, 100 - 40, 30, 0, 90});
  // Without the tool the place is 40 behind, along (1/2, 0, √3/2).
  expect_place(lines[2].end, {5 + 20, 0, 50, 30, 0, 90});
  const auto ended = read_well("G43.4 H1\nG0 Z10\nG53 G49 Z60\nM2\n", conditions).lines();
  ASSERT_EQ(ended.size(), 2u);
  EXPECT_FALSE(ended[1].is_of_tip);
  EXPECT_EQ(ended[1].end[2], 60);
  EXPECT_EQ(read("G43.4 H1\nG53 G0 Z50\nM2\n", conditions).problems(), "2:1 tip-control; ");
}

/// Under tool centre point control, too: the tool would be drawn through the work askew.
TEST(ToolCentrePoint, DrillsAlongTheToolOnly) {
  const Conditions ac = on("table-table-ac");
  const auto problems = [&](const std::string& text) {
    return read("F60 G43.4 H1\n" + text + "\nM2\n", ac).problems();
  };
  EXPECT_EQ(problems("G81 X1 Z-1 R1"), "");
  EXPECT_EQ(problems("G0 C40\nG81 X1 Z-1 R1"), "");
  EXPECT_EQ(problems("G0 A10\nG81 X1 Z-1 R1"), "3:1 tool-not-along; ");
  EXPECT_EQ(problems("G0 A90\nG18 G81 X1 Y-1 R1"), "");
  EXPECT_EQ(problems("G0 A90\nG81 X1 Z-1 R1"), "3:1 tool-not-along; ");
}

TEST(TiltedPlane, FindsWhatLeavesTravel) {
  EXPECT_EQ(read(std::string(leaning) + "G53.1\nG0 X490\nM2\n", on("table-table-ac")).problems(), "3:4 travel; ");
  EXPECT_EQ(read(std::string(leaning) + "G53.1\nF60 G0 X476 Y0\nG2 I5\nM2\n", on("table-table-ac")).problems(),
            "4:1 travel; ");
}

/// LinuxCNC's demonstrations of five axes switch it so.
TEST(ToolCentrePoint, IsSwitchedByM428AndM429) {
  const Conditions conditions = on("table-table-ac");
  const Reading reading = read_well(
      "G43 H1\nG0 Z100\nM428\nG1 X10 Y0 Z5 A30 C90 F600\nG43.1 Z50\nG1 X20\nM429\nG0 X0 Y0 A0 C0\nM2\n", conditions);
  const auto lines = reading.lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_FALSE(lines[0].is_of_tip);
  EXPECT_EQ(lines[0].end[2], 140);
  EXPECT_TRUE(lines[1].is_of_tip);
  EXPECT_EQ(lines[1].tool[2], 40);
  expect_place(lines[1].end, {10, 0, 5, 30, 0, 90});
  EXPECT_EQ(lines[2].tool[2], 50);  // the tool is longer, the axes stand: the tip is elsewhere
  expect_place(lines[2].start, {10 - 5, 0, 5 - 10 * half_root_3, 30, 0, 90});
  EXPECT_FALSE(lines[3].is_of_tip);
  EXPECT_EQ(read("M428\nM2\n").problems(), "1:1 tip-control; ");
  const Reading elsewhere = read("M428\nM2\n", in_dialect(Dialect::grbl));
  ASSERT_EQ(elsewhere.problems(), "1:1 unknown-code; ");
  EXPECT_NE(elsewhere.diagnostics[0].hint.find("linuxcnc"), std::string::npos);
}

// As G55 by itself is refused there.
TEST(TiltedPlane, KeepsItsCoordinateSystem) {
  const Conditions conditions = on("table-table-ac");
  const std::string kept = "F500\nG55\nM70\nG54\n", tilted = "G68.2 X0 Y0 Z0 I0 J30 K0\nG1 X1\nM72\nG1 X2\nM2\n";
  EXPECT_EQ(read(kept + tilted, conditions).problems(), "7:1 tilted-plane; ");
  EXPECT_EQ(read("F500\nM70\nG91\n" + tilted, conditions).problems(), "");
}

}  // namespace test_tilted_planes
}  // namespace leadscrew::gcode
