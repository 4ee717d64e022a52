#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/planner/time_bound.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <span>

namespace leadscrew::planner {

namespace {

using namespace tuning::bound;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_smooth(const geometry::PointJet& leaving, const geometry::PointJet& entering, double negligible) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    largest = std::max({largest, std::abs(leaving[i].first), std::abs(entering[i].first)});
    difference = std::max(difference, std::abs(leaving[i].first - entering[i].first));
  }
  return difference <= negligible * largest;
}

/// How far from here a knot may be, by the turn |q″| h and what it changes by, |q‴| h².
double finest_step(const geometry::PointJet& jet, base::AxisSet moving) {
  double second = 0, third = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!moving.contains(axis)) continue;
    const numeric::Jet<>& q = jet[base::index(axis)];
    second = std::max(second, std::abs(q.second));
    third = std::max(third, std::abs(q.third));
  }
  const double by_turn = second > 0 ? finest_turn / second : infinity;
  return third > 0 ? std::min(by_turn, std::sqrt(finest_turn / third)) : by_turn;
}

/// Is the time at these greatest squares of speed, at both ends and in the middle, that by the mean of the ends?
bool is_told_by_ends(double x_begin, double x_middle, double x_end) {
  const double begin = std::sqrt(x_begin), middle = std::sqrt(x_middle), end = std::sqrt(x_end);
  const double by_ends = 2 / (begin + end), by_three = (1 / begin + 4 / middle + 1 / end) / 6;
  return !(std::abs(by_ends - by_three) > finest_time * by_three);
}

}  // namespace

void TimeBound::push(const toolpath::Element& element) {
  if (const auto* dwell = std::get_if<toolpath::Dwell>(&element)) {
    stop();
    seconds_ += dwell->seconds;
    return;
  }
  const auto* piece = std::get_if<toolpath::Piece>(&element);
  if (!piece) return;
  const double negligible = piece->transformation ? negligible_tip_kink : negligible_kink;
  if (held_ && !is_smooth(leaving_, piece->axes().jets(0), negligible)) {
    stop();
  } else {
    place_held(false);
  }
  held_ = *piece;
  leaving_ = piece->axes().jets(piece->axes().length());
  if (piece->stop) stop();
}

void TimeBound::finish() {
  stop();
}

void TimeBound::place_held(bool ends_at_rest) {
  if (!held_) return;
  if (const auto* line = held_->axes().line()) {
    add_straight(*line, *held_);
  } else {
    add_curved(*held_, ends_at_rest);
  }
  held_.reset();
  begins_at_rest_ = ends_at_rest;
}

void TimeBound::add_straight(const geometry::Line& line, const toolpath::Piece& piece) {
  const geometry::PointJet jet = line.jets(0);
  Interval& interval = waiting_.emplace_back();
  interval.length = line.length();
  interval.x_max = interval.x_end_max = velocity_limit(0, jet, piece);
  interval.straight_b = constraints_.along_tangent({jet, piece.greatest_speed(0, jet)}).acceleration;
  settle_first_half();
}

void TimeBound::add_curved(const toolpath::Piece& piece, bool ends_at_rest) {
  const toolpath::AxisPath axes = piece.axes();
  const base::AxisSet moving = axes.moving();
  const double length = axes.length();
  const std::span<const double> breaks = axes.breaks();
  auto stop_at = breaks.begin();
  double s = 0;
  geometry::PointJet here = axes.jets(0);
  double step_here = finest_step(here, moving), x_here = velocity_limit(0, here, piece);
  while (s < length) {
    // Knots crowd towards a place where the motion comes from rest or goes to it.
    const double longest = std::min(length / fewest_intervals, step_here);
    // Behind a line of the tip, which is a curve of the axes, may come a short blend that is as slow.
    const bool is_slow = piece.transformation != nullptr;
    const double to_rest =
        std::min(begins_at_rest_ || is_slow ? s : infinity, ends_at_rest || is_slow ? length - s : infinity);
    const double graded = std::max(first_interval * longest, grading * to_rest);
    const double limit = stop_at == breaks.end() ? length : *stop_at;
    const auto next_knot = [&](double step) { return limit - s < 1.5 * step ? limit : s + step; };
    double s_next = next_knot(std::min(longest, graded));
    here = axes.jets(s_next);
    step_here = finest_step(here, moving);
    // With shorter steps where the curve begins to turn inside the step.
    for (int halving = 0; halving < most_halvings && step_here < (s_next - s) / 2; ++halving) {
      s_next = s + (s_next - s) / 2;
      here = axes.jets(s_next);
      step_here = finest_step(here, moving);
    }
    double x_next = velocity_limit(s_next, here, piece);
    geometry::PointJet middle = axes.jets((s + s_next) / 2);
    // And where feed is counted by what changes along the curve.
    for (int halving = 0; piece.feed_axes != toolpath::FeedAxes::none && halving < most_halvings; ++halving) {
      const double x_middle = velocity_limit((s + s_next) / 2, middle, piece);
      if (is_told_by_ends(x_here, x_middle, x_next)) break;
      s_next = s + (s_next - s) / 2;
      here = middle;
      step_here = finest_step(here, moving);
      x_next = x_middle;
      middle = axes.jets((s + s_next) / 2);
    }
    Interval& interval = waiting_.emplace_back();
    interval.length = s_next - s;
    interval.x_max = x_here;
    interval.x_end_max = x_here = x_next;
    add_rows(middle, interval);
    settle_first_half();
    s = s_next;
    if (stop_at != breaks.end() && s >= *stop_at) ++stop_at;
  }
}

double TimeBound::velocity_limit(double s, const geometry::PointJet& jet, const toolpath::Piece& piece) const {
  const double speed = constraints_.greatest_speed({jet, piece.greatest_speed(s, jet)});
  return speed * speed;
}

/// |q″(x + hb) + q′b| ≤ a, in the middle of an interval of length h.
void TimeBound::add_rows(const geometry::PointJet& middle, Interval& interval) const {
  for (const auto& [row, jerk] : constraints_.row_pairs({middle, infinity}).pairs) {
    if (!row.bounds()) continue;
    const double by_b = row.by_b + interval.length * row.by_x;
    if (by_b == 0) {
      interval.x_max = std::min(interval.x_max, row.limit / std::abs(row.by_x));
    } else {
      interval.rows[interval.row_count++] = {row.limit / std::abs(by_b), row.by_x / by_b};
    }
  }
}

void TimeBound::settle_first_half() {
  if (waiting_.size() == most_waiting) settle(most_waiting / 2, infinity);
}

void TimeBound::stop() {
  place_held(true);
  settle(waiting_.size(), 0);
  x_begin_ = 0;
  begins_at_rest_ = true;
}

void TimeBound::settle(std::size_t count, double x_beyond) {
  double reach = x_beyond;
  for (std::size_t i = waiting_.size(); i-- > 0;) reach = waiting_[i].reach = greatest_start(waiting_[i], reach);
  double x = x_begin_;
  for (std::size_t i = 0; i < count; ++i) {
    const Interval& interval = waiting_[i];
    const double x_end_most = i + 1 < waiting_.size() ? waiting_[i + 1].reach : x_beyond;
    x = std::min(x, interval.reach);
    const double x_end = std::min(greatest_end(interval, x), x_end_most);
    seconds_ += duration(interval, x, x_end);
    x = x_end;
  }
  x_begin_ = x;
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Each row bounds b from above and from below by straight lines in x, c + m·x, of one slope; so do the speeds allowed
/// at the end. The greatest x is where the first pair of an upper and a lower line crosses.
double TimeBound::greatest_start(const Interval& interval, double x_end) {
  const double x_end_most = std::min(x_end, interval.x_end_max);
  if (interval.is_straight()) return std::min(interval.x_max, x_end_most + 2 * interval.straight_b * interval.length);
  double x = interval.x_max;
  // x at the most where the upper line of one meets the lower line of another.
  const auto cross = [&x](double upper_c, double upper_m, double lower_c, double lower_m) {
    const double closing = lower_m - upper_m, apart = upper_c - lower_c;
    if (closing > 0 && apart < x * closing) x = apart / closing;
  };
  const double per_b = 1 / (2 * interval.length), c_end = x_end_most < infinity ? x_end_most * per_b : infinity;
  for (std::size_t u = 0; u < interval.row_count; ++u) {
    const AccelerationBound& upper = interval.rows[u];
    for (std::size_t l = 0; l < interval.row_count; ++l) {
      const AccelerationBound& lower = interval.rows[l];
      cross(upper.limit, -upper.by_x, -lower.limit, -lower.by_x);
    }
    cross(upper.limit, -upper.by_x, 0, -per_b);
    cross(c_end, -per_b, -upper.limit, -upper.by_x);
  }
  return std::max(x, 0.0);
}

double TimeBound::greatest_end(const Interval& interval, double x_begin) {
  const double up = greatest_slopes(interval, x_begin, 0).up;
  return std::clamp(x_begin + interval.length * up, 0.0, interval.x_end_max);
}

/// On a straight interval speed rises to a peak below the limit, stays there, and falls. Else x rises from one knot as fast as
/// accelerations allow, stays below the line between the greatest at both knots, and falls to the other: the lowest of three
/// straight lines. Where feed jumps at a knot that takes next to nothing of the interval.
double TimeBound::duration(const Interval& interval, double x_begin, double x_end) {
  if (interval.is_straight()) {
    const double b = interval.straight_b;
    const double peak = std::min(interval.x_max, (x_begin + x_end) / 2 + b * interval.length);
    const double cruise = std::max(0.0, interval.length - (2 * peak - x_begin - x_end) / (2 * b));
    const double v_peak = std::sqrt(peak);
    return std::max(0.0, 2 * v_peak - std::sqrt(x_begin) - std::sqrt(x_end)) / b + cruise / v_peak;
  }
  const double length = interval.length, chord = (x_end - x_begin) / length;
  const auto [up, down] = greatest_slopes(interval, x_begin, x_end);
  const double rise = std::max(up, chord), fall = std::max(down, -chord);
  const double top = (interval.x_end_max - interval.x_max) / length, x_fall = x_end + fall * length;
  const auto x_at = [&](double s) {
    return std::min({x_begin + rise * s, interval.x_max + top * s, x_end + fall * (length - s)});
  };
  // Where two of the lines cross.
  std::array<double, 5> places{0, (interval.x_max - x_begin) / (rise - top), (x_fall - interval.x_max) / (top + fall),
                               (x_fall - x_begin) / (rise + fall), length};
  for (double& place : places) place = std::isfinite(place) ? std::clamp(place, 0.0, length) : 0;
  std::ranges::sort(places);
  double seconds = 0, v = std::sqrt(x_begin);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double distance = places[k] - places[k - 1], v_next = std::sqrt(std::max(x_at(places[k]), 0.0));
    if (v + v_next > 0) seconds += 2 * distance / (v + v_next);
    v = v_next;
  }
  return seconds;
}

/// Of x by s, at the first knot where it rises and at the second where it falls.
TimeBound::Slopes TimeBound::greatest_slopes(const Interval& interval, double x_begin, double x_end) {
  if (interval.is_straight()) return {2 * interval.straight_b, 2 * interval.straight_b};
  Slopes slopes{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  for (std::size_t i = 0; i < interval.row_count; ++i) {
    const AccelerationBound& row = interval.rows[i];
    slopes.up = std::min(slopes.up, 2 * (row.limit - row.by_x * x_begin));
    slopes.down = std::min(slopes.down, 2 * (row.limit + row.by_x * x_end));
  }
  return slopes;
}

}  // namespace leadscrew::planner
