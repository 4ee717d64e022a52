// Clocks a second of the reference-pulse interpolators.

#include <benchmark/benchmark.h>

#include "pulse_cases.hpp"

namespace {

using namespace leadscrew;

template <typename Make>
void clocks(benchmark::State& state, const Make& make) {
  std::int64_t count = 0;
  for (auto _ : state) {
    pulse::Point sum;
    count += bench::run(make(), sum);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(count);
}

const bool added = [] {
  bench::for_each_pulse_case([](const char* name, auto make) {
    benchmark::RegisterBenchmark(name, [make](benchmark::State& state) {
      clocks(state, make);
    })->Unit(benchmark::kMicrosecond);
  });
  return true;
}();

}  // namespace
