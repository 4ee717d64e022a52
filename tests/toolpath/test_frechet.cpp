#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/toolpath/frechet.hpp>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_frechet {

/// It is that distance: within a little more, and not within a little less.
void expect_distance(const Polyline& a, const Polyline& b, double distance) {
  for (const auto& [p, q] : {std::pair{a, b}, {b, a}}) {
    EXPECT_TRUE(is_frechet_within(p, q, distance * (1 + 1e-12)));
    EXPECT_FALSE(is_frechet_within(p, q, distance * (1 - 1e-9)));
  }
}

Polyline flat(std::initializer_list<std::pair<double, double>> points) {
  Polyline polyline;
  for (const auto& [x, y] : points) polyline.push_back({x, y});
  return polyline;
}

/// One to six points in a plane or in space, of a size.
Polyline random_polyline(std::size_t dimensions, double size) {
  Polyline polyline;
  for (int count = any(1, 7); count > 0; --count) {
    Point point{};
    for (std::size_t i = 0; i < dimensions; ++i) point[i] = uniform(-size, size);
    polyline.push_back(point);
    if (any(0, 8) == 0) polyline.push_back(point);
  }
  return polyline;
}

/// Another, not far from it.
Polyline near(const Polyline& polyline, std::size_t dimensions, double size) {
  Polyline other = subdivided(polyline, uniform(1, 4));
  for (Point& point : other) {
    for (std::size_t i = 0; i < dimensions; ++i) point[i] += uniform(-size, size);
  }
  return other;
}

struct Pair {
  Polyline a, b;
};

Pair random_pair() {
  const std::size_t dimensions = any<std::size_t>(1, 4);
  Pair pair{random_polyline(dimensions, 2), {}};
  pair.b = any(0, 2) == 0 ? random_polyline(dimensions, 2) : near(pair.a, dimensions, logarithmic(1e-2, 1));
  return pair;
}

RC_GTEST_PROP(Frechet, IsThatOfManyPointsWithinTheirStep, ()) {
  const auto [a, b] = random_pair();
  constexpr double step = 0.03;
  const double upper = discrete_frechet(subdivided(a, step), subdivided(b, step));
  RC_ASSERT(is_frechet_within(a, b, upper + 1e-9));
  if (upper > step) RC_ASSERT(!is_frechet_within(a, b, upper - step - 1e-9));
}

RC_GTEST_PROP(Frechet, IsTheSameBothWaysBackwardsAndSubdivided, ()) {
  const auto [a, b] = random_pair();
  double low = 0, high = 20;
  while (high - low > 1e-7) ((is_frechet_within(a, b, (low + high) / 2)) ? high : low) = (low + high) / 2;
  const Polyline back_a(a.rbegin(), a.rend()), back_b(b.rbegin(), b.rend());
  for (const double distance : {low - 1e-6, high + 1e-6}) {
    if (distance < 0) continue;
    const bool is_within = distance > high;
    RC_ASSERT(is_frechet_within(a, b, distance) == is_within);
    RC_ASSERT(is_frechet_within(b, a, distance) == is_within);
    RC_ASSERT(is_frechet_within(back_a, back_b, distance) == is_within);
    RC_ASSERT(is_frechet_within(subdivided(a, 0.3), b, distance) == is_within);
    RC_ASSERT(is_frechet_within(a, subdivided(b, 0.3), distance) == is_within);
  }
}

RC_GTEST_PROP(Frechet, OfAPolylineFromItselfIsNone, ()) {
  const Polyline a = random_polyline(3, 100);
  RC_ASSERT(is_frechet_within(a, a, 0));
}

TEST(Frechet, OfParallelLinesIsTheirDistance) {
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{0, 1}, {10, 1}}), 1);
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{0, 1}, {3, 1}, {4, 1}, {10, 1}}), 1);
}

TEST(Frechet, OfLinesOppositeToOneAnotherIsThatOfTheirEnds) {
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{10, 0}, {0, 0}}), 10);
}

TEST(Frechet, OfAZigzagIsItsHeight) {
  expect_distance(flat({{0, 0}, {8, 0}}), flat({{0, 0}, {1, 1}, {3, -1}, {5, 1}, {7, -1}, {8, 0}}), 1);
}

TEST(Frechet, OfAWayBackIsHalfOfIt) {
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{0, 0}, {7, 0}, {3, 0}, {10, 0}}), 2);
}

TEST(Frechet, OfTwoWaysBackIsMoreThanHausdorffs) {
  // Each point of one is near one of the other, but not in order.
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{0, 0}, {9, 0}, {1, 0}, {10, 0}}), 4);
}

TEST(Frechet, OfASpikeIsItsHeight) {
  expect_distance(flat({{0, 0}, {10, 0}}), flat({{0, 0}, {5, 0}, {5, 3}, {5, 0}, {10, 0}}), 3);
}

TEST(Frechet, OfCutCornersIsTheFarthestPointOfThem) {
  expect_distance(flat({{0, 0}, {10, 0}, {10, 10}}), flat({{0, 0}, {9, 0}, {10, 1}, {10, 10}}), std::sqrt(0.5));
}

TEST(Frechet, OfAPointIsThatOfTheFarthest) {
  expect_distance(flat({{0, 0}}), flat({{3, 4}}), 5);
  expect_distance(flat({{0, 0}}), flat({{1, 0}, {3, 4}, {0, 1}}), 5);
  EXPECT_TRUE(is_frechet_within(flat({{2, 3}}), flat({{2, 3}}), 0));
}

}  // namespace test_frechet
}  // namespace leadscrew::toolpath::testing
