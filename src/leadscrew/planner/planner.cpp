#include <algorithm>
#include <cmath>
#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>
#include <limits>
#include <utility>

namespace leadscrew::planner {

namespace {

using numeric::DoubleDouble;

constexpr double negligible_length = 1e-9;  // in the units of path length: below it is rounding

/// What an event leaves behind that a later one of the same undoes.
enum class Effect : std::uint8_t {
  none,
  spindle,
  spindle_speed,
  mist,
  flood,
  coolant_off,
  tool_prepared,
  tool,
  turret,
  digital_output,
  analog_output,
  programmed_feed,
  tool_offset,
  tip_control,
  overrides,
  feed_override,
  spindle_override,
  adaptive_feed,
  feed_hold,
  in_step,
  feed_per_revolution,
};

Effect effect_of(base::Event::Kind kind) {
  using Kind = base::Event::Kind;
  switch (kind) {
    case Kind::spindle_stop:
    case Kind::spindle_clockwise:
    case Kind::spindle_counterclockwise:
    case Kind::spindle_orientation:
      return Effect::spindle;
    case Kind::spindle_speed:
      return Effect::spindle_speed;
    case Kind::coolant_mist:
      return Effect::mist;
    case Kind::coolant_flood:
      return Effect::flood;
    case Kind::coolant_off:
      return Effect::coolant_off;
    case Kind::tool_prepare:
      return Effect::tool_prepared;
    case Kind::tool_change:
      return Effect::tool;
    case Kind::turret_indexing:
      return Effect::turret;
    case Kind::digital_output_on_with_motion:
    case Kind::digital_output_off_with_motion:
    case Kind::digital_output_on:
    case Kind::digital_output_off:
      return Effect::digital_output;
    case Kind::analog_output_with_motion:
    case Kind::analog_output:
      return Effect::analog_output;
    case Kind::programmed_feed:
      return Effect::programmed_feed;
    case Kind::tool_offset:
      return Effect::tool_offset;
    case Kind::tip_control:
      return Effect::tip_control;
    case Kind::overrides_on:
    case Kind::overrides_off:
      return Effect::overrides;
    case Kind::feed_override:
      return Effect::feed_override;
    case Kind::spindle_override:
      return Effect::spindle_override;
    case Kind::adaptive_feed:
      return Effect::adaptive_feed;
    case Kind::feed_hold:
      return Effect::feed_hold;
    case Kind::spindle_in_step:
    case Kind::rigid_tap:
      return Effect::in_step;
    case Kind::feed_per_revolution:
      return Effect::feed_per_revolution;
    default:
      return Effect::none;
  }
}

bool undoes(const base::Event& event, const base::Event& before) {
  const Effect now = effect_of(event.kind), then = effect_of(before.kind);
  if (now == Effect::coolant_off && (then == Effect::mist || then == Effect::flood)) return true;
  if (now == Effect::overrides && (then == Effect::feed_override || then == Effect::spindle_override)) return true;
  const bool is_of_output = now == Effect::digital_output || now == Effect::analog_output || now == Effect::tool_offset;
  return now == then && (!is_of_output || event.output == before.output);
}

/// From there on a hold would wait.
bool begins_in_step(const base::Event& event) {
  AllowedOverrides behind;
  behind.pass(event);
  return behind.in_step;
}

}  // namespace

std::optional<Chunk> Planner::pop() {
  if (is_stopped() || has_failed()) return std::nullopt;
  if (closed_form_ && closed_form_->is_done()) go_on_from(closed_form_->rest());
  for (;;) {
    if (last_) {
      if (std::optional<Chunk> chunk = plan()) return chunk;
      if (is_stopped() || has_failed()) return std::nullopt;
      if (look_ahead_.is_done()) {
        look_ahead_.clear();
        last_.reset();
      } else if (look_ahead_.is_closed()) {
        return std::nullopt;  // held
      }
    }
    if (waiting_.empty()) {
      if (!finished_) return std::nullopt;
      if (last_) {
        look_ahead_.close();
        continue;
      }
      if (events_.empty()) return std::nullopt;
      return follow_events({});
    }
    const toolpath::Element& element = waiting_.front();
    if (start_ && pass_over(element)) {
      waiting_.pop_front();
      continue;
    }
    if (const auto* piece = std::get_if<toolpath::Piece>(&element)) {
      if (take(*piece)) waiting_.pop_front();
      continue;
    }
    if (last_) {
      look_ahead_.close();
      continue;
    }
    if (const auto* event = std::get_if<base::Event>(&element)) {
      if (feed_factor_ == 0 && begins_in_step(*event)) return std::nullopt;  // held
      rest_for(*event);
      waiting_.pop_front();
      continue;
    }
    if (feed_factor_ == 0) return std::nullopt;  // held
    Chunk chunk = stand(std::get<toolpath::Dwell>(element));
    if (dwelt_ == 0) waiting_.pop_front();
    return follow_events(std::move(chunk));
  }
}

/// The next slice of a dwell.
Chunk Planner::stand(const toolpath::Dwell& dwell) {
  position_ = dwell.position;
  line_ = dwell.line;
  const double left = dwell.seconds - dwelt_;
  const bool is_last = left <= slice_;
  Chunk chunk;
  chunk.begin = dwelt_;
  chunk.duration = is_last ? left : slice_;
  Segment& standing = chunk.segments.emplace_back();
  standing.state = base::MotionState::rest;
  // The last ends where the whole would, to the last bit.
  standing.begin = is_last ? DoubleDouble() : chunk.begin;
  standing.duration = is_last ? DoubleDouble(dwell.seconds) : chunk.duration;
  dwelt_ = is_last ? 0 : dwelt_ + slice_;
  return chunk;
}

void Planner::start_at(double path_length, base::Line line) {
  started_at_.reset();
  if (path_length > 0 || base::number(line) > 0) {
    start_ = Start{path_length, line};
  } else {
    started_at_ = position_;
  }
}

std::optional<geometry::Point> Planner::started_at() const {
  const bool is_at_end = start_ && start_->path_length - start_->passed <= negligible_length;
  return is_at_end ? position_ : started_at_;
}

/// Does the element lie before the place where motion begins? The piece on which it lies is taken here.
bool Planner::pass_over(const toolpath::Element& element) {
  const double distance_left = start_->path_length - start_->passed;
  if (const auto* piece = std::get_if<toolpath::Piece>(&element)) {
    const double length = piece->axes().length();
    position_ = piece->axes().end();
    line_ = piece->last_line();
    start_->passed += length;
    if (length <= distance_left + negligible_length) {
      pass_events(*piece, std::numeric_limits<double>::infinity());
      pass_turns(*piece);
      return true;
    }
    pass_events(*piece, distance_left);
    travelling_.begin_at(start_->path_length, start_->events);
    start_.reset();
    started_at_ = piece->axes().position(std::max(distance_left, 0.0));
    start_in_step(distance_left <= negligible_length ? 0 : distance_left);
    if (distance_left <= negligible_length) return false;
    position_ = piece->axes().position(distance_left);
    take(*piece);
    look_ahead_.begin_at(distance_left);
    return true;
  }
  const auto* event = std::get_if<base::Event>(&element);
  const base::Line line = event ? event->line : std::get<toolpath::Dwell>(element).line;
  if (distance_left <= negligible_length && !base::is_before(line, start_->line)) return false;
  if (event) keep_in_force(*event);
  return true;
}

/// Those before a place on a piece where motion begins, and those there whose lines lie before its line.
void Planner::pass_events(const toolpath::Piece& piece, double s) {
  if (!piece.events) return;
  for (const toolpath::EventMark& mark : *piece.events) {
    const bool is_there = std::abs(mark.s - s) <= negligible_length;
    if (is_there ? !base::is_before(mark.event.line, start_->line) : mark.s > s) return;
    keep_in_force(mark.event);
    start_->events = mark.number + 1;
  }
}

/// Of events that undo one another, the last.
void Planner::keep_in_force(const base::Event& event) {
  take_lead(event);
  travelling_.rest_for(event);
  take_factor();
  const Effect effect = effect_of(event.kind);
  if (effect == Effect::none) return;
  std::erase_if(events_, [&](const base::Event& before) { return undoes(event, before); });
  if (effect == Effect::in_step && event.value == 0) return;
  events_.push_back(event);
}

/// Does the piece go on with the section? Otherwise the section ends before it.
bool Planner::take(const toolpath::Piece& piece) {
  if (last_) {
    const double end = last_->axes().length();
    const geometry::PointJet leaving = last_->axes().jets(end);
    const geometry::PointJet entering = piece.axes().jets(0);
    const double square = std::min(
        constraints_.greatest_square({leaving, last_->greatest_speed(end, leaving), chords_of(*last_, end, leaving)}),
        squared(piece.greatest_speed(0, entering)));
    if (last_->stop || !runs_through(leaving, entering, std::sqrt(square), machine_)) {
      look_ahead_.close();
      return false;
    }
  }
  pass_turns(piece);
  look_ahead_.append(piece);
  last_ = piece;
  return true;
}

/// A section of one piece waits for what follows it: it may have a closed form.
std::optional<Chunk> Planner::plan() {
  if (look_ahead_.is_untouched() && !closed_form_) {
    const Section& section = look_ahead_.section();
    if (section.size() == 1 && !look_ahead_.is_closed()) return std::nullopt;
    if (look_ahead_.is_closed() && feed_factor_ > 0)
      closed_form_ = ClosedForm::plan(section, constraints_, feed_factor_);
  }
  std::optional<Chunk> chunk;
  if (closed_form_) {
    closed_form_->override_feed(feed_factor_);
    const std::optional<Chunk::InStep> step = in_step();
    chunk = closed_form_->next(step ? std::numeric_limits<double>::infinity() : slice_in_force());
    if (step) chunk->in_step = step;
  } else {
    chunk = look_ahead_.plan();
  }
  if (!chunk) return std::nullopt;
  rest_before_ = position_;
  line_before_ = line_;
  position_ = chunk->rest;
  line_ = chunk->rest_line;
  return follow_events(std::move(*chunk));
}

/// The closed form has ended: at the section's end, or at rest on the way, from where windows go on.
void Planner::go_on_from(double s) {
  closed_form_.reset();
  if (s < look_ahead_.section().length()) return look_ahead_.begin_at(s);
  look_ahead_.clear();
  last_.reset();
}

void Planner::slice(double seconds) {
  slice_ = seconds;
  look_ahead_.slice(slice_in_force());
}

void Planner::override_feed(double factor) {
  asked_.hold = factor == 0;
  if (!asked_.hold) asked_.feed = factor;
  take_factor();
}

void Planner::adapt_feed(double factor) {
  asked_.adaptive = factor;
  take_factor();
}

void Planner::come_to_rest() {
  asked_.must_rest = true;
  take_factor();
}

/// What is asked for, as far as the events allow that motion has passed by the end of the last chunk.
void Planner::take_factor() {
  look_ahead_.slice(slice_in_force());
  take_spindle();
  const double factor = asked_.factor(travelling_.overrides(), feed_factor_);
  if (factor == feed_factor_) return;
  feed_factor_ = factor;
  look_ahead_.override_feed(factor);
}

/// Motion rests for an event, which comes before the next chunk.
void Planner::rest_for(const base::Event& event) {
  events_.push_back(event);
  take_lead(event);
  line_ = event.line;
  travelling_.rest_for(event);
  take_factor();
}

void Planner::refuse() {
  position_ = rest_before_;
  line_ = line_before_;
  travelling_.refuse();
  take_factor();
  if (closed_form_) return go_on_from(closed_form_->rest_before());
  look_ahead_.refuse();
}

void Planner::forget_rest() {
  waiting_.clear();
  last_.reset();
  closed_form_.reset();
  look_ahead_.clear();
  dwelt_ = 0;
  travelling_.forget_rest();
}

Chunk Planner::follow_events(Chunk chunk) {
  travelling_.place(chunk, std::exchange(events_, {}));
  take_factor();
  chunk.rest = position_;
  chunk.rest_line = line_;
  return chunk;
}

}  // namespace leadscrew::planner
