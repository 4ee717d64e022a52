#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_drill_cycles {

struct Step {
  bool feeds;
  Point end;
  friend bool operator==(const Step&, const Step&) = default;
};
std::ostream& operator<<(std::ostream& out, const Step& s) {
  return out << (s.feeds ? "feed " : "rapid ") << s.end;
}

std::vector<Step> steps(std::string_view text) {
  std::vector<Step> result;
  for (const Move& move : read_well(text).lines()) {
    result.push_back({move.feed.mode != Feed::Mode::rapid, xyz(move.end)});
  }
  return result;
}

// The first example of NIST IR 6556, 3.5.16.1: absolute, from 1,2,3 to a hole at 4,5 with R2.8 and the bottom at 1.5.
TEST(G81, DrillsAbsolute) {
  EXPECT_EQ(
      steps("G0 X1 Y2 Z3\nG90 G81 G98 X4 Y5 Z1.5 R2.8 F60\nM2\n"),
      (std::vector<Step>{
          {false, {1, 2, 3}}, {false, {4, 5, 3}}, {false, {4, 5, 2.8}}, {true, {4, 5, 1.5}}, {false, {4, 5, 3}}}));
}

// The second: incremental, three holes.
TEST(G81, DrillsIncrementalHolesInARow) {
  const std::vector<Step> found = steps("G0 X1 Y2 Z3\nG91 G81 G98 X4 Y5 Z-0.6 R1.8 L3 F60\nM2\n");
  EXPECT_EQ(found, (std::vector<Step>{{false, {1, 2, 3}},
                                      {false, {1, 2, 4.8}},
                                      {false, {5, 7, 4.8}},
                                      {true, {5, 7, 4.8 - 0.6}},
                                      {false, {5, 7, 4.8}},
                                      {false, {9, 12, 4.8}},
                                      {true, {9, 12, 4.8 - 0.6}},
                                      {false, {9, 12, 4.8}},
                                      {false, {13, 17, 4.8}},
                                      {true, {13, 17, 4.8 - 0.6}},
                                      {false, {13, 17, 4.8}}}));
}

TEST(G98, ReturnsToTheInitialLevelAndG99ToR) {
  EXPECT_EQ(steps("G0 Z10\nG98 G81 X1 Z-1 R2 F60\nX2\nM2\n"), (std::vector<Step>{{false, {0, 0, 10}},
                                                                                 {false, {1, 0, 10}},
                                                                                 {false, {1, 0, 2}},
                                                                                 {true, {1, 0, -1}},
                                                                                 {false, {1, 0, 10}},
                                                                                 {false, {2, 0, 10}},
                                                                                 {false, {2, 0, 2}},
                                                                                 {true, {2, 0, -1}},
                                                                                 {false, {2, 0, 10}}}));
  EXPECT_EQ(steps("G0 Z10\nG99 G81 X1 Z-1 R2 F60\nX2\nM2\n"), (std::vector<Step>{{false, {0, 0, 10}},
                                                                                 {false, {1, 0, 10}},
                                                                                 {false, {1, 0, 2}},
                                                                                 {true, {1, 0, -1}},
                                                                                 {false, {1, 0, 2}},
                                                                                 {false, {2, 0, 2}},
                                                                                 {true, {2, 0, -1}},
                                                                                 {false, {2, 0, 2}}}));
}

TEST(G98, RemembersTheLevelBeforeTheFirstOfARowOfCycles) {
  const std::vector<Step> found = steps("G0 Z10\nG99 G81 X1 Z-1 R2 F60\nG98 X2\nM2\n");
  EXPECT_EQ(found.back(), (Step{false, {2, 0, 10}}));
}

TEST(G82, DwellsAtTheBottom) {
  const Reading reading = read_well("G82 X1 Z-1 R1 P0.5 F60\nX2\nM2\n");
  const std::vector<Move> dwells = reading.of(Move::Kind::dwell);
  ASSERT_EQ(dwells.size(), 2u);
  EXPECT_EQ(dwells[0].dwell_seconds, 0.5);
  EXPECT_EQ(xyz(dwells[0].start), (Point{1, 0, -1}));
  EXPECT_EQ(xyz(dwells[1].end), (Point{2, 0, -1}));
}

TEST(G83, PecksAndComesBackForMore) {
  EXPECT_EQ(steps("G0 Z1\nG83 X0 Z-2.5 R1 Q1.5 F60\nM2\n"), (std::vector<Step>{{false, {0, 0, 1}},
                                                                               {true, {0, 0, -0.5}},
                                                                               {false, {0, 0, 1}},
                                                                               {false, {0, 0, -0.5 + 0.254}},
                                                                               {true, {0, 0, -2}},
                                                                               {false, {0, 0, 1}},
                                                                               {false, {0, 0, -2 + 0.254}},
                                                                               {true, {0, 0, -2.5}},
                                                                               {false, {0, 0, 1}}}));
}

TEST(G83, NeverGoesBackAboveR) {
  for (const Step& step : steps("G0 Z1\nG83 X0 Z0 R1 Q0.1 F60\nM2\n")) EXPECT_LE(step.end.z, 1);
}

TEST(Cycles, FeedInMillimetresEvenFromTheBottomOfTheHole) {
  const Reading reading = read_well("G20\nF60\nG0 Z-0.5\nG81 Z-0.5 R0.5\nM2\n");
  EXPECT_EQ(reading.lines()[2].feed.value, 25.4);
}

TEST(G85, FeedsOutOfTheHole) {
  EXPECT_EQ(steps("G0 Z1\nG85 X3 Z-1 R1 F60\nM2\n"),
            (std::vector<Step>{{false, {0, 0, 1}}, {false, {3, 0, 1}}, {true, {3, 0, -1}}, {true, {3, 0, 1}}}));
}

// NIST IR 6556, 3.5.16.5: "retract the Z-axis at the current feed rate to clear Z", which is R in a row of holes;
// LinuxCNC 2.9 feeds to R under G98 too, and is rapid from there.
TEST(G85, FeedsToRAndIsRapidFromThere) {
  EXPECT_EQ(steps("G0 Z9\nG98 G85 X3 Z-1 R1 F60\nM2\n"), (std::vector<Step>{{false, {0, 0, 9}},
                                                                            {false, {3, 0, 9}},
                                                                            {false, {3, 0, 1}},
                                                                            {true, {3, 0, -1}},
                                                                            {true, {3, 0, 1}},
                                                                            {false, {3, 0, 9}}}));
}

// LinuxCNC 2.9: in G91 R counts from the level at which the series began, however far down the tool has gone since.
TEST(G81, DrillsARowOfIncrementalHolesEquallyDeep) {
  EXPECT_EQ(steps("G21 G90 G99 G0 Z10\nG91 F100\nG81 X10 Z-5 R-2\nX10\nX10\nM2\n"),
            (std::vector<Step>{{false, {0, 0, 10}},
                               {false, {10, 0, 10}},
                               {false, {10, 0, 8}},
                               {true, {10, 0, 3}},
                               {false, {10, 0, 8}},
                               {false, {20, 0, 8}},
                               {true, {20, 0, 3}},
                               {false, {20, 0, 8}},
                               {false, {30, 0, 8}},
                               {true, {30, 0, 3}},
                               {false, {30, 0, 8}}}));
}

TEST(Cycles, KeepTheirNumbersInWhateverUnits) {
  EXPECT_EQ(steps("G20\nG90 G99 F10\nG0 Z1\nG81 Z-1 R0.5\nG21 X4\nM2\n"), (std::vector<Step>{{false, {0, 0, 25.4}},
                                                                                             {false, {0, 0, 12.7}},
                                                                                             {true, {0, 0, -25.4}},
                                                                                             {false, {0, 0, 12.7}},
                                                                                             {false, {4, 0, 12.7}},
                                                                                             {false, {4, 0, 0.5}},
                                                                                             {true, {4, 0, -1}},
                                                                                             {false, {4, 0, 0.5}}}));
}

TEST(Cycles, MayHaveNoDepth) {
  EXPECT_EQ(steps("G0 Z5\nG98 G81 X1 Z-1 R-1 F60\nM2\n"),
            (std::vector<Step>{{false, {0, 0, 5}}, {false, {1, 0, 5}}, {false, {1, 0, -1}}, {false, {1, 0, 5}}}));
}

// Five pecks of 0.3 inch make 1.5 but for the rounding of millimetres: that is no sixth peck.
TEST(G83, MakesNoPeckOfWhatIsRounding) {
  const Reading reading = read_well("G20\nG99 F30\nG0 Z0.5\nG83 Z-1 R0.5 Q0.3\nM2\n");
  EXPECT_EQ(reading.lines().size(), 1 + 4 * 3 + 2);
}

TEST(Cycles, DrillAlongTheNormalOfThePlane) {
  EXPECT_EQ(steps("G18 G81 X3 Z4 Y-5 R1 F60\nM2\n"),
            (std::vector<Step>{{false, {0, 1, 0}}, {false, {3, 1, 4}}, {true, {3, -5, 4}}, {false, {3, 1, 4}}}));
  EXPECT_EQ(steps("G19 G81 Y3 Z4 X-5 R1 F60\nM2\n"),
            (std::vector<Step>{{false, {1, 0, 0}}, {false, {1, 3, 4}}, {true, {-5, 3, 4}}, {false, {1, 3, 4}}}));
}

TEST(Cycles, RepeatInPlaceWhenAbsolute) {
  EXPECT_EQ(steps("G0 Z1\nG81 X3 Z-1 R1 L2 F60\nM2\n").size(), 6u);
}

TEST(Cycles, AreShiftedByOffsets) {
  EXPECT_EQ(steps("G10 L2 P1 X100 Z50\nG81 X3 Z-1 R1 F60\nM2\n")[2], (Step{true, {103, 0, 49}}));
}

TEST(Cycles, ScaleInches) {
  EXPECT_EQ(steps("G20\nF60\nG81 X1 Z-1 R1\nM2\n")[2], (Step{true, {25.4, 0, -25.4}}));
}

TEST(Cycles, NeedNoMemoryForTheirRepeats) {
  const Reading reading = read_well("G91 G81 X0.001 Z-1 R1 L100000 F60\nM2\n");
  EXPECT_EQ(reading.lines().size(), 300'001u);
  EXPECT_NEAR(xyz(reading.lines().back().end).x, 100, 1e-9);
}

TEST(Cycles, ComeBeforeTheStopOfTheirBlock) {
  const Reading reading = read_well("G81 X1 Z-1 R1 F60 M30\n");
  EXPECT_EQ(reading.moves.back().event.kind, base::Event::Kind::program_end);
  EXPECT_EQ(reading.lines().size(), 4u);
}

TEST(Cycles, ForgetTheirLevelsAfterOtherMotion) {
  EXPECT_EQ(read("G81 X1 Z-1 R1 F60\nG0 X0\nG81 X2\nM2\n").problems(), "3:1 missing-word; ");
  EXPECT_EQ(read("G81 X1 Z-1 R1 F60\nG80\nG81 X2 Z-1\nM2\n").problems(), "3:1 missing-word; ");
}

TEST(Cycles, AreCheckedBeforeTheyBegin) {
  EXPECT_EQ(read("G81 X1 Z1 R0.9 F60\nM2\n").problems(), "1:8 cycle-levels; ");
  EXPECT_EQ(read("G81 X1 Z-501 R1 F60\nM2\n").problems(), "1:8 travel; ");
  EXPECT_EQ(read("G91 G81 X100 Z-1 R1 L6 F60\nM2\n").problems(), "1:9 travel; ");
  EXPECT_EQ(read("G82 X1 Z-1 R1 F60\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("G83 X1 Z-1 R1 F60\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("G83 X1 Z-1 R1 Q0 F60\nM2\n").problems(), "1:15 bad-value; ");
  EXPECT_EQ(read("G83 X1 Z-1 R1 Q0.0000001 F60\nM2\n").problems(), "1:15 bad-value; ");
  EXPECT_EQ(read("G81 X1 Z-1 R1 L0 F60\nM2\n").problems(), "1:15 bad-value; ");
  EXPECT_EQ(read("G81 X1 Z-1 R1 L1.5 F60\nM2\n").problems(), "1:15 bad-value; ");
  EXPECT_EQ(read("G81 X1 Z-1 R1 A5 F60\nM2\n").problems(), "1:15 unused-word; ");
  EXPECT_EQ(read("G93 G81 X1 Z-1 R1 F60\nM2\n").problems(), "1:5 bad-feed-mode; ");
  EXPECT_EQ(read("G81 R1 F60\nM2\n").problems(), "1:1 missing-word; ");
}

}  // namespace test_drill_cycles
}  // namespace leadscrew::gcode
