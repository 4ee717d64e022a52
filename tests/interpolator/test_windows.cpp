// Motion in chunks that begin and end in motion, through the plain interpolator.

#include <gtest/gtest.h>

#include <mixed_paths.hpp>
#include <motion.hpp>
#include <smooth_words.hpp>

namespace test_windows {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Interpolator;

std::vector<base::Word> words_in_chunks(const std::vector<CutChunk>& cuts, interpolator::StepRule rule) {
  Interpolator cycle(path_period, {});
  cycle.step_by(rule);
  std::vector<base::Word> words;
  for (const CutChunk& cut : cuts) {
    cycle.load(cut.chunk);
    while (!cycle.wants_chunk()) words.push_back(cycle.next());
  }
  return words;
}

TEST(Windows, OfAnyLengthGiveTheWordsOfTheWhole) {
  const Path path = mixed_path();
  const auto whole = words_in_chunks(cut_motion(path, 0, path.length(), path_speed, path_jerk, 100),
                                     interpolator::StepRule::arc_length);
  for (const double seconds : {0.2, 0.03, 0.0017, 0.0002}) {
    const auto parts = words_in_chunks(cut_motion(path, 0, path.length(), path_speed, path_jerk, seconds),
                                       interpolator::StepRule::arc_length);
    ASSERT_NEAR(static_cast<double>(parts.size()), static_cast<double>(whole.size()), 1);
    for (std::size_t n = 0; n < std::min(parts.size(), whole.size()); ++n) {
      for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(parts[n].position[i], whole[n].position[i], 1e-11) << n;
      ASSERT_NEAR(parts[n].path_length, whole[n].path_length, 1e-11) << n;
      ASSERT_NEAR(parts[n].feed, whole[n].feed, 1e-9) << n;
      ASSERT_EQ(parts[n].line, whole[n].line) << n;
    }
  }
}

TEST(Windows, LetParameterStepsGoOn) {
  const Path path = mixed_path();
  for (const auto rule : interpolator::all_step_rules) {
    const auto whole = words_in_chunks(cut_motion(path, 0, path.length(), path_speed, path_jerk, 100), rule);
    const auto parts = words_in_chunks(cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.0217), rule);
    for (std::size_t n = 0; n < std::min(parts.size(), whole.size()); ++n) {
      for (std::size_t i = 0; i < 3; ++i)
        ASSERT_NEAR(parts[n].position[i], whole[n].position[i], 1e-9) << name(rule) << " at " << n;
    }
  }
}

TEST(Windows, LetParameterStepsGoOnBehindATailThatEndedOnTheNextPiece) {
  const Path path = mixed_path();
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.01);
  Interpolator cycle(path_period, {});
  cycle.step_by(interpolator::StepRule::newton);
  double rest = 0;
  for (const CutChunk& cut : cuts) {
    if (path.piece_at(cut.end) != 0) break;
    cycle.load(cut.chunk);
    while (!cycle.wants_chunk()) cycle.next();
    rest = cut.rest;
  }
  ASSERT_EQ(path.piece_at(rest), 1u);
  while (!cycle.at_rest()) cycle.next();
  const auto again = cut_motion(path, rest, path.length(), path_speed, path_jerk, 100);
  cycle.load(again[0].chunk);
  // One long step from the piece's start instead would miss by micrometres.
  for (base::Word word = cycle.next(); !cycle.at_rest(); word = cycle.next()) {
    const geometry::Point there = path.at(word.path_length);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(word.position[i], there[i], 2e-4);
  }
}

TEST(Windows, RunTheirTailWhereNoneFollows) {
  const Path path = mixed_path();
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.04);
  for (std::size_t last = 0; last < cuts.size(); ++last) {
    Interpolator cycle(path_period, {});
    SmoothWords words(path, path_jerk, path_period);
    for (std::size_t k = 0; k <= last; ++k) {
      cycle.load(cuts[k].chunk);
      while (!cycle.wants_chunk()) words.look(cycle.next());
    }
    const bool has_tail = last + 1 < cuts.size();
    EXPECT_EQ(cycle.has_stop_tail_left(), has_tail);
    EXPECT_EQ(cycle.at_rest(), !has_tail);
    EXPECT_FALSE(cycle.stopping());
    cycle.run_stop_tail();
    EXPECT_EQ(cycle.stopping(), has_tail);
    while (!cycle.at_rest()) words.look(cycle.next());
    for (int k = 0; k < 5; ++k) words.look(cycle.next());
    EXPECT_EQ(words.last().position, cuts[last].chunk.rest);
    EXPECT_NEAR(words.last().path_length, cuts[last].rest, 1e-11);
    EXPECT_EQ(words.last().feed, 0);
    EXPECT_LT(words.jerk(), 1 + 1e-5) << last;
    EXPECT_LT(words.aside(), 1e-9) << last;
  }
}

TEST(Windows, RunTheirTailUnasked) {
  const Path path = mixed_path();
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.04);
  Interpolator asked(path_period, {}), unasked(path_period, {});
  asked.load(cuts[3].chunk);
  unasked.load(cuts[3].chunk);
  while (!asked.at_rest()) {
    if (asked.wants_chunk()) asked.run_stop_tail();
    const base::Word expected = asked.next(), word = unasked.next();
    ASSERT_EQ(word.position, expected.position);
    ASSERT_EQ(word.path_length, expected.path_length);
  }
  EXPECT_TRUE(unasked.at_rest());
}

TEST(Windows, MotionAfterWaitingBeginsWithTheNextWord) {
  const Path path = mixed_path();
  const auto first = cut_motion(path, 0, 9, path_speed, path_jerk, 100);
  const auto second = cut_motion(path, 9, path.length(), path_speed, path_jerk, 100);
  Interpolator cycle(path_period, {}), fresh(path_period, first[0].chunk.rest);
  cycle.load(first[0].chunk);
  while (!cycle.at_rest()) cycle.next();
  for (int k = 0; k < 700; ++k) cycle.next();
  cycle.load(second[0].chunk);
  fresh.load(second[0].chunk);
  while (!fresh.wants_chunk()) {
    const base::Word expected = fresh.next(), word = cycle.next();
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(word.position[i], expected.position[i], 1e-13);
  }
  EXPECT_TRUE(cycle.at_rest());
}

TEST(Windows, WithoutWaitingBeginWhereTheOneBeforeEndedInTime) {
  const Path path = mixed_path();
  const auto first = cut_motion(path, 0, 9, path_speed, path_jerk, 100);
  const auto second = cut_motion(path, 9, path.length(), path_speed, path_jerk, 100);
  Interpolator cycle(path_period, {});
  cycle.load(first[0].chunk);
  while (!cycle.wants_chunk()) cycle.next();
  cycle.load(second[0].chunk);
  base::Word word;
  while (!cycle.at_rest()) word = cycle.next();
  const double seconds = first[0].chunk.duration.value() + second[0].chunk.duration.value();
  EXPECT_EQ(base::count(word.tick), static_cast<std::int64_t>(seconds / path_period.seconds()));
}

TEST(Windows, KnowWhetherTheyBeginAtRest) {
  const Path path = mixed_path();
  auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.05);
  EXPECT_TRUE(cuts[0].chunk.begins_at_rest());
  for (std::size_t k = 1; k < cuts.size(); ++k) EXPECT_FALSE(cuts[k].chunk.begins_at_rest()) << k;
  EXPECT_TRUE(dwell({}, 1).begins_at_rest());
  EXPECT_TRUE(planner::Chunk{}.begins_at_rest());
  // To rounding.
  cuts[0].chunk.segments.front().v0 = -7e-15;
  EXPECT_TRUE(cuts[0].chunk.begins_at_rest());
  cuts[0].chunk.segments.front().c2 = 1e-3;
  EXPECT_FALSE(cuts[0].chunk.begins_at_rest());
}

}  // namespace test_windows
