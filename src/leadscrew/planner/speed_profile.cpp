#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_profile.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Of the limits, for what lies between the places looked at and for the step from spline to quintics:
constexpr double limit_margin = 0.9995;      // of acceleration and jerk
constexpr double feed_margin = 1 - 1e-7;     // of the programmed speed, squared
constexpr double turning_margin = 1 - 2e-4;  // of the speed, squared, where it is an axis' that trades with others
constexpr std::array<double, 3> gauss_places = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> gauss_weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};

std::array<double, 6> around(const std::vector<double>& s, std::size_t k) {
  std::array<double, 6> t;
  const auto last = static_cast<std::ptrdiff_t>(s.size()) - 1;
  for (std::ptrdiff_t i = 0; i < 6; ++i) {
    t[static_cast<std::size_t>(i)] =
        s[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(k) + i - 2, 0, last))];
  }
  return t;
}

/// c₀, c₁, c₂ of a clamped spline that goes on from x ∝ s^(4/3) at s₁, for x(s₁) = 1: x′ = 4/(3s₁), x″ = 4/(9s₁²).
std::array<double, 3> rest_tie(double s1, double h0, double h1) {
  const double slope = 4 / (3 * s1), bend = 4 / (9 * s1 * s1);
  const double g1 = 1 + slope * h0 / 3;
  return {1, g1, g1 + (h0 + h1) / 3 * (bend * h0 / 2 + slope)};
}

double squared(double v) {
  return v * v;
}

}  // namespace

SpeedProfile::SpeedProfile(const Section& section, const machine::Machine& machine, Knots knots)
    : machine_(machine), knots_(std::move(knots)) {
  const std::vector<double>& s = knots_.s;
  const std::size_t n = intervals();
  basis_.reserve(n);
  gauss_.reserve(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    basis_.emplace_back(around(s, k));
    for (const double u : gauss_places) gauss_.push_back(basis_[k].value(u));
  }
  start_tie_ = rest_tie(knots_.start_ramp, s[1] - s[0], s[2] - s[1]);
  end_tie_ = rest_tie(knots_.end_ramp, s[n] - s[n - 1], s[n - 1] - s[n - 2]);
  tightened_.assign(n, 1.0);
  knot_caps_.assign(n + 1, infinity);
  std::vector<double> middle_caps(n);
  geometry::PointJet left = section.jets(s[0], Side::right);
  const auto cap = [&](double at, Side side, const geometry::PointJet& jet) {
    const double square = section.greatest_square(at, side, jet, machine);
    const bool by_feed = square == squared(section.piece(section.piece_at(at, side)).feed);
    return (turns(jet) && !by_feed ? turning_margin : feed_margin) * square;
  };
  knot_caps_[0] = cap(s[0], Side::right, left);
  add_site(0, 0, left);
  for (std::size_t k = 0; k < n; ++k) {
    const double half = (s[k] + s[k + 1]) / 2;
    const geometry::PointJet middle = section.jets(half, Side::left), right = section.jets(s[k + 1], Side::left);
    middle_caps[k] = cap(half, Side::left, middle);
    knot_caps_[k + 1] = cap(s[k + 1], Side::left, right);
    if (k > 0 && knots_.breaks[k]) add_site(k, 0, left);
    add_hull(k, {&left, &middle, &right});
    bool peak = false;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const auto above = [](double m, double a, double b) {
        return std::abs(m) > 1.001 * std::max(std::abs(a), std::abs(b));
      };
      peak = peak || above(middle[i].second, left[i].second, right[i].second) ||
             above(middle[i].third, left[i].third, right[i].third);
    }
    if (peak) {
      for (const double u : {0.25, 0.5, 0.75}) {
        add_site(k, u, u == 0.5 ? middle : section.jets(s[k] + u * (s[k + 1] - s[k]), Side::left));
      }
    }
    add_site(k, 1, right);
    left = right;
    if (knots_.breaks[k + 1]) {
      left = section.jets(s[k + 1], Side::right);
      knot_caps_[k + 1] = std::min(knot_caps_[k + 1], cap(s[k + 1], Side::right, left));
    }
  }
  // A coefficient is no greater than the greatest x over the two intervals in the middle of its reach; the spline lies
  // in the hull of its coefficients. Where the programmed speed falls at a knot, the smaller holds on both sides.
  caps_.assign(n + 3, infinity);
  for (std::size_t i = 0; i < n + 3; ++i) {
    const std::size_t from = i >= 2 ? std::min(i - 2, n - 1) : 0, to = i >= 1 ? std::min(i - 1, n - 1) : 0;
    double greatest = 0;
    bool step = false;
    for (std::size_t k = from; k <= to; ++k) {
      greatest = std::max({greatest, middle_caps[k], knot_caps_[k], knot_caps_[k + 1]});
      step = step || knots_.breaks[k] || knots_.breaks[k + 1];
    }
    if (step) {
      for (std::size_t k = from; k <= to; ++k)
        greatest = std::min({greatest, middle_caps[k], knot_caps_[k], knot_caps_[k + 1]});
    }
    caps_[i] = greatest;
  }
  creep();
}

void SpeedProfile::add_site(std::size_t interval, double u, const geometry::PointJet& jet) {
  const CubicBasis& basis = basis_[interval];
  const Four x = basis.value(u), slope = basis.slope(u), bend = basis.bend(u);
  Site site{static_cast<std::uint32_t>(interval), static_cast<std::uint32_t>(rows_.size()), 0, false, x};
  for (const base::Axis axis : base::all_axes) {
    const numeric::Jet& q = jet[base::index(axis)];
    if (q.first == 0 && q.second == 0 && q.third == 0) continue;
    const machine::AxisLimits& limits = machine_.limits(axis);
    const double a = 1 / (limit_margin * limits.acceleration), j = 1 / (limit_margin * limits.jerk);
    Row& row = rows_.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      row.acceleration[k] = a * (q.second * x[k] + q.first * slope[k] / 2);
      row.jerk[k] = j * (q.third * x[k] + 1.5 * q.second * slope[k] + q.first * bend[k] / 2);
    }
  }
  site.end_row = static_cast<std::uint32_t>(rows_.size());
  sites_.push_back(site);
}

void SpeedProfile::add_hull(std::size_t interval, const std::array<const geometry::PointJet*, 3>& jets) {
  const CubicBasis& basis = basis_[interval];
  const auto neighbour = [&](std::size_t k) { return std::abs(basis_[k].h / basis.h - 1); };
  double uneven = 0;
  if (interval > 0) uneven = std::max(uneven, neighbour(interval - 1));
  if (interval + 1 < basis_.size()) uneven = std::max(uneven, neighbour(interval + 1));
  uneven = std::min(uneven, 0.4);
  const double jerk_factor = uneven > 0.04 ? 1 + 0.04 * uneven * uneven : 1;
  const std::array<double, 3> places = {0, 0.5, 1}, parts = {-0.5, 2, -0.5};
  Site site{static_cast<std::uint32_t>(interval), static_cast<std::uint32_t>(rows_.size()), 0, true, basis.value(0.5)};
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    bool moves = false;
    for (const geometry::PointJet* jet : jets) {
      const numeric::Jet& q = (*jet)[i];
      moves = moves || q.first != 0 || q.second != 0 || q.third != 0;
    }
    if (!moves) continue;
    const machine::AxisLimits& limits = machine_.limits(axis);
    const double a = 1 / (limit_margin * limits.acceleration), j = jerk_factor / (limit_margin * limits.jerk);
    Row& row = rows_.emplace_back();
    for (std::size_t p = 0; p < 3; ++p) {
      const numeric::Jet& q = (*jets[p])[i];
      const Four x = basis.value(places[p]), slope = basis.slope(places[p]), bend = basis.bend(places[p]);
      for (std::size_t k = 0; k < 4; ++k) {
        row.acceleration[k] += parts[p] * a * (q.second * x[k] + q.first * slope[k] / 2);
        row.jerk[k] += parts[p] * j * (q.third * x[k] + 1.5 * q.second * slope[k] + q.first * bend[k] / 2);
      }
    }
  }
  site.end_row = static_cast<std::uint32_t>(rows_.size());
  sites_.push_back(site);
}

std::size_t SpeedProfile::variable(std::size_t coefficient) const {
  return std::clamp<std::size_t>(coefficient, 2, intervals()) - 2;
}

double SpeedProfile::weight(std::size_t coefficient) const {
  if (coefficient <= 2) return start_tie_[coefficient];
  const std::size_t n = intervals();
  return coefficient >= n ? end_tie_[n + 2 - coefficient] : 1;
}

/// Each row alone, with room to spare, over a span of the narrowest interval around (see the derivation with the
/// knots).
void SpeedProfile::creep() {
  const std::size_t n = intervals();
  std::vector<double> y(n + 3, infinity);
  for (std::size_t i = 0; i < n + 3; ++i) y[i] = 0.5 * caps_[i];
  for (const Site& site : sites_) {
    if (site.hull) continue;
    const std::size_t k = site.interval;
    const CubicBasis& basis = basis_[k];
    double h = basis.h;
    if (k > 0) h = std::min(h, basis_[k - 1].h);
    if (k + 1 < n) h = std::min(h, basis_[k + 1].h);
    double bound = infinity;
    for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
      // Largest |A| and |g| over coefficients between 0 and y are bounded by the rows' sums of magnitudes: use the
      // parts.
      double by_a = 0, by_j = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        by_a += std::abs(rows_[r].acceleration[j]);
        by_j += std::abs(rows_[r].jerk[j]);
      }
      if (by_a > 0) bound = std::min(bound, 0.3 / by_a);
      if (by_j > 0) bound = std::min(bound, std::pow(0.3 / by_j, 2.0 / 3));
    }
    for (std::size_t j = 0; j < 4; ++j) y[k + j] = std::min(y[k + j], bound);
  }
  const auto tie = [&] {
    double start = infinity, end = infinity;
    for (std::size_t j = 0; j < 3; ++j) {
      start = std::min(start, y[j] / start_tie_[j]);
      end = std::min(end, y[n + 2 - j] / end_tie_[j]);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      y[j] = start * start_tie_[j];
      y[n + 2 - j] = end * end_tie_[j];
    }
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 1; i < n + 3; ++i) y[i] = std::min(y[i], 1.5 * y[i - 1]);
    for (std::size_t i = n + 2; i-- > 0;) y[i] = std::min(y[i], 1.5 * y[i + 1]);
    tie();
  }
  c_ = y;
  // Slowing time by λ scales velocity, acceleration and jerk by λ, λ², λ³: always a way inside.
  for (int round = 0; round < 60 && !(greatest_ratio() < 0.9); ++round) {
    for (double& c : c_) c *= 0.7;
  }
  variables_.assign(n - 1, 0.0);
  for (std::size_t i = 0; i < n + 3; ++i) variables_[variable(i)] = c_[i] / weight(i);
}

double SpeedProfile::greatest_ratio() const {
  double greatest = 0;
  for (std::size_t i = 0; i < c_.size(); ++i) greatest = std::max(greatest, c_[i] / caps_[i]);
  for (std::size_t k = 0; k < intervals(); ++k) greatest = std::max(greatest, square(k, 1) / knot_caps_[k + 1]);
  for (const Site& site : sites_) {
    const double* c = &c_[site.interval];
    const double x = dot(site.x, c), f = tightened_[site.interval];
    for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
      const double a = f * dot(rows_[r].acceleration, c), g = f * dot(rows_[r].jerk, c);
      greatest = std::max({greatest, std::abs(a), std::abs(g) * std::sqrt(std::max(x, 0.0))});
    }
    if (!(x > 0)) return infinity;
  }
  return greatest;
}

void SpeedProfile::apply(const std::vector<double>& variables) {
  for (std::size_t i = 0; i < c_.size(); ++i) c_[i] = weight(i) * variables[variable(i)];
}

SpeedProfile::Step SpeedProfile::measure(const std::vector<double>& c, double t) const {
  const Step outside{infinity, infinity};
  double time = 3 * (knots_.start_ramp / std::sqrt(c.front()) + knots_.end_ramp / std::sqrt(c.back()));
  if (!(c.front() > 0 && c.back() > 0)) return outside;
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
    if (!take(1 - c[i] / caps_[i])) return outside;
  }
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const double h = basis_[k].h;
    for (std::size_t q = 0; q < 3; ++q) {
      const double x = dot(gauss_[3 * k + q], &c[k]);
      if (!(x > 0)) return outside;
      time += h * gauss_weights[q] / std::sqrt(x);
    }
  }
  for (const Site& site : sites_) {
    const double* at = &c[site.interval];
    const double x = dot(site.x, at), f = squared(tightened_[site.interval]);
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
    const double x = dot(basis_[k].value(1), &c[k]);
    if (!take(1 - x / knot_caps_[k + 1])) return outside;
  }
  return {t * time + barrier - std::log(product), time};
}

void SpeedProfile::assemble(double t) {
  hessian_.reset(variables_.size());
  gradient_.assign(variables_.size(), 0.0);
  const auto single = [&](std::size_t coefficient, double slope, double curvature) {
    const std::size_t v = variable(coefficient);
    const double w = weight(coefficient);
    gradient_[v] += w * slope;
    hessian_.add(v, v, w * w * curvature);
  };
  for (std::size_t i = 0; i < c_.size(); ++i) {
    const double inverse = 1 / (caps_[i] - c_[i]);
    single(i, inverse, inverse * inverse);
  }
  for (const std::size_t i : {std::size_t{0}, c_.size() - 1}) {
    const double ramp = i == 0 ? knots_.start_ramp : knots_.end_ramp, time = 3 * ramp / std::sqrt(c_[i]);
    single(i, -0.5 * t * time / c_[i], 0.75 * t * time / squared(c_[i]));
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
    }
    const Four end = basis_[k].value(1);
    const double inverse = 1 / (knot_caps_[k + 1] - dot(end, c));
    along(end, inverse);
    rank_one(end, inverse * inverse);
    const double f = tightened_[k], ff = f * f;
    for (; next_site < sites_.size() && sites_[next_site].interval == k; ++next_site) {
      const Site& site = sites_[next_site];
      const double x = dot(site.x, c);
      double by_x = 0, by_xx = 0;
      Four with_x{};
      for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
        const Row& row = rows_[r];
        const double a = dot(row.acceleration, c), g = dot(row.jerk, c);
        const double room_a = 1 / (1 - ff * a * a);
        along(row.acceleration, 2 * ff * a * room_a);
        rank_one(row.acceleration, 2 * ff * room_a * (1 + 2 * ff * a * a * room_a));
        // u = g²x: ∇u = 2gx p + g² e; the Hessian is modelled by U Uᵀ + Z Zᵀ, U = ∇u/(1 − u),
        // Z = √(2x/(1 − u)) (p + (g/x) e), which is never indefinite.
        const double room = 1 / (1 - ff * g * g * x);
        const double u_p = 2 * ff * g * x * room, u_e = ff * g * g * room, z = 2 * ff * x * room;
        along(row.jerk, u_p);
        by_x += u_e;
        rank_one(row.jerk, u_p * u_p + z);
        const double mixed = 2 * (u_p * u_e + z * g / x);
        for (std::size_t i = 0; i < 4; ++i) with_x[i] += mixed * row.jerk[i];
        by_xx += u_e * u_e + z * squared(g / x);
      }
      along(site.x, by_x);
      rank_one(site.x, by_xx);
      outer(with_x, site.x);
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t vi = variable(k + i);
      const double wi = weight(k + i);
      gradient_[vi] += wi * gradient[i];
      for (std::size_t j = 0; j <= i; ++j, ++at) {
        const std::size_t vj = variable(k + j);
        const double value = wi * weight(k + j) * hessian[at];
        hessian_.add(vi, vj, i != j && vi == vj ? 2 * value : value);
      }
    }
  }
}

bool SpeedProfile::newton(double t, double& decrement) {
  ++newton_steps_;
  assemble(t);
  step_ = gradient_;
  hessian_.factor(1e-13);
  hessian_.solve(step_);
  decrement = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) decrement += gradient_[i] * step_[i];
  if (!(decrement > 0)) return false;
  const double before = measure(c_, t).value;
  double length = 1;
  for (int halving = 0; halving < 30; ++halving, length /= 2) {
    trial_.resize(variables_.size());
    for (std::size_t i = 0; i < step_.size(); ++i) trial_[i] = variables_[i] - length * step_[i];
    trial_c_.resize(c_.size());
    for (std::size_t i = 0; i < c_.size(); ++i) trial_c_[i] = weight(i) * trial_[variable(i)];
    if (measure(trial_c_, t).value <= before - 0.05 * length * decrement) {
      variables_.swap(trial_);
      c_.swap(trial_c_);
      return true;
    }
  }
  return false;
}

void SpeedProfile::optimize(double gap) {
  const double m = static_cast<double>(constraints());
  double t = m / (20 * measure(c_, 1).time);
  for (int stage = 0; stage < 30; ++stage) {
    for (int step = 0; step < 25; ++step) {
      double decrement = 0;
      if (!newton(t, decrement) || decrement < 1e-4 * m + 0.3) break;
    }
    if (m / t < gap * measure(c_, 1).time) break;
    t *= 8;
  }
}

void SpeedProfile::tighten(std::size_t interval, double factor) {
  tightened_[interval] *= factor;
}

bool SpeedProfile::is_level(std::size_t k) const {
  return c_[k] == c_[k + 1] && c_[k] == c_[k + 2] && c_[k] == c_[k + 3];
}

/// The barrier keeps x a few parts in ten thousand below the cap. Where it is that close for many knots, close the rest
/// of the gap: not at once, which would be a step of acceleration, but by a smooth share over the first and last knots.
void SpeedProfile::level_cruises() {
  constexpr double near = 2e-3;
  constexpr std::size_t shortest = 40, blend = 16;
  const std::vector<double> before = c_;
  const auto at_cap = [&](std::size_t i) { return c_[i] > (1 - near) * caps_[i]; };
  for (std::size_t i = 3; i + 3 < c_.size();) {
    std::size_t end = i;
    while (end + 3 < c_.size() && at_cap(end) && caps_[end] == caps_[i]) ++end;
    if (end - i >= shortest) {
      for (std::size_t k = i; k < end; ++k) {
        const double into = std::min(1.0, static_cast<double>(std::min(k - i, end - 1 - k)) / blend);
        const double share = into * into * into * (10 - into * (15 - 6 * into));
        c_[k] = share >= 1 ? caps_[k] : c_[k] + share * (caps_[k] - c_[k]);
      }
    }
    i = std::max(end, i + 1);
  }
  if (greatest_ratio() > 1 + 1e-12) c_ = before;
}

}  // namespace leadscrew::planner
