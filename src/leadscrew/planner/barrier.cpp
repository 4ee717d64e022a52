#include <cmath>
#include <leadscrew/planner/barrier.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
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
                             SpeedIterate& iterate)
    : problem_(problem),
      bounds_(bounds),
      goal_(goal),
      iterate_(iterate),
      floors_(goal.floors),
      inequalities_(static_cast<double>(problem.inequalities())) {
  floors_.resize(iterate.coefficients().size(), 0.0);
}

/// Newton steps until they help little; the objective then.
double BarrierSolver::follow(double t) {
  Step at = measure(iterate_.coefficients(), t);
  for (int step = 0; step < 25; ++step) {
    double decrement = 0;
    if (!newton(t, at, decrement) || decrement < 1e-4 * inequalities_ + 0.3) break;
  }
  return at.objective;
}

bool BarrierSolver::newton(double t, Step& at, double& decrement) {
  ++newton_steps_;
  assemble(t);
  direction_ = gradient_;
  hessian_.factor(1e-13);
  hessian_.solve(direction_);
  decrement = 0;
  for (std::size_t i = 0; i < direction_.size(); ++i) decrement += gradient_[i] * direction_[i];
  if (!(decrement > 0)) return false;
  double length = 1;
  for (int halving = 0; halving < 30; ++halving, length /= 2) {
    iterate_.step_back(problem_, direction_, length, trial_);
    const Step there = measure(trial_.coefficients(), t);
    if (there.value <= at.value - 0.05 * length * decrement) {
      at = there;
      std::swap(iterate_, trial_);
      return true;
    }
  }
  return false;
}

// ---------------------------------------------------------------------------------------------------------------------

/// −Σ log of factors, by few logarithms of products.
class BarrierSolver::Product {
 public:
  /// False where the factor is not above 0.
  bool take(double factor) {
    product_ *= factor;
    if (product_ < 1e-200) {
      sum_ -= std::log(product_);
      product_ = 1;
    }
    return factor > 0;
  }
  /// t·objective with the barrier.
  double with(double weighted_objective) const { return weighted_objective + sum_ - std::log(product_); }

 private:
  double sum_ = 0, product_ = 1;
};

BarrierSolver::Step BarrierSolver::measure(const std::vector<double>& c, double t) const {
  const Step outside{infinity, infinity};
  if (!(c.front() > 0 && c.back() > 0)) return outside;
  double objective = 0;
  Product barrier;
  if (!measure_caps(c, barrier) || !measure_objective(c, objective) || !measure_rows(c, barrier) ||
      !measure_places(c, barrier)) {
    return outside;
  }
  return {barrier.with(t * objective), objective};
}

bool BarrierSolver::measure_caps(const std::vector<double>& c, Product& barrier) const {
  const std::vector<double>& caps = bounds_.caps().coefficients;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (problem_.is_free(i) && !(barrier.take(1 - c[i] / caps[i]) && barrier.take((c[i] - floors_[i]) / caps[i])))
      return false;
  }
  return !problem_.ends_in_creep() || barrier.take(1 - c.back() / problem_.creep().back());
}

/// T by three-point Gauss, and on ramps of constant path jerk 3s₁/√x₁.
bool BarrierSolver::measure_objective(const std::vector<double>& c, double& objective) const {
  const Knots& knots = problem_.knots();
  double sum = 3 * (knots.start_ramp / std::sqrt(c.front()) + knots.end_ramp / std::sqrt(c.back()));
  for (std::size_t k = 0; k < problem_.intervals(); ++k) {
    const double h = problem_.basis()[k].h;
    for (std::size_t q = 0; q < 3; ++q) {
      const double x = dot(problem_.gauss()[3 * k + q], &c[k]);
      if (!(x > 0)) return false;
      sum += h * numeric::gauss_3_weights[q] / std::sqrt(x);
      if (!goal_.wanted.empty()) sum += excess(x, goal_.wanted[3 * k + q]).value * h * numeric::gauss_3_weights[q];
    }
  }
  objective = sum;
  return true;
}

bool BarrierSolver::measure_rows(const std::vector<double>& c, Product& barrier) const {
  const std::span<const SpeedProblem::Site> sites = problem_.sites();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const SpeedProblem::Site& site = sites[i];
    const double* at = &c[site.interval];
    const double x = dot(site.x, at), f = squared(bounds_.factor(site, i));
    if (!(x > 0)) return false;
    double factor = 1;
    for (const SpeedProblem::CoefficientRow& row : problem_.rows(site)) {
      const double a = 1 - f * squared(dot(row.acceleration, at));
      const double u = 1 - f * squared(dot(row.jerk, at)) * x;
      if (!(a > 0 && u > 0)) return false;
      factor *= a * u;
    }
    if (!barrier.take(factor)) return false;
  }
  return true;
}

/// x in the middle and at the end of the intervals.
bool BarrierSolver::measure_places(const std::vector<double>& c, Product& barrier) const {
  const SquareCaps& caps = bounds_.caps();
  for (std::size_t k = 0; k < problem_.intervals(); ++k) {
    const double middle = dot(problem_.gauss()[3 * k + 1], &c[k]), end = dot(problem_.basis()[k].value(1), &c[k]);
    if (!(barrier.take(1 - middle / caps.middles[k]) && barrier.take(1 - end / caps.knots[k + 1]))) return false;
  }
  return true;
}

// ---------------------------------------------------------------------------------------------------------------------

namespace {

/// Gradient and Hessian, its lower triangle by rows, in the four coefficients of one interval.
struct LocalModel {
  const double* c = nullptr;
  Four gradient{};
  std::array<double, 10> hessian{};

  void along(const Four& p, double factor) {
    for (std::size_t i = 0; i < 4; ++i) gradient[i] += factor * p[i];
  }
  void rank_one(const Four& p, double factor) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double scaled = factor * p[i];
      for (std::size_t j = 0; j <= i; ++j) hessian[at++] += scaled * p[j];
    }
  }
  /// (p qᵀ + q pᵀ)/2
  void outer(const Four& p, const Four& q) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j) hessian[at++] += 0.5 * (p[i] * q[j] + q[i] * p[j]);
    }
  }
  /// −log(greatest − x)
  void stay_below(const Four& place, double greatest) {
    const double inverse = 1 / (greatest - dot(place, c));
    along(place, inverse);
    rank_one(place, inverse * inverse);
  }
};

void add_objective(const SpeedProblem& problem, const SpeedGoal& goal, std::size_t k, double t, LocalModel& model) {
  const double h = problem.basis()[k].h;
  for (std::size_t q = 0; q < 3; ++q) {
    const Four& e = problem.gauss()[3 * k + q];
    const double x = dot(e, model.c), part = t * h * numeric::gauss_3_weights[q] / (x * std::sqrt(x));
    model.along(e, -0.5 * part);
    model.rank_one(e, 0.75 * part / x);
    if (goal.wanted.empty()) continue;
    const Excess above = excess(x, goal.wanted[3 * k + q]);
    model.along(e, t * h * numeric::gauss_3_weights[q] * above.slope);
    model.rank_one(e, t * h * numeric::gauss_3_weights[q] * above.curvature);
  }
}

/// Of u = g²x, with p = ∇g and e = ∇x: ∇u = 2gx p + g² e; the Hessian is modelled by U Uᵀ + Z Zᵀ, U = ∇u/(1 − u),
/// Z = √(2x/(1 − u)) (p + (g/x) e), which is never indefinite.
void add_site(const SpeedProblem& problem, const SpeedBounds& bounds, std::size_t index, LocalModel& model) {
  const SpeedProblem::Site& site = problem.sites()[index];
  const double* c = model.c;
  const double x = dot(site.x, c), inverse_x = 1 / x, ff = squared(bounds.factor(site, index));
  double by_x = 0, by_xx = 0;
  Four with_x{};
  for (const SpeedProblem::CoefficientRow& row : problem.rows(site)) {
    const double a = dot(row.acceleration, c), g = dot(row.jerk, c);
    const double free_a = 1 - ff * a * a, free_j = 1 - ff * g * g * x, both = 1 / (free_a * free_j);
    const double of_a = free_j * both, of_j = free_a * both;  // 1/(1 − A²) and 1/(1 − u)
    model.along(row.acceleration, 2 * ff * a * of_a);
    model.rank_one(row.acceleration, 2 * ff * of_a * (1 + 2 * ff * a * a * of_a));
    const double u_p = 2 * ff * g * x * of_j, u_e = ff * g * g * of_j, z = 2 * ff * x * of_j;
    model.along(row.jerk, u_p);
    by_x += u_e;
    model.rank_one(row.jerk, u_p * u_p + z);
    const double mixed = 2 * (u_p * u_e + z * g * inverse_x);
    for (std::size_t i = 0; i < 4; ++i) with_x[i] += mixed * row.jerk[i];
    by_xx += u_e * u_e + z * squared(g * inverse_x);
  }
  model.along(site.x, by_x);
  model.rank_one(site.x, by_xx);
  model.outer(with_x, site.x);
}

/// From coefficients to variables.
void add_to_variables(const SpeedProblem& problem, std::size_t k, const LocalModel& model,
                      numeric::BandedMatrix<3>& hessian, std::vector<double>& gradient) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!problem.is_free(k + i)) {
      at += i + 1;
      continue;
    }
    const std::size_t vi = problem.variable(k + i);
    const double wi = problem.weight(k + i);
    gradient[vi] += wi * model.gradient[i];
    for (std::size_t j = 0; j <= i; ++j, ++at) {
      if (!problem.is_free(k + j)) continue;
      const std::size_t vj = problem.variable(k + j);
      const double value = wi * problem.weight(k + j) * model.hessian[at];
      hessian.add(vi, vj, i != j && vi == vj ? 2 * value : value);
    }
  }
}

}  // namespace

void BarrierSolver::assemble(double t) {
  hessian_.reset(iterate_.variables().size());
  gradient_.assign(iterate_.variables().size(), 0.0);
  assemble_coefficients(t);
  const std::span<const SpeedProblem::Site> sites = problem_.sites();
  const SquareCaps& caps = bounds_.caps();
  std::size_t next_site = 0;
  for (std::size_t k = 0; k < problem_.intervals(); ++k) {
    LocalModel model{&iterate_.coefficients()[k]};
    add_objective(problem_, goal_, k, t, model);
    model.stay_below(problem_.gauss()[3 * k + 1], caps.middles[k]);
    model.stay_below(problem_.basis()[k].value(1), caps.knots[k + 1]);
    for (; next_site < sites.size() && sites[next_site].interval == k; ++next_site)
      add_site(problem_, bounds_, next_site, model);
    add_to_variables(problem_, k, model, hessian_, gradient_);
  }
}

void BarrierSolver::add_single(std::size_t coefficient, double slope, double curvature) {
  const std::size_t v = problem_.variable(coefficient);
  const double w = problem_.weight(coefficient);
  gradient_[v] += w * slope;
  hessian_.add(v, v, w * w * curvature);
}

void BarrierSolver::keep_below(std::size_t coefficient, double greatest) {
  const double inverse = 1 / (greatest - iterate_.coefficients()[coefficient]);
  add_single(coefficient, inverse, inverse * inverse);
}

void BarrierSolver::spend_on_ramp(std::size_t coefficient, double ramp, double t) {
  const double x = iterate_.coefficients()[coefficient], time = 3 * ramp / std::sqrt(x);
  add_single(coefficient, -0.5 * t * time / x, 0.75 * t * time / squared(x));
}

/// Caps, floors and ramps.
void BarrierSolver::assemble_coefficients(double t) {
  const std::vector<double>& c = iterate_.coefficients();
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (!problem_.is_free(i)) continue;
    keep_below(i, bounds_.caps().coefficients[i]);
    const double above = 1 / (c[i] - floors_[i]);
    add_single(i, -above, above * above);
  }
  if (problem_.starts_at_rest()) spend_on_ramp(0, problem_.knots().start_ramp, t);
  if (problem_.ends_at_rest()) {
    spend_on_ramp(c.size() - 1, problem_.knots().end_ramp, t);
  } else if (problem_.ends_in_creep()) {
    keep_below(c.size() - 1, problem_.creep().back());
  }
}

}  // namespace leadscrew::planner
