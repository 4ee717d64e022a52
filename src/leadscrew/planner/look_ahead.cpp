#include <algorithm>
#include <cmath>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/look_ahead.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <numeric>

namespace leadscrew::planner {

namespace {

using numeric::DoubleDouble;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double gap = 1e-3;        // of the time, to the optimum
constexpr double cold_gap = 20;     // of creep
constexpr double warm_gap = 0.3;    // of a window whose beginning is nearly optimal already
constexpr double repair_gap = 0.1;  // of a profile that is planned again
constexpr double deep_gap = 10;     // of a profile from which limits can be tightened
constexpr int repairs = 3;
constexpr double repair_margin = 2e-4;
constexpr int refinements = 3;
constexpr double coarse_knots = 1.005;  // ratios above tell that knots lie too far apart
constexpr double cruising = 0.02;       // of the acceleration
constexpr double most_parts = 32;       // of an interval, at once
constexpr double steepest = 2.5;        // ratio of the widths of neighbours
constexpr double widest = 8;
constexpr std::size_t most_refined = 600, intervals_at_end = 8;
constexpr int usual_looks = 12;  // of the proof, a segment
constexpr int few_looks = 4;     // of a part of a segment that was looked at
constexpr int close_looks = 32;  // where knots lie far apart for how speed falls
constexpr std::size_t stopping_intervals = 20;
constexpr double granted_slowing = 1.0002;  // below, slowing time costs less than planning again

constexpr double stops_ahead = 4.5;    // times to stop that lie between what is committed and the end of the window
constexpr double stops_committed = 3;  // times to stop that are committed, where speed is greatest
constexpr double least_reach = 0.25;   // s
constexpr std::size_t rows_of_a_window = 960;  // intervals times axes that move: so long does a window take to plan
constexpr std::size_t least_intervals = 200, greatest_intervals = 320;
constexpr double few = 0.6;  // of the intervals that a window may have
constexpr std::size_t least_ahead = 16;     // intervals
constexpr std::size_t least_to_change = 8;  // intervals left of a window for a change of speed to begin in it
constexpr std::size_t most_pieces = 900;
constexpr std::size_t most_patience = 16;  // segments

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
      if (rate > 0) moving_.set(base::index(axis));
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
  moving_.reset();
}

std::size_t LookAhead::most_intervals() const {
  return std::clamp(rows_of_a_window / std::max(moving_.count(), std::size_t{1}), least_intervals, greatest_intervals);
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
  window.turns_back = false;
  window.factors.assign(n, Ratios{});
  if (!profile.ends_at_rest()) {
    window.last_interval = commit_until(profile, section_, machine_);
    window.after = profile.continuation(window.last_interval);
    if (!window.after) {
      profile.unlevel();
      window.after = profile.continuation(window.last_interval);
    }
  }
  Emission emission = planner::emit(profile, begin_, stretch.end);
  window.segments = std::move(emission.segments);
  window.intervals = std::move(emission.intervals);
  window.places = std::move(emission.places);
  window.end = stretch.end;
  window.to_rest = profile.ends_at_rest();
  const auto stop_from = [&](const PathState& from, double longest) {
    return come_to_rest(from, stretch.end - from.s, longest, section_, machine_);
  };
  std::optional<Segment> stop;
  std::size_t stops = window.segments.size();
  if (!profile.ends_at_rest()) {
    stop = stop_from(state_at(profile, n - 1, 1), infinity);
    if (!stop) return false;
  }
  if (aim == Aim::rest) {  // where that is soonest
    const Segment& last = window.segments.back();
    double soonest = (last.begin + last.duration).value() + (stop ? stop->duration.value() : 0);
    for (std::size_t k = 0; k < window.segments.size(); ++k) {
      const Segment& segment = window.segments[k];
      const double begin = segment.begin.value();
      if (begin >= soonest) break;
      std::optional<Segment> here = stop_from(evaluate(segment, 0), soonest - begin);
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
    window.turns_back = window.turns_back || ratios.turns_back;
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
  Knots knots = place_knots(section_, machine_, stretch, most_intervals());
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

/// Plans until the proof is kept, and slows down what is left: from rest to rest or into creep that always helps, but
/// where motion turns back, for which there is only creep itself. False if it cannot come to rest at its end.
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
      if (window.turns_back) {
        profile.creep();
        if (!emit(window, stretch, Aim::fastest) || window.turns_back) return false;
      }
      slow_down(window, 1 / std::max(1.0, window.worst));
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
    const bool coarse = window.worst > coarse_knots || round + 1 >= repairs;  // or repairs have not helped
    if (finer != nullptr && coarse && refine(*finer, window)) return false;
    if (last_round) return false;
    profile.retreat();
    profile.center(deep_gap);
    first_gap = deep_gap;
    for (std::size_t i = 0; i < window.factors.size(); ++i) {  // half of the room at most
      const Ratios& factors = window.factors[i];
      if (factors.worst() == 1) continue;
      const Ratios room = profile.room(i);
      profile.tighten(i, {std::min(factors.speed, (1 + room.speed) / 2), std::min(factors.rows, (1 + room.rows) / 2)});
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
        widths[k] = wider < infinity ? std::min(profile.width(k) / 2, ramp) : profile.width(k) / 2;
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
  if (added_by(parts) > room) parts = parts_if(false, infinity);
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
  if (window_->next < window_->unchanged_until) return;
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
  stand_at(begin_);
  window_ = std::move(before);
  window_->unchanged_until = window_->next + window_->patience;
  window_->patience = std::min(2 * window_->patience, most_patience);
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
  return settled(solve(stretch, factor_ > 0 ? Aim::fastest : Aim::rest));
}

/// As it is kept, if there is one: planned for the factor asked for, in no more memory than it takes to read it.
std::unique_ptr<LookAhead::Window> LookAhead::settled(std::unique_ptr<Window> window) {
  if (window) {
    window->profile.settle();
    planned_factor_ = factor_;
  }
  return window;
}

/// From rest to rest on a part of what is known: there, slowing down always helps.
void LookAhead::solve_to_rest() {
  ++refused_;
  Stretch stretch = next_stretch();
  stretch.ends_at_rest = true;
  for (int halving = 0; halving < 40 && !window_; ++halving) {
    window_ = settled(solve(stretch, Aim::fastest));
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
    if (static_cast<double>(window_->profile.intervals()) < few * static_cast<double>(most_intervals())) reach_ *= 1.5;
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
  PathState here = state_at(window.profile, k, 0);
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
  chunk.pieces.reserve(last_piece + 1 - first_piece);
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

}  // namespace leadscrew::planner
