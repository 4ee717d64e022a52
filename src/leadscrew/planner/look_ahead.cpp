#include <algorithm>
#include <cmath>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/look_ahead.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <numeric>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using numeric::DoubleDouble;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double gap = 1e-3;        // of the time, to the optimum
constexpr double cold_gap = 20;     // of creep
constexpr double warm_gap = 0.3;    // of a window whose beginning is nearly optimal already
constexpr double repair_gap = 0.1;  // of a profile that is planned again
constexpr double deep_gap = 2.4;     // of a profile from which limits can be tightened
constexpr int repairs = 3;
constexpr double repair_margin = 2e-4;
constexpr int refinements = 3;
constexpr double coarse_knots = 1.005;  // ratios above tell that knots lie too far apart
constexpr double cruising = 0.02;       // of the acceleration
constexpr double most_parts = 32;       // of an interval, at once
constexpr double steepest = 2.5;        // ratio of the widths of neighbours
constexpr double widest = 8;
constexpr std::size_t most_refined = 520, intervals_at_end = 8;
constexpr int usual_looks = 12;  // of the proof, a segment
constexpr int few_looks = 4;     // of a part of a segment that was looked at
constexpr int close_looks = 32;  // where knots lie far apart for how speed falls
constexpr std::size_t stopping_intervals = 20;
constexpr double granted_slowing = 1.0002;  // below, slowing time costs less than planning again

constexpr double stops_ahead = 4.5;    // times to stop that lie between what is committed and the end of the window
constexpr double stops_committed = 3;  // times to stop that are committed, where speed is greatest
constexpr double least_reach = 0.25;   // s
constexpr std::size_t most_intervals = 320;
constexpr std::size_t few_intervals = 200;
constexpr std::size_t least_ahead = 16;     // intervals
constexpr std::size_t least_to_change = 8;  // intervals left of a window for a change of speed to begin in it
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

/// ∫ x^(−1/2) ds over a part of an interval, by eight-point Gauss.
double travel_time(const SpeedProfile& profile, std::size_t k, double from = 0, double to = 1) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    for (const double side : {-1.0, 1.0}) {
      sum += gauss_half_weights[q] / std::sqrt(profile.square(k, middle + half * side * gauss_half_places[q]));
    }
  }
  return sum * half * profile.width(k);
}

Knot knot(const SpeedProfile& profile, std::size_t k, double u) {
  const std::vector<double>& s = profile.knots().s;
  return {u >= 1 ? s[k + 1] : s[k] + u * profile.width(k), std::sqrt(profile.square(k, u)),
          profile.square_slope(k, u) / 2};
}

/// Along a part of an interval, from `from` on, which becomes where it ends.
Segment along_interval(const SpeedProfile& profile, std::size_t k, double begin, double end, Knot& from) {
  const Knot here = from;
  from = knot(profile, k, end);
  if (!profile.is_level(k)) return quintic(here, from, travel_time(profile, k, begin, end));
  from.speed = here.speed;
  from.acceleration = 0;
  Segment segment;
  segment.duration = (from.s - here.s) / here.speed;
  segment.s0 = here.s;
  segment.v0 = here.speed;
  segment.state = MotionState::constant;
  return segment;
}

class Emission {
 public:
  Emission(const SpeedProfile& profile, double begin) : profile_(profile), begin_(begin) {}

  /// From rest or from where the window begins, to rest or to its last knot.
  std::vector<Segment> emit(double length) {
    const std::size_t n = profile_.intervals();
    Knot here = knot(profile_, 0, 0);
    if (profile_.starts_at_rest()) ramp_up(begin_, here);
    for (std::size_t k = 0; k < n; ++k) push(along_interval(profile_, k, 0, 1, here), k, 0);
    if (profile_.ends_at_rest()) ramp_down(here, length);
    return std::move(segments_);
  }
  const std::vector<std::size_t>& intervals() const { return intervals_; }
  const std::vector<double>& places() const { return places_; }

 private:
  void push(Segment segment, std::size_t interval, double place) {
    segment.begin = now_;
    now_ = now_ + segment.duration;
    segments_.push_back(segment);
    intervals_.push_back(interval);
    places_.push_back(place);
  }

  /// s = J t³/6 up to the first knot: t = 3 s₁/v₁.
  void ramp_up(double from, const Knot& to) {
    const double way = to.s - from, t = 3 * way / to.speed;
    Segment segment;
    segment.duration = t;
    segment.s0 = from;
    segment.c3 = way / (t * t * t);
    push(segment, 0, 0);
  }
  void ramp_down(const Knot& from, double length) {
    const double way = length - from.s, t = 3 * way / from.speed, c3 = way / (t * t * t);
    Segment segment;
    segment.duration = t;
    segment.s0 = from.s;
    segment.v0 = 3 * c3 * t * t;
    segment.c2 = -3 * c3 * t;
    segment.c3 = c3;
    push(segment, profile_.intervals() - 1, 1);
  }

  const SpeedProfile& profile_;
  double begin_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> intervals_;
  std::vector<double> places_;
  DoubleDouble now_;
};

/// The greatest of what is looked at in even steps, with the peak of the parabola through every three. What is no
/// number is too much.
class Peak {
 public:
  void look(double value) {
    const double bulge = looks_++ < 2 ? 0 : std::max(0.0, (2 * last_ - before_last_ - value) / 8);
    greatest_ = std::max({greatest_, value + bulge, last_ + bulge, before_last_ + bulge});
    if (std::isnan(value)) greatest_ = infinity;
    before_last_ = last_;
    last_ = value;
  }
  double greatest() const { return greatest_; }

 private:
  int looks_ = 0;
  double last_ = 0, before_last_ = 0, greatest_ = 0;
};

/// The largest ratios of speed, and of acceleration and jerk, some looks a segment.
Ratios greatest_ratios(const Segment& segment, const Section& section, const machine::Machine& machine,
                       double feed_factor, int looks) {
  constexpr double between_looks = 1 + 1e-5;  // of what is no parabola
  Peak speed, rows;
  double feed = 0;
  const double duration = segment.duration.value();
  for (int k = 0; k <= looks; ++k) {
    const PathState at = evaluate(segment, duration * k / looks);
    const Side side = k == 0 ? Side::right : Side::left;
    const geometry::PointJet jet = section.jets(at.s, side);
    const AxisRatios ratios = greatest_ratios(jet, at, machine);
    feed = std::max(feed, at.speed / (feed_factor * section.feed(at.s, side)));
    speed.look(turns(jet) ? ratios.velocity * between_looks : ratios.velocity);
    rows.look(std::max(ratios.acceleration, ratios.jerk) * between_looks);
  }
  return {std::max(speed.greatest(), feed), rows.greatest()};
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
    if (greatest_ratios(segment, section, machine, infinity, close_looks).worst() <= 1) return segment;
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
  if (continuation_) {
    stretch.kept = continuation_->s;
    stretch.kept_breaks = continuation_->breaks;
    stretch.kept_end_ramp = continuation_->end_ramp;
  }
  if (stretch.kept_end_ramp > 0) {
    stretch.end = section_.length();
    stretch.ends_at_rest = true;
  }
  return stretch;
}

/// Law of time of the window, proven or not: `worst` ratio, and `factors` by which rows must be tightened. False if it
/// cannot come to rest at its end.
bool LookAhead::emit(Window& window, const Stretch& stretch, Aim aim) const {
  SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  window.worst = 0;
  window.factors.assign(n, Ratios{});
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
  window.places = emission.places();
  window.end = stretch.end;
  window.to_rest = profile.ends_at_rest();
  const auto stop_from = [&](const Knot& from, double longest) {
    return come_to_rest(from, stretch.end - from.s, longest, section_, machine_);
  };
  std::optional<Segment> stop;
  std::size_t stops = window.segments.size();
  if (!profile.ends_at_rest()) {
    stop = stop_from({profile.knots().s[n], std::sqrt(profile.square(n - 1, 1)), profile.square_slope(n - 1, 1) / 2},
                     infinity);
    if (!stop) return false;
  }
  if (aim == Aim::rest) {  // where that is soonest
    const Segment& last = window.segments.back();
    double soonest = (last.begin + last.duration).value() + (stop ? stop->duration.value() : 0);
    for (std::size_t k = 0; k < window.segments.size(); ++k) {
      const Segment& segment = window.segments[k];
      const double begin = segment.begin.value();
      if (begin >= soonest) break;
      std::optional<Segment> here =
          stop_from({segment.s0.value(), segment.v0.value(), 2 * segment.c2}, soonest - begin);
      if (!here) continue;
      soonest = begin + here->duration.value();
      stop = here;
      stops = k;
      window.to_rest = true;
    }
    window.to_rest = window.to_rest || stop.has_value();
  }
  if (stop) {
    window.intervals.push_back(n);
    window.places.push_back(0);
    window.segments.resize(stops);
    window.intervals.resize(stops + 1);
    window.places.resize(stops + 1);
    if (stops > 0) stop->begin = window.segments.back().begin + window.segments.back().duration;
    window.end = evaluate(*stop, stop->duration.value()).s;
    window.segments.push_back(*stop);
  }
  const double feed_factor = profile.is_too_fast() || factor_ == 0 ? infinity : factor_;

  for (std::size_t k = 0; k < window.segments.size(); ++k) {
    const int looks =
        !profile.ends_at_rest() && window.intervals[k] + stopping_intervals > n ? close_looks : usual_looks;
    const Ratios ratios = greatest_ratios(window.segments[k], section_, machine_, feed_factor, looks);
    window.worst = std::max(window.worst, ratios.worst());
    if (ratios.worst() <= 1) continue;
    const std::size_t interval = std::min(window.intervals[k], n - 1);
    for (std::size_t i = interval > 0 ? interval - 1 : 0; i <= std::min(interval + 1, n - 1); ++i) {
      Ratios& factors = window.factors[i];
      if (ratios.speed > 1) factors.speed = std::max(factors.speed, ratios.speed + repair_margin);
      if (ratios.rows > 1) factors.rows = std::max(factors.rows, ratios.rows + repair_margin);
    }
  }
  return true;
}

std::unique_ptr<LookAhead::Window> LookAhead::solve(const Stretch& stretch, Aim aim) const {
  Knots knots = place_knots(section_, machine_, stretch, most_intervals);
  if (knots.intervals < 2) return nullptr;
  if (!continuation_) {
    auto window = std::make_unique<Window>(SpeedProfile(section_, machine_, std::move(knots), stretch.feed_factor));
    return repair_from_rest(*window, stretch) ? std::move(window) : nullptr;
  }
  for (int refinement = 0; refinement <= refinements; ++refinement) {
    const std::size_t intervals = knots.intervals;
    auto window =
        std::make_unique<Window>(SpeedProfile(section_, machine_, knots, *continuation_, stretch.feed_factor));
    if (!(window->profile.greatest_ratio() < 1)) return nullptr;
    const bool may_refine = stretch.changes_from > 0 && refinement < refinements;
    if (repair_in_motion(*window, stretch, aim, may_refine ? &knots : nullptr)) return window;
    if (knots.intervals == intervals) return nullptr;
  }
  return nullptr;
}

/// Plans until the proof is kept, and slows down what is left: from rest to rest or into creep that always helps. False
/// if it cannot come to rest at its end.
bool LookAhead::repair_from_rest(Window& window, const Stretch& stretch) const {
  SpeedProfile& profile = window.profile;
  if (!(profile.greatest_ratio() < 1)) return false;
  double first_gap = cold_gap;
  for (int round = 0;; ++round) {
    profile.optimize(first_gap, gap);
    profile.level_cruises();
    if (!emit(window, stretch, Aim::fastest)) return false;
    if (window.worst <= 1) return true;
    if (window.worst <= granted_slowing || round == repairs) {
      slow_down(window, 1 / window.worst);
      return true;
    }
    for (std::size_t i = 0; i < window.factors.size(); ++i) profile.tighten(i, window.factors[i]);
    profile.retreat();
    first_gap = repair_gap;
    if (profile.greatest_ratio() < 1) continue;
    profile.creep();
    first_gap = cold_gap;
  }
}

/// Plans until the proof is kept. False if it is not kept for all repairs, or if `finer` knots are needed first.
bool LookAhead::repair_in_motion(Window& window, const Stretch& stretch, Aim aim, Knots* finer) const {
  SpeedProfile& profile = window.profile;
  if (aim == Aim::fastest && profile.is_too_fast()) profile.descend();
  double first_gap = warm_gap;
  for (int round = 0; round <= repairs; ++round) {
    const bool last_round = round == repairs;
    if (!last_round) {
      aim == Aim::rest ? profile.descend_to_creep() : profile.optimize(first_gap, gap);
    }
    if (aim == Aim::fastest) profile.level_cruises();
    if (!emit(window, stretch, aim)) return false;
    if (window.worst <= 1) return true;
    if (last_round || (finer != nullptr && window.worst > coarse_knots && refine(*finer, window))) return false;
    profile.retreat();
    profile.center(deep_gap);
    first_gap = deep_gap;
    for (std::size_t i = 0; i < window.factors.size(); ++i) profile.tighten(i, window.factors[i]);
    // If there is not so much room: as much as there is.
    for (int halving = 0; halving < 8 && !(profile.greatest_ratio() < 1); ++halving) {
      for (std::size_t i = 0; i < window.factors.size(); ++i) {
        Ratios& factors = window.factors[i];
        const Ratios half{(1 + factors.speed) / 2, (1 + factors.rows) / 2};
        profile.tighten(i, {half.speed / factors.speed, half.rows / factors.rows});
        factors = half;
      }
    }
    if (!(profile.greatest_ratio() < 1)) return false;
  }
  return false;
}

/// Knots come between those that lie too far apart for what the window does: where the proof is not kept, and wherever
/// speed changes if there is room for so many. False if none do.
bool LookAhead::refine(Knots& knots, const Window& window) const {
  const SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  if (n < 2 * intervals_at_end) return false;
  // What was known ends in coefficients that have been lowered since: nothing comes between its last knots.
  const std::vector<double>& known = continuation_->s;
  const double from = known[known.size() - std::min(known.size(), intervals_at_end + 4)], to = known.back();
  const auto parts_if = [&](bool everywhere, double wider) {
    std::vector<double> widths(n - intervals_at_end, infinity);
    for (std::size_t k = 0; k < widths.size(); ++k) {
      const TangentLimits limits = tangent_limits(section_.jets(knots.s[k], Side::right), machine_);
      const double slope = std::max(std::abs(profile.square_slope(k, 0)), std::abs(profile.square_slope(k, 1)));
      const double ramp = wider * ramp_width(limits, std::min(profile.square(k, 0), profile.square(k, 1)));
      if (window.factors[k].worst() > 1)
        widths[k] = std::min(profile.width(k) / 2, ramp);
      else if (everywhere && slope / 2 > cruising * limits.acceleration)
        widths[k] = 1.5 * ramp;
    }
    const auto grade = [&](std::size_t k, std::size_t by) {
      widths[k] = std::min(widths[k], steepest * std::min(widths[by], profile.width(by)));
    };
    for (std::size_t k = 1; k < widths.size(); ++k) grade(k, k - 1);
    for (std::size_t k = widths.size() - 1; k-- > 0;) grade(k, k + 1);
    std::vector<std::size_t> parts;
    for (std::size_t k = 0; k < widths.size(); ++k) {
      if (knots.s[k + 1] > from && knots.s[k] < to) widths[k] = infinity;
      parts.push_back(static_cast<std::size_t>(std::clamp(std::round(profile.width(k) / widths[k]), 1.0, most_parts)));
    }
    return parts;
  };
  const std::size_t room = n < most_refined ? most_refined - n : 0;
  const auto added_by = [](const std::vector<std::size_t>& parts) {
    return std::accumulate(parts.begin(), parts.end(), std::size_t{0}) - parts.size();
  };
  std::vector<std::size_t> parts = parts_if(true, 1);
  for (double wider = 1; added_by(parts) > room && wider < widest; wider *= 1.5) parts = parts_if(false, wider);
  if (added_by(parts) == 0 || added_by(parts) > room) return false;
  std::vector<double> s;
  std::vector<bool> breaks;
  for (std::size_t k = 0; k < knots.s.size(); ++k) {
    s.push_back(knots.s[k]);
    breaks.push_back(knots.breaks[k]);
    for (std::size_t part = 1; k < parts.size() && part < parts[k]; ++part) {
      s.push_back(knots.s[k] + profile.width(k) * static_cast<double>(part) / static_cast<double>(parts[k]));
      breaks.push_back(false);
    }
  }
  knots.s = std::move(s);
  knots.breaks = std::move(breaks);
  knots.intervals += added_by(parts);
  return true;
}

/// Changes what is planned but not handed out, if the speed that is asked for is another by now.
void LookAhead::take_change() {
  if (!window_ || factor_ == planned_factor_) return;
  if (window_->next < window_->refused_until) return;
  const SpeedProfile& profile = window_->profile;
  if (window_->next == 0 && profile.starts_at_rest()) {
    stand_at(begin_);
    return;
  }
  const std::size_t interval = window_->intervals[window_->next];
  if (interval + least_to_change > profile.intervals()) return;
  if (window_->to_rest && !profile.ends_at_rest() && window_->next + 1 >= window_->segments.size()) return;
  forget();
  std::optional<Continuation> after = profile.continuation(interval, window_->places[window_->next]);
  if (!after) return;
  std::unique_ptr<Window> before = std::move(window_);
  go_on_from(std::move(*after));
  window_ = solve(Refinement::where_speed_changes);
  if (window_) return;
  ++refused_;
  stand_at(begin_);
  window_ = std::move(before);
  window_->refused_until = window_->next + window_->patience;
  window_->patience *= 2;
}

/// What comes after the window begins in motion at one of its knots.
void LookAhead::go_on_from(Continuation continuation) {
  begin_ = continuation.s[0];
  continuation_ = std::move(continuation);
  window_.reset();
}

std::unique_ptr<LookAhead::Window> LookAhead::solve(Refinement refinement) {
  Stretch stretch = next_stretch();
  if (continuation_ && refinement == Refinement::where_speed_changes) {
    stretch.changes_from = continuation_->c[0];
  }
  std::unique_ptr<Window> window = solve(stretch, factor_ > 0 ? Aim::fastest : Aim::rest);
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
  if (continuation_) {
    for (double& s : continuation_->s) s -= shift;
  }
  for (double* s : {&begin_, &last_begin_, &tail_end_, &last_tail_end_}) *s -= shift;
  if (!window_) return;
  window_->profile.shift(shift);
  if (window_->after) {
    for (double& s : window_->after->s) s -= shift;
  }
  window_->end -= shift;
  for (Segment& segment : window_->segments) segment.s0 = segment.s0 - DoubleDouble(shift);
}

std::optional<Chunk> LookAhead::plan() {
  if (section_.empty()) return std::nullopt;
  take_change();
  if (!window_) {
    if (begin_ >= section_.length() || factor_ == 0 || !knows_enough()) return std::nullopt;
    forget();
    window_ = solve(Refinement::none);
    if (!window_) solve_to_rest();
    if (!window_) return std::nullopt;
  } else if (!window_->to_rest && window_->intervals[window_->next] >= window_->last_interval) {
    if (!knows_enough()) return std::nullopt;
    if (window_->profile.intervals() < few_intervals) reach_ *= 1.5;
    forget();
    std::unique_ptr<Window> before = std::move(window_);
    go_on_from(*before->after);
    window_ = solve(Refinement::none);
    if (!window_) window_ = solve(Refinement::where_speed_changes);
    if (!window_) {  // on to where this one comes to rest
      ++refused_;
      window_ = std::move(before);
      window_->to_rest = true;
    }
  }
  return hand_out();
}

/// What takes longer than a slice, where speed is low, is cut into parts, so that a change may begin in it.
void LookAhead::split_next(Window& window) const {
  constexpr double most_slices = 1000;
  const std::size_t next = window.next, k = window.intervals[next];
  const std::vector<double>& s = window.profile.knots().s;
  const Segment whole = window.segments[next];
  const double duration = whole.duration.value();
  if (!(duration > 1.5 * slice_) || window.places[next] > 0) return;
  if (next + 1 == window.segments.size() || whole.s0.value() != s[k]) return;
  if (window.segments[next + 1].s0.value() != s[k + 1]) return;
  const double parts = std::min(std::ceil(duration / slice_), most_slices);
  Knot here = knot(window.profile, k, 0);
  std::vector<Segment> segments;
  std::vector<double> places;
  DoubleDouble now = whole.begin;
  for (double part = 0; part < parts; ++part) {
    places.push_back(part / parts);
    Segment& segment = segments.emplace_back(along_interval(window.profile, k, part / parts, (part + 1) / parts, here));
    segment.begin = now;
    now = now + segment.duration;
    const bool fast = window.profile.is_too_fast() || factor_ == 0;
    const double feed_factor = fast ? infinity : planned_factor_;
    if (greatest_ratios(segment, section_, machine_, feed_factor, few_looks).worst() > 1) return;
  }
  const DoubleDouble later = now - (whole.begin + whole.duration);
  for (std::size_t i = next + 1; i < window.segments.size(); ++i) {
    window.segments[i].begin = window.segments[i].begin + later;
  }
  const auto at = static_cast<std::ptrdiff_t>(next);
  window.segments.erase(window.segments.begin() + at);
  window.segments.insert(window.segments.begin() + at, segments.begin(), segments.end());
  window.places.erase(window.places.begin() + at);
  window.places.insert(window.places.begin() + at, places.begin(), places.end());
  window.intervals.insert(window.intervals.begin() + at, segments.size() - 1, k);
}

Chunk LookAhead::hand_out() {
  untouched_ = false;
  Window& window = *window_;
  split_next(window);
  const std::vector<Segment>& segments = window.segments;
  const std::size_t count = segments.size();
  const DoubleDouble start = segments[window.next].begin;
  std::size_t after = window.next + 1;  // of the slice
  while (after < count && (window.to_rest || window.intervals[after] < window.last_interval) &&
         (segments[after].begin + segments[after].duration - start).value() <= slice_) {
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
