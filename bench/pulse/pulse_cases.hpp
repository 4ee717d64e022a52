#pragma once
// What the reference-pulse interpolators are timed with, and their operations counted: full circles and long lines.

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/pulse/stretch.hpp>

namespace leadscrew::bench {

/// visit(name, make) for each of them; make() gives an interpolator at its start.
template <typename Visit>
void for_each_pulse_case(const Visit& visit) {
  using namespace pulse;
  constexpr std::int64_t radius = 10000;
  constexpr Arc circle{{radius, 0}, {radius, 0}, Direction::counterclockwise};
  visit("circle/dda/x-first", [=] { return CircularDda(circle); });
  visit("circle/dda/parallel", [=] { return CircularDda(circle, {Order::parallel, Preload::none}); });
  visit("circle/point-comparison", [=] { return CircularSearch<Search::point_comparison>(circle); });
  visit("circle/least-error", [=] { return CircularSearch<Search::least_error>(circle); });
  visit("circle/improved-least-error", [=] { return CircularSearch<Search::improved_least_error>(circle); });
  visit("line/dda", [] { return LinearDda<2>({30000, 20000}, capacity_for(1300000000), Preload::half); });
  visit("line/dda/three-axes", [] { return LinearDda<3>({30000, 20000, 7000}, 40000, Preload::half); });
  visit("line/point-comparison", [] { return LinearPointComparison<2>({30000, 20000}); });
  visit("line/bresenham", [] { return LinearBresenham({30000, 20000}); });
}

/// Runs it to its end and sums its pulses up; how many clocks that took.
template <pulse::Interpolator State>
std::int64_t run(State interpolator, pulse::Point& sum) {
  std::int64_t clocks = 0, x = 0, y = 0;
  pulse::step_through(interpolator, [&](auto& state) {
    const auto pulse = state.step();
    x += pulse.step[0];
    y += pulse.step[1];
    ++clocks;
    return true;
  });
  sum = {sum.x + x, sum.y + y};
  return clocks;
}

}  // namespace leadscrew::bench
