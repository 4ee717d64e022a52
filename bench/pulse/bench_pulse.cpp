// Clocks a second of the reference-pulse interpolators: full circles and long lines, the pulses summed up.

#include <benchmark/benchmark.h>

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/linear.hpp>

namespace {

using namespace leadscrew::pulse;

template <typename Make>
void clocks(benchmark::State& state, const Make& make) {
  std::int64_t count = 0;
  for (auto _ : state) {
    auto interpolator = make();
    std::int64_t x = 0, y = 0;
    while (!interpolator.done()) {
      const auto pulse = interpolator.step();
      x += pulse.step[0];
      y += pulse.step[1];
      ++count;
    }
    benchmark::DoNotOptimize(x);
    benchmark::DoNotOptimize(y);
  }
  state.SetItemsProcessed(count);
}

constexpr std::int64_t radius = 10000;
constexpr Arc circle{{radius, 0}, {radius, 0}, Direction::counterclockwise};

template <typename Make>
void add(const char* name, const Make& make) {
  benchmark::RegisterBenchmark(name, [make](benchmark::State& state) {
    clocks(state, make);
  })->Unit(benchmark::kMicrosecond);
}

const bool added = [] {
  add("circle/dda/x-first", [] { return CircularDda(circle); });
  add("circle/dda/parallel", [] { return CircularDda(circle, {Order::parallel, Preload::none}); });
  add("circle/point-comparison", [] { return CircularSearch<Search::point_comparison>(circle); });
  add("circle/least-error", [] { return CircularSearch<Search::least_error>(circle); });
  add("circle/improved-least-error", [] { return CircularSearch<Search::improved_least_error>(circle); });
  add("line/dda", [] { return LinearDda<2>({30000, 20000}, capacity_for(1300000000), Preload::half); });
  add("line/dda/three-axes", [] { return LinearDda<3>({30000, 20000, 7000}, 40000, Preload::half); });
  add("line/point-comparison", [] { return LinearPointComparison({30000, 20000}); });
  add("line/bresenham", [] { return LinearBresenham({30000, 20000}); });
  return true;
}();

}  // namespace
