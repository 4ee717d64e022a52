#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <span>
#include <type_traits>

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

/// Is q′ = 0 here, or next to it by less than this distance?
bool turns_back(const constraints::AccelerationRow& row, double distance) {
  return std::abs(row.by_b) <= distance * std::abs(row.by_x);
}

/// ∫|q′|ds of the cubic that q′ and q″ at both knots make: by its four Bernstein coefficients, exact where they are of one sign
/// and never less.
double travel(const constraints::AccelerationRow& begin, const constraints::AccelerationRow& end, double length) {
  const double third = length / 3, inner_begin = begin.by_b + third * begin.by_x,
               inner_end = end.by_b - third * end.by_x;
  return length / 4 * (std::abs(begin.by_b) + std::abs(inner_begin) + std::abs(inner_end) + std::abs(end.by_b));
}

}  // namespace

void TimeBound::push(const toolpath::Element& element) {
  if (const auto* dwell = std::get_if<toolpath::Dwell>(&element)) {
    stop();
    seconds_ += dwell->seconds;
    return;
  }
  if (const auto* event = std::get_if<base::Event>(&element)) {
    if (base::is_in_step(event->kind) || event->kind == base::Event::Kind::feed_per_revolution)
      is_in_step_ = event->value > 0;
    return;
  }
  const auto* piece = std::get_if<toolpath::Piece>(&element);
  const double negligible = piece->transformation ? negligible_tip_kink : negligible_kink;
  if (held_) {
    const geometry::PointJet entering = piece->axes().jets(0);
    const bool is_kink = !is_smooth(leaving_, entering, negligible);
    place_held(is_kink);
    if (is_kink) slow_down_to(greatest_speed_over_kink(leaving_, entering, machine_));
  }
  held_ = *piece;
  if (is_in_step_ && machine_.threads_follow()) held_->feed = std::numeric_limits<double>::infinity();
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
  const double length = axes.length();
  const std::span<const double> breaks = axes.breaks();
  auto stop_at = breaks.begin();
  // Behind a line of the tip, which is a curve of the axes, may come a short blend that is as slow.
  const bool is_slow = piece.transformation != nullptr;
  Knot here = knot_at(0, piece);
  while (here.s < length) {
    // Knots crowd towards a place where the motion comes from rest or goes to it.
    const double longest = std::min(length / fewest_intervals, here.step);
    const double to_rest =
        std::min(begins_at_rest_ || is_slow ? here.s : infinity, ends_at_rest || is_slow ? length - here.s : infinity);
    const double step = std::min(longest, std::max(first_interval * longest, grading * to_rest));
    const double limit = stop_at == breaks.end() ? length : *stop_at;
    const Knot next = next_knot(here, limit - here.s < 1.5 * step ? limit : here.s + step, piece);
    Interval& interval = waiting_.emplace_back();
    interval.length = next.s - here.s;
    interval.x_max = here.x_max;
    interval.x_end_max = next.x_max;
    interval.top = here.x_max;
    interval.top_end = next.x_max;
    interval.x_above = x_above(here, next, piece);
    add_squares(here, next, interval);
    settle_first_half();
    here = next;
    if (stop_at != breaks.end() && here.s >= *stop_at) ++stop_at;
  }
}

TimeBound::Knot TimeBound::knot_at(double s, const toolpath::Piece& piece) const {
  Knot knot;
  knot.s = s;
  const geometry::PointJet jet = piece.axes().jets(s);
  const double feed = piece.greatest_speed(s, jet);
  const double speed = constraints_.greatest_speed({jet, feed});
  knot.step = finest_step(jet, piece.axes().moving());
  knot.x_max = speed * speed;
  knot.is_at_feed = speed == feed;
  constraints_.each_row({jet, infinity}, [&](auto kind, std::size_t index, const auto& row) {
    using Row = std::remove_cvref_t<decltype(row)>;
    if constexpr (std::is_same_v<Row, constraints::AccelerationRow>)
      knot.rows[constraints::RowPairs::rows_before<Row, kind> + index] = row;
  });
  return knot;
}

TimeBound::Knot TimeBound::next_knot(const Knot& here, double farthest, const toolpath::Piece& piece) const {
  const auto middle_to = [&](const Knot& there) { return knot_at(here.s + (there.s - here.s) / 2, piece); };
  Knot next = knot_at(farthest, piece);
  // With shorter steps where the curve begins to turn inside the step,
  for (int halving = 0; halving < most_halvings && next.step < (next.s - here.s) / 2; ++halving) next = middle_to(next);
  // and no farther than where an axis turns back,
  for (std::size_t row = 0; row < most_rows; ++row) {
    const double distance = next.s - here.s;
    if (here.rows[row].by_b * next.rows[row].by_b >= 0 || turns_back(here.rows[row], turning_place * distance))
      continue;
    const Knot turn = turning_back(row, here, next, piece);
    if (std::min(turn.s - here.s, next.s - turn.s) > turning_place * distance) next = turn;
  }
  // and where feed is counted by what changes along the curve.
  for (int halving = 0; piece.feed_axes != toolpath::FeedAxes::none && halving < most_halvings; ++halving) {
    const Knot middle = middle_to(next);
    if (is_told_by_ends(here.x_max, middle.x_max, next.x_max)) break;
    next = middle;
  }
  return next;
}

/// By Newton's steps inside the bracket; q′ of the row has unlike signs at both knots.
TimeBound::Knot TimeBound::turning_back(std::size_t row, const Knot& begin, const Knot& end,
                                        const toolpath::Piece& piece) const {
  double low = begin.s, high = end.s;
  const double first = begin.rows[row].by_b, last = end.rows[row].by_b;
  Knot at = knot_at(low + (high - low) * first / (first - last), piece);
  for (int step = 0; step < most_newton_steps && !turns_back(at.rows[row], turning_place * (end.s - begin.s)); ++step) {
    const constraints::AccelerationRow& rate = at.rows[row];
    ((rate.by_b > 0) == (first > 0) ? low : high) = at.s;
    const double newton = at.s - rate.by_b / rate.by_x;
    at = knot_at(newton > low && newton < high ? newton : low + (high - low) / 2, piece);
  }
  return at;
}

double TimeBound::velocity_limit(double s, const geometry::PointJet& jet, const toolpath::Piece& piece) const {
  const double speed = constraints_.greatest_speed({jet, piece.greatest_speed(s, jet)});
  return speed * speed;
}

/// Where one velocity holds back at one knot and another at the other, the greatest square of speed has a peak between, like a
/// tent, which is less than twice as high in the middle.
double TimeBound::x_above(const Knot& begin, const Knot& end, const toolpath::Piece& piece) const {
  if (begin.is_at_feed && end.is_at_feed) return 0;
  const double s = begin.s + (end.s - begin.s) / 2;
  const double x = velocity_limit(s, piece.axes().jets(s), piece);
  return std::max(0.0, 2 * (x - (begin.x_max + end.x_max) / 2));
}

void TimeBound::add_squares(const Knot& begin, const Knot& end, Interval& interval) {
  const double length = interval.length;
  for (std::size_t i = 0; i < most_rows; ++i) {
    const constraints::AccelerationRow &first = begin.rows[i], &last = end.rows[i];
    if (!(first.limit < infinity) || !(first.bounds() || last.bounds())) continue;
    const bool turns_first = turns_back(first, turning_place * length),
               turns_last = turns_back(last, turning_place * length);
    const SquareBound square = {turns_first ? 0 : first.by_b * first.by_b, turns_last ? 0 : last.by_b * last.by_b,
                                2 * first.limit * travel(first, last, length)};
    const auto limit = [](double& x, double by, double most) {
      if (x * by > most) x = most / by;
    };
    // Where the row does not turn evenly all along, the curve may have turned next to the knot alone.
    const auto turns_evenly = [&](const auto& turning, const auto& other) {
      return std::abs(turning.by_x) * length <= 2 * std::abs(other.by_b);
    };
    const bool is_even =
        turns_first != turns_last && (turns_first ? turns_evenly(first, last) : turns_evenly(last, first));
    const auto limit_begin = [&](double by, double most) {
      limit(interval.x_max, by, most);
      if (is_even) limit(interval.top, by, most);
    };
    const auto limit_end = [&](double by, double most) {
      limit(interval.x_end_max, by, most);
      if (is_even) limit(interval.top_end, by, most);
    };
    if (turns_first) limit_begin(std::abs(first.by_x), first.limit);
    if (turns_last) limit_end(std::abs(last.by_x), last.limit);
    // What one end alone is asked bounds no slope.
    if (square.by_begin == 0) limit_end(square.by_end, square.change);
    if (square.by_end == 0) limit_begin(square.by_begin, square.change);
    if (square.by_begin > 0 && square.by_end > 0) interval.squares[interval.square_count++] = square;
  }
}

/// Where what is placed ends; nothing is where all before was without length.
void TimeBound::slow_down_to(double speed) {
  if (waiting_.empty()) return;
  double& x_end_max = waiting_.back().x_end_max;
  x_end_max = std::min(x_end_max, speed * speed);
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

/// Each square bounds x_end from above and from below by straight lines in x, none of which falls. The greatest x is where the
/// first of the lower ones crosses an upper one, or the greatest x_end.
double TimeBound::greatest_start(const Interval& interval, double x_end) {
  const double x_end_most = std::min(x_end, interval.x_end_max);
  if (interval.is_straight()) return std::min(interval.x_max, x_end_most + 2 * interval.straight_b * interval.length);
  double x = interval.x_max;
  const auto squares = std::span(interval.squares).first(interval.square_count);
  for (const SquareBound& lower : squares) {
    if (const double most = lower.change + lower.by_end * x_end_most; x * lower.by_begin > most)
      x = most / lower.by_begin;
    for (const SquareBound& upper : squares) {
      const double closing = lower.by_begin * upper.by_end - upper.by_begin * lower.by_end;
      const double apart = upper.change * lower.by_end + lower.change * upper.by_end;
      if (x * closing > apart) x = apart / closing;
    }
  }
  return x;
}

double TimeBound::greatest_end(const Interval& interval, double x_begin) {
  if (interval.is_straight()) return std::min(interval.x_end_max, x_begin + 2 * interval.straight_b * interval.length);
  double x = interval.x_end_max;
  for (const SquareBound& square : std::span(interval.squares).first(interval.square_count)) {
    if (const double most = square.change + square.by_begin * x_begin; x * square.by_end > most)
      x = most / square.by_end;
  }
  return x;
}

/// On a straight interval speed rises to a peak below the limit, stays there, and falls. Else x rises from one knot as fast as
/// accelerations allow, stays below a line next to the greatest at both knots, and falls to the other: the lowest of three
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
  const double x_top = interval.top + interval.x_above, x_fall = x_end + fall * length;
  const double top = (interval.top_end - interval.top) / length;
  const auto x_at = [&](double s) {
    return std::min({x_begin + rise * s, x_top + top * s, x_end + fall * (length - s)});
  };
  // Where two of the lines cross.
  std::array<double, 5> places{0, (x_top - x_begin) / (rise - top), (x_fall - x_top) / (top + fall),
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

/// Of x by s, so that all of the interval is a rise from the first knot, or a fall to the second.
TimeBound::Slopes TimeBound::greatest_slopes(const Interval& interval, double x_begin, double x_end) {
  Slopes slopes{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  for (const SquareBound& square : std::span(interval.squares).first(interval.square_count)) {
    const double x_end_most = (square.change + square.by_begin * x_begin) / square.by_end;
    const double x_begin_most = (square.change + square.by_end * x_end) / square.by_begin;
    slopes.up = std::min(slopes.up, (x_end_most - x_begin) / interval.length);
    slopes.down = std::min(slopes.down, (x_begin_most - x_end) / interval.length);
  }
  return slopes;
}

}  // namespace leadscrew::planner
