// Many words in one call beside the same words one by one.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <leadscrew/interpolator/interpolator.hpp>
#include <mixed_paths.hpp>
#include <motion.hpp>
#include <random>
#include <vector>

namespace test_many_words {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Interpolator;
using interpolator::Kernel;

/// Everything of a word as whole numbers: −0 is not 0 here.
std::array<std::uint64_t, base::axis_count + 6> bits(const base::Word& word) {
  std::array<std::uint64_t, base::axis_count + 6> bits{};
  std::size_t k = 0;
  for (const double position : word.position) bits[k++] = std::bit_cast<std::uint64_t>(position);
  for (const double number : {word.path_length, word.speed, word.feed})
    bits[k++] = std::bit_cast<std::uint64_t>(number);
  bits[k++] = static_cast<std::uint64_t>(word.tick);
  bits[k++] = static_cast<std::uint64_t>(word.line);
  bits[k++] = static_cast<std::uint64_t>(word.state);
  return bits;
}

/// Draws lengths of spans, and whether the next words are asked for one by one.
class Asker {
 public:
  explicit Asker(unsigned seed) : random_(seed) {}

  /// Until the chunk wants another: words of `many`, each as `one` gives it.
  void compare(Interpolator& one, Interpolator& many) {
    while (!many.wants_chunk()) {
      std::vector<base::Word> words(draw(4) == 0 ? 1 : draw(200));
      std::size_t made = words.size();
      if (draw(8) == 0) {
        for (base::Word& word : words) word = many.next();  // past the end too: into the tail, and to rest
      } else {
        made = many.next(words);
        ASSERT_TRUE(made == words.size() || many.wants_chunk());
      }
      for (std::size_t k = 0; k < made; ++k) {
        const bool is_same = bits(words[k]) == bits(one.next());
        if (!is_same) FAIL() << k << " of " << made;
      }
      ASSERT_EQ(one.tick(), many.tick());
      ASSERT_EQ(one.wants_chunk(), many.wants_chunk());
      ASSERT_EQ(one.stopping(), many.stopping());
    }
    ASSERT_EQ(many.next(std::span<base::Word>()), 0u);
  }
  std::size_t draw(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }

 private:
  std::mt19937 random_;
};

/// All chunks, and the tail of the last, by every kernel.
void compare(const std::vector<planner::Chunk>& chunks, base::Period period, unsigned seed, bool runs_tail = false,
             interpolator::StepRule rule = interpolator::StepRule::arc_length) {
  for (const Kernel kernel : interpolator::all_kernels) {
    if (!has(kernel)) continue;
    SCOPED_TRACE(static_cast<int>(kernel));
    Asker asker(seed);
    Interpolator one(period, {}), many(period, {});
    many.use(kernel);
    one.step_by(rule);
    many.step_by(rule);
    for (const planner::Chunk& chunk : chunks) {
      one.load(chunk);
      many.load(chunk);
      ASSERT_NO_FATAL_FAILURE(asker.compare(one, many));
    }
    if (!runs_tail || !many.has_stop_tail_left()) continue;
    one.run_stop_tail();
    many.run_stop_tail();
    ASSERT_NO_FATAL_FAILURE(asker.compare(one, many));
    ASSERT_TRUE(many.at_rest());
  }
}

double coordinate() {
  return *rc::gen::inRange(-400000, 400001) / 1000.0 * *rc::gen::element(1e-6, 1e-3, 1.0);
}

/// Lines of any axes, arcs, helices and curves, dwells between.
std::vector<toolpath::Element> random_path() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  const int count = *rc::gen::inRange(1, 8);
  for (int k = 0; k < count; ++k) {
    const double feed = *rc::gen::element(INFINITY, 3.0, 20.0, 150.0);
    const int kind = *rc::gen::inRange(0, 4);
    if (kind == 0) {
      path.push_back(toolpath::Dwell{at, *rc::gen::inRange(0, 3000) / 1e4, base::Line{k}});
    } else if (kind == 1) {
      const double angle = *rc::gen::element(-1.0, 1.0) * *rc::gen::inRange(1, 9000) / 1000.0;
      toolpath::Piece arc = arc_piece(at, at[0] + *rc::gen::inRange(1, 9000) / 1000.0, at[1], angle, feed, k);
      at = geometry::end(arc.curve);
      path.push_back(std::move(arc));
    } else {
      geometry::Point end = at;
      for (std::size_t i = 0; i < 3; ++i) {
        if (*rc::gen::inRange(0, 3) > 0) end[i] += coordinate();
      }
      if (end == at) continue;
      toolpath::Piece line = line_piece(at, end, feed, k);
      if (*rc::gen::inRange(0, 4) == 0) line.feed_axes = toolpath::FeedAxes::xyz;
      path.push_back(std::move(line));
      at = end;
    }
  }
  return path;
}

RC_GTEST_PROP(ManyWords, AreThoseOfOneByOneBitForBit, ()) {
  const auto path = random_path();
  const base::Period period{*rc::gen::element(50, 100, 1000, 3777, 20000) * 1000LL};
  const auto chunks = plan(path, machine::mill3());
  compare(chunks, period, *rc::gen::arbitrary<unsigned>());
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(ManyWords, AreThoseOfOneByOneInSlicesAndTails, ()) {
  const Path path = *rc::gen::element(0, 1) == 0 ? mixed_path() : stadium();
  const double seconds = *rc::gen::element(0.0004, 0.003, 0.02, 0.3);
  const base::Period period{*rc::gen::element(50, 333, 1000) * 1000LL};
  std::vector<planner::Chunk> chunks;
  for (const CutChunk& cut : cut_motion(path, 0, path.length(), path_speed, path_jerk, seconds))
    chunks.push_back(cut.chunk);
  compare(chunks, period, *rc::gen::arbitrary<unsigned>());
  chunks.resize(*rc::gen::inRange<std::size_t>(1, chunks.size() + 1));
  compare(chunks, period, *rc::gen::arbitrary<unsigned>(), true);
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(ManyWords, AreThoseOfOneByOneWhereFeedIsOverridden, ()) {
  const machine::Machine machine = machine::mill3();
  planner::Planner planner(machine, {});
  planner.slice(*rc::gen::element(0.005, 0.02));
  for (toolpath::Element element : random_path()) {
    if (auto* piece = std::get_if<toolpath::Piece>(&element)) toolpath::check_travel(*piece, machine, {}, 0);
    planner.push(element);
  }
  planner.finish();
  std::vector<planner::Chunk> chunks;
  while (auto chunk = planner.pop()) {
    chunks.push_back(std::move(*chunk));
    if (*rc::gen::inRange(0, 5) == 0) planner.override_feed(*rc::gen::element(0.3, 0.7, 1.0, 1.6));
    if (chunks.size() > 60) break;
  }
  compare(chunks, base::Period{*rc::gen::element(50, 1000) * 1000LL}, *rc::gen::arbitrary<unsigned>());
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(ManyWords, FollowEveryRuleOfSteps) {
  const Path path = mixed_path();
  std::vector<planner::Chunk> chunks;
  for (const CutChunk& cut : cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.02))
    chunks.push_back(cut.chunk);
  for (const auto rule : interpolator::all_step_rules) compare(chunks, path_period, 1, false, rule);
}

/// A chunk of one line from 0 to `length` along X and Z, of one segment.
planner::Chunk one_segment(const planner::Segment& segment, double length) {
  planner::Chunk chunk;
  geometry::Point end{};
  end[0] = length * 0.6;
  end[2] = length * 0.8;
  chunk.pieces.push_back({geometry::Line({}, end, length), 60, base::Line{1}});
  chunk.segments.push_back(segment);
  chunk.duration = segment.duration;
  chunk.rest = end;
  return chunk;
}

TEST(ManyWords, AreThoseOfOneByOneWherePolynomialsAreOfAnyDegreeAndSize) {
  std::mt19937 random(7);
  const auto draw = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  for (int n = 0; n < 1000; ++n) {
    planner::Segment segment;
    segment.duration = draw(0.01, 0.4);
    segment.s0 = draw(0, 1) < 0.3 ? 0.0 : draw(-0.5, 3);
    const auto coefficient = [&](double size) {
      const double kind = draw(0, 1);
      if (kind < 0.35) return kind < 0.05 ? -0.0 : 0.0;
      if (kind < 0.45) return std::ldexp(draw(-1, 1), static_cast<int>(draw(-1070, -180)));
      return draw(-size, size);
    };
    segment.v0 = {coefficient(20), 1e-16 * coefficient(1)};
    segment.c2 = coefficient(50);
    segment.c3 = coefficient(200);
    segment.c4 = coefficient(1000);
    segment.c5 = coefficient(1000);
    ASSERT_NO_FATAL_FAILURE(compare({one_segment(segment, draw(0.5, 5))}, base::Period{100'000}, 3)) << n;
  }
}

TEST(ManyWords, LeaveOutTheStepsThatOneByOneLeavesOut) {
  // c5 τ² + c4 τ + c3 = 0 exactly at τ = 0.25 s and 0.5 s, with c2 = 0.
  planner::Segment segment;
  segment.duration = 1;
  segment.s0 = 0.25;
  segment.v0 = 1;
  segment.c5 = 8;
  segment.c4 = -6;
  segment.c3 = 1;
  compare({one_segment(segment, 100)}, base::Period{1'000'000}, 5);
  compare({one_segment(segment, 100)}, base::Period{15'625'000}, 6);
}

TEST(ManyWords, AreThoseOfOneByOneWhereSegmentsEndOnTicksOrBesideThem) {
  std::mt19937 random(11);
  const auto draw = [&](std::int64_t from, std::int64_t to) {
    return std::uniform_int_distribution<std::int64_t>(from, to)(random);
  };
  for (const std::int64_t nanoseconds : {10'000, 37'000, 1'000'000}) {
    for (int n = 0; n < 50; ++n) {
      planner::Chunk chunk = one_segment({}, 1e6);
      chunk.segments.clear();
      std::int64_t tick = n == 0 ? 300'000 : 1;  // of the end of the rest that motion begins with
      planner::Segment segment;
      segment.state = base::MotionState::rest;
      for (int k = 0; k < 30; ++k) {
        if (k > 0) tick += draw(1, 40);
        const numeric::DoubleDouble end =
            numeric::DoubleDouble(static_cast<double>(tick * nanoseconds)) / numeric::DoubleDouble(1e9) +
            numeric::DoubleDouble(static_cast<double>(draw(-2, 2)) * 1e-18);
        segment.duration = end - segment.begin;
        chunk.segments.push_back(segment);
        segment.state = base::MotionState::constant;
        segment.s0 = static_cast<double>(k + 1) * 100;
        segment.v0 = 1 + static_cast<double>(k);
        segment.begin = end;
      }
      chunk.duration = segment.begin;
      ASSERT_NO_FATAL_FAILURE(compare({chunk}, base::Period{nanoseconds}, 3)) << nanoseconds << " ns, " << n;
    }
  }
}

TEST(ManyWords, OfAFullBlockOfAnySegmentsAreMadeByTheKernel) {
  const geometry::Curve curve = geometry::Line({}, {60, 0, 80}, 100);
  for (const Kernel kernel : interpolator::all_kernels) {
    for (std::size_t words = 1; words <= interpolator::words_in_block && has(kernel); ++words) {
      interpolator::Block block;
      block.curve = &curve;
      block.nanoseconds = block.period = 1e6;
      planner::Segment segment;
      segment.s0 = 1;
      segment.v0 = 50;
      segment.c5 = 1;
      while (block.count < interpolator::words_in_block) {
        ASSERT_TRUE(block.add(segment, 0, std::min(words, interpolator::words_in_block - block.count)));
      }
      ASSERT_TRUE(block.is_in_range());
      std::array<base::Word, interpolator::words_in_block> made;
      EXPECT_TRUE(make_words(kernel, block, made)) << words;
    }
  }
}

/// Of a segment that ends right before the curve does, no vector goes on behind its last word.
TEST(ManyWords, BesideTheEndOfAPieceAreMadeByTheKernel) {
  const geometry::Curve curve = geometry::Line({}, {10, 0, 0}, 10);
  interpolator::Block block;
  block.curve = &curve;
  block.tick = base::Tick{1000};
  block.nanoseconds = 1e9;
  block.period = 1e6;
  planner::Segment segment;
  segment.s0 = 8.8;
  segment.v0 = 500;
  ASSERT_TRUE(block.add(segment, 0.9995, 1));
  segment.s0 = 9.3;
  segment.c2 = -500 / 5.6e-3;
  ASSERT_TRUE(block.add(segment, 1.0005, 3));
  std::array<base::Word, interpolator::words_in_block> made;
  for (const Kernel kernel : interpolator::all_kernels) {
    EXPECT_TRUE(!has(kernel) || make_words(kernel, block, made)) << static_cast<int>(kernel);
  }
}

TEST(ManyWords, TakesNoWordsAtTheEndOfAChunk) {
  Interpolator cycle(path_period, {});
  std::vector<base::Word> words(10);
  EXPECT_EQ(cycle.next(words), 0u);
  EXPECT_EQ(cycle.tick(), base::Tick{0});
}

}  // namespace test_many_words
