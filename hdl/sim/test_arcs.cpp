#include <Vby_point_comparison_24.h>
#include <Vby_point_comparison_6.h>
#include <Vby_point_comparison_first.h>
#include <Vdda_24.h>
#include <Vdda_6.h>
#include <Vdda_first.h>
#include <Vimproved_minimum_error_24.h>
#include <Vimproved_minimum_error_6.h>
#include <Vimproved_minimum_error_first.h>
#include <Vminimum_error_24.h>
#include <Vminimum_error_6.h>
#include <Vminimum_error_first.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "arc_bench.hpp"

// Every clock of the paper's four cores is that of pulse/.

namespace leadscrew::hardware {
namespace test_arcs {

using pulse::Arc;
using pulse::Direction;
using pulse::Point;

constexpr std::array both_ways{Direction::clockwise, Direction::counterclockwise};

template <typename Small_, typename Large_, typename First_, typename Reference_>
struct Core {
  using Small = ArcBench<Small_, Reference_>;
  using Large = ArcBench<Large_, Reference_>;
  using First = ArcBench<First_, Reference_>;
};
using ByPointComparison =
    Core<Vby_point_comparison_6, Vby_point_comparison_24, Vby_point_comparison_first, PointComparisonReference>;
using MinimumError = Core<Vminimum_error_6, Vminimum_error_24, Vminimum_error_first, LeastErrorReference>;
using ImprovedMinimumError = Core<Vimproved_minimum_error_6, Vimproved_minimum_error_24, Vimproved_minimum_error_first,
                                  ImprovedLeastErrorReference>;
using Dda = Core<Vdda_6, Vdda_24, Vdda_first, DdaReference>;
using Cores = ::testing::Types<ByPointComparison, MinimumError, ImprovedMinimumError, Dda>;

struct Names {
  template <typename T>
  static std::string GetName(int index) {
    return std::array{"ByPointComparison", "MinimumError", "ImprovedMinimumError",
                      "Dda"}[static_cast<std::size_t>(index)];
  }
};

/// All that a register of 6 bits holds, −32 … 31.
template <typename Take>
void each_arc(const Take& take) {
  for (int start = 0; start < 64 * 64; ++start) {
    for (int end = 0; end < 64 * 64; ++end) {
      for (const Direction direction : both_ways)
        take(Arc{{start / 64 - 32, start % 64 - 32}, {end / 64 - 32, end % 64 - 32}, direction});
    }
  }
}

template <typename T>
class ArcsOfWidth6 : public ::testing::Test {};
TYPED_TEST_SUITE(ArcsOfWidth6, Cores, Names);

/// Those that begin and end on the same circle, the full circle from each point among them.
TYPED_TEST(ArcsOfWidth6, BetweenLatticePointsOfEveryCircleAreThoseOfPulse) {
  typename TypeParam::Small bench(6);
  std::int64_t arcs = 0;
  const auto square = [](Point at) { return at.x * at.x + at.y * at.y; };
  each_arc([&](const Arc& arc) {
    if (square(arc.start) != square(arc.end) || !is_accepted(arc, 6)) return;
    ++arcs;
    const std::string different = bench.follow(arc);
    if (!different.empty()) FAIL() << different;
  });
  EXPECT_EQ(arcs, 57'888);
}

/// Some of those whose end is beside the circle too, and of those that are refused.
TYPED_TEST(ArcsOfWidth6, WithAnyEndAreThoseOfPulseOrRefused) {
  typename TypeParam::Small bench(6);
  std::int64_t accepted = 0;
  each_arc([&](const Arc& arc) {
    const bool is_arc = is_accepted(arc, 6);
    accepted += is_arc;
    const std::string different = is_arc ? bench.follow(arc) : bench.refuse(arc);
    if (!different.empty()) FAIL() << different;
  });
  EXPECT_GT(accepted, 500000);
}

template <typename T>
class ArcsOfWidth24 : public ::testing::Test {};
TYPED_TEST_SUITE(ArcsOfWidth24, Cores, Names);

TYPED_TEST(ArcsOfWidth24, CirclesToRadius100AreThoseOfPulse) {
  typename TypeParam::Large bench(24);
  for (std::int64_t radius = 1; radius <= 100; ++radius) {
    for (const Point start : {Point{radius, 0}, Point{0, radius}, Point{-radius, 0}, Point{0, -radius}}) {
      for (const Direction direction : both_ways) ASSERT_EQ(bench.follow({start, start, direction}), "");
    }
  }
}

TYPED_TEST(ArcsOfWidth24, RandomOnesToRadius100AreThoseOfPulse) {
  typename TypeParam::Large bench(24);
  std::mt19937 random(1980);
  std::uniform_int_distribution<std::int64_t> coordinate(-100, 100);
  std::uniform_real_distribution<double> turn(0, 8 * std::atan(1.0));
  int arcs = 0;
  while (arcs < 3000) {
    const Point start{coordinate(random), coordinate(random)};
    const double radius = std::hypot(static_cast<double>(start.x), static_cast<double>(start.y)), angle = turn(random);
    const Point end{std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))};
    const Arc arc{start, end, both_ways[random() & 1]};
    if (radius > 100 || !is_accepted(arc, 24)) continue;
    ++arcs;
    ASSERT_EQ(bench.follow(arc), "");
  }
}

/// R = 8 388 605, the greatest: the first clocks of quarters, and their ends from near by.
TYPED_TEST(ArcsOfWidth24, AtTheGreatestRadiusAreThoseOfPulse) {
  typename TypeParam::Large bench(24);
  constexpr std::int64_t greatest = (1 << 23) - 3;
  // Short arcs across the axes: an end 2000 BLU beside an axis is 2000²/2R = 0.24 BLU off the circle.
  for (const Direction direction : both_ways) {
    const auto sense = static_cast<std::int64_t>(direction);
    for (const Point start : {Point{greatest, 0}, Point{0, greatest}, Point{-greatest, 0}, Point{0, -greatest}}) {
      const Point end = start.x != 0 ? Point{start.x, sense * pulse::sign(start.x) * 2000}
                                     : Point{-sense * pulse::sign(start.y) * 2000, start.y};
      ASSERT_TRUE(is_accepted({start, end, direction}, 24));
      ASSERT_EQ(bench.follow({start, end, direction}), "");
    }
    ASSERT_EQ(bench.refuse({{greatest + 1, 0}, {0, greatest + 1}, direction}), "");
  }
}

template <typename T>
class ArcsOfTheFirstQuadrant : public ::testing::Test {};
TYPED_TEST_SUITE(ArcsOfTheFirstQuadrant, Cores, Names);

/// What Table 1 is compared with. The DDA begins on the X axis.
TYPED_TEST(ArcsOfTheFirstQuadrant, AreThoseOfPulse) {
  typename TypeParam::First bench(6);
  int arcs = 0;
  each_arc([&](const Arc& arc) {
    const bool is_first = arc.start.x > 0 && arc.start.y >= 0 && arc.end.x >= 0 && arc.end.y > 0;
    if (!is_first || !arc.is_counterclockwise() || !is_accepted(arc, 6) || borders(arc) != 0) return;
    if (std::is_same_v<TypeParam, Dda> && arc.start.y != 0) return;
    ++arcs;
    const std::string different = bench.follow(arc);
    if (!different.empty()) FAIL() << different;
  });
  EXPECT_GT(arcs, 400);
}

template <typename T>
class Starts : public ::testing::Test {};
TYPED_TEST_SUITE(Starts, Cores, Names);

/// Syn in the middle of an arc begins the next one; what stands at the ports between is not looked at.
TYPED_TEST(Starts, TakeEverythingAtSyn) {
  typename TypeParam::Small bench(6);
  bench.start({{20, 0}, {0, 20}, Direction::counterclockwise});
  for (int clock = 0; clock < 7; ++clock) bench.core().clock();
  const Arc second{{0, -13}, {5, 12}, Direction::clockwise};
  bench.start(second);
  EXPECT_EQ(bench.at(), second.start);
  bench.core()->Start_X0 = 1;
  bench.core()->End_X1 = 3;
  bench.core()->End_Z1 = 60;
  bench.core()->Cw = 0;
  while (bench.core()->Busy) bench.core().clock();
  EXPECT_EQ(bench.at(), second.end);
  EXPECT_EQ(bench.follow(second), "");
}

TYPED_TEST(Starts, EndByReset) {
  typename TypeParam::Small bench(6);
  bench.start({{20, 0}, {0, 20}, Direction::counterclockwise});
  bench.core().clock();
  bench.core()->rst = 1;
  bench.core().clock();
  bench.core()->rst = 0;
  EXPECT_EQ(bench.core()->Busy, 0);
  EXPECT_EQ(bench.core()->X_Pwm_Out | bench.core()->Z_Pwm_Out, 0);
  const Point here = bench.at();
  for (int clock = 0; clock < 5; ++clock) bench.core().clock();
  EXPECT_EQ(bench.at(), here);
  bench.refuse({{0, 0}, {1, 0}, Direction::clockwise});
  bench.core()->rst = 1;
  bench.core().clock();
  EXPECT_EQ(bench.core()->Err, 0);
}

}  // namespace test_arcs
}  // namespace leadscrew::hardware
