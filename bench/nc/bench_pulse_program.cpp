// Pulses a second of whole part programs, read, planned and interpolated, by every method. One item is a pulse: a clock
// with a step of one axis or more.

#include <benchmark/benchmark.h>

#include <percentiles.hpp>
#include <pulse_programs.hpp>

namespace {

using namespace leadscrew;

void pulses(benchmark::State& state, const bench::PulsedProgram& program, nc::PulseMethod method) {
  bench::Stepped sum;
  for (auto _ : state) {
    const bench::Stepped stepped = bench::run(program, method);
    if (stepped.errors > 0) state.SkipWithError("the program has errors");
    sum.pulses += stepped.pulses;
    sum.steps += stepped.steps;
    benchmark::DoNotOptimize(sum.sum += stepped.sum);
  }
  state.SetItemsProcessed(sum.pulses);
  state.counters["steps"] = benchmark::Counter(static_cast<double>(sum.steps), benchmark::Counter::kIsRate);
}

const bool added = [] {
  for (const bench::PulsedProgram& program : bench::pulsed_programs()) {
    for (const nc::PulseMethod method : nc::all_pulse_methods) {
      const std::string name = "pulses/" + bench::name(program, method);
      bench::with_percentiles(
          benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { pulses(state, program, method); })
              ->Unit(benchmark::kMillisecond)
              ->Iterations(1));
    }
  }
  return true;
}();

}  // namespace
