#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <motion.hpp>

namespace test_words {

using namespace leadscrew;
using testing_support::arc_piece;
using testing_support::line_piece;
using testing_support::plan;
using testing_support::words;

rc::Gen<double> coordinates() {
  return rc::gen::map(rc::gen::inRange(-400000, 400001), [](int thousandths) { return thousandths / 1000.0; });
}

/// A path of lines and arcs from the origin, with dwells here and there.
std::vector<toolpath::Element> random_path() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  const int count = *rc::gen::inRange(1, 12);
  for (int k = 0; k < count; ++k) {
    const double feed = *rc::gen::element(INFINITY, 3.0, 20.0, 150.0);
    const int kind = *rc::gen::inRange(0, 5);
    if (kind == 0) {
      path.push_back(toolpath::Dwell{at, *rc::gen::inRange(0, 3000) / 1e4, base::Line{k}});
    } else if (kind == 1) {
      const toolpath::Piece arc = arc_piece(at, at[0] + *rc::gen::inRange(1, 9000) / 1000.0, at[1],
                                            *rc::gen::inRange(1, 7000) / 1000.0, feed, k);
      at = geometry::end(arc.curve);
      path.push_back(arc);
    } else {
      geometry::Point end = at;
      const double step = *rc::gen::element(1e-6, 1e-3, 1.0, 100.0);
      for (int i = 0; i < 3; ++i) end[static_cast<std::size_t>(i)] += *coordinates() / 400 * step;
      if (end == at) continue;
      path.push_back(line_piece(at, end, feed, k));
      at = end;
    }
  }
  return path;
}

geometry::Point end_of(const std::vector<toolpath::Element>& path) {
  geometry::Point end{};
  for (const auto& element : path) {
    if (const auto* piece = std::get_if<toolpath::Piece>(&element)) end = geometry::end(piece->curve);
  }
  return end;
}

const machine::Machine& mill() {
  static const machine::Machine machine = machine::mill3();
  return machine;
}

RC_GTEST_PROP(Words, BeginAtTheStartAndEndAtTheEndExactly, ()) {
  const auto path = random_path();
  const base::Period period{*rc::gen::inRange(200, 20001) * 1000LL};
  const auto train = words(plan(path, mill()), period);
  RC_ASSERT(train.front().position == geometry::Point{});
  RC_ASSERT(train.front().tick == base::Tick{0});
  RC_ASSERT(train.back().position == end_of(path));
  RC_ASSERT(train.back().feed == 0);
}

RC_GTEST_PROP(Words, OfALongPeriodAreThoseOfAShortOneBitForBit, ()) {
  // Nothing is accumulated: a word depends on its instant alone.
  const auto chunks = plan(random_path(), mill());
  const std::size_t factor = *rc::gen::inRange<std::size_t>(2, 20);
  const base::Period fine{*rc::gen::inRange(100, 1000) * 1000LL};
  const base::Period coarse{fine.nanoseconds * static_cast<std::int64_t>(factor)};
  RC_PRE(base::is_valid(coarse));
  const auto many = words(chunks, fine), few = words(chunks, coarse);
  for (std::size_t n = 0; n < few.size(); ++n) {
    const auto& at_same_time = many[std::min(n * factor, many.size() - 1)];
    RC_ASSERT(few[n].position == at_same_time.position);
    RC_ASSERT(few[n].path_length == at_same_time.path_length);
  }
}

RC_GTEST_PROP(Words, TakeTheTimeOfThePlan, ()) {
  const auto chunks = plan(random_path(), mill());
  const base::Period period{*rc::gen::inRange(100, 20001) * 1000LL};
  double duration = 0;
  for (const auto& chunk : chunks) duration += chunk.duration.value();
  const auto train = words(chunks, period);
  const double last = base::seconds(train.back().tick, period);
  RC_ASSERT(last >= duration - 1e-12);
  RC_ASSERT(last < duration + period.seconds() + 1e-12);
}

/// The position along a rest-to-rest line in extended precision, phase after phase.
long double extended(const planner::Chunk& chunk, long double t) {
  long double s = 0, v = 0, a = 0;
  for (const auto& segment : chunk.segments) {
    const long double duration = static_cast<long double>(segment.duration.hi) + segment.duration.lo;
    const long double j = 6.0L * segment.c3, tau = std::min(t, duration);
    a = 2.0L * segment.c2;
    s += tau * (v + tau * (a / 2 + tau * j / 6));
    v += tau * (a + tau * j / 2);
    t -= tau;
    if (t <= 0) break;
  }
  return s;
}

TEST(Words, MatchExtendedPrecisionToAUnitInTheLastPlace) {
  geometry::Point end{};
  end[0] = 300;
  end[1] = 17.25;
  const auto path = line_piece({}, end, 80);
  const auto chunks = plan({path}, mill());
  const base::Period period{10'000};
  const double length = geometry::length(path.curve);
  for (const auto& word : words(chunks, period)) {
    const long double t = static_cast<long double>(base::count(word.tick) * period.nanoseconds) / 1e9L;
    const long double s = extended(chunks[0], t);
    ASSERT_NEAR(word.position[0], static_cast<double>(300 * (s / length)), 5.7e-14) << base::count(word.tick);
    ASSERT_NEAR(word.position[1], static_cast<double>(17.25L * (s / length)), 3.6e-15) << base::count(word.tick);
  }
}

TEST(Words, KeepJerkAtTheShortestPeriodWhereRoundingWouldShow) {
  // At T = 10 µs one unit in the last place of 10 mm is 1.8 mm/s³ of apparent jerk, eight are the bound that a judge
  // allows.
  const toolpath::Piece there = arc_piece({}, 10, 0, 6.0, 60);
  const toolpath::Piece back = arc_piece(geometry::end(there.curve), 10, 0, -6.0, 60);
  const auto chunks = plan({there, back}, mill());
  const base::Period period{10'000};
  const auto train = words(chunks, period);
  const double T = period.seconds(), bound = 8 * 3.6e-15 / (T * T * T);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t n = 3; n < train.size(); ++n) {
      const double third = train[n].position[axis] - 3 * train[n - 1].position[axis] + 3 * train[n - 2].position[axis] -
                           train[n - 3].position[axis];
      ASSERT_LE(std::abs(third) / (T * T * T), 20000 * 1.001 + bound);
    }
  }
}

TEST(Words, PassThroughThousandsOfTinyBlocksInOnePeriod) {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 5000; ++k) {
    geometry::Point next = at;
    next[0] = k * 1e-12;
    toolpath::Piece piece = line_piece(at, next, 50, k);
    piece.stop = true;
    path.push_back(piece);
    at = next;
  }
  const auto train = words(plan(path, mill()), base::Period{20'000'000});
  EXPECT_EQ(train.back().position[0], 5000 * 1e-12);
  const double duration = 5000 * 4 * std::cbrt(1e-12 / (2 * 20000.0));
  EXPECT_EQ(train.size(), 1 + static_cast<std::size_t>(std::ceil(duration / 0.02)));
}

TEST(Words, StandStillInADwellAndCarryItsLine) {
  geometry::Point end{};
  end[0] = 1;
  const auto train =
      words(plan({line_piece({}, end, 50, 1), toolpath::Dwell{end, 0.5, base::Line{2}}}, mill()), base::Period{});
  int standing = 0;
  for (const auto& word : train) {
    if (word.state != base::MotionState::rest || word.line != base::Line{2}) continue;
    EXPECT_EQ(word.position, end);
    ++standing;
  }
  EXPECT_NEAR(standing, 500, 1);
}

TEST(Words, OfAnEmptyPlanAreOneWordAtRest) {
  const auto train = words({}, base::Period{});
  ASSERT_EQ(train.size(), 1u);
  EXPECT_EQ(train[0].position, geometry::Point{});
}

}  // namespace test_words
