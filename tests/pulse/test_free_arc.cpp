// The generator along an arc without counters: Koren's figure, and the circle generator beside it.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pulse/free_circle.hpp>

namespace leadscrew::pulse::testing {
namespace test_free_arc {

constexpr Arc half_turn{{10'000, 0}, {-10'000, 0}, Direction::counterclockwise};
constexpr std::int64_t clocks_of_half_turn = 31'415;  // ⌊π·10 000⌋

Point end_of(FreeArc state) {
  while (!state.done()) state.step();
  return state.at();
}

/// "The radius … 10 001 BLU" at half a period, whether an integrator overflows at r ≥ q or at r > q.
TEST(FreeArc, HasKorensRadiusAtHalfAPeriod) {
  for (const Preload preload : {Preload::none, Preload::minus_one}) {
    EXPECT_EQ(end_of(FreeArc(half_turn, clocks_of_half_turn, {Order::x_first, preload})), (Point{-10'001, 1}));
  }
}

/// What tells the program's order from the hardware's are half full remainders.
TEST(FreeArc, DriftsWhereRegistersAreClockedTogether) {
  const Point by_program = end_of(FreeArc(half_turn, clocks_of_half_turn, {Order::x_first, Preload::half}));
  const Point by_hardware = end_of(FreeArc(half_turn, clocks_of_half_turn, {Order::parallel, Preload::half}));
  EXPECT_EQ(by_program.x, -10'000);
  EXPECT_EQ(by_hardware.x, -10'002);
}

TEST(FreeArc, MakesThePulsesOfTheCircleGenerator) {
  for (const Order order : {Order::parallel, Order::x_first}) {
    for (const auto& [preload, remainder] :
         {std::pair{Preload::none, 0}, {Preload::half, 45}, {Preload::full, 89}, {Preload::minus_one, -1}}) {
      for (const Point start : {Point{70, 0}, {-33, 41}, {0, -12}}) {
        FreeArc arc({start, start, Direction::counterclockwise}, 2000, {order, preload, 0, 90});
        FreeCircle circle(start, 90, remainder, order, Accumulation::sign_magnitude);
        while (!arc.done()) ASSERT_EQ(arc.step(), circle.step());
        EXPECT_EQ(arc.at(), circle.at());
      }
    }
  }
}

TEST(FreeArc, IsItsMirrorImage) {
  for (const Order order : {Order::parallel, Order::x_first, Order::shrinking_first, Order::growing_first}) {
    for (const Preload preload : {Preload::none, Preload::half, Preload::half_lagging, Preload::full}) {
      FreeArc one({{50, 0}, {50, 0}, Direction::counterclockwise}, 400, {order, preload});
      FreeArc below({{50, 0}, {50, 0}, Direction::clockwise}, 400, {order, preload});
      FreeArc exchanged({{0, 50}, {0, 50}, Direction::clockwise}, 400, {order, preload});
      while (!one.done()) {
        const auto [x, y] = one.step().step;
        ASSERT_EQ(below.step(), (Pulse<2>{{x, static_cast<std::int8_t>(-y)}}));
        if (order == Order::x_first) continue;
        ASSERT_EQ(exchanged.step(), (Pulse<2>{{y, x}})) << static_cast<int>(order);
      }
    }
  }
}

}  // namespace test_free_arc
}  // namespace leadscrew::pulse::testing
