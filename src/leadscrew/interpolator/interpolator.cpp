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

struct Along {
  DoubleDouble s;
  double speed = 0;
};

/// The polynomial of the segment at τ by Horner's rule, the rounding error of every step carried along and added at the
/// end (Graillat, Langlois, Louvet, "Compensated Horner scheme"): as good as twice the precision, for less than its
/// price.
Along along(const planner::Segment& segment, DoubleDouble tau) {
  const numeric::Split t = tau.hi;
  double value = 0, error = 0, speed = 0;
  const auto step = [&](double coefficient) {
    const DoubleDouble product = numeric::two_product(numeric::Split(value), t);
    const DoubleDouble sum = numeric::two_sum(product.hi, coefficient);
    speed = speed * t.value + value;
    error = error * t.value + (product.lo + sum.lo);
    value = sum.hi;
  };
  if (segment.c5 != 0 || segment.c4 != 0) {
    value = segment.c5;
    step(segment.c4);
    step(segment.c3);
  } else {
    value = segment.c3;
  }
  if (value != 0 || segment.c2 != 0) {
    step(segment.c2);
    step(segment.v0.hi);
  } else {
    value = segment.v0.hi;
  }
  error += segment.v0.lo;
  step(segment.s0.hi);
  error += segment.s0.lo;
  return {numeric::two_sum(value, error + tau.lo * speed), speed};
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
  stepped_curve_ = nullptr;
  segment_begin_ = begin_;
  segment_end_ = chunk.segments.size() > 1 ? begin_ + chunk.segments[1].begin : end_;
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
  const planner::Segment& segment = segment_at(now);
  word.state = segment.state;
  word.path_length = length_before_;
  if (segment.state == base::MotionState::rest) {
    word.position = rest_;
    return word;
  }
  const auto [s, speed] = along(segment, now - segment_begin_);
  const toolpath::Piece& piece = chunk_->pieces[segment.piece];
  word.position = position(piece.curve, s);
  word.path_length += s.value();
  word.feed = speed;
  word.line = piece.line;
  return word;
}

base::AxisVector Interpolator::position(const geometry::Curve& curve, DoubleDouble s) {
  const auto* nurbs = std::get_if<geometry::Nurbs>(&curve);
  if (rule_ == StepRule::arc_length || !nurbs) return geometry::evaluate(curve, s);
  if (stepped_curve_ != &curve) {
    stepped_curve_ = &curve;
    parameter_ = nurbs->first_parameter();
    stepped_ = 0;
  }
  parameter_ = next_parameter(*nurbs, rule_, parameter_, stepped_, s.value() - stepped_);
  stepped_ = s.value();
  const geometry::PointJet there = nurbs->jets_at(parameter_);
  base::AxisVector position{};
  for (std::size_t i = 0; i < position.size(); ++i) position[i] = there[i].value;
  return position;
}

const planner::Segment& Interpolator::segment_at(DoubleDouble time) {
  const auto& segments = chunk_->segments;
  while (segment_end_ <= time && segment_ + 1 < segments.size()) {
    const std::size_t piece = segments[segment_++].piece;
    if (segments[segment_].piece != piece) length_before_ += geometry::length(chunk_->pieces[piece].curve);
    segment_begin_ = segment_end_;
    segment_end_ = segment_ + 1 < segments.size() ? begin_ + segments[segment_ + 1].begin : end_;
  }
  return segments[segment_];
}

}  // namespace leadscrew::interpolator
