// Words per second along lines, arcs and a helix: one item is one call of the cycle.

#include <benchmark/benchmark.h>

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

auto* const along_lines = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines", words, lines)->Unit(benchmark::kMillisecond));
auto* const along_arcs = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/arcs", words, arcs)->Unit(benchmark::kMillisecond));
auto* const along_both = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines-and-arcs", words, mixed)->Unit(benchmark::kMillisecond));

}  // namespace
