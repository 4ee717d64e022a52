#include <algorithm>
#include <cmath>
#include <leadscrew/planner/speed_profile.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using constraints::RowPairs;

constexpr double next_to_nothing = 0.01;  // of a limit, by the curve alone at the greatest speed
constexpr std::size_t most_borders = 7;   // between polynomials, that an interval has sites for
constexpr double infinity = std::numeric_limits<double>::infinity();
// Of the limits, for what lies between the places looked at and for the step from spline to quintics:
constexpr double limit_margin = 0.9995;      // of acceleration and jerk
constexpr double feed_margin = 1 - 1e-7;     // of the programmed speed, squared
constexpr double turning_margin = 1 - 3e-4;  // of the speed, squared, where it is an axis' that trades with others
constexpr std::size_t creep_tail = 3;        // of the intervals at an end in motion: all their coefficients creep
constexpr std::size_t stopping_tail = 16;    // of the intervals before an end in motion
constexpr double stopping_factor = 1.08;     // of the rows there
constexpr std::array<double, 3> gauss_places = {0.1127016653792583, 0.5, 0.8872983346207417};

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

constexpr std::size_t blend = 16;  // coefficients over which a cruise is reached and left

/// From 0 to 1 with two derivatives 0 at both ends; 0 below and 1 above.
double smooth_share(double u) {
  if (u <= 0) return 0;
  return u >= 1 ? 1 : u * u * u * (10 - u * (15 - 6 * u));
}

}  // namespace

SpeedProfile::SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           double feed_factor)
    : knots_(std::move(knots)) {
  build(section, constraints, {}, feed_factor);
  tie_variables();
  creep();
}

SpeedProfile::SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           Continuation before, double feed_factor)
    : knots_(std::move(knots)) {
  for (std::size_t k = 0; k < knots_.s.size() && knots_.s[k] < before.s.back(); ++k) {
    if (knots_.s[k] != before.s[k]) before.insert(knots_.s[k]);
  }
  build(section, constraints, before, feed_factor);
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

/// Between the places looked at the profile may have been above the rows, which are those of 0.9995 of the limits: a
/// little where motion was proven, more beyond where the last window would have come to rest. Where it is now looked at
/// for the first time, that is granted until the profile is far inside; the proof decides what becomes of it.
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

void SpeedProfile::build(const Section& section, const constraints::Constraints& constraints,
                         const Continuation& before, double feed_factor) {
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
  const auto rows_at = [&](const geometry::PointJet& jet) { return constraints.row_pairs({jet, infinity}); };
  RowPairs left_rows = rows_at(left);
  const RowPairs half_way = rows_at(section.jets(s[n / 2], Side::right)),
                 last = rows_at(section.jets(s[n], Side::left));
  std::size_t moving = 0;
  for (std::size_t i = 0; i < RowPairs::size; ++i) {
    moving += left_rows.pairs[i].bounds() || half_way.pairs[i].bounds() || last.pairs[i].bounds();
  }
  rows_.reserve(sites * moving);
  // Where rows had to be tightened they would have to be again, when there may be less room for it.
  const std::size_t known = std::min({before.loose, before.tightened.size(), n});
  tightened_.assign(before.tightened.begin(), before.tightened.begin() + static_cast<std::ptrdiff_t>(known));
  tightened_.resize(n, 1.0);
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
    const double feed = feed_factor * section.greatest_speed(at, side, jet),
                 square = constraints.greatest_square({jet, feed});
    const bool by_feed = square == squared(feed);
    return (turns(jet) && !by_feed ? turning_margin : feed_margin) * square;
  };
  knot_caps_[0] = cap(s[0], Side::right, left);
  add_site(0, 0, left_rows);
  for (std::size_t k = 0; k < n; ++k) {
    const double half = (s[k] + s[k + 1]) / 2;
    const geometry::PointJet middle = section.jets(half, Side::left), right = section.jets(s[k + 1], Side::left);
    middle_caps_[k] = cap(half, Side::left, middle);
    knot_caps_[k + 1] = cap(s[k + 1], Side::left, right);
    const RowPairs middle_rows = rows_at(middle), right_rows = rows_at(right);
    if (k > 0 && knots_.breaks[k]) add_site(k, 0, left_rows);
    add_hull(k, {&left_rows, &middle_rows, &right_rows});
    const double fastest = std::sqrt(std::max({middle_caps_[k], knot_caps_[k], knot_caps_[k + 1]}));
    const auto is_above_ends = [&](const RowPairs& here) {
      const auto above = [](double m, double x, double y, double counts) {
        return std::abs(m) > std::max(1.001 * std::max(std::abs(x), std::abs(y)), counts);
      };
      for (std::size_t i = 0; i < RowPairs::size; ++i) {
        const auto& [a, j] = here.pairs[i];
        const auto& [left_a, left_j] = left_rows.pairs[i];
        const auto& [right_a, right_j] = right_rows.pairs[i];
        if (above(a.by_x, left_a.by_x, right_a.by_x, next_to_nothing * a.limit / squared(fastest)) ||
            above(j.by_x, left_j.by_x, right_j.by_x, next_to_nothing * j.limit / (squared(fastest) * fastest))) {
          return true;
        }
      }
      return false;
    };
    // Where the curve is made of several polynomials, peaks may lie anywhere.
    const bool peak = is_above_ends(middle_rows);
    const std::size_t borders = std::min(section.borders(s[k], s[k + 1]), most_borders);
    const std::size_t inside = borders > 0 || peak ? std::max<std::size_t>(3, 2 * borders + 1) : 0;
    for (std::size_t i = 1; i <= inside; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(inside + 1);
      const RowPairs here =
          2 * i == inside + 1 ? middle_rows : rows_at(section.jets(s[k] + u * (s[k + 1] - s[k]), Side::left));
      if ((peak && inside == 3) || is_above_ends(here)) add_site(k, u, here);
    }
    add_site(k, 1, right_rows);
    left = right;
    left_rows = right_rows;
    if (knots_.breaks[k + 1]) {
      left = section.jets(s[k + 1], Side::right);
      left_rows = rows_at(left);
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

void SpeedProfile::add_site(std::size_t interval, double u, const RowPairs& at) {
  const CubicBasis& basis = basis_[interval];
  const Four x = basis.value(u), slope = basis.slope(u), bend = basis.bend(u);
  Site site{static_cast<std::uint32_t>(interval), static_cast<std::uint32_t>(rows_.size()), 0, false, 1, x};
  for (const RowPairs::Pair& pair : at.pairs) {
    if (!pair.bounds()) continue;
    const auto& [acceleration, jerk] = pair;
    const double a = 1 / (limit_margin * acceleration.limit), j = 1 / (limit_margin * jerk.limit);
    Row& row = rows_.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      row.acceleration[k] = a * (acceleration.by_x * x[k] + acceleration.by_b * slope[k] / 2);
      row.jerk[k] = j * (jerk.by_x * x[k] + jerk.by_b * slope[k] / 2 + jerk.by_c * bend[k] / 2);
    }
  }
  site.end_row = static_cast<std::uint32_t>(rows_.size());
  sites_.push_back(site);
}

void SpeedProfile::add_hull(std::size_t interval, const std::array<const RowPairs*, 3>& at) {
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
  for (std::size_t i = 0; i < RowPairs::size; ++i) {
    const auto bounds = [&](const RowPairs* rows) { return rows->pairs[i].bounds(); };
    if (std::none_of(at.begin(), at.end(), bounds)) continue;
    Row& row = rows_.emplace_back();
    for (std::size_t p = 0; p < 3; ++p) {
      const auto& [acceleration, jerk] = at[p]->pairs[i];
      const double a = 1 / (limit_margin * acceleration.limit), j = jerk_factor / (limit_margin * jerk.limit);
      const Four x = basis.value(places[p]), slope = basis.slope(places[p]), bend = basis.bend(places[p]);
      for (std::size_t k = 0; k < 4; ++k) {
        row.acceleration[k] += parts[p] * a * (acceleration.by_x * x[k] + acceleration.by_b * slope[k] / 2);
        row.jerk[k] += parts[p] * j * (jerk.by_x * x[k] + jerk.by_b * slope[k] / 2 + jerk.by_c * bend[k] / 2);
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
  before_levelling_.clear();
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
  for (std::vector<double>* c : {&c_, &far_inside_, &before_levelling_}) {
    for (double& value : *c) value *= squared(factor);
  }
  read_variables();
}

void SpeedProfile::shift(double by) {
  for (double& s : knots_.s) s -= by;
}

void SpeedProfile::retreat() {
  c_ = far_inside_;
  before_levelling_.clear();
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
