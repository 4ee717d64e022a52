// What the planner holds while an endless section streams through it.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <planned.hpp>
#include <six_axes.hpp>

namespace {

using namespace leadscrew;

constexpr std::int64_t two_megabytes = 2'000'000;

/// Pushes pieces as the planner wants them and throws chunks away.
template <typename NextPiece>
std::int64_t most_memory(const machine::Machine& machine, const geometry::Point& start, int pieces, NextPiece next) {
  const std::int64_t before = testing_support::memory_held();
  testing_support::watch_memory();
  planner::Planner planner(machine, start);
  std::int64_t chunks = 0;
  for (int k = 0; k < pieces; ++k) {
    planner.push(next());
    while (planner.pop()) ++chunks;
  }
  planner.finish();
  while (planner.pop()) ++chunks;
  EXPECT_GT(chunks, 2);
  EXPECT_EQ(planner.refused_windows(), 0);
  return testing_support::most_memory_held() - before;
}

TEST(PlannerMemory, OfShortArcsIsBelowTwoMegabytes) {
  const machine::Machine machine = machine::mill3();
  geometry::Point at{10};
  const std::int64_t most = most_memory(machine, at, 20'000, [&] {
    const toolpath::Piece piece = testing_support::arc_piece(at, 0, 0, 0.01, 100);
    at = geometry::end(piece.curve);
    return piece;
  });
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

TEST(PlannerMemory, OfCurvesInSixAxesIsBelowTwoMegabytes) {
  const machine::Machine machine = testing_support::mill_of_six_axes();
  testing_support::CurveInSixAxes curve(50);
  const std::int64_t most = most_memory(machine, curve.start(), 1000, [&] { return curve.next(); });
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

}  // namespace
