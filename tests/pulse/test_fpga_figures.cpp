#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <vector>

#include "tracing.hpp"

// "FPGA-based implementation of circular interpolation": its comparison on the arc of radius 5 from (5, 0) to (0, 5),
// and its equations for the first quadrant.

namespace leadscrew::pulse::testing {
namespace test_fpga_figures {

constexpr Arc quarter{{5, 0}, {0, 5}, Direction::counterclockwise};

TEST(FpgaTable1, PointComparisonTakes10StepsAndErrs0877) {
  const Trace found = trace_arc(CircularSearch<Search::point_comparison>(quarter), quarter);
  EXPECT_TRUE(found.ends);
  EXPECT_EQ(found.clocks, 10);
  EXPECT_NEAR(found.worst, 0.877, 5e-4);
  // As its text says, with F = 0 inward, it would be 1.
  EXPECT_NEAR(trace_arc(CircularSearch<Search::point_comparison, OnCircle::inward>(quarter), quarter).worst, 1, 1e-12);
}

void expect_7_steps_and_0385(const Trace& found) {
  EXPECT_TRUE(found.ends);
  EXPECT_EQ(found.clocks, 7);
  EXPECT_NEAR(found.worst, 0.385, 5e-4);
}

TEST(FpgaTable1, LeastErrorTakes7StepsAndErrs0385) {
  expect_7_steps_and_0385(trace_arc(CircularSearch<Search::least_error>(quarter), quarter));
}

TEST(FpgaTable1, ImprovedLeastErrorTakes7StepsAndErrs0385) {
  expect_7_steps_and_0385(trace_arc(CircularSearch<Search::improved_least_error>(quarter), quarter));
}

TEST(FpgaTable1, DdaTakes8ClocksAndErrs0385) {
  const Trace found = trace_arc(CircularDda(quarter, {Order::parallel, Preload::half_lagging}), quarter);
  EXPECT_TRUE(found.ends);
  EXPECT_EQ(found.clocks, 8);
  EXPECT_EQ(found.pulses, 7);
  EXPECT_NEAR(found.worst, 0.385, 5e-4);
}

constexpr bool ends_at_compile_time(CircularSearch<Search::least_error> state) {
  while (!state.done()) state.step();
  return state.at() == quarter.end;
}
static_assert(ends_at_compile_time(CircularSearch<Search::least_error>(quarter)));

/// The least error of any path of so many pulses from (5, 0) to (0, 5), each a step of the quadrant.
double best_error(Point at, int pulses) {
  if (pulses == 0) return at == quarter.end ? 0 : INFINITY;
  double best = INFINITY;
  for (const Point next : {Point{at.x - 1, at.y}, Point{at.x, at.y + 1}, Point{at.x - 1, at.y + 1}}) {
    if (next.x < 0 || next.y > 5) continue;
    const double off = std::abs(std::hypot(static_cast<double>(next.x), static_cast<double>(next.y)) - 5);
    best = std::min(best, std::max(off, best_error(next, pulses - 1)));
  }
  return best;
}

/// So its DDA's 8 steps are clocks.
TEST(FpgaTable1, NoPathOf8PulsesErrsLessThan0528) {
  EXPECT_NEAR(best_error(quarter.start, 8), 0.528, 5e-4);
  EXPECT_NEAR(best_error(quarter.start, 7), 0.385, 5e-4);
}

/// Eqs. 18 to 21, clockwise: what the diagonal step is taken for, faster along y (x > y) and faster along x.
TEST(FpgaEquations18To21, AreTheImprovedMethodClockwise) {
  for (std::int64_t radius = 2; radius <= 60; ++radius) {
    CircularSearch<Search::improved_least_error> arc({{0, radius}, {radius, 0}, Direction::clockwise});
    while (!arc.done()) {
      const auto [x, y] = arc.at();
      const std::int64_t f = x * x + y * y - radius * radius;
      const bool both = x > y ? 8 * y - 4 * x - 5 - 4 * f >= 0 : 4 * y - 8 * x - 5 - 4 * f < 0;
      const Pulse<2> one = x > y ? Pulse<2>{{0, -1}} : Pulse<2>{{1, 0}};
      if (x == y) {  // on the diagonal either axis may be the faster one
        arc.step();
        continue;
      }
      ASSERT_EQ(arc.step(), both ? (Pulse<2>{{1, -1}}) : one) << radius << ": " << x << ' ' << y;
    }
  }
}

/// The same counterclockwise where it is steep, |k| > 1: 4x − 8y − 5 − 4F ≤ 0.
TEST(FpgaEquations18To21, AreTheImprovedMethodCounterclockwiseWhereItIsSteep) {
  for (std::int64_t radius = 2; radius <= 60; ++radius) {
    CircularSearch<Search::improved_least_error> arc({{radius, 0}, {0, radius}, Direction::counterclockwise});
    while (arc.at().x > arc.at().y) {
      const auto [x, y] = arc.at();
      const std::int64_t f = x * x + y * y - radius * radius;
      const bool both = 4 * x - 8 * y - 5 - 4 * f <= 0;
      ASSERT_EQ(arc.step(), both ? (Pulse<2>{{-1, 1}}) : (Pulse<2>{{0, 1}})) << radius << ": " << x << ' ' << y;
    }
  }
}

/// .385 BLU: √29 − 5.
TEST(FpgaTable1, LeastErrorIsFarthestAtTwoPlaces) {
  CircularSearch<Search::least_error> arc(quarter);
  std::vector<Point> farthest;
  while (!arc.done()) {
    arc.step();
    const auto [x, y] = arc.at();
    const double error = std::abs(std::hypot(static_cast<double>(x), static_cast<double>(y)) - 5);
    if (error > 0.38) farthest.push_back(arc.at());
  }
  EXPECT_EQ(farthest, (std::vector<Point>{{5, 2}, {2, 5}}));
}

}  // namespace test_fpga_figures
}  // namespace leadscrew::pulse::testing
