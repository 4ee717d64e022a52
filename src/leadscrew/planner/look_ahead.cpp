#include <algorithm>
#include <cmath>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/look_ahead.hpp>
#include <leadscrew/planner/speed_profile.hpp>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using numeric::DoubleDouble;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double gap = 1e-3;        // of the time, to the optimum
constexpr double cold_gap = 20;     // of creep
constexpr double warm_gap = 0.3;    // of a window whose beginning is nearly optimal already
constexpr double repair_gap = 0.1;  // of a profile that is planned again
constexpr int repairs = 3;
constexpr double repair_margin = 2e-4;
constexpr int usual_looks = 12;  // of the proof, a segment
constexpr int close_looks = 32;  // where knots lie far apart for how speed falls
constexpr std::size_t stopping_intervals = 20;
constexpr double granted_slowing = 1.0002;  // below, slowing time costs less than planning again

constexpr double stops_ahead = 4.5;    // times to stop that lie between what is committed and the end of the window
constexpr double stops_committed = 3;  // times to stop that are committed, where speed is greatest
constexpr double least_reach = 0.25;   // s
constexpr std::size_t most_intervals = 320;
constexpr std::size_t few_intervals = 200;
constexpr std::size_t least_ahead = 16;      // intervals
constexpr std::size_t least_to_change = 8;   // intervals left of a window for a change of speed to begin in it
constexpr double sliced_cruise_knots = 40;   // where speed may have to fall at any time
constexpr double sliced_cruise_time = 1e-3;  // s
constexpr std::size_t most_pieces = 2048;

constexpr std::array<double, 4> gauss_half_places = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                     0.9602898564975363};
constexpr std::array<double, 4> gauss_half_weights = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                      0.1012285362903763};

struct Knot {
  double s = 0, speed = 0, acceleration = 0;
};

/// s(τ) along the section, by a quintic with the speeds and accelerations of both ends (Hermite).
Segment quintic(const Knot& from, const Knot& to, double duration) {
  const double t = duration, way = to.s - from.s;
  const double r0 = way - t * (from.speed + t * from.acceleration / 2);
  const double r1 = t * (to.speed - from.speed - t * from.acceleration);
  const double r2 = t * t * (to.acceleration - from.acceleration);
  Segment segment;
  segment.duration = t;
  segment.s0 = from.s;
  segment.v0 = from.speed;
  segment.c2 = from.acceleration / 2;
  segment.c3 = (10 * r0 - 4 * r1 + r2 / 2) / (t * t * t);
  segment.c4 = (-15 * r0 + 7 * r1 - r2) / (t * t * t * t);
  segment.c5 = (6 * r0 - 3 * r1 + r2 / 2) / (t * t * t * t * t);
  return segment;
}

/// ∫ x^(−1/2) ds over an interval, by eight-point Gauss.
double travel_time(const SpeedProfile& profile, std::size_t k) {
  double sum = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    for (const double side : {-1.0, 1.0}) {
      sum += gauss_half_weights[q] / std::sqrt(profile.square(k, 0.5 + 0.5 * side * gauss_half_places[q]));
    }
  }
  return sum / 2 * profile.width(k);
}

class Emission {
 public:
  Emission(const SpeedProfile& profile, double begin) : profile_(profile), begin_(begin) {}

  /// From rest or from where the window begins, to rest or to its last knot.
  std::vector<Segment> emit(double length) {
    const std::size_t n = profile_.intervals();
    Knot here = knot(0, 0);
    if (profile_.starts_at_rest()) ramp_up(begin_, here);
    for (std::size_t k = 0; k < n; ++k) here = interval(k, here);
    if (profile_.ends_at_rest()) ramp_down(here, length);
    return std::move(segments_);
  }
  const std::vector<std::size_t>& intervals() const { return intervals_; }

 private:
  Knot knot(std::size_t k, double u) const {
    const double x = profile_.square(k, u);
    const std::vector<double>& s = profile_.knots().s;
    return {u >= 1 ? s[k + 1] : s[k] + u * profile_.width(k), std::sqrt(x), profile_.square_slope(k, u) / 2};
  }

  void push(Segment segment, std::size_t interval) {
    segment.begin = now_;
    now_ = now_ + segment.duration;
    segments_.push_back(segment);
    intervals_.push_back(interval);
  }

  /// s = J t³/6 up to the first knot: t = 3 s₁/v₁.
  void ramp_up(double from, const Knot& to) {
    const double way = to.s - from, t = 3 * way / to.speed;
    Segment segment;
    segment.duration = t;
    segment.s0 = from;
    segment.c3 = way / (t * t * t);
    push(segment, 0);
  }
  void ramp_down(const Knot& from, double length) {
    const double way = length - from.s, t = 3 * way / from.speed, c3 = way / (t * t * t);
    Segment segment;
    segment.duration = t;
    segment.s0 = from.s;
    segment.v0 = 3 * c3 * t * t;
    segment.c2 = -3 * c3 * t;
    segment.c3 = c3;
    push(segment, profile_.intervals() - 1);
  }

  Knot interval(std::size_t k, const Knot& from) {
    if (profile_.is_level(k)) {
      Segment segment;
      segment.duration = profile_.width(k) / from.speed;
      segment.s0 = from.s;
      segment.v0 = from.speed;
      segment.state = MotionState::constant;
      const Knot to{profile_.knots().s[k + 1], from.speed, 0};
      push(segment, k);
      return to;
    }
    const Knot to = knot(k, 1);
    push(quintic(from, to, travel_time(profile_, k)), k);
    return to;
  }

  const SpeedProfile& profile_;
  double begin_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> intervals_;
  DoubleDouble now_;
};

/// The largest ratio of any limit, some looks a segment. What has a peak between two looks, higher than both by a few
/// millionths, counts as if it were larger by `between_looks`.
double greatest_ratio(const Segment& segment, const Section& section, const machine::Machine& machine,
                      double feed_factor, int looks) {
  constexpr double between_looks = 5e-5;
  double greatest = 0;
  const double duration = segment.duration.value();
  for (int k = 0; k <= looks; ++k) {
    const PathState at = evaluate(segment, duration * k / looks);
    const Side side = k == 0 ? Side::right : Side::left;
    const geometry::PointJet jet = section.jets(at.s, side);
    const AxisRatios ratios = greatest_ratios(jet, at, machine);
    const double feed = at.speed / (feed_factor * section.feed(at.s, side));
    const double turning = turns(jet) ? 1 + between_looks : 1;
    greatest = std::max(
        {greatest, feed, ratios.velocity * turning, std::max(ratios.acceleration, ratios.jerk) * (1 + between_looks)});
  }
  return greatest;
}

/// The time at which the segment passes a place inside it, by bisection and Newton.
double time_at(const Segment& segment, double s) {
  double from = 0, to = segment.duration.value();
  for (int step = 0; step < 200 && to - from > 1e-16 * to; ++step) {
    const double middle = (from + to) / 2;
    (evaluate(segment, middle).s < s ? from : to) = middle;
  }
  return to;
}

/// The same polynomial from a later time on.
Segment later(const Segment& segment, double t) {
  Segment rest = segment;
  const PathState at = evaluate(segment, t);
  const double c3 = segment.c3, c4 = segment.c4, c5 = segment.c5;
  rest.begin = segment.begin + DoubleDouble(t);
  rest.duration = segment.duration - DoubleDouble(t);
  rest.v0 = at.speed;
  rest.c2 = at.acceleration / 2;
  rest.c3 = c3 + t * (4 * c4 + t * 10 * c5);
  rest.c4 = c4 + 5 * t * c5;
  return rest;
}

/// From motion to rest within `room`, no longer than `longest`, s: speed falls by a cubic from the speed and the
/// acceleration there are to 0 and 0, v(u) = (1 − u)²(v + u(2v + aT)), u = τ/T. Jerk is (4aT + 6v)/T² against the
/// motion at first and (6v + 2aT)/T² at last; the first T that keeps every limit of every axis is taken. Nothing if
/// there is none.
std::optional<Segment> come_to_rest(const Knot& from, double room, double longest, const Section& section,
                                    const machine::Machine& machine) {
  const double jerk = 0.99 * tangent_limits(section.jets(from.s, Side::right), machine).jerk;
  const double v = from.speed, a = from.acceleration;
  if (!(v > 0)) return std::nullopt;
  double t = (a + std::sqrt(a * a + 6 * v * jerk)) / jerk;
  for (int attempt = 0; attempt < 40; ++attempt, t *= 1.06) {
    const double way = t * (v / 2 + t * a / 12);
    if (t > longest || way > room || 3 * v + a * t < 0) return std::nullopt;
    Segment segment;
    segment.duration = t;
    segment.s0 = from.s;
    segment.v0 = v;
    segment.c2 = a / 2;
    segment.c3 = (-3 * v - 2 * t * a) / (3 * t * t);
    segment.c4 = (2 * v + t * a) / (4 * t * t * t);
    if (greatest_ratio(segment, section, machine, infinity, close_looks) <= 1) return segment;
  }
  return std::nullopt;
}

double stop_time(double speed, const TangentLimits& limits) {
  const double a = limits.acceleration, j = limits.jerk;
  return speed > a * a / j ? speed / a + a / j : 2 * std::sqrt(speed / j);
}

/// The knot that the next window begins at: as late as the end of this one still lies some stops ahead of it.
std::size_t commit_until(const SpeedProfile& profile, const Section& section, const machine::Machine& machine) {
  const std::size_t n = profile.intervals();
  std::size_t k = n;
  double ahead = 0;
  while (k > 0) {
    --k;
    ahead += travel_time(profile, k);
    if (n - k < least_ahead) continue;
    const double s = profile.knots().s[k];
    const TangentLimits limits = tangent_limits(section.jets(s, Side::right), machine);
    if (ahead >= stops_ahead * stop_time(std::sqrt(profile.square(k, 0)), limits)) break;
  }
  return std::max({k, n / 4, std::size_t{1}});
}

}  // namespace

/// Only from rest: x(s) becomes λ²x(s), and so does what follows.
void LookAhead::slow_down(Window& window, double factor) {
  window.profile.slow_down(factor);
  DoubleDouble now;
  for (Segment& segment : window.segments) {
    segment.begin = now;
    segment.duration = segment.duration / DoubleDouble(factor);
    now = now + segment.duration;
    double power = factor;
    segment.v0 = segment.v0 * power;
    for (double* const c : {&segment.c2, &segment.c3, &segment.c4, &segment.c5}) *c *= power *= factor;
  }
  if (!window.after) return;
  const double square = factor * factor;
  window.after->x *= square;
  window.after->slope *= square;
  window.after->bend *= square;
  window.after->share *= square;
  for (double& c : window.after->c) c *= square;
}

void LookAhead::append(const toolpath::Piece& piece) {
  section_.append(piece);
  const double length = geometry::length(piece.curve);
  for (const double s : {0.0, length / 2}) {
    const geometry::PointJet jet = geometry::jets(piece.curve, s);
    const TangentLimits limits = tangent_limits(jet, machine_);
    double speed = piece.feed;
    for (const base::Axis axis : base::all_axes) {
      const double rate = std::abs(jet[base::index(axis)].first);
      if (rate > 1e-3) speed = std::min(speed, machine_.limits(axis).velocity / rate);
    }
    fastest_ = std::max(fastest_, speed);
    slowest_stop_ = std::max(slowest_stop_, stop_time(speed, limits));
  }
  reach_ = std::max(reach_, fastest_ * std::max(least_reach, slowest_stop_ * (stops_ahead + stops_committed)));
}

void LookAhead::clear() {
  section_.clear();
  closed_ = false;
  untouched_ = true;
  stand_at(0);
  last_begin_ = tail_end_ = last_tail_end_ = 0;
  fastest_ = slowest_stop_ = reach_ = 0;
}

void LookAhead::override_feed(double factor) {
  factor_ = factor;
}

void LookAhead::refuse() {
  stand_at(last_tail_end_);
  tail_end_ = last_tail_end_;
}

void LookAhead::stand_at(double s) {
  begin_ = s;
  window_.reset();
  continuation_.reset();
  knots_.clear();
  breaks_.clear();
  end_ramp_ = 0;
}

bool LookAhead::knows_enough() const {
  return closed_ || section_.length() - begin_ >= reach_ || section_.size() >= most_pieces;
}

Stretch LookAhead::next_stretch() const {
  Stretch stretch;
  stretch.begin = begin_;
  stretch.end = section_.length();
  if (stretch.end - begin_ > 1.5 * reach_) stretch.end = begin_ + reach_;
  stretch.starts_at_rest = !continuation_;
  stretch.ends_at_rest = closed_ && stretch.end == section_.length();
  if (factor_ > 0) stretch.feed_factor = factor_;
  stretch.kept = knots_;
  stretch.kept_breaks = breaks_;
  stretch.kept_end_ramp = end_ramp_;
  if (end_ramp_ > 0) {
    stretch.end = section_.length();
    stretch.ends_at_rest = true;
  }
  if (slice_ < infinity) {
    stretch.cruise_knots = sliced_cruise_knots;
    stretch.cruise_time = sliced_cruise_time;
  }
  return stretch;
}

/// Law of time of the window, proven or not: `worst` ratio, and by how much rows must be tightened. False if it cannot
/// come to rest at its end.
bool LookAhead::emit(Window& window, const Stretch& stretch, Aim aim, double& worst,
                     std::vector<double>& factors) const {
  SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  Emission emission(profile, begin_);
  if (!profile.ends_at_rest()) {
    window.last_interval = commit_until(profile, section_, machine_);
    window.after = profile.continuation(window.last_interval);
    if (!window.after) {
      profile.unlevel();
      window.after = profile.continuation(window.last_interval);
    }
  }
  window.segments = emission.emit(stretch.end);
  window.intervals = emission.intervals();
  window.end = stretch.end;
  window.to_rest = profile.ends_at_rest();
  const auto stop_at = [&](std::size_t knot, double longest) {
    const double s = profile.knots().s[knot];
    const Knot last = knot < n ? Knot{s, std::sqrt(profile.square(knot, 0)), profile.square_slope(knot, 0) / 2}
                               : Knot{s, std::sqrt(profile.square(n - 1, 1)), profile.square_slope(n - 1, 1) / 2};
    return come_to_rest(last, stretch.end - s, longest, section_, machine_);
  };
  std::optional<Segment> stop;
  std::size_t stops = n;
  if (!profile.ends_at_rest()) {
    stop = stop_at(n, infinity);
    if (!stop) return false;
  }
  if (aim == Aim::rest) {  // where that is soonest
    const Segment& last = window.segments.back();
    double soonest = (last.begin + last.duration).value() + (stop ? stop->duration.value() : 0);
    for (std::size_t k = 0; k < window.segments.size(); ++k) {
      const double begin = window.segments[k].begin.value();
      const std::size_t knot = window.intervals[k];
      if (begin >= soonest) break;
      if (profile.starts_at_rest() && knot == 0) continue;
      std::optional<Segment> here = stop_at(knot, soonest - begin);
      if (!here) continue;
      soonest = begin + here->duration.value();
      stop = here;
      stops = knot;
      window.to_rest = true;
    }
    window.to_rest = window.to_rest || stop.has_value();
  }
  if (stop) {
    const auto cut = std::lower_bound(window.intervals.begin(), window.intervals.end(), stops);
    window.segments.resize(static_cast<std::size_t>(cut - window.intervals.begin()));
    window.intervals.resize(window.segments.size());
    if (!window.segments.empty()) stop->begin = window.segments.back().begin + window.segments.back().duration;
    window.end = evaluate(*stop, stop->duration.value()).s;
    window.segments.push_back(*stop);
    window.intervals.push_back(stops);
  }
  const double feed_factor = profile.is_too_fast() || factor_ == 0 ? infinity : factor_;
  worst = 0;
  factors.assign(n, 1.0);
  for (std::size_t k = 0; k < window.segments.size(); ++k) {
    const int looks =
        !profile.ends_at_rest() && window.intervals[k] + stopping_intervals > n ? close_looks : usual_looks;
    const double ratio =
        ::leadscrew::planner::greatest_ratio(window.segments[k], section_, machine_, feed_factor, looks);
    worst = std::max(worst, ratio);
    if (ratio <= 1) continue;
    const std::size_t interval = std::min(window.intervals[k], n - 1);
    for (std::size_t i = interval > 0 ? interval - 1 : 0; i <= std::min(interval + 1, n - 1); ++i) {
      factors[i] = std::max(factors[i], ratio + repair_margin);
    }
  }
  return true;
}

std::unique_ptr<LookAhead::Window> LookAhead::solve(const Stretch& stretch, Aim aim) const {
  Knots knots = place_knots(section_, machine_, stretch, most_intervals);
  if (knots.intervals < 2) return nullptr;
  const double factor = stretch.feed_factor;
  auto solved = std::make_unique<Window>(
      Window{continuation_ ? SpeedProfile(section_, machine_, std::move(knots), *continuation_, factor)
                           : SpeedProfile(section_, machine_, std::move(knots), factor),
             {},
             {},
             0,
             false,
             std::nullopt,
             0,
             0});
  Window& window = *solved;
  SpeedProfile& profile = window.profile;
  if (!(profile.greatest_ratio() < 1)) return nullptr;
  if (aim == Aim::rest) {
    profile.descend_to_creep();
  } else if (profile.is_too_fast()) {
    profile.descend();
  }
  double first_gap = continuation_ ? warm_gap : cold_gap;
  std::vector<double> factors;
  for (int round = 0; round <= repairs; ++round) {
    const bool last_round = round == repairs;
    if (aim == Aim::fastest) {
      if (!last_round || !continuation_) profile.optimize(first_gap, gap);
      profile.level_cruises();
    } else if (round > 0 && !last_round) {
      profile.descend_to_creep();
    }
    double worst = 0;
    if (!emit(window, stretch, aim, worst, factors)) return nullptr;
    if (worst <= 1) return solved;
    if (!continuation_ && (worst <= granted_slowing || last_round)) {
      slow_down(window, 1 / worst);
      return solved;
    }
    if (last_round) return nullptr;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      if (factors[i] > 1) profile.tighten(i, factors[i]);
    }
    profile.retreat();
    first_gap = repair_gap;
    if (profile.greatest_ratio() < 1) continue;
    if (!continuation_) {
      profile.creep();
      first_gap = cold_gap;
      continue;
    }
    // There is not so much room: as much as there is.
    for (int halving = 0; halving < 8 && !(profile.greatest_ratio() < 1); ++halving) {
      for (double& factor_of : factors) {
        const double half = 1 + (factor_of - 1) / 2;
        if (factor_of > 1) profile.tighten(static_cast<std::size_t>(&factor_of - factors.data()), half / factor_of);
        factor_of = half;
      }
    }
    if (!(profile.greatest_ratio() < 1)) return nullptr;
  }
  return nullptr;
}

/// Changes what is planned but not handed out, if the speed that is asked for is another by now.
void LookAhead::take_change() {
  if (!window_ || factor_ == planned_factor_) return;
  const SpeedProfile& profile = window_->profile;
  if (window_->next == 0 && profile.starts_at_rest()) {
    stand_at(begin_);
    return;
  }
  const std::size_t interval =
      window_->next < window_->segments.size() ? window_->intervals[window_->next] : profile.intervals();
  if (interval + least_to_change > profile.intervals()) return;
  if (window_->to_rest && !profile.ends_at_rest() && window_->next + 1 >= window_->segments.size()) return;
  std::optional<Continuation> after = profile.continuation(interval);
  if (!after) return;
  forget();
  std::unique_ptr<Window> before = std::move(window_);
  go_on_from(*before, interval, std::move(*after));
  window_ = solve();
  if (window_) return;
  ++refused_;
  stand_at(begin_);
  window_ = std::move(before);
}

/// What comes after the window begins in motion at one of its knots.
void LookAhead::go_on_from(const Window& window, std::size_t interval, Continuation continuation) {
  const Knots& knots = window.profile.knots();
  const auto from = static_cast<std::ptrdiff_t>(interval);
  knots_.assign(knots.s.begin() + from, knots.s.end());
  breaks_.assign(knots.breaks.begin() + from, knots.breaks.end());
  end_ramp_ = knots.end_ramp;
  begin_ = knots_[0];
  continuation_ = std::move(continuation);
  window_.reset();
}

std::unique_ptr<LookAhead::Window> LookAhead::solve() {
  std::unique_ptr<Window> window = solve(next_stretch(), factor_ > 0 ? Aim::fastest : Aim::rest);
  if (window) planned_factor_ = factor_;
  return window;
}

/// From rest to rest on a part of what is known: there, slowing down always helps.
void LookAhead::solve_to_rest() {
  ++refused_;
  Stretch stretch = next_stretch();
  stretch.ends_at_rest = true;
  for (int halving = 0; halving < 40 && !window_; ++halving) {
    window_ = solve(stretch, Aim::fastest);
    stretch.end = begin_ + (stretch.end - begin_) / 2;
  }
}

/// Pieces that nothing comes back to. All places on the section are counted anew.
void LookAhead::forget() {
  const double shift = section_.forget_before(std::min(last_begin_, begin_));
  if (shift == 0) return;
  for (double& s : knots_) s -= shift;
  for (double* s : {&begin_, &last_begin_, &tail_end_, &last_tail_end_}) *s -= shift;
  if (!window_) return;
  window_->profile.shift(shift);
  window_->end -= shift;
  for (Segment& segment : window_->segments) segment.s0 = segment.s0 - DoubleDouble(shift);
}

std::optional<Chunk> LookAhead::plan() {
  if (section_.empty()) return std::nullopt;
  take_change();
  if (!window_) {
    if (begin_ >= section_.length() || factor_ == 0 || !knows_enough()) return std::nullopt;
    forget();
    window_ = solve();
    if (!window_) solve_to_rest();
    if (!window_) return std::nullopt;
  } else if (!window_->to_rest && window_->intervals[window_->next] >= window_->last_interval) {
    if (!knows_enough()) return std::nullopt;
    if (window_->profile.intervals() < few_intervals) reach_ *= 1.5;
    forget();
    std::unique_ptr<Window> before = std::move(window_);
    go_on_from(*before, before->last_interval, *before->after);
    window_ = solve();
    if (!window_) {  // on to where this one comes to rest
      ++refused_;
      window_ = std::move(before);
      window_->to_rest = true;
    }
  }
  return hand_out();
}

Chunk LookAhead::hand_out() {
  untouched_ = false;
  Window& window = *window_;
  const std::vector<Segment>& segments = window.segments;
  const std::size_t count = segments.size();
  const DoubleDouble start = segments[window.next].begin;
  std::size_t after = window.next + 1;  // of the slice
  while (after < count && (window.to_rest || window.intervals[after] < window.last_interval) &&
         (window.intervals[after] == window.intervals[after - 1] ||
          (segments[after].begin + segments[after].duration - start).value() <= slice_)) {
    ++after;
  }
  const auto from = segments.begin() + static_cast<std::ptrdiff_t>(window.next);
  const auto middle = segments.begin() + static_cast<std::ptrdiff_t>(after);
  const double end = after < count ? segments[after].s0.value() : window.end;
  const std::size_t first_piece = section_.piece_at(begin_, Side::right);
  const std::size_t last_piece = section_.piece_at(window.end, Side::left);
  Chunk chunk;
  for (std::size_t p = first_piece; p <= last_piece; ++p) chunk.pieces.push_back(section_.piece(p));
  chunk.segments = along_pieces({from, middle}, section_, end, first_piece);
  chunk.stop_tail = along_pieces({middle, segments.end()}, section_, window.end, first_piece);
  for (std::vector<Segment>* part : {&chunk.segments, &chunk.stop_tail}) {
    for (Segment& segment : *part) segment.begin = segment.begin - start;
  }
  chunk.duration = chunk.segments.back().begin + chunk.segments.back().duration;
  chunk.length = end - begin_;
  chunk.tail_length = window.end - end;
  const toolpath::Piece& last = section_.piece(last_piece);
  chunk.rest = geometry::evaluate(last.curve, DoubleDouble(window.end - section_.offset(last_piece)));
  chunk.rest_line = last.line;
  last_begin_ = begin_;
  last_tail_end_ = tail_end_;
  begin_ = end;
  tail_end_ = window.end;
  window.next = after;
  if (after == count) stand_at(window.end >= section_.length() ? section_.length() : window.end);
  return chunk;
}

std::vector<Segment> along_pieces(const std::vector<Segment>& segments, const Section& section, double section_end,
                                  std::size_t first_piece) {
  std::vector<Segment> cut;
  cut.reserve(segments.size() + 8);
  std::size_t piece = first_piece;
  const auto place = [&](Segment segment, std::size_t on) {
    segment.piece = static_cast<std::uint32_t>(on - first_piece);
    segment.s0 = segment.s0 - DoubleDouble(section.offset(on));
    cut.push_back(segment);
  };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment segment = segments[k];
    const double end = k + 1 < segments.size() ? segments[k + 1].s0.value() : section_end;
    while (piece + 1 < section.size() && section.offset(piece + 1) <= segment.s0.value()) ++piece;
    while (piece + 1 < section.size() && section.offset(piece + 1) < end) {
      const double border = section.offset(piece + 1), t = time_at(segment, border);
      if (!(t < segment.duration.value())) break;  // it ends where the piece does
      if (t > 0) {
        Segment rest = later(segment, t);
        segment.duration = DoubleDouble(t);
        rest.s0 = border;
        place(segment, piece);
        segment = rest;
      }
      ++piece;
    }
    place(segment, piece);
  }
  return cut;
}

}  // namespace leadscrew::planner
