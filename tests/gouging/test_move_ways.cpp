// Moves of programs as ways of a tool: beside closed forms.

#include <gtest/gtest.h>

#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gouging/move_ways.hpp>
#include <numbers>

namespace leadscrew::gouging {
namespace test_move_ways {

std::vector<gcode::Move> moves_of(std::string_view text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  std::vector<gcode::Move> moves;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic& problem) {
    EXPECT_NE(problem.severity, base::Severity::error) << problem.message;
  });
  gcode::Move move;
  while (reader.next(move)) {
    if (move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event) moves.push_back(move);
  }
  return moves;
}

void expect_tip(const Way& way, double t, const Vector& expected) {
  const Vector tip = way.at(t).tip;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(tip[k], expected[k], 1e-12) << "t " << t << " coordinate " << k;
}

TEST(WayOfMove, GoesStraightBelowTheToolsOffset) {
  const machine::Machine machine = machine::mill3();
  const MovePoses poses(machine);
  const auto moves = moves_of("G0 X10 Y20 Z30\nG1 X20 F600\n", machine);
  ASSERT_EQ(moves.size(), 2u);
  const Way way = way_of(moves[1], poses, {1, 2, 40});
  expect_tip(way, 0, {9, 18, -10});
  expect_tip(way, 0.25, {11.5, 18, -10});
  expect_tip(way, 1, {19, 18, -10});
  EXPECT_EQ(way.most_step, 1);
  EXPECT_EQ(way.at(0.5).axis, (Vector{0, 0, 1}));
}

TEST(WayOfMove, GoesRoundBothWaysAndInWholeTurns) {
  const machine::Machine machine = machine::mill3();
  const MovePoses poses(machine);
  const auto moves = moves_of(
      "G1 X10 F600\nG3 X0 Y10 I-10 J0\nG2 X10 Y0 I0 J-10\nG2 I-10 J0\nG3 Z6 P3 I-10 J0\n"
      "G18 G3 X20 Z6 I5 K0\n",
      machine);
  ASSERT_EQ(moves.size(), 6u);
  const double root = 10 * std::sqrt(0.5);
  expect_tip(way_of(moves[1], poses, {}), 0.5, {root, root, 0});
  expect_tip(way_of(moves[2], poses, {}), 0.5, {root, root, 0});
  expect_tip(way_of(moves[3], poses, {}), 0.25, {0, -10, 0});
  expect_tip(way_of(moves[4], poses, {}), 0.5, {-10, 0, 3});
  expect_tip(way_of(moves[4], poses, {}), 1.0 / 12, {0, 10, 0.5});
  expect_tip(way_of(moves[5], poses, {}), 0.5, {15, 0, 11});
  EXPECT_NEAR(way_of(moves[3], poses, {}).most_step, 0.5 / (2 * std::numbers::pi), 1e-12);
}

TEST(WayOfMove, FollowsCurves) {
  const machine::Machine machine = machine::mill3();
  const MovePoses poses(machine);
  // A quarter of a circle as a rational quadratic, and a cubic
  const auto moves = moves_of(
      "G1 X10 F600\nG6.2 P3 K0 X10 Y0\nK0 X10 Y10 R0.70710678118654752\nK0 X0 Y10\nK1\nK1\nK1\n"
      "G5 X10 Y10 I0 J5 P-5 Q0\n",
      machine);
  ASSERT_EQ(moves.size(), 3u);
  const Way circle = way_of(moves[1], poses, {});
  for (double t = 0; t <= 1; t += 0.125) {
    const Vector tip = circle.at(t).tip;
    EXPECT_NEAR(std::hypot(tip[0], tip[1]), 10, 1e-13);
  }
  expect_tip(circle, 1, {0, 10, 0});
  // (P₀ + 3 P₁ + 3 P₂ + P₃)/8
  expect_tip(way_of(moves[2], poses, {}), 0.5, {(0 + 0 + 3 * 5 + 10) / 8.0, (10 + 3 * 15 + 3 * 10 + 10) / 8.0, 0});
}

TEST(WayOfMove, SeesTheToolFromTheWorkpiece) {
  machine::Machine machine = machine::mill3();
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  for (const machine::RotaryAxis& axis : machine.rotary_chain->axes) {
    machine.axes[base::index(axis.axis)] = machine::AxisLimits{-360, 360, 100, 1000, 10000, 0.001};
  }
  const MovePoses poses(machine);
  const auto moves = moves_of("G0 X30 Y20 Z10\nG1 A90 F600\n", machine);
  ASSERT_EQ(moves.size(), 2u);
  const Way way = way_of(moves[1], poses, {0, 0, 4});
  EXPECT_NEAR(way.most_step, 10.0 / 90, 1e-12);
  // The table turns by A about X: seen from it, places and the tool turn the other way.
  for (const double t : {0.0, 0.5, 1.0}) {
    const double c = std::cos(t * std::numbers::pi / 2), s = std::sin(t * std::numbers::pi / 2), z = 10 - 4;
    expect_tip(way, t, {30, c * 20 + s * z, c * z - s * 20});
    const Vector axis = way.at(t).axis;
    EXPECT_NEAR(axis[1], s, 1e-12);
    EXPECT_NEAR(axis[2], c, 1e-12);
  }
}

}  // namespace test_move_ways
}  // namespace leadscrew::gouging
