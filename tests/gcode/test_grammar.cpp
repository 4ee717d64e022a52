#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_grammar {

TEST(Words, StandInAnyOrderAndCase) {
  for (const char* text : {"G1 X1 Y2 F60", "f60y2x1g1", "X1 F60 G01 Y2", "x1\tg1 F60 y2\r", "N10 X1 Y2 G1 F60"}) {
    const Reading reading = read_well(std::string(text) + "\nM2\n");
    ASSERT_EQ(reading.lines().size(), 1u) << text;
    const Move move = reading.lines()[0];
    EXPECT_EQ(xyz(move.end), (Point{1, 2, 0})) << text;
    EXPECT_EQ(move.feed.mode, Feed::Mode::units_per_second);
    EXPECT_EQ(move.feed.value, 1);
  }
}

TEST(Blanks, MayStandAnywhere) {
  const Reading reading = read_well("g 0 x + 0 . 12 3 4 y 7\nM 2\n");
  ASSERT_EQ(reading.lines().size(), 1u);
  EXPECT_EQ(xyz(reading.lines()[0].end), (Point{0.1234, 7, 0}));
}

TEST(Comments, AreNotRead) {
  const Reading reading = read_well("(G0 X9) G0 (MSG, hello) X1 (\xC3\xA9 %) ;Y2 ( \nG0 ; X5\n;\n(DEBUG, #1)\nM2\n");
  ASSERT_EQ(reading.lines().size(), 1u);
  EXPECT_EQ(xyz(reading.lines()[0].end), (Point{1, 0, 0}));
  EXPECT_EQ(reading.blocks, 3);
}

TEST(BlockDelete, SkipsTheBlockWhereAsked) {
  const char* text = " / G0 X1\nG0 Y1\nM2\n";
  Conditions conditions;
  EXPECT_EQ(xyz(read_well(text, conditions).lines().back().end), (Point{0, 1, 0}));
  conditions.options.block_delete = false;
  EXPECT_EQ(xyz(read_well(text, conditions).lines().back().end), (Point{1, 1, 0}));
}

TEST(Percent, DelimitsTheProgram) {
  const Reading reading = read_well("\n \n%\nG0 X1\n%\nG0 X2 ???\n");
  ASSERT_EQ(reading.moves.size(), 2u);
  EXPECT_EQ(xyz(reading.moves[0].end), (Point{1, 0, 0}));
  EXPECT_EQ(reading.moves[1].event.kind, base::Event::Kind::program_end);
  EXPECT_EQ(base::number(reading.moves[1].line), 5);
  EXPECT_TRUE(reading.diagnostics.empty());
}

TEST(Text, MayEndWithoutLineFeed) {
  const Reading reading = read_well("G0 X1\nM2");
  EXPECT_EQ(reading.lines().size(), 1u);
  EXPECT_TRUE(reading.diagnostics.empty());
}

TEST(Text, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(read_well("\xEF\xBB\xBFG0 X1\nM2\n").lines().size(), 1u);
  EXPECT_EQ(read_well("\xEF\xBB\xBF%\nG0 X1\n%\n").lines().size(), 1u);
  EXPECT_EQ(read("\xEF\xBB\xBFG0 X?\nM2\n").problems(), "1:8 bad-number; ");
}

TEST(Moves, CarryTheLineOfTheText) {
  const Reading reading = read_well("\n(remark)\nG0 X1\n\nX2\nM2\n");
  ASSERT_EQ(reading.lines().size(), 2u);
  EXPECT_EQ(base::number(reading.lines()[0].line), 3);
  EXPECT_EQ(base::number(reading.lines()[1].line), 5);
}

TEST(Blocks, AreLinesWithAWord) {
  EXPECT_EQ(read_well("%\n\nN5\n(remark)\nG0\n#1=2\n/G0 X3\n%\n").blocks, 3);
}

}  // namespace test_grammar
}  // namespace leadscrew::gcode
