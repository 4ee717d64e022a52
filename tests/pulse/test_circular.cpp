#include <gtest/gtest.h>

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <map>
#include <string>
#include <vector>

#include "tracing.hpp"

// Bounds: of every arc between lattice points of one circle, and of every circle.

namespace leadscrew::pulse::testing {
namespace {

/// Of the three steps that the quadrant allows, by brute force.
TEST(LeastError, TakesTheStepNearestToTheCircle) {
  for (std::int64_t radius = 1; radius <= 60; ++radius) {
    for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
      CircularSearch<Search::least_error> circle({{radius, 0}, {radius, 0}, direction});
      while (!circle.done()) {
        const Point at = circle.at();
        const auto [sx, sy] = tangent(quadrant(at, direction), direction).step;
        const auto off = [&](std::int64_t x, std::int64_t y) { return absolute(x * x + y * y - radius * radius); };
        const std::int64_t least = std::min({off(at.x + sx, at.y), off(at.x, at.y + sy), off(at.x + sx, at.y + sy)});
        circle.step();
        ASSERT_EQ(off(circle.at().x, circle.at().y), least) << radius << ": " << at.x << ' ' << at.y;
        ASSERT_EQ(absolute(circle.deviation()), least);
      }
    }
  }
}

// ---------------------------------------------------------------------------------------------------------------------

struct Method {
  std::string name;
  Trace (*trace)(const Arc&);
  double one_quadrant, more;  ///< greatest errors, BLU
};

template <Search method, OnCircle on_circle = OnCircle::outward>
Trace search(const Arc& arc) {
  return trace_arc(CircularSearch<method, on_circle>(arc), arc);
}
template <Order order, Preload preload, int places = 0>
Trace dda(const Arc& arc) {
  return trace_arc(CircularDda(arc, {order, preload, places}), arc);
}

class OnEveryLatticeArc : public ::testing::TestWithParam<Method> {};

/// All arcs with R² ≤ 900, both ways; the full circle from each point among them.
TEST_P(OnEveryLatticeArc, EndsExactlyAndStaysWithinItsBound) {
  constexpr std::int64_t reach = 30;
  std::map<std::int64_t, std::vector<Point>> circles;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) {
      const std::int64_t n = x * x + y * y;
      if (n > 0 && n <= reach * reach) circles[n].push_back({x, y});
    }
  }
  double one = 0, more = 0;
  std::int64_t arcs = 0, not_ended = 0;
  for (const auto& [n, points] : circles) {
    for (const Point& start : points) {
      for (const Point& end : points) {
        for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
          const Arc arc{start, end, direction};
          const Trace found = GetParam().trace(arc);
          ++arcs;
          not_ended += !found.ends;
          double& worst = borders(arc) == 0 ? one : more;
          worst = std::max(worst, found.worst);
        }
      }
    }
  }
  EXPECT_EQ(arcs, 63328);
  EXPECT_EQ(not_ended, 0);
  EXPECT_LE(one, GetParam().one_quadrant);
  EXPECT_LE(more, GetParam().more);
  RecordProperty("one_quadrant", std::to_string(one));
  RecordProperty("more", std::to_string(more));
}

INSTANTIATE_TEST_SUITE_P(
    Methods, OnEveryLatticeArc,
    ::testing::Values(Method{"PointComparison", search<Search::point_comparison>, 0.9995, 0.9995},
                      Method{"PointComparisonInward", search<Search::point_comparison, OnCircle::inward>, 1, 1},
                      Method{"LeastError", search<Search::least_error>, 0.5, 0.5},
                      Method{"ImprovedLeastError", search<Search::improved_least_error>, 0.5,
                             0.586},  // .586 at R² = 2 alone
                      Method{"ParallelEmpty", dda<Order::parallel, Preload::none>, 1.55, 2.04},
                      Method{"ParallelHalf", dda<Order::parallel, Preload::half>, 1.16, 1.65},
                      Method{"ParallelHalfLagging", dda<Order::parallel, Preload::half_lagging>, 1.14, 1.62},
                      Method{"ParallelFull", dda<Order::parallel, Preload::full>, 0.95, 1.42},
                      Method{"XFirstEmpty", dda<Order::x_first, Preload::none>, 1.45, 1.92},
                      Method{"XFirstHalf", dda<Order::x_first, Preload::half>, 0.94, 1.43},
                      Method{"XFirstHalfWide", dda<Order::x_first, Preload::half, 8>, 0.94, 1.43},
                      Method{"ShrinkingFirstEmpty", dda<Order::shrinking_first, Preload::none>, 1.45, 1.92},
                      Method{"ShrinkingFirstHalf", dda<Order::shrinking_first, Preload::half>, 0.94, 1.43},
                      Method{"GrowingFirstEmpty", dda<Order::growing_first, Preload::none>, 0.97, 1.28},
                      Method{"GrowingFirstHalf", dda<Order::growing_first, Preload::half>, 0.94, 1.43},
                      Method{"GrowingFirstHalfWide", dda<Order::growing_first, Preload::half, 8>, 0.94, 1.43}),
    [](const auto& test) { return test.param.name; });

// ---------------------------------------------------------------------------------------------------------------------

struct CircleBound {
  std::string name;
  Trace (*trace)(const Arc&);
  double worst;              ///< on full circles, BLU
  double clocks_per_radius;  ///< about
};

class OnEveryCircle : public ::testing::TestWithParam<CircleBound> {
 protected:
  void run_to(std::int64_t greatest) const {
    double worst = 0;
    for (std::int64_t radius = 1; radius <= greatest; ++radius) {
      const Trace found = GetParam().trace({{radius, 0}, {radius, 0}, Direction::counterclockwise});
      ASSERT_TRUE(found.ends) << radius;
      worst = std::max(worst, found.worst);
      const double expected = GetParam().clocks_per_radius * static_cast<double>(radius);
      ASSERT_NEAR(static_cast<double>(found.clocks), expected, 0.001 * expected + 8) << radius;
    }
    EXPECT_LE(worst, GetParam().worst);
  }
};
class LongOnEveryCircle : public OnEveryCircle {};

TEST_P(OnEveryCircle, EndsWhereItBeganAndStaysWithinItsBound) {
  run_to(300);
}
TEST_P(LongOnEveryCircle, EndsWhereItBeganAndStaysWithinItsBound) {
  run_to(4096);
}

const auto circle_bounds =
    ::testing::Values(CircleBound{"PointComparison", search<Search::point_comparison>, 1, 8},
                      CircleBound{"PointComparisonInward", search<Search::point_comparison, OnCircle::inward>, 1, 8},
                      CircleBound{"LeastError", search<Search::least_error>, 0.5, 5.65685},
                      CircleBound{"ImprovedLeastError", search<Search::improved_least_error>, 0.5, 5.65685},
                      CircleBound{"ParallelEmpty", dda<Order::parallel, Preload::none>, 1.8026, 6.28319},
                      CircleBound{"ParallelHalf", dda<Order::parallel, Preload::half>, 1.2951, 6.28319},
                      CircleBound{"ParallelFull", dda<Order::parallel, Preload::full>, 0.99976, 6.28319},
                      CircleBound{"ParallelHalfLagging", dda<Order::parallel, Preload::half_lagging>, 1.32, 6.28319},
                      CircleBound{"XFirstEmpty", dda<Order::x_first, Preload::none>, 1.4676, 6.28319},
                      CircleBound{"XFirstHalf", dda<Order::x_first, Preload::half>, 0.9656, 6.28319},
                      CircleBound{"ShrinkingFirstHalf", dda<Order::shrinking_first, Preload::half>, 0.9505, 6.28319},
                      CircleBound{"GrowingFirstEmpty", dda<Order::growing_first, Preload::none>, 1.0225, 6.28319},
                      CircleBound{"GrowingFirstHalf", dda<Order::growing_first, Preload::half>, 0.9656, 6.28319});
const auto name_of_bound = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Methods, OnEveryCircle, circle_bounds, name_of_bound);
INSTANTIATE_TEST_SUITE_P(LongMethods, LongOnEveryCircle, circle_bounds, name_of_bound);

/// The end is off the circle by up to half a BLU: reached all the same.
TEST(CircularEnds, AreReachedWhereTheyAreOffTheCircle) {
  double worst = 0;
  std::int64_t arcs = 0;
  for (std::int64_t x = -21; x <= 21; ++x) {
    for (std::int64_t y = -21; y <= 21; ++y) {
      if (std::abs(std::hypot(double(x), double(y)) - 20) > 0.5) continue;
      for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
        const Arc arc{{12, 16}, {x, y}, direction};
        for (const Trace& found : {search<Search::point_comparison>(arc), search<Search::least_error>(arc),
                                   search<Search::improved_least_error>(arc)}) {
          EXPECT_TRUE(found.ends) << x << ' ' << y;
          worst = std::max(worst, found.worst);
        }
        EXPECT_TRUE(trace_arc(CircularDda(arc), arc).ends) << x << ' ' << y;
        EXPECT_TRUE(trace_arc(CircularDda(arc, {Order::parallel, Preload::none}), arc).ends) << x << ' ' << y;
        ++arcs;
      }
    }
  }
  EXPECT_GT(arcs, 200);
  EXPECT_LE(worst, 1.5);
}

}  // namespace
}  // namespace leadscrew::pulse::testing
