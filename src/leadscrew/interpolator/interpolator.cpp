#include <cmath>
#include <leadscrew/interpolator/interpolator.hpp>

namespace leadscrew::interpolator {

using numeric::DoubleDouble;

namespace {

constexpr DoubleDouble nanosecond = DoubleDouble(1) / DoubleDouble(1e9);

/// n·T to the precision of a double-double, for any run shorter than 104 days: n·T in nanoseconds is exact.
DoubleDouble time_of(base::Tick tick, base::Period period) {
  return nanosecond * static_cast<double>(base::count(tick) * period.nanoseconds);
}

DoubleDouble path_length(const planner::Segment& segment, DoubleDouble tau) {
  DoubleDouble s = segment.c3;
  if (segment.c5 != 0 || segment.c4 != 0) s = (tau * segment.c5 + segment.c4) * tau + segment.c3;
  if (s.hi == 0 && segment.c2 == 0) return segment.v0 * tau + segment.s0;
  s = s * tau + segment.c2;
  s = s * tau + segment.v0;
  return s * tau + segment.s0;
}

}  // namespace

Interpolator::Interpolator(base::Period period, const base::AxisVector& position) : period_(period), rest_(position) {}

bool Interpolator::wants_chunk() const {
  return !(now_ < end_);
}

void Interpolator::load(const planner::Chunk& chunk) {
  length_before_ = length_after_;
  length_after_ += chunk.length;
  begin_ = end_;
  end_ = begin_ + chunk.duration;
  chunk_ = &chunk;
  segment_ = 0;
  rest_ = chunk.rest;
  line_ = chunk.rest_line;
}

base::Word Interpolator::next() {
  const DoubleDouble now = now_;
  base::Word word;
  word.tick = tick_;
  word.line = line_;
  tick_ = base::next(tick_);
  now_ = time_of(tick_, period_);
  if (!chunk_ || !(now < end_)) {
    word.position = rest_;
    word.path_length = length_after_;
    return word;
  }
  const planner::Segment& segment = segment_at(now - begin_);
  word.state = segment.state;
  word.path_length = length_before_;
  if (segment.state == base::MotionState::rest) {
    word.position = rest_;
    return word;
  }
  const DoubleDouble tau = now - begin_ - segment.begin;
  const DoubleDouble s = path_length(segment, tau);
  const toolpath::Piece& piece = chunk_->pieces[segment.piece];
  word.position = geometry::evaluate(piece.curve, s);
  word.path_length += s.value();
  word.feed = planner::evaluate(segment, tau.value()).speed;
  word.line = piece.line;
  return word;
}

const planner::Segment& Interpolator::segment_at(DoubleDouble time) {
  const auto& segments = chunk_->segments;
  while (segment_ + 1 < segments.size() && segments[segment_ + 1].begin <= time) ++segment_;
  return segments[segment_];
}

}  // namespace leadscrew::interpolator
