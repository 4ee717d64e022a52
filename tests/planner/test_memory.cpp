// What the planner holds while an endless section streams through it.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <cmath>
#include <planned.hpp>

namespace {

using namespace leadscrew;
using base::Axis;

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

/// A uniform cubic B-spline in six axes, each piece one span of it.
TEST(PlannerMemory, OfCurvesInSixAxesIsBelowTwoMegabytes) {
  machine::Machine machine = machine::mill3();
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e6, 1e6, 100, 2000, 50000, 0.001};
  }
  int first = 0;
  const auto point = [](int k) {
    const double angle = 0.3 * k, wave = 1 + 0.1 * std::sin(1.7 * k);
    geometry::Point p{};
    p[0] = 40 * wave * std::cos(angle), p[1] = 40 * wave * std::sin(angle), p[2] = 3 * std::sin(0.5 * angle);
    for (const std::size_t i : {3, 4, 5}) p[i] = 10 * std::sin(0.7 * angle + static_cast<double>(i));
    return p;
  };
  geometry::Point start{};
  for (std::size_t i = 0; i < start.size(); ++i) start[i] = (point(0)[i] + 4 * point(1)[i] + point(2)[i]) / 6;
  const std::int64_t most = most_memory(machine, start, 1000, [&] {
    geometry::NurbsForm form{3, {}, {}, {1, 1, 1, 1}};
    for (int k = 0; k < 4; ++k) form.points.push_back(point(first + k));
    for (int k = 0; k < 8; ++k) form.knots.push_back(first + k);
    ++first;
    return toolpath::Piece{geometry::smooth_pieces(form).at(0), 50, base::Line{first}};
  });
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

}  // namespace
