#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/barrier.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <numeric>
#include <utility>

namespace leadscrew::planner {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What x above the wanted costs a unit of distance, with derivatives: ρ (y + √(y² + ε²)) / 2√w, y = x/w − 1.
struct Excess {
  double value = 0, slope = 0, curvature = 0;
};
Excess excess(double x, double wanted) {
  const double y = x / wanted - 1, root = std::sqrt(y * y + squared(tuning::descent::softness));
  const double scale = tuning::descent::weight / (2 * std::sqrt(wanted));
  return {scale * (y + root), scale * (1 + y / root) / wanted,
          scale * squared(tuning::descent::softness) / (root * root * root * squared(wanted))};
}

}  // namespace

void SpeedIterate::set(const SpeedProblem& problem, std::vector<double> coefficients) {
  c_ = std::move(coefficients);
  variables_.resize(problem.variables());
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (problem.is_free(i)) variables_[problem.variable(i)] = c_[i] / problem.weight(i);
  }
}

void SpeedIterate::step_back(const SpeedProblem& problem, std::span<const double> direction, double length,
                             SpeedIterate& to) const {
  to.variables_.resize(variables_.size());
  for (std::size_t i = 0; i < direction.size(); ++i) to.variables_[i] = variables_[i] - length * direction[i];
  to.c_ = c_;
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (problem.is_free(i)) to.c_[i] = problem.weight(i) * to.variables_[problem.variable(i)];
  }
}

BarrierSolver::BarrierSolver(const SpeedProblem& problem, const SpeedBounds& bounds, const SpeedGoal& goal,
                             SpeedIterate& iterate, Ways ways)
    : problem_(problem),
      bounds_(bounds),
      goal_(goal),
      kernel_(barrier_kernel()),
      iterate_(iterate),
      floors_(goal.floors),
      ways_(ways),
      inequalities_(static_cast<double>(problem.inequalities())) {
  const std::size_t n = problem.intervals();
  floors_.resize(n + 3, 0.0);
  first_free_ = problem.starts_at_rest() ? 0 : 3;
  first_single_ = 3;
  end_single_ = n + 3;
  while (end_single_ > first_single_ && problem.variable(end_single_ - 1) == problem.variable(n + 2)) --end_single_;
  terms_.places = problem.places();
  terms_.basis = problem.basis();
  terms_.sites = problem.sites();
  terms_.blocks = problem.blocks();
  std::copy(numeric::gauss_3_weights.begin(), numeric::gauss_3_weights.end(), terms_.time_weights.begin());
  terms_.inverse_caps.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    terms_.inverse_caps[k][SpeedProblem::middle_place] = 1 / bounds.caps().middles[k];
    terms_.inverse_caps[k][SpeedProblem::end_place] = 1 / bounds.caps().knots[k + 1];
  }
  for (BarrierValues* const values : {&values_, &trial_values_}) {
    values->rows.resize(terms_.blocks.size());
    values->squares.resize(terms_.sites.size());
    values->places.resize(n);
  }
  duals_.rows.resize(terms_.blocks.size());
  duals_.places.resize(n);
  cap_duals_.resize(n + 3);
  models_.resize(n);
  terms_.factors.resize(terms_.sites.size());
  if (ways.weighs_caps) weigh_caps();
}

void BarrierSolver::weigh_caps() {
  const std::size_t n = problem_.intervals();
  std::vector<double> wanted;
  for (std::size_t k = 0; k < n; ++k) wanted.push_back(problem_.basis()[k].h / std::sqrt(bounds_.caps().middles[k]));
  const double mean = std::accumulate(wanted.begin(), wanted.end(), 0.0) / static_cast<double>(n);
  for (double& weight : wanted) weight = std::min(weight / mean, 1.0);
  for (std::size_t i = 0; i < n + 3; ++i) {
    const std::size_t from = i > 3 ? i - 3 : 0, to = std::min(i, n - 1);
    double sum = 0;
    for (std::size_t k = from; k <= to; ++k) sum += wanted[k];
    weights_.push_back(nearest_weight(sum / static_cast<double>(to - from + 1)));
  }
  for (const double weight : wanted) terms_.weights.push_back(nearest_weight(weight));
  // Two caps of each interval; a cap and a floor of each coefficient that is free.
  for (const std::uint8_t weight : terms_.weights) inequalities_ -= 2 * (1 - cap_weights[weight]);
  for (std::size_t i = first_free_; i < n + 3; ++i) inequalities_ -= 2 * (1 - weight(i));
}

/// Rows may have been relaxed less since.
void BarrierSolver::find_factors() {
  for (std::size_t i = 0; i < terms_.sites.size(); ++i) terms_.factors[i] = squared(bounds_.factor(terms_.sites[i], i));
}

/// t for a gap, with the multipliers of a centre.
double BarrierSolver::begin(double gap) {
  find_factors();
  const Step at = measure(iterate_.coefficients(), 1, values_);
  center_duals();
  is_first_ = true;
  return inequalities_ / (gap * at.objective);
}

/// For the next stage, with the multipliers.
double BarrierSolver::grown(double t, double most) {
  const double factor = std::min(ways_.is_of_least_time ? tuning::least_time::growth : tuning::barrier::growth, most);
  is_first_ = false;
  for (std::vector<Lanes>* const part : {&duals_.rows, &duals_.places}) {
    for (Lanes& lanes : *part) {
      for (double& dual : lanes) dual *= factor;
    }
  }
  for (double& dual : cap_duals_) dual *= factor;
  creep_dual_ *= factor;
  return t * factor;
}

/// Newton steps until they help little; the objective then. The first stage's centre need not be found: the next, with
/// multipliers, begins as well from near it.
double BarrierSolver::follow(double t) {
  using namespace tuning::barrier;
  const double share = is_first_ ? negligible_first : negligible;
  find_factors();
  Step at = measure(iterate_.coefficients(), t, values_);
  is_lost_ = false;
  double first = 0;
  for (int step = 0; step < 25; ++step) {
    double decrement = 0;
    if (!newton(t, at, decrement) || decrement < share * inequalities_) break;
    if (step == 0) first = decrement;
    is_lost_ = ways_.is_of_least_time && !is_first_ && decrement > std::max(lost * inequalities_, times_first * first);
    if (is_lost_ && !was_lost_) break;
  }
  return at.objective;
}

bool BarrierSolver::newton(double t, Step& at, double& decrement) {
  ++newton_steps_;
  find_direction(t);
  decrement = 0;
  for (std::size_t i = 0; i < direction_.size(); ++i) decrement += gradient_[i] * direction_[i];
  if (!(decrement > 0)) return false;
  double length = 1;
  for (int attempt = 0; attempt < most_attempts; ++attempt, length *= tuning::barrier::shorter) {
    iterate_.step_back(problem_, direction_, length, trial_);
    trial_values_.outside = problem_.intervals();
    const Step there = measure(trial_.coefficients(), t, trial_values_);
    for (const std::size_t k = trial_values_.outside; k < problem_.intervals() && attempt < most_attempts; ++attempt) {
      if (is_inside(k, length * tuning::barrier::shorter)) break;
      length *= tuning::barrier::shorter;
    }
    if (there.value <= at.value - 0.05 * length * decrement) {
      at = there;
      if (!is_first_) step_duals(trial_.coefficients(), trial_values_, length);
      std::swap(iterate_, trial_);
      std::swap(values_, trial_values_);
      if (is_first_) center_duals();
      return true;
    }
  }
  return false;
}

/// Of an interval alone: whatever else may be outside, a step is too long that leaves this one so.
bool BarrierSolver::is_inside(std::size_t k, double length) const {
  std::array<double, 4> c;
  for (std::size_t i = 0; i < 4; ++i) {
    c[i] = iterate_.coefficients()[k + i];
    if (problem_.is_free(k + i)) c[i] -= length * problem_.weight(k + i) * direction_[problem_.variable(k + i)];
  }
  const auto lane_of = [&](const std::array<Lanes, 4>& by, std::size_t lane) {
    return by[0][lane] * c[0] + by[1][lane] * c[1] + (by[2][lane] * c[2] + by[3][lane] * c[3]);
  };
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const double x = lane_of(terms_.places[k], lane);
    if (!(x > 0 && x * terms_.inverse_caps[k][lane] < 1)) return false;
  }
  const auto before = [](const SpeedProblem::Site& site, std::size_t interval) { return site.interval < interval; };
  const auto first = std::lower_bound(terms_.sites.begin(), terms_.sites.end(), k, before);
  for (auto site = first; site != terms_.sites.end() && site->interval == k; ++site) {
    const double x = dot(site->x, c.data()),
                 factor = terms_.factors[static_cast<std::size_t>(site - terms_.sites.begin())];
    if (!(x > 0)) return false;
    for (std::size_t block = site->first_block; block < site->end_block; ++block) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const double y = lane_of(terms_.blocks[block].by, lane), square = lane % 2 == 0 ? 1 : x;
        if (!(factor * square * y * y < 1)) return false;
      }
    }
  }
  return true;
}

/// Out of a creep, Newton's method goes up by two thirds of x a step where time alone counts, and doubles x where its
/// logarithm does: with less curvature of both, the line search permitting, a few steps are enough.
void BarrierSolver::find_direction(double t) {
  terms_.time_curvature = is_first_ ? tuning::barrier::first_time_curvature : 0.75;
  assemble(t);
  direction_ = gradient_;
  hessian_.factor(1e-13);
  hessian_.solve(direction_);
}

// ---------------------------------------------------------------------------------------------------------------------

/// −Σ log of factors, by few logarithms of products.
class BarrierSolver::Product {
 public:
  /// False where the factor is not above 0.
  bool take(double factor) {
    product_ *= factor;
    if (product_ < 1e-200) {
      sum_ -= numeric::log(product_);
      product_ = 1;
    }
    return factor > 0;
  }
  /// Of two at once, with a weight, by index.
  bool take(double factor, double other, std::uint8_t weight) {
    if (weight == 0) return take(factor) && take(other);
    if (!(factor > 0 && other > 0)) return false;
    weighed_.take(factor * other, weight);
    return true;
  }
  double logarithm() { return sum_ - numeric::log(product_) + weighed_.sum(); }

 private:
  double sum_ = 0, product_ = 1;
  WeighedLogarithms weighed_;
};

/// T by three-point Gauss, and on ramps of constant path jerk 3s₁/√x₁.
BarrierSolver::Step BarrierSolver::measure(std::span<const double> c, double t, BarrierValues& values) const {
  const Step outside{infinity, infinity};
  if (!(c.front() > 0 && c.back() > 0)) return outside;
  Product barrier;
  if (!measure_coefficients(c, barrier) || !kernel_.measure(terms_, c, values)) return outside;
  const Knots& knots = problem_.knots();
  double objective = values.time + 3 * (knots.start_ramp / std::sqrt(c.front()) + knots.end_ramp / std::sqrt(c.back()));
  if (!goal_.wanted.empty()) objective += measure_excess(values);
  return {t * objective + (values.barrier + barrier.logarithm()), objective};
}

bool BarrierSolver::measure_coefficients(std::span<const double> c, Product& barrier) const {
  const std::vector<double>& caps = bounds_.caps().coefficients;
  for (std::size_t i = first_free_; i < c.size(); ++i) {
    const double inverse = 1 / caps[i];
    if (!barrier.take(1 - c[i] * inverse, (c[i] - floors_[i]) * inverse, weight_index(i))) return false;
  }
  return !problem_.ends_in_creep() || barrier.take(1 - c.back() / problem_.creep().back());
}

double BarrierSolver::measure_excess(const BarrierValues& values) const {
  double sum = 0;
  for (std::size_t k = 0; k < problem_.intervals(); ++k) {
    const double h = problem_.basis()[k].h;
    for (std::size_t q = 0; q < 3; ++q)
      sum += excess(values.places[k][q], goal_.wanted[3 * k + q]).value * h * numeric::gauss_3_weights[q];
  }
  return sum;
}

void BarrierSolver::find_excess(double t) {
  terms_.excess.resize(problem_.intervals());
  for (std::size_t k = 0; k < problem_.intervals(); ++k) {
    const double h = problem_.basis()[k].h;
    for (std::size_t q = 0; q < 3; ++q) {
      const Excess above = excess(values_.places[k][q], goal_.wanted[3 * k + q]);
      const double weight = t * h * numeric::gauss_3_weights[q];
      terms_.excess[k].slope[q] = weight * above.slope;
      terms_.excess[k].curvature[q] = weight * above.curvature;
    }
  }
}

// ---------------------------------------------------------------------------------------------------------------------

void BarrierSolver::assemble(double t) {
  hessian_.reset(iterate_.variables().size());
  gradient_.assign(iterate_.variables().size(), 0.0);
  if (!goal_.wanted.empty()) find_excess(t);
  assemble_coefficients(t);
  kernel_.assemble(terms_, t, values_, duals_, models_);
  for (std::size_t k = 0; k < problem_.intervals(); ++k) add_to_variables(k, models_[k]);
}

/// From coefficients to variables.
void BarrierSolver::add_to_variables(std::size_t k, const LocalModel& model) {
  std::size_t at = 0;
  if (k >= first_single_ && k + 4 <= end_single_) {
    const std::size_t first = problem_.variable(k);
    for (std::size_t i = 0; i < 4; ++i) {
      gradient_[first + i] += model.gradient[i];
      for (std::size_t j = 0; j <= i; ++j) hessian_.row(first + i)[i - j] += model.hessian[at++];
    }
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (!problem_.is_free(k + i)) {
      at += i + 1;
      continue;
    }
    const std::size_t vi = problem_.variable(k + i);
    const double wi = problem_.weight(k + i);
    gradient_[vi] += wi * model.gradient[i];
    for (std::size_t j = 0; j <= i; ++j, ++at) {
      if (!problem_.is_free(k + j)) continue;
      const std::size_t vj = problem_.variable(k + j);
      const double value = wi * problem_.weight(k + j) * model.hessian[at];
      hessian_.add(vi, vj, i != j && vi == vj ? 2 * value : value);
    }
  }
}

void BarrierSolver::add_single(std::size_t coefficient, double slope, double curvature) {
  const std::size_t v = problem_.variable(coefficient);
  const double w = problem_.weight(coefficient);
  gradient_[v] += w * slope;
  hessian_.add(v, v, w * w * curvature);
}

void BarrierSolver::keep_below(std::size_t coefficient, double greatest, double dual, double weight) {
  const double inverse = weight / (greatest - iterate_.coefficients()[coefficient]);
  add_single(coefficient, inverse, dual * inverse / greatest);
}

void BarrierSolver::spend_on_ramp(std::size_t coefficient, double ramp, double t) {
  const double x = iterate_.coefficients()[coefficient], time = 3 * ramp / std::sqrt(x);
  add_single(coefficient, -0.5 * t * time / x, 0.75 * t * time / squared(x));
}

/// Caps, floors and ramps.
void BarrierSolver::assemble_coefficients(double t) {
  const std::vector<double>& c = iterate_.coefficients();
  const double of_floors = is_first_ ? tuning::barrier::first_floor_curvature : 1;
  for (std::size_t i = first_free_; i < c.size(); ++i) {
    keep_below(i, bounds_.caps().coefficients[i], cap_duals_[i], weight(i));
    const double above = 1 / (c[i] - floors_[i]), weighed = weight(i) * above;
    add_single(i, -weighed, of_floors * weighed * above);
  }
  if (problem_.starts_at_rest()) spend_on_ramp(0, problem_.knots().start_ramp, t);
  if (problem_.ends_at_rest()) {
    spend_on_ramp(c.size() - 1, problem_.knots().end_ramp, t);
  } else if (problem_.ends_in_creep()) {
    keep_below(c.size() - 1, problem_.creep().back(), creep_dual_, 1);
  }
}

// ---------------------------------------------------------------------------------------------------------------------

void BarrierSolver::center_duals() {
  const std::vector<double>&c = iterate_.coefficients(), &caps = bounds_.caps().coefficients;
  kernel_.center_duals(terms_, values_, duals_);
  for (std::size_t i = first_free_; i < c.size(); ++i) cap_duals_[i] = 1 / (1 - c[i] / caps[i]);
  creep_dual_ = 1 / (1 - c.back() / problem_.creep().back());
}

/// From the iterate to `there`, a share of Newton's step.
void BarrierSolver::step_duals(std::span<const double> there, const BarrierValues& values, double share) {
  const std::vector<double>&c = iterate_.coefficients(), &caps = bounds_.caps().coefficients;
  kernel_.step_duals(terms_, values_, values, share, duals_);
  const auto stepped = [&](double& dual, std::size_t i, double greatest) {
    const double free = 1 - c[i] / greatest, change = (there[i] - c[i]) / (greatest * share);
    dual = near_center((1 + dual * change) / free, 1 - there[i] / greatest);
  };
  for (std::size_t i = first_free_; i < c.size(); ++i) stepped(cap_duals_[i], i, caps[i]);
  if (problem_.ends_in_creep()) stepped(creep_dual_, c.size() - 1, problem_.creep().back());
}

}  // namespace leadscrew::planner
