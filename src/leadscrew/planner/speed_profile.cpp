#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <utility>

namespace leadscrew::planner {

namespace {

/// From 0 to 1 with two derivatives 0 at both ends; 0 below and 1 above.
double smooth_share(double u) {
  if (u <= 0) return 0;
  return u >= 1 ? 1 : u * u * u * (10 - u * (15 - 6 * u));
}

/// Is this said of any piece that the knots lie on?
bool any_piece(const Section& section, const Knots& knots, bool toolpath::Piece::* said) {
  const std::size_t last = section.piece_at(knots.s.back(), Side::left);
  for (std::size_t p = section.piece_at(knots.s.front(), Side::right); p <= last; ++p) {
    if (section.piece(p).*said) return true;
  }
  return false;
}

BarrierSolver::Ways ways(const Section& section, const Knots& knots) {
  return {any_piece(section, knots, &toolpath::Piece::is_of_tip),
          any_piece(section, knots, &toolpath::Piece::is_of_least_time)};
}

/// With the continuation's knots those that lie between them.
const Continuation& refined(Continuation& before, const std::vector<double>& knots) {
  for (std::size_t k = 0; k < knots.size() && knots[k] < before.s.back(); ++k) {
    if (knots[k] != before.s[k]) before.insert(knots[k]);
  }
  return before;
}

}  // namespace

SpeedProfile::SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           double feed_factor)
    : problem_(section, constraints, std::move(knots), feed_factor),
      bounds_(problem_, {}),
      ways_(ways(section, problem_.knots())) {
  creep();
}

SpeedProfile::SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           Continuation before, double feed_factor, const SpeedProfile* previous)
    : problem_(section, constraints, std::move(knots), feed_factor, previous ? &previous->problem_ : nullptr),
      bounds_(problem_, refined(before, problem_.knots().s)),
      ways_(ways(section, problem_.knots())) {
  std::vector<double> c(problem_.creep().begin(), problem_.creep().end());
  for (double& value : c) value *= before.share;
  for (std::size_t i = 0; i < before.c.size() && i < c.size(); ++i)
    c[i] = i < before.creeping ? before.c[i] : std::min(before.c[i], c[i]);
  set(c);
  too_fast_ = bounds_.relax_caps(problem_, this->c(), tuning::descent::too_fast_margin);
  bounds_.relax_rows(problem_, this->c());
  inside_ = {{std::numeric_limits<double>::infinity(), this->c()}};
}

void SpeedProfile::set(std::vector<double> coefficients) {
  levelled_.clear();
  iterate_.set(problem_, std::move(coefficients));
}

void SpeedProfile::creep() {
  std::vector<double> c(problem_.creep().begin(), problem_.creep().end());
  for (double& value : c) value *= 0.5;
  // Slowing time by λ scales velocity, acceleration and jerk by λ, λ², λ³: some λ brings all of them inside their
  // limits.
  for (int round = 0; round < 60 && !(bounds_.greatest_ratio(problem_, c) < 0.9); ++round) {
    for (double& value : c) value *= 0.7;
  }
  set(c);
  inside_ = {{std::numeric_limits<double>::infinity(), std::move(c)}};
}

void SpeedProfile::optimize(double first_gap, double gap) {
  optimize(goal_, first_gap, gap);
}

void SpeedProfile::optimize(const SpeedGoal& goal, double first_gap, double gap) {
  BarrierSolver solver = this->solver(goal);
  solver.optimize(first_gap, gap, [this](double left) { keep(left); });
  newton_steps_ += solver.newton_steps();
}

void SpeedProfile::center(double gap) {
  BarrierSolver solver = this->solver(goal_);
  solver.center(gap);
  newton_steps_ += solver.newton_steps();
  keep(gap);
}

/// Remembers the present profile to go back to. What was relaxed is taken back where it is not needed far inside the limits.
void SpeedProfile::keep(double gap) {
  while (!inside_.empty() && inside_.back().gap <= gap) inside_.pop_back();
  inside_.push_back({gap, iterate_.coefficients()});
  if (gap > tuning::window::far_inside) bounds_.restore_rows(problem_, iterate_.coefficients());
}

void SpeedProfile::descend() {
  const SquareCaps& caps = problem_.caps();
  SpeedGoal goal;
  for (std::size_t k = 0; k < intervals(); ++k) {
    const double lower =
        std::min({caps.knots[k], caps.knots[k + 1], caps.coefficients[k + 1], caps.coefficients[k + 2]});
    goal.wanted.insert(goal.wanted.end(), numeric::gauss_3_places.size(), lower);
  }
  for (std::size_t i = 0; i < c().size(); ++i)
    goal.floors.push_back(std::min(tuning::descent::floor * caps.coefficients[i],
                                   tuning::descent::floor * tuning::descent::floor * c()[i]));
  optimize(goal, tuning::descent::first_gap, tuning::descent::last_gap);
  bounds_.restore_caps(problem_, c(), tuning::descent::descended_margin);
}

void SpeedProfile::descend_to_creep(double first_gap, double last_gap) {
  const double least = 2e-3 * c()[0];
  goal_ = {};
  for (std::size_t k = 0; k < intervals(); ++k) {
    for (const double u : numeric::gauss_3_places)
      goal_.wanted.push_back(std::max(0.5 * dot(problem_.basis()[k].value(u), &problem_.creep()[k]), least));
  }
  optimize(goal_, first_gap, last_gap);
}

void SpeedProfile::settle() {
  problem_.settle();
  bounds_.settle();
  goal_ = {};
  inside_ = {};
}

std::size_t SpeedProfile::bytes() const {
  const std::size_t an_interval = sizeof(CubicBasis) + 9 * sizeof(double);
  return an_interval * problem_.basis().size() + problem_.sites().size_bytes() + problem_.blocks().size_bytes() +
         sizeof(double) * problem_.sites().size();
}

void SpeedProfile::slow_down(double factor) {
  const auto slower = [&](std::vector<double> coefficients) {
    for (double& value : coefficients) value *= squared(factor);
    return coefficients;
  };
  iterate_.set(problem_, slower(iterate_.coefficients()));
  levelled_ = slower(std::move(levelled_));
  for (Inside& inside : inside_) inside.c = slower(std::move(inside.c));
}

void SpeedProfile::retreat(double gap) {
  while (inside_.size() > 1 && inside_.back().gap < gap) inside_.pop_back();
  set(inside_.back().c);
}

/// Between two profiles ratios of rows and caps are no greater than the straight line between theirs: all of them are convex, but
/// for g²x, which nearly is. Little of the way costs little of the time, and no step of Newton's method.
bool SpeedProfile::move_inside(std::span<const Ratios> exceeding) {
  using namespace tuning::window;
  const auto inner =
      std::find_if(inside_.rbegin(), inside_.rend(), [](const Inside& inside) { return inside.gap >= near_inside; });
  if (inner == inside_.rend()) return false;
  std::vector<double> c = iterate_.coefficients();
  double share = 0;
  const auto lower = [&](double ratio, double inner_ratio, double factor) {
    if (factor == 1) return;
    const double wanted = ratio * (1 - 1 / factor), most = most_inside * (ratio - inner_ratio);
    share = std::max(share, wanted < most ? wanted / (ratio - inner_ratio) : 1);
  };
  for (std::size_t i = 0; i < exceeding.size(); ++i) {
    if (exceeding[i].worst() == 1) continue;
    const Ratios factors = exceeding[i].raised(inside_margin);
    const Ratios margin = bounds_.margin(problem_, c, i), inner_margin = bounds_.margin(problem_, inner->c, i);
    lower(1 / margin.rows, 1 / inner_margin.rows, factors.rows);
    lower(1 / squared(margin.speed), 1 / squared(inner_margin.speed), squared(factors.speed));
  }
  if (share == 1) return false;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += share * (inner->c[i] - c[i]);
  set(std::move(c));
  return true;
}

bool SpeedProfile::is_level(std::size_t k) const {
  const std::vector<double>& x = c();
  return x[k] == x[k + 1] && x[k] == x[k + 2] && x[k] == x[k + 3];
}

void SpeedProfile::unlevel() {
  levelled_.clear();
}

/// The barrier keeps x a few parts in ten thousand below the cap. Where it is that close for many knots, close the rest
/// of the gap: not at once, which would be a step of acceleration, but by a smooth share over the first and last knots.
void SpeedProfile::level_cruises() {
  using namespace tuning::cruises;
  levelled_.clear();
  std::vector<double> c = iterate_.coefficients();
  const std::vector<double>& caps = bounds_.caps().coefficients;
  const auto at_cap = [&](std::size_t i) { return c[i] > (1 - near) * caps[i]; };
  const bool joins = !starts_at_rest() && c[0] == c[1] && c[0] == c[2] && c[0] == caps[3];
  for (std::size_t i = 3; i + 3 < c.size();) {
    std::size_t end = i;
    while (end + 3 < c.size() && at_cap(end) && caps[end] == caps[i]) ++end;
    const bool goes_on = joins && i == 3;  // the cruise has begun before
    if (end - i >= (goes_on ? blend : shortest)) {
      for (std::size_t k = i; k < end; ++k) {
        const std::size_t inside = goes_on ? end - 1 - k : std::min(k - i, end - 1 - k);
        const double share = smooth_share(static_cast<double>(inside) / blend);
        c[k] = share >= 1 ? caps[k] : c[k] + share * (caps[k] - c[k]);
      }
    }
    i = std::max(end, i + 1);
  }
  if (c != iterate_.coefficients() && !(bounds_.greatest_ratio(problem_, c) > 1 + 1e-12)) levelled_ = std::move(c);
}

/// Where the profile has been levelled it lies on its greatest speed, where no barrier can start: what follows leaves
/// it by as smooth a share as it was reached.
std::optional<Continuation> SpeedProfile::continuation(std::size_t interval, double u) const {
  if (interval >= intervals() || interval + 2 >= knots().s.size()) return std::nullopt;
  std::vector<double> next = c();
  if (!levelled_.empty()) {
    const std::vector<double>& before_levelling = iterate_.coefficients();
    for (std::size_t i = interval + 3; i < next.size(); ++i) {
      next[i] += smooth_share(static_cast<double>(i - interval - 2) / (tuning::cruises::blend + 1)) *
                 (before_levelling[i] - next[i]);
    }
    if (!(bounds_.greatest_ratio(problem_, next, interval) < 1)) return std::nullopt;
  }
  Continuation after;
  const auto from = static_cast<std::ptrdiff_t>(interval);
  after.s.assign(knots().s.begin() + from, knots().s.end());
  after.breaks.assign(knots().breaks.begin() + from, knots().breaks.end());
  after.end_ramp = knots().end_ramp;
  after.tightened.assign(bounds_.tightened().begin() + from, bounds_.tightened().end());
  if (u > 0) {
    after.s[0] += u * width(interval);
    after.breaks[0] = false;
  }
  after.c.assign(next.begin() + from, next.end());
  clamp_at(after, interval, u);
  after.creeping = ends_at_rest() ? after.c.size() : after.c.size() - 3;
  after.loose = intervals() - interval > stopping_tail ? intervals() - interval - stopping_tail : 0;
  after.share = c().back() / problem_.creep().back();
  return after;
}

/// The first three coefficients of a spline clamped at its first knot, by the value, slope and bend there. Where x is
/// the same all over the interval they are it already.
void SpeedProfile::clamp_at(Continuation& after, std::size_t interval, double u) const {
  const double* const here = &c()[interval];
  if (here[0] == here[1] && here[0] == here[2] && (u == 0 || here[0] == here[3])) return;
  const double x = square(interval, u), slope = square_slope(interval, u), bend = square_bend(interval, u);
  const double h0 = after.s[1] - after.s[0], h1 = after.s[2] - after.s[1];
  after.c[0] = x;
  after.c[1] = x + slope * h0 / 3;
  after.c[2] = x + slope * (2 * h0 + h1) / 3 + bend * h0 * (h0 + h1) / 6;
}

}  // namespace leadscrew::planner
