// Steps a second of whole part programs by their words: read, planned, made into words and these into steps. One item
// is a pulse: a tick of the clock with a step of one axis or more.

#include <benchmark/benchmark.h>

#include <array>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <percentiles.hpp>
#include <pulse_programs.hpp>

namespace {

using namespace leadscrew;

constexpr std::int64_t clock_hz = 10'000'000;

void steps(benchmark::State& state, const bench::PulsedProgram& program) {
  const machine::Machine machine = bench::stepped_machine();
  const machine::ToolTable tools({{1}, {2}});
  bench::Stepped sum;
  std::int64_t words = 0;
  std::array<base::Word, 64> made;
  for (auto _ : state) {
    pipeline::Program motion(gcode::text_source(program.text), machine, tools, {}, nullptr);
    auto generator = steps::StepGenerator::create(machine, clock_hz);
    if (!generator) return state.SkipWithError(generator.error().message.c_str());
    std::int64_t last = 0;
    const auto sink = [&](std::span<const steps::StepEvent> events) {
      sum.steps += static_cast<std::int64_t>(events.size());
      for (const steps::StepEvent event : events) {
        sum.pulses += event.tick() != last;
        last = event.tick();
        sum.sum += last * event.direction();
      }
    };
    while (motion.prepare()) {
      for (const base::Word& word : motion.cycle(std::span<base::Word>(made))) {
        generator->follow(word, sink);
        ++words;
      }
    }
    generator->finish(sink);
    if (motion.failure() || sum.steps == 0) return state.SkipWithError("the program has errors, or no steps");
    benchmark::DoNotOptimize(sum.sum);
  }
  state.SetItemsProcessed(sum.pulses);
  state.counters["steps"] = benchmark::Counter(static_cast<double>(sum.steps), benchmark::Counter::kIsRate);
  state.counters["words"] = benchmark::Counter(static_cast<double>(words), benchmark::Counter::kIsRate);
}

const bool added = [] {
  for (const bench::PulsedProgram& program : bench::pulsed_programs()) {
    if (program.shape == nc::Shape::accelerate) continue;  // words always are
    const std::string name = std::string("program-steps/") + program.name;
    bench::with_percentiles(
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { steps(state, program); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1));
  }
  return true;
}();

}  // namespace
