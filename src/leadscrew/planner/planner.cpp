#include <algorithm>
#include <cmath>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using numeric::DoubleDouble;

/// Lays phases of constant jerk end to end, in double-double.
class Phases {
 public:
  void add(double jerk, double duration, MotionState state) {
    if (duration <= 0) return;
    Segment segment;
    segment.begin = begin_;
    segment.duration = duration;
    segment.s0 = s_;
    segment.v0 = v_;
    segment.c2 = acceleration_ / 2;
    segment.c3 = jerk / 6;
    segment.state = state;
    const DoubleDouble c2 = segment.c2, c3 = segment.c3;
    s_ = s_ + (v_ + (c2 + c3 * duration) * duration) * duration;
    v_ = v_ + (c2 * 2.0 + c3 * 3.0 * duration) * duration;
    acceleration_ += jerk * duration;
    begin_ = begin_ + duration;
    segments_.push_back(segment);
  }
  /// The acceleration that a phase ends with is known; rounding must not leave some of it to the next.
  void acceleration_is(double acceleration) { acceleration_ = acceleration; }

  DoubleDouble duration() const { return begin_; }

  /// Rounding has left the way a few units in the last place off the length: spread that evenly over time. The speed
  /// that this takes goes to the lesser part of v0, so that a motion from rest is seen to begin at speed 0.
  std::vector<Segment> take(double length) {
    const DoubleDouble defect_rate = (DoubleDouble(length) - s_) / begin_;
    for (Segment& segment : segments_) {
      segment.s0 = segment.s0 + defect_rate * segment.begin;
      segment.v0.lo += defect_rate.value();
    }
    return std::move(segments_);
  }

 private:
  std::vector<Segment> segments_;
  DoubleDouble begin_, s_, v_;
  double acceleration_ = 0;
};

void lay_out(const RestToRest& motion, double length, Chunk& chunk) {
  const double peak = motion.peak_acceleration(), jerk = motion.jerk;
  Phases phases;
  phases.add(jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(peak);
  phases.add(0, motion.acceleration_time, MotionState::changing);
  phases.add(-jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(0);
  phases.add(0, motion.cruise_time, MotionState::constant);
  phases.add(-jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(-peak);
  phases.add(0, motion.acceleration_time, MotionState::changing);
  phases.add(jerk, motion.jerk_time, MotionState::changing);
  chunk.duration = phases.duration();
  chunk.segments = phases.take(length);
}

/// Is the closed form as good as the optimum? On a line it is the optimum; on an arc through so small an angle, the
/// axes' limits along the path hardly change.
bool has_closed_form(const Section& section) {
  const auto is_line = [&](const toolpath::Piece& piece) {
    // Where feed is counted by some axes only, lines may differ in how fast it lets them be travelled.
    const bool is_alike = piece.feed == section.piece(0).feed && piece.feed_axes == toolpath::FeedAxes::none;
    return std::holds_alternative<geometry::Line>(piece.curve) && (is_alike || section.size() == 1);
  };
  if (std::all_of(section.pieces().begin(), section.pieces().end(), is_line)) return true;
  const auto* arc = std::get_if<geometry::Arc>(&section.piece(0).curve);
  constexpr double small_angle = 0.02;  // rad
  return section.size() == 1 && arc && std::abs(arc->angle_rate()) * arc->length() < small_angle;
}

/// The section as one piece.
toolpath::Piece whole(const Section& section) {
  toolpath::Piece piece = section.piece(0);
  if (section.size() == 1) return piece;
  piece.curve = geometry::Line(geometry::start(piece.curve), geometry::end(section.piece(section.size() - 1).curve),
                               section.length());
  return piece;
}

double greatest(const LimitRatios& ratios) {
  double greatest = 0;
  for (const AxisRatios& axis : ratios) greatest = std::max({greatest, axis.velocity, axis.acceleration, axis.jerk});
  return greatest;
}

}  // namespace

std::optional<Chunk> Planner::pop() {
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
    standing.state = MotionState::rest;
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
  if (look_ahead_.is_untouched()) {
    const Section& section = look_ahead_.section();
    if (section.size() == 1 && !look_ahead_.is_closed()) return std::nullopt;
    if (look_ahead_.is_closed() && has_closed_form(section) && feed_factor_ > 0) {
      if (std::optional<Chunk> chunk = closed_form()) return follow_events(std::move(*chunk));
    }
  }
  std::optional<Chunk> chunk = look_ahead_.plan();
  if (!chunk) return std::nullopt;
  rest_before_ = position_;
  line_before_ = line_;
  position_ = chunk->rest;
  line_ = chunk->rest_line;
  return follow_events(std::move(*chunk));
}

/// Unless it would commit to too much, or lines that are nearly one are not one.
std::optional<Chunk> Planner::closed_form() {
  const Section& section = look_ahead_.section();
  Chunk chunk;
  chunk.pieces.assign(section.pieces().begin(), section.pieces().end());
  chunk.length = section.length();
  toolpath::Piece overridden = whole(section);
  overridden.feed *= feed_factor_;
  lay_out(plan_piece(overridden, machine_), chunk.length, chunk);
  if (chunk.duration.value() > 2 * slice_) return std::nullopt;
  if (section.size() > 1) {
    chunk.segments = along_pieces(chunk.segments, section, section.length(), 0);
    LimitRatios ratios{};
    raise_limit_ratios(chunk, machine_, ratios);
    if (greatest(ratios) > 1 + 1e-10) return std::nullopt;
  }
  position_ = geometry::end(last_->curve);
  line_ = last_->last_line();
  look_ahead_.clear();
  last_.reset();
  return chunk;
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
