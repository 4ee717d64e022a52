// G6.5: the moves that a surface becomes, and why some cannot be made.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/pose.hpp>

#include "surface_programs.hpp"

namespace leadscrew::gcode {
namespace test_surface_moves {

using Part = MachinedMove::Part;
using surfaces::Vector;

const std::string begin = "F600\nG0 Z40\n";

std::string problems(const std::string& text, const Conditions& conditions = with_shapes()) {
  return read(begin + text + "M2\n", conditions).problems();
}

std::vector<OnSurface> of_part(const std::vector<OnSurface>& all, Part part) {
  std::vector<OnSurface> result;
  for (const OnSurface& each : all) {
    if (each.machined.surface && each.machined.part == part) result.push_back(each);
  }
  return result;
}

/// Each move begins where the one before ends.
void expect_connected(const std::vector<OnSurface>& all) {
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (all[k - 1].machined.surface) {
      EXPECT_EQ(all[k].move.start, all[k - 1].move.end) << k;
    }
  }
  for (const OnSurface& each : all) {
    if (each.move.kind != Move::Kind::nurbs) continue;
    EXPECT_EQ(each.move.curve.points.front().position, each.move.start);
    EXPECT_EQ(each.move.curve.points.back().position, each.move.end);
  }
}

TEST(SurfaceMoves, ComeMachineAndGo) {
  const auto all = read_surfaces(begin + flat_patch + "G6.5 D1 T1 Q5 Z10\nG1 X0\nM2\n");
  ASSERT_EQ(all.size(), 10u);
  expect_connected(all);
  EXPECT_FALSE(all[0].machined.surface);  // G0
  EXPECT_FALSE(all[9].machined.surface);  // G1
  // Over the first place from above, and down to it.
  EXPECT_EQ(xyz(all[1].move.end), (Point{0, 0, 10}));
  EXPECT_EQ(all[1].move.feed.mode, Feed::Mode::rapid);
  EXPECT_EQ(xyz(all[2].move.end), (Point{0, 0, 0}));
  EXPECT_EQ(all[2].move.feed.value, 10);
  const auto passes = of_part(all, Part::pass), links = of_part(all, Part::link);
  ASSERT_EQ(passes.size(), 3u);
  ASSERT_EQ(links.size(), 2u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(passes[k].machined.pass, k);
    EXPECT_EQ(base::number(passes[k].move.line), 8u);
    EXPECT_EQ(passes[k].move.feed.value, 10);
    EXPECT_EQ(passes[k].move.path_mode, PathMode::exact_path);
    EXPECT_EQ(passes[k].move.tolerance, 0);
    EXPECT_TRUE(passes[k].move.curve.contact.empty());
    for (const base::AxisVector& place : places_on(passes[k].move.curve, 20)) {
      EXPECT_NEAR(place[1], 5.0 * static_cast<double>(k), 1e-9);
      EXPECT_NEAR(place[2], 0, 1e-12);
    }
    EXPECT_NEAR(passes[k].move.end[0], k % 2 == 0 ? 20 : 0, 1e-9);
  }
  const auto retract = of_part(all, Part::retract);
  ASSERT_EQ(retract.size(), 1u);
  EXPECT_NEAR(retract[0].move.end[2], 10, 1e-12);
  EXPECT_EQ(retract[0].move.feed.mode, Feed::Mode::rapid);
}

TEST(SurfaceMoves, RiseFirstWhereTheToolStandsLower) {
  const auto all = read_surfaces("F600\nG0 Z3\n" + flat_patch + "G6.5 D1 T1 Q5 P3 Z10\nM2\n");
  EXPECT_EQ(xyz(all[1].move.end), (Point{0, 0, 10}));
  EXPECT_EQ(xyz(all[2].move.end), (Point{20, 10, 10}));
  EXPECT_EQ(xyz(all[3].move.end), (Point{20, 10, 0}));
  // Under G91 Z counts from where the tool stands.
  const auto above = read_surfaces("F600\nG0 Z3\nG91\n" + flat_patch + "G6.5 D1 T1 Q5 Z2\nM2\n");
  EXPECT_EQ(xyz(above[1].move.end), (Point{0, 0, 5}));
}

/// SURFACES: 100 passes of a ball of 10 mm over patch A for ridges of 0.01 mm, 6210.5 mm of the tip's path.
TEST(SurfaceMoves, OfPatchATakeAHundredPasses) {
  const auto all = read_surfaces(begin + patch_a() + "G6.5 D1 T1 H0.01\nM2\n");
  expect_connected(all);
  const auto passes = of_part(all, Part::pass);
  EXPECT_EQ(passes.size(), 100u);
  double length = 0;
  for (const OnSurface& each : passes) {
    const auto places = places_on(each.move.curve, 200);
    for (std::size_t k = 1; k < places.size(); ++k)
      length +=
          std::hypot(places[k][0] - places[k - 1][0], places[k][1] - places[k - 1][1], places[k][2] - places[k - 1][2]);
  }
  EXPECT_NEAR(length, 6210.5, 0.5);
}

TEST(SurfaceMoves, TellTheContactWhereFeedIsThere) {
  const auto all = read_surfaces(begin + patch_a() + "G6.5 D1 T1 Q10 K1\nM2\n");
  for (const OnSurface& each : of_part(all, Part::pass)) {
    ASSERT_EQ(each.move.curve.contact.size(), each.move.curve.points.size());
    // At its ends the tip is the ball's lowest place, as far from its middle as the contact.
    const base::AxisVector& tip = each.move.end;
    const auto& contact = each.move.curve.contact.back();
    EXPECT_NEAR(std::hypot(contact[0] - tip[0], contact[1] - tip[1], contact[2] - tip[2] - 5), 5, 1e-9);
  }
  for (const OnSurface& each : of_part(all, Part::link)) EXPECT_TRUE(each.move.curve.contact.empty());
}

/// The ball's middle is its radius off a sphere of 30 mm, all along each pass, however the tool is held.
TEST(SurfaceMoves, TouchASphereToTheNanometre) {
  const std::string part_of_sphere =
      "G6.4 D1 P3 Q3 I3 J3\n"
      "X21.213203435596427 Y0 Z-21.213203435596427\nX21.213203435596427 Y21.213203435596427 R0.70710678118654752\n"
      "X0 R1\nX42.426406871192853 Y0 Z0 R0.70710678118654752\nX42.426406871192853 Y42.426406871192853 R0.5\n"
      "X0 R0.70710678118654752\nX21.213203435596427 Y0 Z21.213203435596427 R1\n"
      "X21.213203435596427 Y21.213203435596427 R0.70710678118654752\nX0 R1\n";
  Conditions table = with_shapes("table-table-ac");
  for (const char* const lean : {"A0", "A10 B5", ""}) {
    const bool turns = lean[0] != 0;
    const std::string text = begin + (turns ? "G43.4 H1\nG0 Z60\n" : "G0 Z60\n") + part_of_sphere +
                             "G6.5 D1 T1 Q4 U0.1 V0.9 I0.55 J0.9 " + lean + "\nM2\n";
    const auto all = read_surfaces(text, table);
    expect_connected(all);
    const kinematics::Chain chain = kinematics::chain_of(table.machine);
    const auto passes = of_part(all, Part::pass);
    EXPECT_GE(passes.size(), 4u);
    for (const OnSurface& each : passes) {
      EXPECT_EQ(each.move.is_of_tip, turns);
      for (const base::AxisVector& place : places_on(each.move.curve, 101)) {
        const Vector axis =
            kinematics::direction_of(chain, kinematics::angles_of(chain, kinematics::Coordinates<double>(place)));
        const double distance = std::hypot(place[0] + 5 * axis[0], place[1] + 5 * axis[1], place[2] + 5 * axis[2]);
        EXPECT_NEAR(distance, 35, 3e-9) << lean;
      }
    }
  }
}

// Five axes --------------------------------------------------------------------------------------------------------

/// With a lead the tool turns over at each end of a pass, on a plane straight through the pole.
TEST(SurfaceMoves, GoStraightThroughPoles) {
  const Conditions table = with_shapes("table-table-ac");
  const auto all = read_surfaces(begin + "G43.4\nG0 Z60\n" + flat_patch + "G6.5 D1 T1 Q2 A5\nM2\n", table);
  expect_connected(all);
  double least = 1e9, greatest = -1e9;
  for (const OnSurface& each : all) {
    least = std::min(least, each.move.end[5]);
    greatest = std::max(greatest, each.move.end[5]);
  }
  EXPECT_LE(greatest - least, 90 + 1e-9);  // from where C stands
  const auto passes = of_part(all, Part::pass);
  ASSERT_EQ(passes.size(), 6u);
  EXPECT_NEAR(std::abs(passes[0].move.end[3]), 5, 1e-9);
  EXPECT_NEAR(passes[0].move.end[3], -passes[1].move.end[3], 1e-9);
}

/// A tool that is along the pole all the time needs no turn.
TEST(SurfaceMoves, StandInAPoleWhereTheSurfaceIsFlat) {
  const Conditions table = with_shapes("table-table-ac");
  const auto all = read_surfaces(begin + "G0 C40\nG43.4\nG0 Z60\n" + flat_patch + "G6.5 D1 T1 Q2 A0\nM2\n", table);
  for (const OnSurface& each : of_part(all, Part::pass)) {
    for (const base::AxisVector& place : places_on(each.move.curve, 11)) {
      EXPECT_EQ(place[3], 0);
      EXPECT_EQ(place[5], 40);
    }
  }
}

/// A dome's passes go through its top, where the normal is the pole, or beside it.
std::string dome(const std::string& low, const std::string& middle) {
  return "G6.4 D1 P3 Q3 I3 J3\nX-20 Y-20 Z-8\nX0 Z0\nX20 Z-8\nX-20 Y0 Z0\nX0 Z8\nX20 Z0\nX-20 Y20 Z" + low + "\nX0 Z" +
         middle + "\nX20 Z" + low + "\n";
}

TEST(SurfaceMoves, PassTheTopOfADome) {
  const Conditions table = with_shapes("table-table-ac");
  const std::string control = "G43.4\nG0 Z60\n";
  const auto all = read_surfaces(begin + control + dome("-8", "0") + "G6.5 D1 T1 Q2 I0.5 A0\nM2\n", table);
  const auto first = of_part(all, Part::pass).front().move;
  EXPECT_NEAR(first.start[3], -first.end[3], 1e-9);
  EXPECT_NEAR(first.start[5], first.end[5], 1e-9);
  EXPECT_EQ(read(begin + control + dome("-8.00001", "-0.00001") + "G6.5 D1 T1 Q2 I0.5 A0\nM2\n", table).problems(),
            "15:1 surface-pole; ");
}

/// Half of the directions are out of C's travel where it begins, from either side.
TEST(SurfaceMoves, BeginWhereAllOfTheSurfaceIsInsideTravel) {
  Conditions table = with_shapes("table-table-ac");
  table.machine.axes[base::index(base::Axis::C)]->travel_min = -200;
  table.machine.axes[base::index(base::Axis::C)]->travel_max = 200;
  const std::string control = "G0 C150\nG43.4\nG0 Z60\n";
  const auto all = read_surfaces(begin + control + patch_a() + "G6.5 D1 T1 Q2 V0.3 J0.3 A0\nM2\n", table);
  for (const OnSurface& each : all) EXPECT_LE(std::abs(each.move.end[5]), 200);
  table.machine.axes[base::index(base::Axis::C)]->travel_min = -10;
  table.machine.axes[base::index(base::Axis::C)]->travel_max = 10;
  EXPECT_EQ(read(begin + "G43.4\nG0 Z60\n" + patch_a() + "G6.5 D1 T1 Q2 A0\nM2\n", table).problems(),
            "22:1 rotary-travel; ");
}

TEST(SurfaceMoves, NeedAnglesThatHoldTheTool) {
  Conditions nutating = with_shapes("head-head-bc");
  nutating.machine.rotary_chain->axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  const std::string found =
      read(begin + "G43.4\nG0 Z60\n" + flat_patch + "G6.5 D1 T1 Q2 A0 R-1\nM2\n", nutating).problems();
  EXPECT_EQ(found, "10:1 pose-out-of-reach; ");
}

// What cannot be ----------------------------------------------------------------------------------------------------

TEST(SurfaceMoves, AreRefusedWhereTheToolGouges) {
  const std::string valley = "G6.4 D1 P3 Q2 I3 J2\nX-10 Y0 Z-10\nX0 Z-40\nX10 Z-10\nX-10 Y10\nX0 Z-40\nX10 Z-10\n";
  EXPECT_EQ(problems(valley + "G6.5 D1 T1 Q5\n"), "10:1 surface-gouge; ");
  Conditions allowing = with_shapes();
  allowing.options.allows_gouging = true;
  EXPECT_EQ(problems(valley + "G6.5 D1 T1 Q5 L2\n", allowing), "");
  // Across a valley that is narrower than the tool, steps leave what they leave.
  EXPECT_EQ(problems(valley + "G6.5 D1 T1 H0.01 L2\n", allowing), "10:1 surface-step; ");
}

/// SURFACES: on patch A a ball of 45.4 mm does not gouge, one of 45.5 mm does.
TEST(SurfaceMoves, AreRefusedByTheSurfacesCurvature) {
  for (const auto& [radius, expected] : {std::pair{45.4, ""}, {45.5, "20:1 surface-gouge; "}}) {
    Conditions conditions = with_shapes();
    machine::Tool ball;
    ball.number = 1;
    ball.diameter = 2 * radius;
    ball.corner_radius = radius;
    conditions.tools = machine::ToolTable({ball});
    EXPECT_EQ(problems(patch_a() + "G6.5 D1 T1 Q2\n", conditions), expected) << radius;
  }
}

TEST(SurfaceMoves, AreRefusedWithAReason) {
  const std::string edge = "G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0\nX10 Z5\nX20 Z0\nX0 Y10\nX10 Z5\nX20 Z0\n";
  const std::string brow = "G6.4 D1 P2 Q3 I2 J3\nX0 Y0 Z0\nX20\nX0 Y10\nX20\nX0 Y20 Z-10\nX20\n";
  EXPECT_EQ(problems(edge + "G6.5 D1 T1 Q5\n"), "10:1 surface-edge; ");
  EXPECT_EQ(problems(brow + "G6.5 D1 T3 Q5\n"), "10:1 surface-flat-contact; ");
  EXPECT_EQ(problems(flat_patch + "G6.5 D1 T1 Q5 R-1\n"), "8:1 surface-overhang; ");
  EXPECT_EQ(problems(flat_patch + "G6.5 D1 T1 Q0.000001\n"), "8:1 surface-passes; ");
  EXPECT_EQ(problems(flat_patch + "G6.5 D1 T1 H0.0000000001\n"), "8:1 surface-passes; ");
  const std::string fold =
      "G6.4 D1 P2 Q3 I2 J3\nX0 Y20 Z0\nX50\nX0 Z20 R0.70710678118654752\nX50 R0.70710678118654752\nX0 Y0\nX50\n";
  EXPECT_EQ(problems(fold + "G6.5 D1 T1 Q5 S5 R-1\n"), "10:1 surface-section; ");
}

/// A tool that lies nearly flat would have to turn over from pass to pass.
TEST(SurfaceMoves, NeedLinks) {
  const Conditions table = with_shapes("table-table-ac");
  const std::string text = begin + "G43.4\nG0 Z60\n" + flat_patch + "G6.5 D1 T1 Q5 A89.98\nM2\n";
  EXPECT_EQ(read(text, table).problems(), "10:1 surface-link; ");
}

TEST(SurfaceMoves, StayInsideTravel) {
  Conditions small = with_shapes();
  small.machine.axes[base::index(base::Axis::Y)]->travel_max = 7;
  EXPECT_EQ(problems(flat_patch + "G6.5 D1 T1 Q2\n", small), "8:1 travel; ");
  // Of the tip between the ends of a pass, where the table swings the place beyond its ends.
  Conditions table = with_shapes("table-table-ac");
  EXPECT_EQ(read(begin + "G43.4\nG0 Z60\n" + patch_a() + "G6.5 D1 T1 Q5 A0\nM2\n", table).problems(), "");
  table.machine.axes[base::index(base::Axis::Y)]->travel_min = -20;
  EXPECT_EQ(read(begin + "G43.4\nG0 Z60\n" + patch_a() + "G6.5 D1 T1 Q5 A0\nM2\n", table).problems(), "22:1 travel; ");
}

TEST(SurfaceMoves, NeedThreeAxes) {
  Conditions lathe = with_shapes();
  lathe.machine.axes[base::index(base::Axis::Y)].reset();
  EXPECT_EQ(problems(flat_patch + "G6.5 D1 T1 Q2\n", lathe), "8:1 unknown-axis; ");
  EXPECT_EQ(problems("G6.6 P1\nX5\n", lathe), "3:1 unknown-axis; ");
}

/// What follows is read as if nothing had been.
TEST(SurfaceMoves, LeaveTheNextBlocksToThemselves) {
  const Reading reading = read(begin + flat_patch + "G6.5 D1 T1 Q0.000001\nG1 X5\nG0 Z41\nM2\n", with_shapes());
  EXPECT_EQ(reading.problems(), "8:1 surface-passes; ");
  EXPECT_EQ(reading.lines().size(), 3u);
}

}  // namespace test_surface_moves
}  // namespace leadscrew::gcode
