// Words per second along lines, arcs and cubic rational NURBS curves, by the plain interpolator and by the controller:
// one item is one call of the cycle.

#include <benchmark/benchmark.h>

#include <leadscrew/interpolator/controller.hpp>
#include <motion.hpp>
#include <percentiles.hpp>

namespace {

using namespace leadscrew;
using testing_support::arc_piece;
using testing_support::line_piece;

std::vector<toolpath::Element> lines() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 100; ++k) {
    const geometry::Point next = {k * 1.7, (k % 7) * 13.0, (k % 5) * -2.25};
    path.push_back(line_piece(at, next, 60));
    at = next;
  }
  return path;
}

std::vector<toolpath::Element> arcs() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 100; ++k) {
    const toolpath::Piece arc = arc_piece(at, at[0] + 9 + k % 5, at[1] + k % 3, k % 2 ? 5.0 : -4.0, 60);
    at = geometry::end(arc.curve);
    path.push_back(arc);
  }
  return path;
}

std::vector<toolpath::Element> mixed() {
  auto path = lines();
  geometry::Point at = geometry::end(std::get<toolpath::Piece>(path.back()).curve);
  for (int k = 0; k < 100; ++k) {
    const geometry::Point next = {at[0] + 20, at[1], at[2] + 1};
    path.push_back(line_piece(at, next, 60));
    const toolpath::Piece arc = arc_piece(next, next[0], next[1] + 8, 3.0, 60);
    path.push_back(arc);
    at = geometry::end(arc.curve);
  }
  return path;
}

std::vector<toolpath::Element> curves() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 20; ++k) {
    geometry::NurbsForm form{3, {0, 0, 0, 0}, {at}, {1}};
    for (int i = 1; i <= 12; ++i) {
      at[0] += 4;
      at[1] += (i * 7 + k) % 5 - 2;
      at[2] += (i + k) % 3 - 1;
      form.points.push_back(at);
      form.weights.push_back(1 + i % 3 * 0.5);
      if (i < 10) form.knots.push_back(i);
    }
    form.knots.insert(form.knots.end(), 4, 10);
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(form))
      path.push_back(toolpath::Piece{piece, 60, base::Line{k}});
  }
  return path;
}

void words(benchmark::State& state, std::vector<toolpath::Element> (*make)()) {
  const auto chunks = testing_support::plan(make(), machine::mill3());
  const base::Period period{1'000'000};
  for (auto _ : state) {
    interpolator::Interpolator interpolator(period, {});
    for (const auto& chunk : chunks) {
      interpolator.load(chunk);
      while (!interpolator.wants_chunk()) benchmark::DoNotOptimize(interpolator.next());
    }
    state.SetItemsProcessed(state.items_processed() + base::count(interpolator.tick()));
  }
}

/// All chunks are there before the first word: what is measured is the cycle alone.
void controlled(benchmark::State& state, std::vector<toolpath::Element> (*make)()) {
  const auto chunks = testing_support::plan(make(), machine::mill3());
  for (auto _ : state) {
    state.PauseTiming();
    interpolator::Controller controller(base::Period{1'000'000}, {}, chunks.size() + 1);
    for (planner::Chunk chunk : chunks) {
      if (controller.offer(chunk) != interpolator::Controller::Offer::accepted) state.SkipWithError("not accepted");
    }
    std::int64_t count = 0;
    state.ResumeTiming();
    for (; !controller.idle(); ++count) benchmark::DoNotOptimize(controller.next());
    state.SetItemsProcessed(state.items_processed() + count);
  }
}

auto* const along_lines = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines", words, lines)->Unit(benchmark::kMillisecond));
auto* const along_arcs = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/arcs", words, arcs)->Unit(benchmark::kMillisecond));
auto* const along_both = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines-and-arcs", words, mixed)->Unit(benchmark::kMillisecond));
auto* const along_curves = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/nurbs", words, curves)->Unit(benchmark::kMillisecond));
auto* const controlled_lines = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/lines", controlled, lines)->Unit(benchmark::kMillisecond));
auto* const controlled_arcs = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/arcs", controlled, arcs)->Unit(benchmark::kMillisecond));
auto* const controlled_curves = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/nurbs", controlled, curves)->Unit(benchmark::kMillisecond));

}  // namespace
