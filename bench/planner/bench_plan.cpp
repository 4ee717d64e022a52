// Pieces planned per second, lines and arcs, and what it takes to plan windows of a curve in six axes.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <motion.hpp>
#include <percentiles.hpp>
#include <six_axes.hpp>

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

double thread_cpu_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// "longest": s of the longest call; "share": of the time that the motion takes.
void plan_six_axes(benchmark::State& state) {
  constexpr int spans = 300;
  const machine::Machine machine = testing_support::mill_of_six_axes();
  testing_support::CurveInSixAxes curve(50);
  std::vector<toolpath::Piece> pieces;
  const geometry::Point start = curve.start();
  while (pieces.size() < spans) pieces.push_back(curve.next());
  double longest = 0, taken = 0, motion = 0;
  for (auto _ : state) {
    planner::Planner planner(machine, start);
    const auto pop = [&] {
      for (;;) {
        const double before = thread_cpu_seconds();
        const std::optional<planner::Chunk> chunk = planner.pop();
        const double call = thread_cpu_seconds() - before;
        longest = std::max(longest, call);
        taken += call;
        if (!chunk) return;
        motion += chunk->duration.value();
      }
    };
    for (const toolpath::Piece& piece : pieces) {
      planner.push(piece);
      pop();
    }
    planner.finish();
    pop();
  }
  state.counters["longest"] = longest;
  state.counters["share"] = taken / motion;
  state.SetItemsProcessed(spans * state.iterations());
}

auto* const six_axes = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("plan/windows of a curve in six axes", plan_six_axes)->Iterations(1));
auto* const line = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("plan/line", plan, testing_support::line_piece({}, {3, 4, 5}, 60)));
auto* const arc = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("plan/arc", plan, testing_support::arc_piece({}, 10, 0, 2, 60)));

}  // namespace
