#include <algorithm>
#include <cmath>
#include <leadscrew/planner/planner.hpp>
#include <limits>
#include <utility>

namespace leadscrew::planner {

namespace {

using numeric::DoubleDouble;

constexpr double negligible_length = 1e-9;  // in the units of path length: below it is rounding

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
      events_.push_back(*event);
      line_ = event->line;
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
      return true;
    }
    pass_events(*piece, distance_left);
    travelling_.begin_at(start_->path_length, start_->events);
    start_.reset();
    started_at_ = piece->axes().position(std::max(distance_left, 0.0));
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
  using Kind = base::Event::Kind;
  const auto group = [](Kind kind) {
    switch (kind) {
      case Kind::spindle_stop:
      case Kind::spindle_clockwise:
      case Kind::spindle_counterclockwise:
        return 1;
      case Kind::spindle_speed:
        return 2;
      case Kind::coolant_mist:
        return 3;
      case Kind::coolant_flood:
        return 4;
      case Kind::coolant_off:
        return 5;
      case Kind::tool_prepare:
        return 6;
      case Kind::tool_change:
        return 7;
      case Kind::digital_output_on_with_motion:
      case Kind::digital_output_off_with_motion:
      case Kind::digital_output_on:
      case Kind::digital_output_off:
        return 8;
      case Kind::analog_output_with_motion:
      case Kind::analog_output:
        return 9;
      case Kind::programmed_feed:
        return 10;
      case Kind::pause:
      case Kind::optional_pause:
      case Kind::pallet_pause:
      case Kind::program_end:
      case Kind::spindle_in_step:
      case Kind::rigid_tap:
        return 0;
    }
    return 0;
  };
  if (group(event.kind) == 0) return;
  std::erase_if(events_, [&](const base::Event& before) {
    const bool is_coolant = before.kind == Kind::coolant_mist || before.kind == Kind::coolant_flood;
    const bool is_alike = group(before.kind) == group(event.kind) && before.output == event.output;
    return is_alike || (event.kind == Kind::coolant_off && is_coolant);
  });
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
    chunk = closed_form_->next(slice_);
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
  look_ahead_.slice(seconds);
}

void Planner::override_feed(double factor) {
  feed_factor_ = factor;
  look_ahead_.override_feed(factor);
}

void Planner::refuse() {
  position_ = rest_before_;
  line_ = line_before_;
  travelling_.refuse();
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
  chunk.rest = position_;
  chunk.rest_line = line_;
  return chunk;
}

}  // namespace leadscrew::planner
