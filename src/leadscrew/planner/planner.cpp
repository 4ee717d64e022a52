#include <cmath>
#include <leadscrew/planner/optimal_motion.hpp>
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

double squared(double v) {
  return v * v;
}

/// Is the closed form as good as the optimum? On a line it is the optimum; on an arc through so small an angle, the
/// axes' limits along the path hardly change.
bool has_closed_form(const Section& section) {
  if (section.size() != 1) return false;
  const geometry::Curve& curve = section.piece(0).curve;
  if (std::holds_alternative<geometry::Line>(curve)) return true;
  const auto* arc = std::get_if<geometry::Arc>(&curve);
  constexpr double small_angle = 0.02;  // rad
  return arc && std::abs(arc->angle_rate()) * arc->length() < small_angle;
}

}  // namespace

void Planner::push(const toolpath::Element& element) {
  if (const auto* piece = std::get_if<toolpath::Piece>(&element)) {
    push_piece(*piece);
    return;
  }
  settle_section();
  if (const auto* event = std::get_if<base::Event>(&element)) {
    events_.push_back(*event);
    line_ = event->line;
    return;
  }
  const auto& dwell = std::get<toolpath::Dwell>(element);
  Segment standing;
  standing.duration = dwell.seconds;
  standing.state = MotionState::rest;
  position_ = dwell.position;
  line_ = dwell.line;
  Chunk& chunk = begin_chunk();
  chunk.segments.push_back(standing);
  chunk.duration = dwell.seconds;
}

void Planner::push_piece(const toolpath::Piece& piece) {
  if (!section_.empty()) {
    const toolpath::Piece& last = section_.piece(section_.size() - 1);
    const geometry::PointJet leaving = geometry::jets(last.curve, geometry::length(last.curve));
    const geometry::PointJet entering = geometry::jets(piece.curve, 0);
    const double square = std::min(section_.greatest_square(section_.length(), Side::left, leaving, machine_),
                                   squared(std::min(piece.feed, last.feed)));
    const bool through =
        !last.stop && section_.size() < longest_section && runs_through(leaving, entering, std::sqrt(square), machine_);
    if (!through) settle_section();
  }
  section_.append(piece);
}

void Planner::settle_section() {
  if (section_.empty()) return;
  const toolpath::Piece& last = section_.piece(section_.size() - 1);
  position_ = geometry::end(last.curve);
  line_ = last.line;
  Chunk& chunk = begin_chunk();
  chunk.pieces = section_.pieces();
  for (const toolpath::Piece& piece : chunk.pieces) chunk.length += geometry::length(piece.curve);
  if (has_closed_form(section_)) {
    lay_out(plan_piece(last, machine_), chunk.length, chunk);
  } else {
    chunk.segments = plan_section(section_, machine_);
    const Segment& end = chunk.segments.back();
    chunk.duration = end.begin + end.duration;
  }
  section_.clear();
}

void Planner::finish() {
  settle_section();
  if (!events_.empty()) begin_chunk();
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
  chunk.rest = position_;
  chunk.rest_line = line_;
  return chunk;
}

}  // namespace leadscrew::planner
