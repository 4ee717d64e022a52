#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_bounds.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using namespace tuning::rows;

constexpr double infinity = std::numeric_limits<double>::infinity();

double square_at(const SpeedProblem& problem, std::span<const double> c, std::size_t interval, double u) {
  return dot(problem.basis()[interval].value(u), &c[interval]);
}

}  // namespace

SpeedBounds::SpeedBounds(const SpeedProblem& problem, const Continuation& before) : caps_(problem.caps()) {
  const std::size_t n = problem.intervals();
  const std::size_t known = std::min({before.loose, before.tightened.size(), n});
  tightened_.assign(before.tightened.begin(), before.tightened.begin() + static_cast<std::ptrdiff_t>(known));
  tightened_.resize(n, 1.0);
  relaxed_.assign(problem.sites().size(), 1.0);
  if (!problem.ends_in_creep()) return;
  // Knots that lie well for a motion that goes on lie far apart for one that stops so soon.
  const std::size_t from = n > stopping_tail ? n - stopping_tail : 0;
  for (std::size_t k = std::max(from, before.loose); k < n; ++k) {
    const double factor = k + last_intervals < n ? stopping_factor : last_factor;
    tightened_[k] = std::max(factor, k < before.tightened.size() ? before.tightened[k] : 1);
  }
}

double SpeedBounds::greatest_ratio(const SpeedProblem& problem, std::span<const double> c, std::size_t from) const {
  double greatest = 0;
  for (std::size_t i = from + 3; i < c.size(); ++i) greatest = std::max(greatest, c[i] / caps_.coefficients[i]);
  for (std::size_t k = from; k < problem.intervals(); ++k) {
    greatest = std::max(
        {greatest, square_at(problem, c, k, 0.5) / caps_.middles[k], square_at(problem, c, k, 1) / caps_.knots[k + 1]});
  }
  const std::span<const SpeedProblem::Site> sites = problem.sites();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].interval < from) continue;
    greatest = std::max(greatest, factor(sites[i], i) * problem.greatest_ratio(sites[i], c));
  }
  return greatest;
}

void SpeedBounds::tighten(std::size_t interval, const Ratios& factors) {
  tightened_[interval] *= factors.rows;
  for (const std::size_t i : {interval + 1, interval + 2}) caps_.coefficients[i] /= squared(factors.speed);
  for (const std::size_t k : {interval, interval + 1}) caps_.knots[k] /= squared(factors.speed);
  caps_.middles[interval] /= squared(factors.speed);
}

Ratios SpeedBounds::margin(const SpeedProblem& problem, std::span<const double> c, std::size_t interval) const {
  double square = infinity, rows = infinity;
  for (const std::size_t i : {interval + 1, interval + 2}) {
    if (problem.is_free(i)) square = std::min(square, caps_.coefficients[i] / c[i]);
  }
  square = std::min(square, caps_.middles[interval] / square_at(problem, c, interval, 0.5));
  if (interval > 0) square = std::min(square, caps_.knots[interval] / square_at(problem, c, interval, 0));
  square = std::min(square, caps_.knots[interval + 1] / square_at(problem, c, interval, 1));
  const std::span<const SpeedProblem::Site> sites = problem.sites();
  const auto before = [](const SpeedProblem::Site& site, std::size_t k) { return site.interval < k; };
  const auto first = std::lower_bound(sites.begin(), sites.end(), interval, before);
  for (auto i = static_cast<std::size_t>(first - sites.begin()); i < sites.size() && sites[i].interval == interval; ++i)
    rows = std::min(rows, 1 / (factor(sites[i], i) * problem.greatest_ratio(sites[i], c)));
  return {std::sqrt(square), rows};
}

bool SpeedBounds::relax_caps(const SpeedProblem& problem, std::span<const double> c, double margin) {
  constexpr double touching = 1 - 1e-11;
  bool raised = false;
  const auto raise = [&](double& greatest, double x) {
    if (x < touching * greatest) return;
    greatest = (1 + margin) * x;
    raised = true;
  };
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (problem.is_free(i)) raise(caps_.coefficients[i], c[i]);
  }
  for (std::size_t k = 0; k < problem.intervals(); ++k) {
    raise(caps_.middles[k], square_at(problem, c, k, 0.5));
    raise(caps_.knots[k + 1], square_at(problem, c, k, 1));
  }
  return raised;
}

void SpeedBounds::restore_caps(const SpeedProblem& problem, std::span<const double> c, double margin) {
  caps_ = problem.caps();
  relax_caps(problem, c, margin);
}

/// Between the places looked at the profile may have been above the rows, which are those of limit_margin of the limits: a
/// little where motion was proven, more beyond where the last window would have come to rest. Where it is now looked at
/// for the first time, rows are relaxed until the profile is far inside; the proof decides what becomes of it.
void SpeedBounds::relax_rows(const SpeedProblem& problem, std::span<const double> c) {
  constexpr double margin = relaxed_margin;
  const std::span<const SpeedProblem::Site> sites = problem.sites();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double ratio = tightened_[sites[i].interval] * problem.greatest_ratio(sites[i], c);
    if (ratio > 1 - margin && ratio < greatest_relaxed) relaxed_[i] = (1 - margin) / ratio;
  }
}

void SpeedBounds::restore_rows(const SpeedProblem& problem, std::span<const double> c) {
  constexpr double inside = 0.999;
  const std::span<const SpeedProblem::Site> sites = problem.sites();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (relaxed_[i] < 1 && tightened_[sites[i].interval] * problem.greatest_ratio(sites[i], c) < inside)
      relaxed_[i] = 1;
  }
}

}  // namespace leadscrew::planner
