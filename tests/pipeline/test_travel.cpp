#include <gtest/gtest.h>

#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <numbers>

// No piece leaves for a cycle that has not been found inside the travel of every axis.

namespace test_travel {

using namespace leadscrew;
using interpolator::Controller;
using toolpath::Piece;

constexpr double most = 500;  // mm, of every axis of the built-in mill

Piece line_to(double x) {
  geometry::Point start{}, end{};
  end[0] = x;
  return {geometry::Line(start, end, std::abs(x)), 100, base::Line{1}};
}

/// Half a turn from X = 480 back to it, that reaches X = 480 + radius between its ends.
Piece half_turn(double radius) {
  geometry::Point start{}, end{};
  start[0] = end[0] = 480;
  start[1] = -radius;
  end[1] = radius;
  const double turn = std::numbers::pi;
  return {geometry::Arc(start, end, 0, 1, 480, 0, turn, geometry::Arc::helix_length(radius, turn, 0)), 100,
          base::Line{1}};
}

std::optional<toolpath::TravelExcess> check(Piece& piece, double slack = 0) {
  return toolpath::check_travel(piece, machine::mill3(), {}, slack);
}

TEST(Travel, MarksPiecesThatLieInsideAndNoOthers) {
  for (Piece piece : {line_to(most), line_to(-most), half_turn(1), half_turn(20)}) {
    EXPECT_FALSE(piece.travel.is_inside());
    EXPECT_FALSE(check(piece));
    EXPECT_TRUE(piece.travel.is_inside());
  }
  for (Piece piece : {line_to(most + 1e-6), line_to(-most - 1e-6), half_turn(20 + 1e-6), line_to(std::nan(""))}) {
    EXPECT_TRUE(check(piece));
    EXPECT_FALSE(piece.travel.is_inside());
  }
}

TEST(Travel, SaysWhichAxisLeavesItAndByHowMuch) {
  Piece beyond = half_turn(30);
  const auto excess = check(beyond);
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->axis, base::Axis::X);
  EXPECT_NEAR(excess->position, 510, 1e-9);
  EXPECT_FALSE(check(beyond, 10 + 1e-6));
}

TEST(Travel, IsAskedOfWholeTurnsToo) {
  geometry::Point start{}, end{};
  start[0] = end[0] = 470;
  end[2] = 5;
  const double turns = 40 * 2 * std::numbers::pi, radius = 16;  // about X = 486: to 502
  Piece helix{geometry::Arc(start, end, 0, 1, 486, 0, turns, geometry::Arc::helix_length(radius, turns, 5)), 100,
              base::Line{1}};
  const auto excess = check(helix);
  ASSERT_TRUE(excess);
  EXPECT_NEAR(excess->position, 502, 1e-6);
}

/// A chunk as the planner makes it, of a path that nobody has checked.
planner::Chunk unchecked_chunk(const machine::Machine& machine) {
  planner::Planner planner(machine, {});
  planner.push(line_to(9999));
  planner.finish();
  return *planner.pop();
}

TEST(Travel, UncheckedIsRefusedByTheControllerAndNothingMoves) {
  const machine::Machine machine = machine::mill3();
  Controller controller(machine.period, {});
  planner::Chunk chunk = unchecked_chunk(machine);
  EXPECT_EQ(controller.offer(chunk), Controller::Offer::unchecked);
  for (int word = 0; word < 100; ++word) ASSERT_EQ(controller.next().position, base::AxisVector{});
  EXPECT_EQ(controller.begun(), 0);
}

TEST(Travel, OfAProgramIsKeptByEveryPieceThatMoves) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::MotionSource source(
      gcode::text_source("G21 G90 G17 F6000 G64 P0.05\nG1 X499.99\nG1 Y10\nG3 X489.99 Y20 I-10\nG1 X500\nY0\nM2\n"),
      machine, tools, {}, nullptr);
  std::size_t pieces = 0;
  while (const std::optional<planner::Chunk> chunk = source.next()) {
    for (const Piece& piece : chunk->pieces) EXPECT_TRUE(piece.travel.is_inside()) << ++pieces;
  }
  EXPECT_FALSE(source.failure());
}

}  // namespace test_travel
