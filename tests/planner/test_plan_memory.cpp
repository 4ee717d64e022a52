#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/plan_memory.hpp>
#include <leadscrew/planner/planner.hpp>

#include "random_section.hpp"

// Windows that come again: found wherever on the machine they lie, and nothing but what would have been planned.

namespace test_plan_memory {

using namespace leadscrew;
using planner::Chunk;
using planner::Segment;
using planner::WindowKey;
using testing_support::any;
using testing_support::arc_piece;

std::vector<Chunk> planned(planner::Planner& planner, const std::vector<toolpath::Piece>& pieces) {
  std::vector<Chunk> chunks;
  for (const toolpath::Piece& piece : pieces) {
    planner.push(piece);
    while (auto chunk = planner.pop()) chunks.push_back(std::move(*chunk));
  }
  planner.finish();
  while (auto chunk = planner.pop()) chunks.push_back(std::move(*chunk));
  return chunks;
}

bool same(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  const auto equal = [](numeric::DoubleDouble x, numeric::DoubleDouble y) { return x.hi == y.hi && x.lo == y.lo; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Segment& x, const Segment& y) {
    return equal(x.begin, y.begin) && equal(x.duration, y.duration) && equal(x.s0, y.s0) && equal(x.v0, y.v0) &&
           x.c2 == y.c2 && x.c3 == y.c3 && x.c4 == y.c4 && x.c5 == y.c5 && x.piece == y.piece && x.state == y.state;
  });
}

/// Of chunks one after another, from the first: are they these?
bool begins_with(const std::vector<Chunk>& chunks, std::size_t first, const std::vector<Chunk>& those) {
  if (chunks.size() - first < those.size()) return false;
  return std::equal(
      those.begin(), those.end(), chunks.begin() + static_cast<std::ptrdiff_t>(first),
      [](const Chunk& a, const Chunk& b) { return same(a.segments, b.segments) && same(a.stop_tail, b.stop_tail); });
}

/// Full circles of 1 mm at these depths, with a stop after each.
std::vector<toolpath::Piece> bores(const std::vector<double>& depths) {
  std::vector<toolpath::Piece> pieces;
  for (const double z : depths) {
    pieces.push_back(arc_piece({1, 0, z}, 0, 0, 2 * std::numbers::pi, 100));
    pieces.back().stop = true;
  }
  return pieces;
}

TEST(PlanMemory, FindsACircleThatWasPlannedAtAnotherDepth) {
  const machine::Machine machine = machine::mill3();
  planner::Planner planner(machine, {1});
  const std::vector<Chunk> chunks = planned(planner, bores({0, -1, -2.7}));
  EXPECT_EQ(planner.remembered_windows(), 2);
  ASSERT_EQ(chunks.size(), 3u);
  EXPECT_TRUE(same(chunks[0].segments, chunks[1].segments));
  EXPECT_TRUE(same(chunks[0].segments, chunks[2].segments));
}

TEST(PlanMemory, TakesWhatDiffersInOneBitForAnother) {
  std::vector<toolpath::Piece> pieces = bores({0, 0});
  pieces[1].feed = std::nextafter(pieces[0].feed, 0);
  pieces.push_back(arc_piece({std::nextafter(1.0, 2), 0}, 0, 0, 2 * std::numbers::pi, 100));
  const machine::Machine machine = machine::mill3();
  planner::Planner planner(machine, {1});
  EXPECT_EQ(planned(planner, pieces).size(), 3u);
  EXPECT_EQ(planner.remembered_windows(), 0);
}

TEST(PlanMemory, ForgetsTheOldest) {
  const machine::Machine machine = machine::mill3();
  planner::Planner planner(machine, {1});
  std::vector<toolpath::Piece> pieces;
  const auto add = [&](int number) {
    pieces.push_back(arc_piece({1 + 0.01 * number}, 0, 0, 2 * std::numbers::pi, 100));
    pieces.back().stop = true;
  };
  add(1);
  for (int k = 2; k < 40; ++k) add(k);  // more than are remembered
  add(39);
  EXPECT_EQ(planned(planner, pieces).size(), pieces.size());
  EXPECT_EQ(planner.remembered_windows(), 1);
  add(1);
  planner::Planner other(machine, {1});
  planned(other, pieces);
  EXPECT_EQ(other.remembered_windows(), 1);
}

TEST(PlanMemory, KeyHasEveryNumberOfAWholeSection) {
  toolpath::Piece piece = arc_piece({1}, 0, 0, 3, 100);
  planner::PlannedRange range;
  range.end = geometry::length(piece.curve);
  const auto key = [&](planner::Aim aim = planner::Aim::fastest, std::size_t most = 100) {
    return WindowKey::of(testing_support::section_of({piece}), range, aim, most);
  };
  const std::optional<WindowKey> first = key();
  ASSERT_TRUE(first);
  EXPECT_TRUE(*key() == *first);
  EXPECT_FALSE(*key(planner::Aim::rest) == *first);
  EXPECT_FALSE(*key(planner::Aim::fastest, 101) == *first);
  for (double* number : {&range.feed_factor, &piece.feed, &piece.sagitta}) {
    const double before = *number;
    *number = std::nextafter(before, 9);
    EXPECT_FALSE(*key() == *first);
    *number = before;
  }
  piece.feed_axes = toolpath::FeedAxes::abc;
  EXPECT_FALSE(*key() == *first);
  range.ends_at_rest = false;
  EXPECT_FALSE(key());
  range.ends_at_rest = true;
  range.end /= 2;
  EXPECT_FALSE(key());
}

/// Of what was planned before, nothing is left in what is planned: neither in windows that come again nor in others.
RC_GTEST_PROP(PlanMemory, ChangesNoBit, ()) {
  machine::Machine machine = testing_support::random_machine();
  std::vector<std::vector<toolpath::Piece>> paths(3);
  for (auto& path : paths) {
    path = testing_support::random_path(8);
    testing_support::soften(machine, path, 4);
    path.back().stop = true;
  }
  std::vector<std::vector<Chunk>> alone;
  for (const auto& path : paths) {
    planner::Planner planner(machine, {});
    alone.push_back(planned(planner, path));
  }
  std::vector<std::size_t> order;
  std::vector<toolpath::Piece> pieces;
  for (int k = 0; k < 6; ++k) {
    order.push_back(any<std::size_t>(0, paths.size()));
    pieces.insert(pieces.end(), paths[order.back()].begin(), paths[order.back()].end());
  }
  planner::Planner planner(machine, {});
  const std::vector<Chunk> together = planned(planner, pieces);
  std::size_t first = 0;
  for (const std::size_t path : order) {
    RC_ASSERT(begins_with(together, first, alone[path]));
    first += alone[path].size();
  }
  RC_ASSERT(first == together.size());
}

}  // namespace test_plan_memory
