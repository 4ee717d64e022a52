// NURBS curves: the cycle's evaluation, the planner's derivatives, and making the table of arc length.

#include <benchmark/benchmark.h>

#include <butterfly.hpp>
#include <cmath>
#include <leadscrew/geometry/curve.hpp>
#include <percentiles.hpp>

namespace {

using namespace leadscrew;
using geometry::NurbsForm;

/// A helix-like cubic through as many points as asked, with changing weights: three coordinates move.
NurbsForm winding(std::size_t points) {
  NurbsForm form;
  form.degree = 3;
  form.knots.assign(4, 0.0);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 0.2 * static_cast<double>(k);
    form.points.push_back({20 * std::cos(angle), 20 * std::sin(angle), 0.1 * static_cast<double>(k)});
    form.weights.push_back(1 + 0.3 * std::sin(3 * angle));
    if (k >= 4) form.knots.push_back(static_cast<double>(k - 3));
  }
  form.knots.insert(form.knots.end(), 4, static_cast<double>(points - 3));
  return form;
}

/// At a thousand places in order, then at a thousand that jump about.
void evaluate(benchmark::State& state, const NurbsForm& form) {
  const geometry::Curve curve = geometry::smooth_pieces(form).at(0);
  const double length = geometry::length(curve);
  for (auto _ : state) {
    for (int k = 0; k < 1000; ++k) {
      benchmark::DoNotOptimize(geometry::evaluate(curve, length * (k + 0.5) / 1000));
      benchmark::DoNotOptimize(geometry::evaluate(curve, length * ((k * 619) % 1000 + 0.5) / 1000));
    }
  }
  state.SetItemsProcessed(2000 * state.iterations());
}

void jets(benchmark::State& state, const NurbsForm& form) {
  const geometry::Curve curve = geometry::smooth_pieces(form).at(0);
  const double length = geometry::length(curve);
  for (auto _ : state) {
    for (int k = 0; k < 1000; ++k) benchmark::DoNotOptimize(geometry::jets(curve, length * (k + 0.5) / 1000));
  }
  state.SetItemsProcessed(1000 * state.iterations());
}

void make(benchmark::State& state, const NurbsForm& form) {
  std::size_t pieces = 0;
  for (auto _ : state) pieces = geometry::smooth_pieces(form).at(0).map_pieces();
  state.counters["map_pieces"] = static_cast<double>(pieces);
}

auto* const plane = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("nurbs/evaluate/butterfly", evaluate, testing_support::butterfly())
        ->Unit(benchmark::kMicrosecond));
auto* const space = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("nurbs/evaluate/three-axes", evaluate, winding(200))->Unit(benchmark::kMicrosecond));
auto* const derivatives = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("nurbs/jets/butterfly", jets, testing_support::butterfly())
        ->Unit(benchmark::kMicrosecond));
auto* const table = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("nurbs/make/butterfly", make, testing_support::butterfly())
        ->Unit(benchmark::kMicrosecond));
auto* const long_table = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("nurbs/make/3000-points", make, winding(3000))->Unit(benchmark::kMicrosecond));

}  // namespace
