#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_profile.hpp>
#include <limits>

// The least time by a logarithmic barrier, and the fastest way down to a lower speed.

namespace leadscrew::planner {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double descent_weight = 4;        // of speed above what is wanted, against time
constexpr double descent_floor = 0.9;       // of the wanted x
constexpr double descent_softness = 0.004;  // of the wanted x
constexpr double descent_first_gap = 3, cold_descent_gap = 20, descent_gap = 0.02;
constexpr std::array<double, 3> gauss_weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// What x above the wanted costs a unit of way, with derivatives: ρ (y + √(y² + ε²)) / 2√w, y = x/w − 1.
struct Excess {
  double value = 0, slope = 0, curvature = 0;
};
Excess excess(double x, double wanted) {
  const double y = x / wanted - 1, root = std::sqrt(y * y + squared(descent_softness));
  const double scale = descent_weight / (2 * std::sqrt(wanted));
  return {scale * (y + root), scale * (1 + y / root) / wanted,
          scale * squared(descent_softness) / (root * root * root * squared(wanted))};
}

}  // namespace

SpeedProfile::Step SpeedProfile::measure(const std::vector<double>& c, double t) const {
  const Step outside{infinity, infinity};
  if (!(c.front() > 0 && c.back() > 0)) return outside;
  double time = 3 * (knots_.start_ramp / std::sqrt(c.front()) + knots_.end_ramp / std::sqrt(c.back()));
  double barrier = 0, product = 1;
  const auto take = [&](double factor) {
    product *= factor;
    if (product < 1e-200) {
      barrier -= std::log(product);
      product = 1;
    }
    return factor > 0;
  };
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (is_free(i) && !(take(1 - c[i] / caps_[i]) && take((c[i] - floors_[i]) / caps_[i]))) return outside;
  }
  if (!ends_at_rest() && !take(1 - c.back() / creep_.back())) return outside;
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const double h = basis_[k].h;
    for (std::size_t q = 0; q < 3; ++q) {
      const double x = dot(gauss_[3 * k + q], &c[k]);
      if (!(x > 0)) return outside;
      time += h * gauss_weights[q] / std::sqrt(x);
      if (!wanted_.empty()) time += excess(x, wanted_[3 * k + q]).value * h * gauss_weights[q];
    }
  }
  for (const Site& site : sites_) {
    const double* at = &c[site.interval];
    const double x = dot(site.x, at), f = squared(tightened_[site.interval] * site.factor);
    if (!(x > 0)) return outside;
    double factor = 1;
    for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
      const double a = 1 - f * squared(dot(rows_[r].acceleration, at));
      const double u = 1 - f * squared(dot(rows_[r].jerk, at)) * x;
      if (!(a > 0 && u > 0)) return outside;
      factor *= a * u;
    }
    if (!take(factor)) return outside;
  }
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const double middle = dot(gauss_[3 * k + 1], &c[k]), end = dot(basis_[k].value(1), &c[k]);
    if (!(take(1 - middle / middle_caps_[k]) && take(1 - end / knot_caps_[k + 1]))) return outside;
  }
  return {t * time + barrier - std::log(product), time};
}

void SpeedProfile::assemble(double t) {
  hessian_.reset(variables_.size());
  gradient_.assign(variables_.size(), 0.0);
  const auto single = [&](std::size_t coefficient, double slope, double curvature) {
    const auto v = static_cast<std::size_t>(variable_[coefficient]);
    const double w = weight_[coefficient];
    gradient_[v] += w * slope;
    hessian_.add(v, v, w * w * curvature);
  };
  const auto keep_below = [&](std::size_t coefficient, double greatest) {
    const double inverse = 1 / (greatest - c_[coefficient]);
    single(coefficient, inverse, inverse * inverse);
  };
  const auto spend_on_ramp = [&](std::size_t coefficient, double ramp) {
    const double time = 3 * ramp / std::sqrt(c_[coefficient]);
    single(coefficient, -0.5 * t * time / c_[coefficient], 0.75 * t * time / squared(c_[coefficient]));
  };
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (!is_free(i)) continue;
    keep_below(i, caps_[i]);
    const double above = 1 / (c_[i] - floors_[i]);
    single(i, -above, above * above);
  }
  if (starts_at_rest()) spend_on_ramp(0, knots_.start_ramp);
  if (ends_at_rest()) {
    spend_on_ramp(c_.size() - 1, knots_.end_ramp);
  } else {
    keep_below(c_.size() - 1, creep_.back());
  }
  std::size_t next_site = 0;
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const double* c = &c_[k];
    Four gradient{};
    std::array<double, 10> hessian{};                       // lower triangle by rows
    const auto outer = [&](const Four& p, const Four& q) {  // (p qᵀ + q pᵀ)/2
      std::size_t at = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j <= i; ++j) hessian[at++] += 0.5 * (p[i] * q[j] + q[i] * p[j]);
      }
    };
    const auto rank_one = [&](const Four& p, double factor) {
      std::size_t at = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const double scaled = factor * p[i];
        for (std::size_t j = 0; j <= i; ++j) hessian[at++] += scaled * p[j];
      }
    };
    const auto along = [&](const Four& p, double factor) {
      for (std::size_t i = 0; i < 4; ++i) gradient[i] += factor * p[i];
    };
    for (std::size_t q = 0; q < 3; ++q) {
      const Four& e = gauss_[3 * k + q];
      const double x = dot(e, c), part = t * basis_[k].h * gauss_weights[q] / (x * std::sqrt(x));
      along(e, -0.5 * part);
      rank_one(e, 0.75 * part / x);
      if (wanted_.empty()) continue;
      const Excess above = excess(x, wanted_[3 * k + q]);
      along(e, t * basis_[k].h * gauss_weights[q] * above.slope);
      rank_one(e, t * basis_[k].h * gauss_weights[q] * above.curvature);
    }
    const auto stay_below = [&](const Four& place, double greatest) {
      const double inverse = 1 / (greatest - dot(place, c));
      along(place, inverse);
      rank_one(place, inverse * inverse);
    };
    stay_below(gauss_[3 * k + 1], middle_caps_[k]);
    stay_below(basis_[k].value(1), knot_caps_[k + 1]);
    for (; next_site < sites_.size() && sites_[next_site].interval == k; ++next_site) {
      const Site& site = sites_[next_site];
      const double x = dot(site.x, c), inverse_x = 1 / x, ff = squared(tightened_[k] * site.factor);
      double by_x = 0, by_xx = 0;
      Four with_x{};
      for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
        const Row& row = rows_[r];
        const double a = dot(row.acceleration, c), g = dot(row.jerk, c);
        const double free_a = 1 - ff * a * a, free_j = 1 - ff * g * g * x, both = 1 / (free_a * free_j);
        const double room_a = free_j * both, room = free_a * both;
        along(row.acceleration, 2 * ff * a * room_a);
        rank_one(row.acceleration, 2 * ff * room_a * (1 + 2 * ff * a * a * room_a));
        // u = g²x: ∇u = 2gx p + g² e; the Hessian is modelled by U Uᵀ + Z Zᵀ, U = ∇u/(1 − u),
        // Z = √(2x/(1 − u)) (p + (g/x) e), which is never indefinite.
        const double u_p = 2 * ff * g * x * room, u_e = ff * g * g * room, z = 2 * ff * x * room;
        along(row.jerk, u_p);
        by_x += u_e;
        rank_one(row.jerk, u_p * u_p + z);
        const double mixed = 2 * (u_p * u_e + z * g * inverse_x);
        for (std::size_t i = 0; i < 4; ++i) with_x[i] += mixed * row.jerk[i];
        by_xx += u_e * u_e + z * squared(g * inverse_x);
      }
      along(site.x, by_x);
      rank_one(site.x, by_xx);
      outer(with_x, site.x);
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!is_free(k + i)) {
        at += i + 1;
        continue;
      }
      const auto vi = static_cast<std::size_t>(variable_[k + i]);
      const double wi = weight_[k + i];
      gradient_[vi] += wi * gradient[i];
      for (std::size_t j = 0; j <= i; ++j, ++at) {
        if (!is_free(k + j)) continue;
        const auto vj = static_cast<std::size_t>(variable_[k + j]);
        const double value = wi * weight_[k + j] * hessian[at];
        hessian_.add(vi, vj, i != j && vi == vj ? 2 * value : value);
      }
    }
  }
}

bool SpeedProfile::newton(double t, Step& at, double& decrement) {
  ++newton_steps_;
  assemble(t);
  step_ = gradient_;
  hessian_.factor(1e-13);
  hessian_.solve(step_);
  decrement = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) decrement += gradient_[i] * step_[i];
  if (!(decrement > 0)) return false;
  double length = 1;
  for (int halving = 0; halving < 30; ++halving, length /= 2) {
    trial_.resize(variables_.size());
    for (std::size_t i = 0; i < step_.size(); ++i) trial_[i] = variables_[i] - length * step_[i];
    trial_c_ = c_;
    for (std::size_t i = 0; i < c_.size(); ++i) {
      if (is_free(i)) trial_c_[i] = weight_[i] * trial_[static_cast<std::size_t>(variable_[i])];
    }
    const Step there = measure(trial_c_, t);
    if (there.value <= at.value - 0.05 * length * decrement) {
      at = there;
      variables_.swap(trial_);
      c_.swap(trial_c_);
      return true;
    }
  }
  return false;
}

SpeedProfile::Step SpeedProfile::follow(double t) {
  const double m = static_cast<double>(constraints());
  Step at = measure(c_, t);
  for (int step = 0; step < 25; ++step) {
    double decrement = 0;
    if (!newton(t, at, decrement) || decrement < 1e-4 * m + 0.3) break;
  }
  return at;
}

/// Remembers the present profile to go back to, and takes back what was granted and it does not need.
void SpeedProfile::keep_far_inside() {
  constexpr double inside = 0.999;
  far_inside_ = c_;
  for (Site& site : sites_) {
    if (site.factor < 1 && tightened_[site.interval] * greatest_of_rows(site, c_) < inside) site.factor = 1;
  }
}

void SpeedProfile::center(double gap) {
  follow(static_cast<double>(constraints()) / (gap * measure(c_, 1).objective));
  keep_far_inside();
}

void SpeedProfile::optimize(double first_gap, double gap) {
  const double m = static_cast<double>(constraints());
  double t = m / (first_gap * measure(c_, 1).objective);
  for (int stage = 0; stage < 30; ++stage) {
    const double left = m / t / follow(t).objective;
    if (left > 0.1) keep_far_inside();
    if (left < gap) break;
    t *= 8;
  }
}

void SpeedProfile::descend() {
  const std::vector<double> caps = asked_caps_, knot_caps = asked_knot_caps_, middle_caps = asked_middle_caps_;
  for (std::size_t i = 0; i < c_.size(); ++i) {
    floors_[i] = std::min(descent_floor * caps[i], descent_floor * descent_floor * c_[i]);
  }
  optimize(descent_first_gap, descent_gap);
  floors_.assign(c_.size(), 0.0);
  wanted_.clear();
  caps_ = caps;
  knot_caps_ = knot_caps;
  middle_caps_ = middle_caps;
  grant(0.0005);
}

void SpeedProfile::descend_to_creep() {
  const double least = 2e-3 * c_[0];
  wanted_.clear();
  for (std::size_t k = 0; k < intervals(); ++k) {
    for (std::size_t q = 0; q < gauss_weights.size(); ++q) {
      wanted_.push_back(std::max(0.5 * dot(gauss_[3 * k + q], &creep_[k]), least));
    }
  }
  optimize(cold_descent_gap, descent_gap);
}

}  // namespace leadscrew::planner
