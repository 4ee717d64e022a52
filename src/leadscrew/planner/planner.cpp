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

}  // namespace

void Planner::push(const toolpath::Element& element) {
  if (const auto* event = std::get_if<base::Event>(&element)) {
    events_.push_back(*event);
    line_ = event->line;
    return;
  }
  Chunk& chunk = begin_chunk();
  if (const auto* piece = std::get_if<toolpath::Piece>(&element)) {
    chunk.length = geometry::length(piece->curve);
    chunk.pieces.push_back(*piece);
    lay_out(plan_piece(*piece, machine_), chunk.length, chunk);
    position_ = geometry::end(piece->curve);
    line_ = piece->line;
  } else {
    const auto& dwell = std::get<toolpath::Dwell>(element);
    Segment standing;
    standing.duration = dwell.seconds;
    standing.state = MotionState::rest;
    chunk.segments.push_back(standing);
    chunk.duration = dwell.seconds;
    position_ = dwell.position;
    line_ = dwell.line;
  }
  chunk.rest = position_;
  chunk.rest_line = line_;
}

void Planner::finish() {
  if (events_.empty()) return;
  Chunk& chunk = begin_chunk();
  chunk.rest = position_;
  chunk.rest_line = line_;
}

std::optional<Chunk> Planner::pop() {
  if (settled_.empty()) return std::nullopt;
  std::optional<Chunk> chunk(std::move(settled_.front()));
  settled_.pop_front();
  return chunk;
}

Chunk& Planner::begin_chunk() {
  Chunk& chunk = settled_.emplace_back();
  chunk.events = std::move(events_);
  events_.clear();
  return chunk;
}

}  // namespace leadscrew::planner
