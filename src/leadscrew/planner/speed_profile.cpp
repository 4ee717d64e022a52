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
constexpr double turning_margin = 1 - 3e-4;  // of the speed, squared, where it is an axis' that trades with others
constexpr std::size_t creep_tail = 3;        // of the intervals at an end in motion: all their coefficients creep
constexpr std::size_t stopping_tail = 16;    // of the intervals before an end in motion
constexpr double stopping_factor = 1.08;     // of the rows there
constexpr double descent_weight = 4;         // of speed above what is wanted, against time
constexpr double descent_floor = 0.9;        // of the wanted x
constexpr double descent_softness = 0.004;   // of the wanted x
constexpr double descent_first_gap = 3, cold_descent_gap = 20, descent_gap = 0.02;
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

bool moves(const numeric::Jet& q) {
  return q.first != 0 || q.second != 0 || q.third != 0;
}

double squared(double v) {
  return v * v;
}

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

constexpr std::size_t blend = 16;  // coefficients over which a cruise is reached and left

/// From 0 to 1 with two derivatives 0 at both ends; 0 below and 1 above.
double smooth_share(double u) {
  if (u <= 0) return 0;
  return u >= 1 ? 1 : u * u * u * (10 - u * (15 - 6 * u));
}

}  // namespace

SpeedProfile::SpeedProfile(const Section& section, const machine::Machine& machine, Knots knots, double feed_factor)
    : machine_(&machine), knots_(std::move(knots)) {
  build(section, {}, feed_factor);
  tie_variables();
  creep();
}

SpeedProfile::SpeedProfile(const Section& section, const machine::Machine& machine, Knots knots, Continuation before,
                           double feed_factor)
    : machine_(&machine), knots_(std::move(knots)) {
  for (std::size_t k = 0; k < knots_.s.size() && knots_.s[k] < before.s.back(); ++k) {
    if (knots_.s[k] != before.s[k]) before.insert(knots_.s[k]);
  }
  build(section, before, feed_factor);
  tie_variables();
  c_ = creep_;
  for (double& c : c_) c *= before.share;
  for (std::size_t i = 0; i < before.c.size() && i < c_.size(); ++i) {
    c_[i] = i < before.creeping ? before.c[i] : std::min(before.c[i], c_[i]);
  }
  read_variables();
  far_inside_ = c_;
  wanted_.clear();
  for (std::size_t k = 0; k < intervals(); ++k) {
    const double lower = std::min({knot_caps_[k], knot_caps_[k + 1], caps_[k + 1], caps_[k + 2]});
    wanted_.insert(wanted_.end(), gauss_places.size(), lower);
  }
  asked_caps_ = caps_;
  asked_knot_caps_ = knot_caps_;
  asked_middle_caps_ = middle_caps_;
  too_fast_ = grant(0.002);
  if (!too_fast_) wanted_.clear();
  loosen();
}

void Continuation::insert(double knot) {
  if (knot < s[loose]) ++loose;
  const auto at = std::upper_bound(s.begin(), s.end(), knot) - s.begin();
  breaks.insert(breaks.begin() + at, false);
  if (static_cast<std::size_t>(at) <= tightened.size())
    tightened.insert(tightened.begin() + at, tightened[static_cast<std::size_t>(at) - 1]);
  insert_knot(s, c, knot);
  ++creeping;
}

/// Between the places looked at the profile may have been a little above the rows, which are those of 0.9995 of the
/// limits. Where it is now looked at for the first time, that is granted.
void SpeedProfile::loosen() {
  constexpr double greatest_granted = 1.1, margin = 1e-4;
  for (Site& site : sites_) {
    const double ratio = tightened_[site.interval] * greatest_of_rows(site, c_);
    if (ratio > 1 - margin && ratio < greatest_granted) site.factor = (1 - margin) / ratio;
  }
}

/// Raises the greatest speeds to the present ones where these are above, with a margin of their square. Was any?
bool SpeedProfile::grant(double margin) {
  constexpr double touching = 1 - 1e-11;
  bool raised = false;
  const auto raise = [&](double& greatest, double x) {
    if (x < touching * greatest) return;
    greatest = (1 + margin) * x;
    raised = true;
  };
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (is_free(i)) raise(caps_[i], c_[i]);
  }
  for (std::size_t k = 0; k < intervals(); ++k) {
    raise(middle_caps_[k], square(k, 0.5));
    raise(knot_caps_[k + 1], square(k, 1));
  }
  return raised;
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
    for (std::size_t q = 0; q < gauss_places.size(); ++q) {
      wanted_.push_back(std::max(0.5 * dot(gauss_[3 * k + q], &creep_[k]), least));
    }
  }
  optimize(cold_descent_gap, descent_gap);
}

void SpeedProfile::build(const Section& section, const Continuation& before, double feed_factor) {
  const std::vector<double>& s = knots_.s;
  const std::size_t n = intervals();
  basis_.reserve(n);
  gauss_.reserve(3 * n);
  for (std::size_t k = 0; k < n; ++k) {
    basis_.emplace_back(around(s, k));
    for (const double u : gauss_places) gauss_.push_back(basis_[k].value(u));
  }
  if (starts_at_rest()) start_tie_ = rest_tie(knots_.start_ramp, s[1] - s[0], s[2] - s[1]);
  if (ends_at_rest()) end_tie_ = rest_tie(knots_.end_ramp, s[n] - s[n - 1], s[n - 1] - s[n - 2]);
  geometry::PointJet left = section.jets(s[0], Side::right);
  // Two sites an interval and one more at a break; some more where the curve's derivatives have peaks.
  std::size_t sites = 2 * n + static_cast<std::size_t>(std::count(knots_.breaks.begin(), knots_.breaks.end(), true));
  sites += sites / 4;
  sites_.reserve(sites);
  const geometry::PointJet half_way = section.jets(s[n / 2], Side::right), last = section.jets(s[n], Side::left);
  std::size_t moving = 0;
  for (std::size_t i = 0; i < left.size(); ++i) moving += moves(left[i]) || moves(half_way[i]) || moves(last[i]);
  rows_.reserve(sites * moving);
  tightened_.assign(n, 1.0);
  floors_.assign(n + 3, 0.0);
  if (!ends_at_rest()) {
    // Knots that lie well for a motion that goes on lie far apart for one that stops so soon.
    const std::size_t from = n > stopping_tail ? n - stopping_tail : 0;
    for (std::size_t k = std::max(from, before.loose); k < n; ++k) {
      tightened_[k] = std::max(stopping_factor, k < before.tightened.size() ? before.tightened[k] : 1);
    }
  }
  knot_caps_.assign(n + 1, infinity);
  middle_caps_.assign(n, infinity);
  const auto cap = [&](double at, Side side, const geometry::PointJet& jet) {
    const double feed = feed_factor * section.feed(at, side), square = greatest_square(jet, feed, *machine_);
    const bool by_feed = square == squared(feed);
    return (turns(jet) && !by_feed ? turning_margin : feed_margin) * square;
  };
  knot_caps_[0] = cap(s[0], Side::right, left);
  add_site(0, 0, left);
  for (std::size_t k = 0; k < n; ++k) {
    const double half = (s[k] + s[k + 1]) / 2;
    const geometry::PointJet middle = section.jets(half, Side::left), right = section.jets(s[k + 1], Side::left);
    middle_caps_[k] = cap(half, Side::left, middle);
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
      greatest = std::max({greatest, middle_caps_[k], knot_caps_[k], knot_caps_[k + 1]});
      step = step || knots_.breaks[k] || knots_.breaks[k + 1];
    }
    if (step) {
      for (std::size_t k = from; k <= to; ++k)
        greatest = std::min({greatest, middle_caps_[k], knot_caps_[k], knot_caps_[k + 1]});
    }
    caps_[i] = greatest;
  }
  find_creep();
}

void SpeedProfile::add_site(std::size_t interval, double u, const geometry::PointJet& jet) {
  const CubicBasis& basis = basis_[interval];
  const Four x = basis.value(u), slope = basis.slope(u), bend = basis.bend(u);
  Site site{static_cast<std::uint32_t>(interval), static_cast<std::uint32_t>(rows_.size()), 0, false, 1, x};
  for (const base::Axis axis : base::all_axes) {
    const numeric::Jet& q = jet[base::index(axis)];
    if (!moves(q)) continue;
    const machine::AxisLimits& limits = machine_->limits(axis);
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
  if (interval + 2 < knots_.s.size()) {
    uneven = std::max(uneven, std::abs((knots_.s[interval + 2] - knots_.s[interval + 1]) / basis.h - 1));
  }
  uneven = std::min(uneven, 0.4);
  const double jerk_factor = uneven > 0.04 ? 1 + 0.04 * uneven * uneven : 1;
  const std::array<double, 3> places = {0, 0.5, 1}, parts = {-0.5, 2, -0.5};
  Site site{
      static_cast<std::uint32_t>(interval), static_cast<std::uint32_t>(rows_.size()), 0, true, 1, basis.value(0.5)};
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const auto moves_axis = [&](const geometry::PointJet* jet) { return moves((*jet)[i]); };
    if (std::none_of(jets.begin(), jets.end(), moves_axis)) continue;
    const machine::AxisLimits& limits = machine_->limits(axis);
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

/// Which coefficients are one variable: three at a rest, six in the creep before an end in motion. Three are given
/// where the window begins in motion.
void SpeedProfile::tie_variables() {
  const std::size_t n = intervals();
  variable_.assign(n + 3, -1);
  weight_.assign(n + 3, 1.0);
  const std::size_t first = starts_at_rest() ? 2 : 3;  // the first free coefficient, or the last that is tied to it
  const std::size_t last = ends_at_rest() ? n : n - creep_tail;
  for (std::size_t i = starts_at_rest() ? 0 : 3; i < n + 3; ++i) {
    variable_[i] = static_cast<std::int32_t>(std::clamp(i, first, last) - first);
    if (i <= 2) weight_[i] = start_tie_[i];
    if (ends_at_rest() && i >= n) weight_[i] = end_tie_[n + 2 - i];
    if (!ends_at_rest() && i >= last) weight_[i] = creep_[i] / creep_[last];
  }
  variables_.assign(last - first + 1, 0.0);
}

void SpeedProfile::read_variables() {
  for (std::size_t i = 0; i < c_.size(); ++i) {
    if (is_free(i)) variables_[static_cast<std::size_t>(variable_[i])] = c_[i] / weight_[i];
  }
}

/// Each row alone, with room to spare, over a span of the narrowest interval around (see the derivation with the
/// knots).
void SpeedProfile::find_creep() {
  const std::size_t n = intervals();
  std::vector<double>& y = creep_;
  y.assign(n + 3, infinity);
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
      if (starts_at_rest()) y[j] = start * start_tie_[j];
      if (ends_at_rest()) y[n + 2 - j] = end * end_tie_[j];
    }
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 1; i < n + 3; ++i) y[i] = std::min(y[i], 1.5 * y[i - 1]);
    for (std::size_t i = n + 2; i-- > 0;) y[i] = std::min(y[i], 1.5 * y[i + 1]);
    tie();
  }
}

void SpeedProfile::creep() {
  c_ = creep_;
  for (double& c : c_) c *= 0.5;
  // Slowing time by λ scales velocity, acceleration and jerk by λ, λ², λ³: always a way inside.
  for (int round = 0; round < 60 && !(greatest_ratio() < 0.9); ++round) {
    for (double& c : c_) c *= 0.7;
  }
  read_variables();
  far_inside_ = c_;
}

void SpeedProfile::settle() {
  gauss_ = {};
  hessian_ = {};
  for (std::vector<double>* used : {&wanted_, &asked_caps_, &asked_knot_caps_, &asked_middle_caps_, &floors_,
                                    &far_inside_, &weight_, &variables_, &trial_, &trial_c_, &step_, &gradient_}) {
    *used = {};
  }
  sites_.shrink_to_fit();
  rows_.shrink_to_fit();
}

void SpeedProfile::slow_down(double factor) {
  for (std::vector<double>* c : {&c_, &far_inside_}) {
    for (double& value : *c) value *= squared(factor);
  }
  read_variables();
}

void SpeedProfile::shift(double by) {
  for (double& s : knots_.s) s -= by;
}

void SpeedProfile::retreat() {
  c_ = far_inside_;
  read_variables();
}

/// Where the profile has been levelled it lies on its greatest speed, where no barrier can start: what follows leaves
/// it by as smooth a share as it was reached.
std::optional<Continuation> SpeedProfile::continuation(std::size_t interval, double u) const {
  std::vector<double> next = c_;
  if (!before_levelling_.empty()) {
    for (std::size_t i = interval + 3; i < c_.size(); ++i) {
      next[i] += smooth_share(static_cast<double>(i - interval - 2) / (blend + 1)) * (before_levelling_[i] - c_[i]);
    }
    if (!(greatest_ratio(next, interval) < 1)) return std::nullopt;
  }
  Continuation after;
  if (interval + 2 >= knots_.s.size()) return std::nullopt;
  const auto from = static_cast<std::ptrdiff_t>(interval);
  after.s.assign(knots_.s.begin() + from, knots_.s.end());
  after.breaks.assign(knots_.breaks.begin() + from, knots_.breaks.end());
  after.end_ramp = knots_.end_ramp;
  after.tightened.assign(tightened_.begin() + from, tightened_.end());
  if (u > 0) {
    after.s[0] += u * width(interval);
    after.breaks[0] = false;
  }
  after.c.assign(next.begin() + from, next.end());
  if (!(c_[interval] == c_[interval + 1] && c_[interval] == c_[interval + 2] &&
        (u == 0 || c_[interval] == c_[interval + 3]))) {
    // Clamped at the new first knot: by the value, slope and bend there.
    const double x = square(interval, u), slope = square_slope(interval, u), bend = square_bend(interval, u);
    const double h0 = after.s[1] - after.s[0], h1 = after.s[2] - after.s[1];
    after.c[0] = x;
    after.c[1] = x + slope * h0 / 3;
    after.c[2] = x + slope * (2 * h0 + h1) / 3 + bend * h0 * (h0 + h1) / 6;
  }
  after.creeping = ends_at_rest() ? after.c.size() : after.c.size() - 3;
  after.loose = intervals() - interval > stopping_tail ? intervals() - interval - stopping_tail : 0;
  after.share = c_.back() / creep_.back();
  return after;
}

/// The largest ratio of the rows of one site, not tightened. Infinite where the motion would not go forward.
double SpeedProfile::greatest_of_rows(const Site& site, const std::vector<double>& c) const {
  const double* at = &c[site.interval];
  const double x = dot(site.x, at);
  if (!(x > 0)) return infinity;
  double greatest = 0;
  for (std::uint32_t r = site.first_row; r < site.end_row; ++r) {
    greatest =
        std::max({greatest, std::abs(dot(rows_[r].acceleration, at)), std::abs(dot(rows_[r].jerk, at)) * std::sqrt(x)});
  }
  return greatest;
}

/// Given coefficients count only where others bear upon the same limit.
double SpeedProfile::greatest_ratio(const std::vector<double>& c, std::size_t from) const {
  double greatest = 0;
  for (std::size_t i = from + 3; i < c.size(); ++i) greatest = std::max(greatest, c[i] / caps_[i]);
  for (std::size_t k = from; k < intervals(); ++k) {
    greatest = std::max({greatest, dot(basis_[k].value(0.5), &c[k]) / middle_caps_[k],
                         dot(basis_[k].value(1), &c[k]) / knot_caps_[k + 1]});
  }
  for (const Site& site : sites_) {
    if (site.interval < from) continue;
    greatest = std::max(greatest, tightened_[site.interval] * site.factor * greatest_of_rows(site, c));
  }
  return greatest;
}

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

void SpeedProfile::tighten(std::size_t interval, const Ratios& factors) {
  tightened_[interval] *= factors.rows;
  for (const std::size_t i : {interval + 1, interval + 2}) caps_[i] /= squared(factors.speed);
  for (const std::size_t k : {interval, interval + 1}) knot_caps_[k] /= squared(factors.speed);
  middle_caps_[interval] /= squared(factors.speed);
}

Ratios SpeedProfile::room(std::size_t interval) const {
  double square = infinity, rows = infinity;
  for (const std::size_t i : {interval + 1, interval + 2}) {
    if (is_free(i)) square = std::min(square, caps_[i] / c_[i]);
  }
  square = std::min(square, middle_caps_[interval] / this->square(interval, 0.5));
  if (interval > 0) square = std::min(square, knot_caps_[interval] / this->square(interval, 0));
  square = std::min(square, knot_caps_[interval + 1] / this->square(interval, 1));
  const auto before = [](const Site& site, std::size_t k) { return site.interval < k; };
  for (auto site = std::lower_bound(sites_.begin(), sites_.end(), interval, before);
       site != sites_.end() && site->interval == interval; ++site) {
    rows = std::min(rows, 1 / (tightened_[interval] * site->factor * greatest_of_rows(*site, c_)));
  }
  return {std::sqrt(square), rows};
}

bool SpeedProfile::is_level(std::size_t k) const {
  return c_[k] == c_[k + 1] && c_[k] == c_[k + 2] && c_[k] == c_[k + 3];
}

void SpeedProfile::unlevel() {
  if (!before_levelling_.empty()) c_ = before_levelling_;
  before_levelling_.clear();
}

/// The barrier keeps x a few parts in ten thousand below the cap. Where it is that close for many knots, close the rest
/// of the gap: not at once, which would be a step of acceleration, but by a smooth share over the first and last knots.
void SpeedProfile::level_cruises() {
  constexpr double near = 4e-3;
  constexpr std::size_t shortest = 40;
  before_levelling_ = c_;
  const auto at_cap = [&](std::size_t i) { return c_[i] > (1 - near) * caps_[i]; };
  const bool joins = !starts_at_rest() && c_[0] == c_[1] && c_[0] == c_[2] && c_[0] == caps_[3];
  for (std::size_t i = 3; i + 3 < c_.size();) {
    std::size_t end = i;
    while (end + 3 < c_.size() && at_cap(end) && caps_[end] == caps_[i]) ++end;
    const bool goes_on = joins && i == 3;  // the cruise has begun before
    if (end - i >= (goes_on ? blend : shortest)) {
      for (std::size_t k = i; k < end; ++k) {
        const std::size_t inside = goes_on ? end - 1 - k : std::min(k - i, end - 1 - k);
        const double share = smooth_share(static_cast<double>(inside) / blend);
        c_[k] = share >= 1 ? caps_[k] : c_[k] + share * (caps_[k] - c_[k]);
      }
    }
    i = std::max(end, i + 1);
  }
  if (greatest_ratio() > 1 + 1e-12) c_ = before_levelling_;
  if (c_ == before_levelling_) before_levelling_.clear();
}

}  // namespace leadscrew::planner
