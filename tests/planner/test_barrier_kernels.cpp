// What a step of Newton's method does along a window: the same bits by every kind of vectors, and derivatives of the
// value that it goes down.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/barrier_kernels.hpp>
#include <vector>

#include "random_section.hpp"

namespace test_barrier_kernels {

using namespace leadscrew;
using planner::BarrierDuals;
using planner::BarrierKernel;
using planner::BarrierTerms;
using planner::BarrierValues;
using planner::LocalModel;
using planner::SpeedProblem;
using testing_support::any;

/// A window of a random section with a profile inside every limit.
struct Window {
  machine::Machine machine = testing_support::random_machine();
  std::vector<toolpath::Piece> pieces;
  planner::Section section;
  std::optional<SpeedProblem> problem;
  BarrierTerms terms;
  std::vector<double> c;

  Window() {
    pieces = testing_support::random_path(20);
    testing_support::soften(machine, pieces, 10);
    section = testing_support::section_of(pieces);
    planner::PlannedRange range;
    range.end = section.length();
    problem.emplace(section, machine, place_knots(section, machine, range, 400), 1);
    terms.places = problem->places();
    terms.basis = problem->basis();
    terms.sites = problem->sites();
    terms.blocks = problem->blocks();
    for (std::size_t q = 0; q < 3; ++q) terms.time_weights[q] = numeric::gauss_3_weights[q];
    for (std::size_t k = 0; k < problem->intervals(); ++k)
      terms.inverse_caps.push_back({{0, 1 / problem->caps().middles[k], 0, 1 / problem->caps().knots[k + 1]}});
    if (any(0, 2) == 0) {
      for (std::size_t k = 0; k < problem->intervals(); ++k)
        terms.weights.push_back(static_cast<std::uint8_t>(any(0, static_cast<int>(planner::cap_weights.size()))));
    }
    for (std::size_t i = 0; i < terms.sites.size(); ++i) terms.factors.push_back(1 + any(0, 100) / 1000.0);
    for (const double creep : problem->creep()) c.push_back(creep * any(20, 60) / 100);
  }
  BarrierValues values() const {
    BarrierValues values;
    values.rows.resize(terms.blocks.size());
    values.squares.resize(terms.sites.size());
    values.places.resize(terms.places.size());
    return values;
  }
  BarrierDuals duals() const { return {values().rows, values().places}; }
};

template <typename Numbers>
bool same_bits(const Numbers& a, const Numbers& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

RC_GTEST_PROP(BarrierKernels, HaveTheSameBits, ()) {
  const Window window;
  std::vector<double> there = window.c;
  for (double& value : there) value *= 0.9;
  const auto made = [&](const BarrierKernel& kernel) {
    BarrierValues at = window.values(), after = window.values();
    BarrierDuals duals = window.duals();
    std::vector<LocalModel> models(window.terms.places.size());
    RC_ASSERT(kernel.measure(window.terms, window.c, at));
    RC_ASSERT(kernel.measure(window.terms, there, after));
    kernel.center_duals(window.terms, at, duals);
    kernel.step_duals(window.terms, at, after, 0.7, duals);
    kernel.assemble(window.terms, 100, at, duals, models);
    return std::tuple{at, duals, models};
  };
  const auto [values, duals, models] = made(planner::barrier_kernel());
  const auto [plain_values, plain_duals, plain_models] = made(planner::plain_barrier_kernel());
  RC_ASSERT(same_bits(values.rows, plain_values.rows));
  RC_ASSERT(same_bits(values.places, plain_values.places));
  RC_ASSERT(values.time == plain_values.time && values.barrier == plain_values.barrier);
  RC_ASSERT(same_bits(duals.rows, plain_duals.rows) && same_bits(duals.places, plain_duals.places));
  RC_ASSERT(same_bits(models, plain_models));
}

/// Along random directions, by differences of the value.
RC_GTEST_PROP(BarrierKernels, HaveTheGradientOfTheirValue, ()) {
  const Window window;
  const BarrierKernel& kernel = planner::barrier_kernel();
  const double t = testing_support::logarithmic(0.1, 1e4), step = 1e-5;
  std::vector<double> direction;
  for (const double creep : window.problem->creep()) direction.push_back(creep * any(-100, 101) / 100);
  BarrierValues at = window.values();
  RC_ASSERT(kernel.measure(window.terms, window.c, at));
  BarrierDuals duals = window.duals();
  kernel.center_duals(window.terms, at, duals);
  std::vector<LocalModel> models(window.terms.places.size());
  kernel.assemble(window.terms, t, at, duals, models);
  double slope = 0, size = 0;
  for (std::size_t k = 0; k < models.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      slope += models[k].gradient[i] * direction[k + i];
      size += std::abs(models[k].gradient[i] * direction[k + i]);
    }
  }
  const auto value = [&](double by) {
    std::vector<double> c = window.c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += by * direction[i];
    BarrierValues there = window.values();
    RC_ASSERT(kernel.measure(window.terms, c, there));
    return t * there.time + there.barrier;
  };
  const double difference = (value(step) - value(-step)) / (2 * step);
  RC_ASSERT(std::abs(difference - slope) <= 1e-5 * size + 1e-10 * std::abs(value(0)) / step);
}

/// At a centre the model of the Hessian bends upwards in every direction, no less than the value does.
RC_GTEST_PROP(BarrierKernels, BendNoLessThanTheirValue, ()) {
  const Window window;
  const BarrierKernel& kernel = planner::barrier_kernel();
  const double step = 1e-3;
  std::vector<double> direction;
  for (const double creep : window.problem->creep()) direction.push_back(creep * any(-100, 101) / 100);
  BarrierValues at = window.values();
  RC_ASSERT(kernel.measure(window.terms, window.c, at));
  BarrierDuals duals = window.duals();
  kernel.center_duals(window.terms, at, duals);
  std::vector<LocalModel> models(window.terms.places.size());
  kernel.assemble(window.terms, 100, at, duals, models);
  double bend = 0;
  for (std::size_t k = 0; k < models.size(); ++k) {
    std::size_t entry = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        bend += (i == j ? 1 : 2) * models[k].hessian[entry++] * direction[k + i] * direction[k + j];
    }
  }
  const auto value = [&](double by) {
    std::vector<double> c = window.c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += by * direction[i];
    BarrierValues there = window.values();
    RC_ASSERT(kernel.measure(window.terms, c, there));
    return 100 * there.time + there.barrier;
  };
  const double difference = (value(step) - 2 * value(0) + value(-step)) / (step * step);
  RC_ASSERT(bend > 0);
  RC_ASSERT(bend >= difference * (1 - 1e-3) - 1e-11 * std::abs(value(0)) / (step * step));
}

}  // namespace test_barrier_kernels
