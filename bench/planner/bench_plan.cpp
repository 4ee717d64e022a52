// Pieces planned per second, lines and arcs.

#include <benchmark/benchmark.h>

#include <motion.hpp>
#include <percentiles.hpp>

namespace {

using namespace leadscrew;

void plan(benchmark::State& state, toolpath::Piece piece) {
  const machine::Machine machine = machine::mill3();
  planner::Planner planner(machine, {});
  for (auto _ : state) {
    planner.push(piece);
    benchmark::DoNotOptimize(planner.pop());
  }
  state.SetItemsProcessed(state.iterations());
}

auto* const line = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("plan/line", plan, testing_support::line_piece({}, {3, 4, 5}, 60)));
auto* const arc = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("plan/arc", plan, testing_support::arc_piece({}, 10, 0, 2, 60)));

}  // namespace
