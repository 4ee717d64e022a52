#include <gtest/gtest.h>

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/stretch.hpp>
#include <vector>

// What runs of clocks make is what single clocks make.

namespace leadscrew::pulse::testing {
namespace test_stretch {

constexpr std::size_t most_clocks = 2000;

/// By integrators with all their registers, as the papers have them; both remainders begin half full.
std::vector<Pulse<2>> quarter_by_the_book(std::int64_t radius, Order order) {
  std::vector<Pulse<2>> pulses;
  Integrator of_x(radius, radius / 2), of_y(radius, radius / 2);
  std::int64_t x = radius, y = 0;
  while (x > 0 || y < radius) {
    const bool drains = x == 0;
    const bool steps_x = x > 0 && of_x.add(y);
    const std::int64_t seen = order == Order::parallel || !steps_x ? x : x - 1;
    const bool steps_y = drains || (y < radius && of_y.add(seen));
    x -= steps_x;
    y += steps_y;
    pulses.push_back({{static_cast<std::int8_t>(-steps_x), static_cast<std::int8_t>(steps_y)}});
  }
  return pulses;
}

template <typename State>
std::vector<Pulse<2>> by_runs(State state, std::size_t run) {
  std::vector<Pulse<2>> pulses;
  while (!state.done() && pulses.size() < most_clocks) {
    std::size_t left = run;
    step_through(state, [&](auto& stepped) {
      pulses.push_back(stepped.step());
      return --left > 0;
    });
  }
  return pulses;
}

TEST(CircularDda, OverflowsAsIntegratorsDo) {
  for (std::int64_t radius = 1; radius <= 300; ++radius) {
    for (const Order order : {Order::parallel, Order::x_first}) {
      const CircularDda quarter({{radius, 0}, {0, radius}, Direction::counterclockwise}, {order, Preload::half});
      ASSERT_EQ(by_runs(quarter, 1), quarter_by_the_book(radius, order)) << radius;
    }
  }
}

TEST(Stretches, MakeThePulsesOfSingleClocks) {
  for (std::int64_t x = -9; x <= 9; ++x) {
    for (std::int64_t y = -9; y <= 9; ++y) {
      if (x == 0 && y == 0) continue;
      for (const Point end : {Point{x, y}, Point{-y, x}, Point{y, x}, Point{-x, -y}}) {
        for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
          for (const Order order : {Order::parallel, Order::x_first, Order::shrinking_first, Order::growing_first}) {
            const CircularDda circle({{x, y}, end, direction}, {order, Preload::half, 16});
            CircularDda single = circle;
            std::vector<Pulse<2>> pulses;
            while (!single.done() && pulses.size() < most_clocks) pulses.push_back(single.step());
            ASSERT_TRUE(single.done());
            for (const std::size_t run : {1, 2, 5, 1000}) ASSERT_EQ(by_runs(circle, run), pulses);
          }
        }
      }
    }
  }
}

}  // namespace test_stretch
}  // namespace leadscrew::pulse::testing
