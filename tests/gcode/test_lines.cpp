#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_lines {

using base::Axis;

TEST(Lines, BeginWhereTheLastEnded) {
  Conditions conditions;
  conditions.options.start[0] = 5;
  const std::vector<Move> lines = read_well("G0 Y1\nG1 F60 Z2\nM2\n", conditions).lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(xyz(lines[0].start), (Point{5, 0, 0}));
  EXPECT_EQ(xyz(lines[0].end), (Point{5, 1, 0}));
  EXPECT_EQ(lines[1].start, lines[0].end);
  EXPECT_EQ(xyz(lines[1].end), (Point{5, 1, 2}));
}

TEST(Rapid, HasNoFeed) {
  const Move move = read_well("F60 G0 X1\nM2\n").lines()[0];
  EXPECT_EQ(move.feed.mode, Feed::Mode::rapid);
  EXPECT_EQ(move.feed.value, 0);
}

TEST(Motion, StaysInForce) {
  const std::vector<Move> lines = read_well("G1 X1 F60\nX2\nG0\nX3\nM2\n").lines();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1].feed.mode, Feed::Mode::units_per_second);
  EXPECT_EQ(lines[2].feed.mode, Feed::Mode::rapid);
}

TEST(Lines, OfNoLengthAreNoMoves) {
  EXPECT_EQ(read_well("G0 X0 Y0\nG1 F60 X1\nX1\nG91 X0\nM2\n").lines().size(), 1u);
}

TEST(Lines, TakeAllNineAxes) {
  const Move move = read_well("G0 X1 Y2 Z3 A4 B5 C6 U7 V8 W9\nM2\n").lines()[0];
  EXPECT_EQ(move.end, (base::AxisVector{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Incremental, AddsToThePosition) {
  const std::vector<Move> lines = read_well("G0 X10 Y5\nG91 X1 Z-2\nX1\nG90 X1\nM2\n").lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(xyz(lines[1].end), (Point{11, 5, -2}));
  EXPECT_EQ(xyz(lines[2].end), (Point{12, 5, -2}));
  EXPECT_EQ(xyz(lines[3].end), (Point{1, 5, -2}));
}

TEST(Inches, ScaleLengthsAndLeaveDegrees) {
  const Move move = read_well("G20\nG1 X1 A45 F60\nM2\n").lines()[0];
  EXPECT_EQ(at(move.end, Axis::X), 25.4);
  EXPECT_EQ(at(move.end, Axis::A), 45);
  EXPECT_EQ(move.feed.value, 25.4);
}

TEST(Inches, LeaveDegreesPerMinute) {
  const Move move = read_well("G20\nG1 A90 F360\nM2\n").lines()[0];
  EXPECT_EQ(move.feed.mode, Feed::Mode::units_per_second);
  EXPECT_EQ(move.feed.value, 6);
}

TEST(Inches, DoNotReachBackToTheFeedOfTheirBlock) {
  const Reading reading = read("G20 G1 X1 F60\nM2\n");
  EXPECT_EQ(reading.problems(), "1:11 feed-before-units; ");
  EXPECT_EQ(reading.errors, 0);
  EXPECT_EQ(reading.lines()[0].feed.value, 1);
  EXPECT_EQ(at(reading.lines()[0].end, Axis::X), 25.4);
}

TEST(InverseTime, IsTheReciprocalOfTheDuration) {
  const std::vector<Move> lines = read_well("G93 G1 X10 F30\nX20 F60\nG0 X0\nG94 F60 G1 X1\nM2\n").lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].feed.mode, Feed::Mode::per_second);
  EXPECT_EQ(lines[0].feed.value, 0.5);
  EXPECT_EQ(lines[1].feed.value, 1);
  EXPECT_EQ(lines[2].feed.mode, Feed::Mode::rapid);
  EXPECT_EQ(lines[3].feed.mode, Feed::Mode::units_per_second);
}

TEST(InverseTime, LeavesNoFeedBehind) {
  EXPECT_EQ(read("G93 G1 X1 F6\nG94\nX2\nM2\n").problems(), "3:1 missing-feed; ");
}

TEST(G53, NamesPlacesOfTheMachine) {
  const Reading reading = read_well("G10 L2 P1 X100\nG92 Y5\nG43.1 Z7\nG53 G0 X1 Y2 Z3\nG53 X2\nM2\n");
  ASSERT_EQ(reading.lines().size(), 2u);
  EXPECT_EQ(xyz(reading.lines()[0].end), (Point{1, 2, 3}));
  EXPECT_EQ(xyz(reading.lines()[1].end), (Point{2, 2, 3}));
}

TEST(G80, EndsMotion) {
  EXPECT_EQ(read("G0 X1\nG80\nX2\nM2\n").problems(), "3:1 axis-without-motion; ");
}

}  // namespace test_lines
}  // namespace leadscrew::gcode
