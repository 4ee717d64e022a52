// Smoothed paths name the lines that they take the place of, and keep their feeds.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "smoothed_programs.hpp"

namespace leadscrew::toolpath::testing {
namespace test_smoother_lines {

RC_GTEST_PROP(Smoother, NamesLinesInOrder, ()) {
  const std::vector<std::int64_t> lines = lines_of(pieces_of(random_program().moves));
  RC_ASSERT(std::is_sorted(lines.begin(), lines.end()));
}

TEST(Smoother, NamesEveryLineOfAWave) {
  for (const double chord : {0.05, 0.3, 1.0}) {
    std::vector<std::int64_t> lines = lines_of(pieces_of(wave(chord, 0.01, 0.01).moves));
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    ASSERT_EQ(lines.size(), 200u) << chord;
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i], static_cast<std::int64_t>(i) + 1);
  }
}

TEST(Smoother, NamesBothLinesOfACorner) {
  Program program;
  program.tolerance = program.cam_tolerance = 0.01;
  program.line_to({10});
  program.line_to({10, 10});
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), 3u);
  const double length = geometry::length(pieces[1].curve);
  EXPECT_EQ(base::number(pieces[1].line_at(0.49 * length)), 1);
  EXPECT_EQ(base::number(pieces[1].line_at(0.51 * length)), 2);
}

/// Lines of 1 mm that are one, up to a corner and from it on: the blend takes the place of some.
TEST(Smoother, NamesEveryLineThatABlendTakesThePlaceOf) {
  Program program;
  program.tolerance = program.cam_tolerance = 1;
  for (int k = 1; k <= 20; ++k) program.line_to({1.0 * k});
  for (int k = 1; k <= 20; ++k) program.line_to({20, 1.0 * k});
  std::vector<std::int64_t> lines = lines_of(pieces_of(program.moves));
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end()));
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  EXPECT_EQ(lines.size(), 40u);
}

/// Each half of the blend at the feed of its line.
TEST(Smoother, ChangesTheFeedInTheMiddleOfACorner) {
  Program program;
  program.tolerance = program.cam_tolerance = 0.1;
  program.line_to({10});
  program.line_to({10, 10});
  program.moves.back().feed.value = 5 * program.moves.front().feed.value;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), 4u);
  EXPECT_EQ(pieces[1].feed, program.moves.front().feed.value);
  EXPECT_EQ(pieces[2].feed, program.moves.back().feed.value);
  EXPECT_EQ(base::number(pieces[1].last_line()), 1);
  EXPECT_EQ(base::number(pieces[2].line), 2);
  EXPECT_NEAR(geometry::length(pieces[1].curve), geometry::length(pieces[2].curve), 1e-6);
  EXPECT_EQ(geometry::end(pieces[1].curve), geometry::start(pieces[2].curve));
}

TEST(Smoother, NamesLinesWhereTheyWereProgrammed) {
  const Program program = wave(0.3, 0.01, 0.01);
  for (const Piece& piece : pieces_of(program.moves)) {
    if (!piece.lines) continue;
    for (const LineMark& mark : *piece.lines) {
      const Point& begin = program.moves[static_cast<std::size_t>(base::number(mark.line)) - 1].start;
      EXPECT_LE(distance(geometry::evaluate(piece.curve, mark.s), begin), 0.01);
    }
  }
}

TEST(Smoother, ChangesTheFeedWhereItWasProgrammed) {
  Program program = wave(0.1, 0.01, 0.01);
  for (Move& move : program.moves) move.feed.value = line_number(move) <= 100 ? 50 : line_number(move) <= 150 ? 80 : 20;
  std::vector<double> feeds;
  const Piece* last = nullptr;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  for (const Piece& piece : pieces) {
    if (last && piece.feed != last->feed) {
      const std::size_t line = piece.feed == 80 ? 101 : 151;
      EXPECT_LE(distance(geometry::start(piece.curve), program.moves[line - 1].start), 0.01);
      EXPECT_EQ(piece.line, program.moves[line - 1].line);
    }
    if (feeds.empty() || feeds.back() != piece.feed) feeds.push_back(piece.feed);
    last = &piece;
  }
  EXPECT_EQ(feeds, (std::vector<double>{50, 80, 20}));
}

/// 0.02 mm at 50 mm/s is 0.4 ms.
TEST(Smoother, HoldsTheLeastOfFeedsThatFollowEachOtherAtOnce) {
  Program program = wave(0.02, 0.01, 0.01);
  const std::vector<Piece> at_one_feed = pieces_of(program.moves);
  for (Move& move : program.moves) move.feed.value = line_number(move) % 2 == 0 ? 49 : 50;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), at_one_feed.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].feed, 49);
    EXPECT_EQ(lines_of({pieces[i]}), lines_of({at_one_feed[i]}));
  }
}

TEST(Smoother, HoldsTheFeedOfAShortLineNoLongerThanSpeedTakesToChange) {
  Program program = wave(0.02, 0.01, 0.01);
  program.moves[99].feed.value = 20;
  double slow = 0;
  for (const Piece& piece : pieces_of(program.moves)) {
    if (piece.feed != 50) {
      EXPECT_EQ(piece.feed, 20);
      slow += geometry::length(piece.curve);
    }
  }
  EXPECT_GE(slow, 0.02 * (1 - 1e-3));
  EXPECT_LE(slow, 0.02 + 0.002 * 20);
}

RC_GTEST_PROP(Smoother, IsNoFasterThanTheLinesItNames, ()) {
  Program program = random_program();
  const int share = any(2, 8);
  for (Move& move : program.moves) move.feed.value = any(0, share) == 0 ? any(1, 40) : 60;
  for (const Piece& piece : pieces_of(program.moves)) {
    for (const std::int64_t line : lines_of({piece}))
      RC_ASSERT(piece.feed <= program.moves[static_cast<std::size_t>(line) - 1].feed.value);
  }
}

}  // namespace test_smoother_lines
}  // namespace leadscrew::toolpath::testing
