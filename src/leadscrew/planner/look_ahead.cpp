#include <algorithm>
#include <cmath>
#include <leadscrew/planner/early_stop.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/look_ahead.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using numeric::DoubleDouble;

using namespace tuning::look_ahead;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

void LookAhead::append(const toolpath::Piece& piece) {
  section_.append(piece);
  is_of_least_time_ = is_of_least_time_ || piece.is_of_least_time;
  const double length = piece.axes().length();
  for (const double s : {0.0, length / 2}) {
    const geometry::PointJet jet = piece.axes().jets(s);
    const machine::Derivatives limits = tangent_limits(jet, constraints_);
    const double speed = constraints_.greatest_speed({jet, piece.greatest_speed(s, jet)}, hardly_moves);
    for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
      if (std::abs(jet[axis].first) > 1e-12) moving_.set(axis);
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
  is_of_least_time_ = false;
  gentle_.reset();
  lowerings_ = 0;
  least_balance_ = 0;
}

std::size_t LookAhead::most_intervals() const {
  return std::clamp(rows_of_a_window / std::max(moving_.count(), std::size_t{1}), least_intervals, greatest_intervals);
}

void LookAhead::override_feed(double factor) {
  if (factor == factor_) return;
  factor_ = factor;
  if (window_) window_->unchanged_until = window_->next;
}

void LookAhead::refuse() {
  effort_.give_back();
  stand_at(last_tail_end_);
  tail_end_ = last_tail_end_;
}

void LookAhead::begin_at(double s) {
  untouched_ = false;
  stand_at(s);
  last_begin_ = tail_end_ = last_tail_end_ = s;
}

void LookAhead::stand_at(double s) {
  begin_ = s;
  window_.reset();
  continuation_.reset();
}

bool LookAhead::knows_enough() const {
  return closed_ || section_.length() - begin_ >= reach_ || section_.size() >= most_pieces;
}

PlannedRange LookAhead::next_range() const {
  PlannedRange range;
  range.begin = begin_;
  range.end = section_.length();
  if (range.end - begin_ > 1.5 * reach_) range.end = begin_ + reach_;
  range.starts_at_rest = !continuation_;
  range.ends_at_rest = closed_ && range.end == section_.length();
  if (factor_ > 0) range.feed_factor = factor_;
  if (is_of_least_time_) range.closeness = tuning::least_time::closeness;
  if (continuation_) {
    range.kept = continuation_->s;
    range.kept_breaks = continuation_->breaks;
    range.kept_end_ramp = continuation_->end_ramp;
  }
  if (range.kept_end_ramp > 0) {
    range.end = section_.length();
    range.ends_at_rest = true;
  }
  return range;
}

/// Is enough left of the window for another motion to begin in it?
bool LookAhead::may_change() const {
  const SpeedProfile& profile = window_->profile;
  if (window_->next == 0 && profile.starts_at_rest()) return true;
  if (window_->intervals[window_->next] + least_to_change > profile.intervals()) return false;
  return !window_->to_rest || profile.ends_at_rest() || window_->next + 1 < window_->segments.size();
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
  if (!may_change()) return;
  forget();
  std::optional<Continuation> after =
      profile.continuation(window_->intervals[window_->next], window_->places[window_->next]);
  if (!after) return;
  std::unique_ptr<Window> before = std::move(window_);
  go_on_from(std::move(*after));
  effort_.begin_window();
  window_ = solve(Refinement::where_speed_changes, before.get());
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

std::unique_ptr<Window> LookAhead::solve(Refinement refinement, const Window* before) {
  PlannedRange range = next_range();
  if (continuation_ && refinement == Refinement::where_speed_changes) {
    range.changes_from = continuation_->c[0];
  }
  return remembered_or_planned(range, before);
}

std::unique_ptr<Window> LookAhead::remembered_or_planned(const PlannedRange& range, const Window* before) {
  const Aim aim = factor_ > 0 ? Aim::fastest : Aim::rest;
  const auto plan = [&] {
    return settled(plan_window(section_, limits(), range, continuation_, aim, most_intervals(), effort_, before));
  };
  if (gentle_ || effort_.of_window() > 0) return plan();
  std::optional<WindowKey> key = WindowKey::of(section_, range, aim, most_intervals());
  if (!key) return plan();
  if (const PlanMemory::Plan* known = memory_.find(*key)) {
    ++remembered_;
    effort_.spend(known->effort);
    planned_factor_ = factor_;
    return std::make_unique<Window>(known->window);
  }
  std::unique_ptr<Window> window = plan();
  if (window && effort_.goes_on()) memory_.keep(std::move(*key), *window, effort_.of_window());
  return window;
}

/// As it is kept, if there is one: planned for the factor asked for, in no more memory than it takes to read it.
std::unique_ptr<Window> LookAhead::settled(std::unique_ptr<Window> window) {
  if (window) {
    window->profile.settle();
    planned_factor_ = factor_;
    split(*window);
  }
  return window;
}

/// From rest to rest on a part of what is known: there, slowing down always helps.
void LookAhead::solve_to_rest() {
  ++refused_;
  PlannedRange range = next_range();
  range.ends_at_rest = true;
  for (int halving = 0; halving < 40 && !window_ && !effort_.is_stopped(); ++halving) {
    effort_.pay();
    effort_.begin_window();
    window_ = settled(plan_window(section_, limits(), range, continuation_, Aim::fastest, most_intervals(), effort_));
    range.end = begin_ + (range.end - begin_) / 2;
  }
  failed_ = !window_ && !effort_.is_stopped();
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
  if (section_.empty() || failed_ || effort_.is_stopped()) return std::nullopt;
  take_change();
  if (!window_) {
    if (begin_ >= section_.length() || factor_ == 0 || !knows_enough()) return std::nullopt;
    plan_from_rest();
  } else if (!window_->to_rest && window_->intervals[window_->next] >= window_->last_interval) {
    if (!knows_enough()) return std::nullopt;
    plan_in_motion();
  }
  if (!window_ || effort_.is_stopped()) return std::nullopt;
  return hand_out();
}

void LookAhead::plan_from_rest() {
  forget();
  if (untouched_) effort_.earn_section();
  if (is_overdrawn()) lower_limits();
  effort_.begin_window();
  window_ = solve(Refinement::none);
  while (!window_ && !effort_.goes_on() && lower_limits()) {
    effort_.pay();
    effort_.begin_window();
    window_ = solve(Refinement::none);
  }
  if (!window_) solve_to_rest();
  effort_.pay();
}

/// On from where the part ends that the window commits to; if that cannot be planned, to where it comes to rest.
void LookAhead::plan_in_motion() {
  if (static_cast<double>(window_->profile.intervals()) < few_share * static_cast<double>(most_intervals()))
    reach_ *= 1.5;
  forget();
  if (is_overdrawn()) {
    window_->to_rest = true;
    return;
  }
  std::unique_ptr<Window> before = std::move(window_);
  go_on_from(*before->after);
  effort_.begin_window();
  window_ = solve(Refinement::none, before.get());
  if (!window_ && effort_.goes_on()) window_ = solve(Refinement::where_speed_changes, before.get());
  effort_.pay();
  if (window_) return;
  if (effort_.goes_on()) ++refused_;
  window_ = std::move(before);
  window_->to_rest = true;
}

/// Has planning taken too much effort, also since limits were lowered last?
bool LookAhead::is_overdrawn() const {
  return effort_.balance() < least_balance_ && lowerings_ < tuning::gentle::most_lowerings;
}

/// From rest on, lower limits, whose motion takes fewer windows. False if they are as low as they get.
bool LookAhead::lower_limits() {
  if (lowerings_ == tuning::gentle::most_lowerings || effort_.is_stopped()) return false;
  if (lowerings_ == 0) ++simplified_;
  const double speed = fastest_ * std::pow(tuning::gentle::slower, -lowerings_);
  ++lowerings_;
  least_balance_ = std::min(effort_.balance(), 0.0) - tuning::gentle::between_lowerings;
  machine::Machine gentle = machine_;
  for (std::optional<machine::AxisLimits>& axis : gentle.axes) {
    if (!axis) continue;
    axis->velocity = std::min(axis->velocity, speed);
    axis->acceleration = std::min(axis->acceleration, axis->velocity / tuning::gentle::time);
    axis->jerk = std::min(axis->jerk, axis->acceleration / tuning::gentle::time);
  }
  gentle_.emplace(gentle);
  return true;
}

/// What takes long, where speed is low, is cut into parts, so that a change may begin in it. However motion is sliced:
/// the parts' polynomials are not the whole one's.
void LookAhead::split(Window& window) const {
  for (std::size_t next = 0; next < window.segments.size(); ++next) {
    if (!window.to_rest && window.intervals[next] >= window.last_interval) return;  // the tail
    if (window.segments[next].duration.value() > 1.5 * longest_segment) next += split_at(window, next);
  }
}

/// How many segments more there are now.
std::size_t LookAhead::split_at(Window& window, std::size_t next) const {
  const std::size_t k = window.intervals[next];
  const std::vector<double>& s = window.profile.knots().s;
  const Segment whole = window.segments[next];
  if (window.places[next] > 0) return 0;
  if (next + 1 == window.segments.size() || whole.s0.value() != s[k]) return 0;
  if (window.segments[next + 1].s0.value() != s[k + 1]) return 0;
  const double parts = std::min(std::ceil(whole.duration.value() / longest_segment), most_parts);
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
    if (greatest_ratios(segment, section_, limits(), feed_factor, few_looks).worst() > 1) return 0;
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
  return segments.size() - 1;
}

Chunk LookAhead::hand_out() {
  untouched_ = false;
  Window& window = *window_;
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
  Tail tail{{middle, segments.end()}, window.end};
  if (slice_ < infinity && factor_ > 0) tail = tail_of(window, after, section_, limits(), planned_factor_);
  const double rest = tail.end;
  const std::size_t last_piece = section_.piece_at(rest, Side::left);
  Chunk chunk;
  chunk.pieces.reserve(last_piece + 1 - first_piece);
  for (std::size_t p = first_piece; p <= last_piece; ++p) chunk.pieces.push_back(section_.piece(p));
  chunk.segments = along_pieces({from, middle}, section_, end, first_piece);
  chunk.stop_tail = along_pieces(tail.segments, section_, rest, first_piece);
  chunk.begin = start;
  chunk.duration = chunk.segments.back().begin + chunk.segments.back().duration - start;
  effort_.earn(chunk.duration.value());
  chunk.length = end - begin_;
  chunk.tail_length = rest - end;
  const toolpath::Piece& last = section_.piece(last_piece);
  // At the end of a piece exactly there: `rest - offset`, which has been rounded, may fall short of its length.
  const double offset = section_.offset(last_piece), length = last.axes().length();
  const double on_piece = rest >= offset + length ? length : rest - offset;
  chunk.rest = last.axes().position(on_piece);
  chunk.rest_line = last.line_at(on_piece);
  // Of the window: what is forgotten must not depend on how it is sliced.
  if (window.next == 0) last_begin_ = begin_;
  last_tail_end_ = tail_end_;
  begin_ = end;
  tail_end_ = rest;
  window.next = after;
  if (after == count) stand_at(window.end >= section_.length() ? section_.length() : window.end);
  return chunk;
}

}  // namespace leadscrew::planner
