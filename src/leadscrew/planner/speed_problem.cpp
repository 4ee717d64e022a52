#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using namespace tuning::rows;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

/// Largest |A| and |g| over coefficients between 0 and a bound are no greater than the rows' sums of magnitudes times
/// it: the bound for which each row alone is kept with a margin.
double SpeedProblem::bound_of_rows(const Site& site) const {
  double bound = infinity;
  double greatest_by_j = 0;
  for (const Block& block : blocks(site)) {
    Lanes by{};
    for (const Lanes& row : block.by) {
      for (std::size_t lane = 0; lane < 4; ++lane) by[lane] += std::abs(row[lane]);
    }
    for (const std::size_t a : {0, 2}) {
      if (by[a] > 0) bound = std::min(bound, 0.3 / by[a]);
      greatest_by_j = std::max(greatest_by_j, by[a + 1]);
    }
  }
  return greatest_by_j > 0 ? std::min(bound, squared(numeric::cbrt(0.3 / greatest_by_j))) : bound;
}

/// At most half of the caps, inside every row, and from coefficient to coefficient no steeper than 1.5.
void SpeedProblem::find_creep() {
  const std::size_t n = intervals();
  std::vector<double>& y = creep_;
  y.assign(n + 3, infinity);
  for (std::size_t i = 0; i < n + 3; ++i) y[i] = 0.5 * caps_.coefficients[i];
  for (const Site& site : sites_) {
    if (site.hull) continue;
    const double bound = bound_of_rows(site);
    for (std::size_t j = 0; j < 4; ++j) y[site.interval + j] = std::min(y[site.interval + j], bound);
  }
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 1; i < n + 3; ++i) y[i] = std::min(y[i], 1.5 * y[i - 1]);
    for (std::size_t i = n + 2; i-- > 0;) y[i] = std::min(y[i], 1.5 * y[i + 1]);
    tie_creep();
  }
}

void SpeedProblem::tie_creep() {
  const std::size_t n = intervals();
  double start = infinity, end = infinity;
  for (std::size_t j = 0; j < 3; ++j) {
    start = std::min(start, creep_[j] / start_tie_[j]);
    end = std::min(end, creep_[n + 2 - j] / end_tie_[j]);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    if (starts_at_rest()) creep_[j] = start * start_tie_[j];
    if (ends_at_rest()) creep_[n + 2 - j] = end * end_tie_[j];
  }
}

void SpeedProblem::tie_variables() {
  const std::size_t n = intervals();
  variable_.assign(n + 3, -1);
  weight_.assign(n + 3, 1.0);
  const std::size_t first = starts_at_rest() ? 2 : 3;  // the first free coefficient, or the last that is tied to it
  const std::size_t last = ends_at_rest() ? n : ends_in_creep() ? n - creep_tail : n + 2;
  for (std::size_t i = starts_at_rest() ? 0 : 3; i < n + 3; ++i) {
    variable_[i] = static_cast<std::int32_t>(std::clamp(i, first, last) - first);
    if (i <= 2) weight_[i] = start_tie_[i];
    if (ends_at_rest() && i >= n) weight_[i] = end_tie_[n + 2 - i];
    if (ends_in_creep() && i >= last) weight_[i] = creep_[i] / creep_[last];
  }
  variable_count_ = last - first + 1;
}

double SpeedProblem::greatest_ratio(const Site& site, std::span<const double> c) const {
  const double* at = &c[site.interval];
  const double x = dot(site.x, at);
  if (!(x > 0)) return infinity;
  double of_a = 0, of_g = 0;
  for (const Block& block : blocks(site)) {
    Lanes y;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      y[lane] = std::abs(block.by[0][lane] * at[0] + block.by[1][lane] * at[1] + block.by[2][lane] * at[2] +
                         block.by[3][lane] * at[3]);
    }
    of_a = std::max({of_a, y[0], y[2]});
    of_g = std::max({of_g, y[1], y[3]});
  }
  return std::max(of_a, of_g * std::sqrt(x));
}

void SpeedProblem::shift(double by) {
  for (double& s : knots_.s) s -= by;
}

void SpeedProblem::settle() {
  places_ = {};
  weight_ = {};
  caps_ = {};
  sites_.shrink_to_fit();
  blocks_.shrink_to_fit();
}

}  // namespace leadscrew::planner
