#include <algorithm>
#include <cmath>
#include <leadscrew/planner/planner.hpp>
#include <utility>

namespace leadscrew::planner {

std::optional<Chunk> Planner::pop() {
  if (closed_form_ && closed_form_->is_done()) go_on_from(closed_form_->rest());
  for (;;) {
    if (last_) {
      if (std::optional<Chunk> chunk = plan()) return chunk;
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
    const auto& dwell = std::get<toolpath::Dwell>(element);
    Segment standing;
    standing.duration = dwell.seconds;
    standing.state = base::MotionState::rest;
    position_ = dwell.position;
    line_ = dwell.line;
    waiting_.pop_front();
    Chunk chunk;
    chunk.duration = standing.duration;
    chunk.segments.push_back(standing);
    return follow_events(std::move(chunk));
  }
}

/// Does the piece go on with the section? Otherwise the section ends before it.
bool Planner::take(const toolpath::Piece& piece) {
  if (last_) {
    const geometry::PointJet leaving = geometry::jets(last_->curve, geometry::length(last_->curve));
    const geometry::PointJet entering = geometry::jets(piece.curve, 0);
    const double square = std::min(greatest_square(leaving, last_->greatest_speed(leaving), machine_),
                                   squared(piece.greatest_speed(entering)));
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
    if (look_ahead_.is_closed() && feed_factor_ > 0) closed_form_ = ClosedForm::plan(section, machine_, feed_factor_);
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
  if (closed_form_) return go_on_from(closed_form_->rest_before());
  look_ahead_.refuse();
}

Chunk Planner::follow_events(Chunk chunk) {
  chunk.events = std::move(events_);
  events_.clear();
  chunk.rest = position_;
  chunk.rest_line = line_;
  return chunk;
}

}  // namespace leadscrew::planner
