#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/toolpath/builder.hpp>
#include <numbers>

namespace test_builder {

using namespace leadscrew;
using gcode::Move;
using toolpath::Builder;
using toolpath::Piece;

Move line_to(base::AxisVector end, gcode::Feed feed = {gcode::Feed::Mode::units_per_second, 10}) {
  Move move;
  move.end = end;
  move.feed = feed;
  return move;
}

Piece only_piece(const Move& move) {
  Builder builder;
  builder.push(move);
  builder.finish();
  const auto element = builder.pop();
  EXPECT_TRUE(element && std::holds_alternative<Piece>(*element));
  EXPECT_FALSE(builder.pop());
  return std::get<Piece>(*element);
}

TEST(FeedLength, IsThatOfTheToolTipWhereItMoves) {
  EXPECT_DOUBLE_EQ(toolpath::feed_length(line_to({3, 4, 0, 90, 0, 0, 7, 0, 0})), 5);
}

TEST(FeedLength, IsThatOfTheSecondaryAxesWhereTheTipStands) {
  EXPECT_DOUBLE_EQ(toolpath::feed_length(line_to({0, 0, 0, 90, 0, 0, 6, 8, 0})), 10);
}

TEST(FeedLength, IsInDegreesWhereOnlyRotaryAxesMove) {
  EXPECT_DOUBLE_EQ(toolpath::feed_length(line_to({0, 0, 0, 30, 40, 0, 0, 0, 0})), 50);
}

TEST(Builder, MakesRapidsWithoutAFeed) {
  EXPECT_EQ(only_piece(line_to({1}, {})).feed, INFINITY);
}

TEST(Builder, TurnsInverseTimeIntoSpeed) {
  EXPECT_DOUBLE_EQ(only_piece(line_to({3, 4}, {gcode::Feed::Mode::per_second, 2})).feed, 10);
}

Move blended(Move move) {
  move.path_mode = gcode::PathMode::blend;
  move.tolerance = move.naive_cam_tolerance = 0.01;
  return move;
}

/// 4 mm of arc at 50 mm of radius, in degrees.
const double turned = 4.0 / 50 * 180 / std::numbers::pi;

TEST(Builder, TellsMovesByTheSpaceOfTolerancesWhereRotaryAxesMoveBesides) {
  for (const Move& move : {line_to({3, 0, 0, turned}), blended(line_to({3, 0, 0, turned}))}) {
    const Piece line = only_piece(move);
    EXPECT_DOUBLE_EQ(geometry::length(line.curve), 5);
    EXPECT_DOUBLE_EQ(line.feed, 10);
    EXPECT_DOUBLE_EQ(line.greatest_speed(1, geometry::jets(line.curve, 1)), 10 * 5.0 / 3);
  }

  Move helix = blended(line_to({0, 2 * 2 / std::numbers::pi, 0, turned}));
  helix.kind = Move::Kind::arc;
  helix.center_second = 2 / std::numbers::pi;  // half a turn is 2 mm
  helix.turns = 1;
  EXPECT_DOUBLE_EQ(geometry::length(only_piece(helix).curve), std::hypot(2, 4));

  Move curve = blended(line_to({3, 0, 0, turned}));
  curve.kind = Move::Kind::nurbs;
  curve.curve.degree = 1;
  curve.curve.knots = {0, 0, 1, 1};
  curve.curve.points = {{{}, 1}, {curve.end, 1}};
  EXPECT_DOUBLE_EQ(geometry::length(only_piece(curve).curve), 5);
}

TEST(Builder, TellsMovesByFeedWhereOnlyLinearAxesMove) {
  const Piece linear = only_piece(blended(line_to({3, 4})));
  EXPECT_DOUBLE_EQ(geometry::length(linear.curve), 5);
  EXPECT_EQ(linear.feed_axes, toolpath::FeedAxes::none);
}

TEST(Builder, TellsMovesOfRotaryAxesInMillimetresAndTheirFeedInDegrees) {
  const Piece rotary = only_piece(blended(line_to({0, 0, 0, turned * 3 / 4, turned})));
  EXPECT_DOUBLE_EQ(geometry::length(rotary.curve), 5);
  EXPECT_DOUBLE_EQ(rotary.greatest_speed(1, geometry::jets(rotary.curve, 1)), 10 * 4 / turned);
}

TEST(Builder, StopsAtNoEarlierMoveForOneThatDoesNotMove) {
  Builder builder;
  builder.push(blended(line_to({1})));
  Move standing = line_to({1});
  standing.start = standing.end;
  standing.path_mode = gcode::PathMode::exact_stop;
  builder.push(standing);
  builder.finish();
  const auto element = builder.pop();
  ASSERT_TRUE(element && std::holds_alternative<Piece>(*element));
  EXPECT_FALSE(std::get<Piece>(*element).stop);
}

TEST(Builder, PassesOverMovesOfNoLength) {
  Builder builder;
  builder.push(line_to({}));
  EXPECT_FALSE(builder.pop());
}

TEST(Builder, KeepsDwellsAndEventsInTheirPlace) {
  Builder builder;
  builder.push(line_to({1}));
  Move dwell;
  dwell.kind = Move::Kind::dwell;
  dwell.start = dwell.end = {1};
  dwell.dwell_seconds = 0.5;
  builder.push(dwell);
  Move event;
  event.kind = Move::Kind::event;
  event.event = {base::Event::Kind::spindle_stop, 0, base::Line{3}};
  builder.push(event);
  EXPECT_TRUE(std::holds_alternative<Piece>(*builder.pop()));
  const auto second = builder.pop();
  ASSERT_TRUE(std::holds_alternative<toolpath::Dwell>(*second));
  EXPECT_EQ(std::get<toolpath::Dwell>(*second).seconds, 0.5);
  EXPECT_EQ(std::get<toolpath::Dwell>(*second).position[0], 1);
  EXPECT_EQ(std::get<base::Event>(*builder.pop()).kind, base::Event::Kind::spindle_stop);
}

Move quarter(gcode::Plane plane) {
  // From 10 on the plane's first axis, counterclockwise to 10 on its second, about the origin, rising by 5.
  Move move;
  move.kind = Move::Kind::arc;
  move.plane = plane;
  move.turns = 1;
  move.start[base::index(first_axis(plane))] = 10;
  move.end[base::index(second_axis(plane))] = 10;
  move.end[base::index(normal_axis(plane))] = 5;
  move.feed = {gcode::Feed::Mode::units_per_second, 10};
  return move;
}

class InEveryPlane : public testing::TestWithParam<gcode::Plane> {};

TEST_P(InEveryPlane, AHelixPassesThroughItsMiddle) {
  const auto plane = GetParam();
  const Piece piece = only_piece(quarter(plane));
  const double length = std::hypot(5 * std::numbers::pi, 5);
  EXPECT_NEAR(geometry::length(piece.curve), length, 1e-12);
  const auto middle = geometry::evaluate(piece.curve, geometry::length(piece.curve) / 2);
  EXPECT_NEAR(middle[base::index(first_axis(plane))], 10 * std::numbers::sqrt2 / 2, 1e-13);
  EXPECT_NEAR(middle[base::index(second_axis(plane))], 10 * std::numbers::sqrt2 / 2, 1e-13);
  EXPECT_NEAR(middle[base::index(normal_axis(plane))], 2.5, 1e-13);
}

TEST_P(InEveryPlane, PlaneAxesAreRightHanded) {
  const auto plane = GetParam();
  const int a = static_cast<int>(base::index(first_axis(plane))), b = static_cast<int>(base::index(second_axis(plane))),
            c = static_cast<int>(base::index(normal_axis(plane)));
  EXPECT_EQ((a + 1) % 3, b);
  EXPECT_EQ((b + 1) % 3, c);
}

INSTANTIATE_TEST_SUITE_P(Planes, InEveryPlane, testing::Values(gcode::Plane::XY, gcode::Plane::ZX, gcode::Plane::YZ));

std::vector<Piece> pieces(const Move& move) {
  Builder builder;
  builder.push(move);
  builder.finish();
  std::vector<Piece> pieces;
  while (const auto element = builder.pop()) pieces.push_back(std::get<Piece>(*element));
  return pieces;
}

Move corner_of_splines() {
  // Two straight cubics, 3 and 4 long, at a right angle.
  Move move;
  move.kind = Move::Kind::nurbs;
  move.line = base::Line{7};
  move.feed = {gcode::Feed::Mode::units_per_second, 10};
  move.curve.degree = 3;
  move.curve.knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 4}}) {
    move.curve.points.push_back({{static_cast<double>(x), static_cast<double>(y)}, 1});
  }
  move.start = move.curve.points.front().position;
  move.end = move.curve.points.back().position;
  return move;
}

TEST(Builder, CutsASplineIntoSmoothPieces) {
  const Move move = corner_of_splines();
  const std::vector<Piece> made = pieces(move);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(geometry::start(made[0].curve), move.start);
  EXPECT_EQ(geometry::end(made[0].curve), geometry::start(made[1].curve));
  EXPECT_EQ(geometry::end(made[1].curve), move.end);
  for (const Piece& piece : made) {
    EXPECT_EQ(piece.feed, 10);
    EXPECT_EQ(piece.line, base::Line{7});
  }
}

TEST(FeedLength, OfASplineIsThatOfAllItsPieces) {
  EXPECT_NEAR(toolpath::feed_length(corner_of_splines()), 7, 1e-12);
}

TEST(Builder, TurnsInverseTimeOfASplineIntoSpeedAlongTheWhole) {
  Move move = corner_of_splines();
  move.feed = {gcode::Feed::Mode::per_second, 2};
  for (const Piece& piece : pieces(move)) EXPECT_NEAR(piece.feed, 14, 1e-12);
}

TEST(Builder, PassesOverASplineThatStandsStill) {
  Move move = corner_of_splines();
  for (auto& point : move.curve.points) point.position = {1, 2};
  EXPECT_TRUE(pieces(move).empty());
  EXPECT_EQ(toolpath::feed_length(move), 0);
}

}  // namespace test_builder
