// Chunks handed over to the cycle, one thread playing both sides.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/interpolator/controller.hpp>
#include <mixed_paths.hpp>
#include <motion.hpp>
#include <smooth_words.hpp>

namespace test_controller {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Controller;
using Offer = Controller::Offer;

std::vector<CutChunk> cuts_of(const Path& path, double seconds = 0.04) {
  return cut_motion(path, 0, path.length(), path_speed, path_jerk, seconds);
}

Offer offer(Controller& controller, const CutChunk& cut) {
  planner::Chunk chunk = cut.chunk;
  return controller.offer(chunk);
}

/// Words until all has come to rest, and that one at rest.
void run_out(Controller& controller, SmoothWords& words) {
  for (int n = 0; n < 100000; ++n) {
    words.look(controller.next());
    if (controller.idle()) return;
  }
  FAIL() << "does not come to rest";
}

RC_GTEST_PROP(Handover, GivesTheWordsOfThePlainInterpolatorBitForBit, ()) {
  const Path path = mixed_path();
  const bool is_short = *rc::gen::element(false, true);
  const std::size_t capacity = *rc::gen::element<std::size_t>(2, 3, 8, 100);
  // As long as the planner is never behind: with short chunks a period takes more than one.
  RC_PRE(!is_short || capacity >= 8);
  const base::Period period{is_short ? 2'000'000 : *rc::gen::inRange(100, 2001) * 1000LL};
  std::vector<planner::Chunk> chunks;
  for (const CutChunk& cut : cuts_of(path, is_short ? 0.0004 : 0.01)) chunks.push_back(cut.chunk);
  chunks.push_back(dwell(chunks.back().rest, *rc::gen::inRange(0, 100) / 1e3 + (is_short ? 0 : 0.01)));
  if (capacity >= 8) {
    chunks.emplace_back();
    chunks.back().rest = chunks[chunks.size() - 2].rest;
  }
  const auto expected = words(chunks, period);
  Controller controller(period, {}, capacity);
  auto chunk = chunks.begin();
  for (const base::Word& word : expected) {
    while (chunk != chunks.end() && controller.offer(*chunk) == Offer::accepted) ++chunk;
    const base::Word given = controller.next();
    RC_ASSERT(given.tick == word.tick);
    RC_ASSERT(given.position == word.position);
    RC_ASSERT(given.path_length == word.path_length);
    RC_ASSERT(given.feed == word.feed);
    RC_ASSERT(given.line == word.line);
    RC_ASSERT(given.state == word.state);
  }
  RC_ASSERT(chunk == chunks.end());
  RC_ASSERT(controller.idle());
  RC_ASSERT(controller.starvations() == 0);
  RC_ASSERT(controller.begun() == static_cast<std::int64_t>(chunks.size()));
}

TEST(Starvation, AtEveryChunkComesToRestOnThePathAndStartsAgain) {
  const Path path = mixed_path();
  for (const double seconds : {0.04, 0.0037}) {
    const auto cuts = cuts_of(path, seconds);
    for (std::size_t last = 0; last + 1 < cuts.size(); ++last) {
      SCOPED_TRACE(last);
      Controller controller(path_period, {}, cuts.size() + 1);
      SmoothWords words(path, path_jerk, path_period);
      for (std::size_t k = 0; k <= last; ++k) ASSERT_EQ(offer(controller, cuts[k]), Offer::accepted);
      run_out(controller, words);
      EXPECT_EQ(controller.starvations(), 1);
      EXPECT_EQ(words.last().position, cuts[last].chunk.rest);
      EXPECT_EQ(offer(controller, cuts[last + 1]), Offer::late);
      // Anew from rest, to the end.
      const double left = path.length() - cuts[last].rest;
      if (left > 1e-9) {
        for (const CutChunk& cut : cut_motion(path, cuts[last].rest, path.length(), path_speed, path_jerk, 100)) {
          ASSERT_EQ(offer(controller, cut), Offer::accepted);
        }
        run_out(controller, words);
        EXPECT_EQ(words.last().position, path.at(path.length()));
      }
      EXPECT_EQ(words.gaps(), 0);
      EXPECT_LT(words.jerk(), 1 + 1e-5);
      EXPECT_LT(words.aside(), 1e-9);
      EXPECT_EQ(controller.starvations(), 1);
    }
  }
}

TEST(Starvation, RefusesWhatIsLateFromTheFirstWordOfTheTailOn) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  const std::size_t half = cuts.size() / 2;
  Controller controller(path_period, {}, cuts.size() + 1);
  for (std::size_t k = 0; k < half; ++k) ASSERT_EQ(offer(controller, cuts[k]), Offer::accepted);
  while (controller.starvations() == 0) controller.next();
  EXPECT_FALSE(controller.idle());
  planner::Chunk late = cuts[half].chunk;
  while (!controller.idle()) {
    ASSERT_EQ(controller.offer(late), Offer::late);
    ASSERT_EQ(late.segments.size(), cuts[half].chunk.segments.size()) << "moved from";
    controller.next();
  }
  EXPECT_EQ(controller.begun(), static_cast<std::int64_t>(half));
}

TEST(Starvation, KeepsWhatBeginsAtRestUntilTheTailHasRunOut) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  const std::size_t half = cuts.size() / 2;
  const auto again = cut_motion(path, cuts[half].rest, path.length(), path_speed, path_jerk, 0.04);
  Controller controller(path_period, {}, 100);
  SmoothWords words(path, path_jerk, path_period);
  for (std::size_t k = 0; k <= half; ++k) ASSERT_EQ(offer(controller, cuts[k]), Offer::accepted);
  while (controller.starvations() == 0) words.look(controller.next());
  for (const CutChunk& cut : again) ASSERT_EQ(offer(controller, cut), Offer::accepted);
  EXPECT_EQ(controller.begun(), static_cast<std::int64_t>(half + 1));
  run_out(controller, words);
  EXPECT_EQ(words.last().position, path.at(path.length()));
  EXPECT_LT(words.jerk(), 1 + 1e-5);
  EXPECT_LT(words.aside(), 1e-9);
  EXPECT_EQ(controller.starvations(), 1);
}

TEST(Handover, StopsByTheTailWhereAStopIsPlanned) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  const std::size_t half = cuts.size() / 2;
  Controller controller(path_period, {}, 100);
  SmoothWords words(path, path_jerk, path_period);
  for (std::size_t k = 0; k <= half; ++k) ASSERT_EQ(offer(controller, cuts[k]), Offer::accepted);
  planner::Chunk standing = dwell(path.at(cuts[half].rest), 0.25);
  ASSERT_EQ(controller.offer(standing), Offer::accepted);
  for (const CutChunk& cut : cut_motion(path, cuts[half].rest, path.length(), path_speed, path_jerk, 0.04))
    ASSERT_EQ(offer(controller, cut), Offer::accepted);
  run_out(controller, words);
  EXPECT_EQ(words.last().position, path.at(path.length()));
  EXPECT_LT(words.jerk(), 1 + 1e-5);
  EXPECT_LT(words.aside(), 1e-9);
  EXPECT_EQ(controller.starvations(), 0);
}

TEST(Handover, IsLateForMotionThatContinuesRest) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  Controller controller(path_period, {});
  EXPECT_EQ(offer(controller, cuts[1]), Offer::late);
  planner::Chunk standing = dwell({}, 1);
  EXPECT_EQ(controller.offer(standing), Offer::accepted);
  EXPECT_EQ(offer(controller, cuts[1]), Offer::late);
  EXPECT_EQ(offer(controller, cuts[0]), Offer::accepted);
  EXPECT_EQ(offer(controller, cuts[1]), Offer::accepted);
}

TEST(Handover, IsFullWhenAllLinksAreInUse) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  for (const std::size_t capacity : {2u, 3u, 5u}) {
    Controller controller(path_period, {}, capacity);
    for (std::size_t k = 0; k + 1 < capacity; ++k) ASSERT_EQ(offer(controller, cuts[k]), Offer::accepted);
    planner::Chunk chunk = cuts[capacity - 1].chunk;
    EXPECT_EQ(controller.offer(chunk), Offer::full);
    EXPECT_EQ(chunk.segments.size(), cuts[capacity - 1].chunk.segments.size()) << "moved from";
    controller.next();
    EXPECT_EQ(controller.offer(chunk), Offer::accepted);
    EXPECT_TRUE(chunk.segments.empty());
  }
}

TEST(Handover, TellsWhatIsAhead) {
  const Path path = mixed_path();
  const auto cuts = cuts_of(path);
  Controller controller(path_period, {}, 100);
  EXPECT_TRUE(controller.idle());
  EXPECT_EQ(controller.seconds_ahead(), 0);
  double ahead = 0;
  for (const CutChunk& cut : cuts) {
    ASSERT_EQ(offer(controller, cut), Offer::accepted);
    ahead += cut.chunk.duration.value();
    EXPECT_NEAR(controller.seconds_ahead(), ahead, 1e-12);
    EXPECT_FALSE(controller.idle());
  }
  controller.next();
  EXPECT_NEAR(controller.seconds_ahead(), ahead - cuts[0].chunk.duration.value(), 1e-12);
  while (!controller.idle()) controller.next();
  EXPECT_EQ(controller.seconds_ahead(), 0);
}

TEST(Handover, IsNotIdleInADwellAndPassesEmptyChunks) {
  Controller controller(path_period, {});
  for (const double seconds : {0.0, 0.0045}) {
    planner::Chunk empty, standing = dwell({}, seconds);
    ASSERT_EQ(controller.offer(empty), Offer::accepted);
    ASSERT_EQ(controller.offer(standing), Offer::accepted);
    EXPECT_FALSE(controller.idle());
  }
  for (int n = 0; n < 5; ++n) {
    controller.next();
    EXPECT_FALSE(controller.idle()) << n;
  }
  EXPECT_EQ(controller.begun(), 4);
  controller.next();
  EXPECT_TRUE(controller.idle());
  EXPECT_EQ(controller.starvations(), 0);
}

TEST(Handover, AfterStandingBeginsWithTheNextWord) {
  const Path path = mixed_path();
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 100);
  Controller controller(path_period, {}, 2);
  for (int n = 0; n < 1000; ++n) controller.next();
  ASSERT_EQ(offer(controller, cuts[0]), Offer::accepted);
  const auto expected = words({cuts[0].chunk}, path_period);
  for (const base::Word& word : expected) {
    const base::Word given = controller.next();
    ASSERT_EQ(base::count(given.tick), base::count(word.tick) + 1000);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(given.position[i], word.position[i], 1e-12);
  }
}

TEST(Handover, PassesThousandsOfTinyChunksAFullRingAtATime) {
  const Path path = mixed_path();
  Controller controller(base::Period{20'000'000}, {}, 8);
  double at = 0;
  int offered = 0, periods = 0;
  while (offered < 5000 || !controller.idle()) {
    while (offered < 5000) {
      const double next = (offered + 1) * 1e-9;
      planner::Chunk chunk = cut_motion(path, at, next, path_speed, path_jerk, 100)[0].chunk;
      if (controller.offer(chunk) != Offer::accepted) break;
      at = next;
      ++offered;
    }
    const std::int64_t before = controller.begun();
    controller.next();
    EXPECT_LE(controller.begun() - before, 7);
    ++periods;
  }
  EXPECT_NEAR(controller.next().path_length, 5000e-9, 1e-15);
  // Every other call finds the machine waiting: there one chunk begins with the word, and seven pass in the next.
  EXPECT_NEAR(periods, 5000 / 4.0, 2);
}

}  // namespace test_controller
