#include <cmath>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/interpolator/tick_time.hpp>

namespace leadscrew::interpolator {

using numeric::DoubleDouble;

namespace {

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

Interpolator::Interpolator(base::Period period, const base::AxisVector& position, double path_length, base::Line line)
    : period_(period),
      ticks_per_second_(1e9 / static_cast<double>(period.nanoseconds)),
      length_before_end_(path_length),
      rest_(position),
      line_(line) {}

void Interpolator::load(const planner::Chunk& chunk) {
  if (!chunk.pieces.empty()) {
    const double s = chunk.first_state().s;
    constexpr double negligible_length = 1e-9;  // in the units of path length: below it is rounding
    const bool is_new_piece = !on_piece_ || s < end_on_piece_ - negligible_length || s <= negligible_length;
    first_number_ = last_number_ + (is_new_piece ? 1 : 0) - chunk.segments.front().piece;
    last_number_ = first_number_ + chunk.segments.back().piece;
    on_piece_ = true;
    length_before_ = is_new_piece ? length_before_end_ + end_on_piece_ - s : length_before_end_;
  }
  const bool goes_on = DoubleDouble(0) < chunk.begin;
  if (waited_) {
    begin_ = now_ - chunk.begin;
  } else if (!goes_on) {
    begin_ = end_;
  }
  waited_ = false;
  in_tail_ = false;
  passed_ = 0;
  chunk_ = &chunk;
  begin_part(chunk.segments, begin_ + chunk.end());
  rest_ = chunk.rest;
  line_ = chunk.rest_line;
  turned_ = 0;
  if (spindle_ && chunk.in_step) begin_thread();
}

void Interpolator::run_stop_tail() {
  if (!has_stop_tail_left()) return;
  const planner::Segment& last = chunk_->stop_tail.back();
  in_tail_ = true;
  last_number_ = first_number_ + last.piece;
  length_before_ = length_before_end_;
  const std::size_t from = chunk_->segments.back().piece, to = chunk_->stop_tail.front().piece;
  if (from != to) length_before_ += chunk_->pieces[from].axes().length();
  begin_part(chunk_->stop_tail, begin_ + (last.begin + last.duration));
}

/// Goes on through contiguous segments to their end.
void Interpolator::begin_part(std::span<const planner::Segment> segments, DoubleDouble end) {
  end_ = end;
  segments_ = segments;
  segment_ = 0;
  if (segments.empty()) return;
  segment_begin_ = begin_ + segments.front().begin;
  segment_end_ = segments.size() > 1 ? begin_ + segments[1].begin : end_;
  const planner::Segment& last = segments.back();
  if (last.state == base::MotionState::rest) return;  // on the piece before
  length_before_end_ = length_before_;
  for (std::size_t piece = segments.front().piece; piece < last.piece; ++piece) {
    length_before_end_ += chunk_->pieces[piece].axes().length();
  }
  const double length = chunk_->pieces[last.piece].axes().length();
  constexpr double negligible_length = 1e-9;
  const double s = planner::evaluate(last, (end_ - begin_ - last.begin).value()).s;
  end_on_piece_ = s > length - negligible_length ? length : s;
}

base::Word Interpolator::next() {
  if (thread_) return next_in_step();
  const base::Word word = next_word();
  if (spindle_) turn_spindle(time_of(word.tick, period_));
  return word;
}

base::Word Interpolator::next_word() {
  if (wants_chunk()) run_stop_tail();
  const DoubleDouble now = now_;
  const bool has_ended = wants_chunk();
  base::Word word;
  word.tick = tick_;
  word.line = line_;
  tick_ = base::next(tick_);
  now_ = time_of(tick_, period_);
  if (has_ended) {
    waited_ = true;
    passed_ = events_of_part();
    word.position = rest_;
    word.path_length = length_before_end_ + end_on_piece_;
    return word;
  }
  const planner::Segment& segment = segment_at(now);
  word.state = segment.state;
  if (segment.state == base::MotionState::rest) {
    pass_events(0, 0);
    word.position = rest_;
    word.path_length = length_before_end_ + end_on_piece_;
    return word;
  }
  const auto [s, speed] = along(segment, now - segment_begin_);
  const toolpath::Piece& piece = chunk_->pieces[segment.piece];
  word.position = position(piece, segment.piece, s);
  word.path_length = length_before_ + s.value();
  word.speed = word.feed = speed;
  if (piece.feed_axes != toolpath::FeedAxes::none) {
    word.feed *= piece.feed_rate(s.value());
  }
  word.line = piece.line_at(s.value());
  pass_events(segment.piece, s.value());
  return word;
}

std::optional<Interpolator::OnPath> Interpolator::on_path() {
  if (wants_chunk()) return std::nullopt;
  const planner::Segment& segment = segment_at(now_);
  if (segment.state == base::MotionState::rest) return std::nullopt;
  return OnPath{chunk_->pieces[segment.piece], planner::evaluate(segment, (now_ - segment_begin_).value())};
}

/// Those that lie before a place of the chunk, or there: found by halving, as there may be many.
void Interpolator::pass_events(std::size_t piece, double s) {
  std::size_t end = events_of_part();
  while (passed_ < end) {
    const std::size_t middle = passed_ + (end - passed_) / 2;
    const planner::PlacedEvent& event = chunk_->event(middle);
    const bool is_passed = event.piece < piece || (event.piece == piece && event.s <= s);
    (is_passed ? passed_ : end) = is_passed ? middle + 1 : middle;
  }
}

base::AxisVector Interpolator::position(const toolpath::Piece& piece, std::size_t index, DoubleDouble s) {
  const toolpath::AxisPath axes = piece.axes();
  const geometry::Nurbs* nurbs = axes.nurbs();
  if (rule_ == StepRule::arc_length || !nurbs) return axes.position(s);
  const std::int64_t number = first_number_ + static_cast<std::int64_t>(index);
  if (stepped_number_ != number) {
    stepped_number_ = number;
    parameter_ = nurbs->first_parameter();
    stepped_ = 0;
  }
  parameter_ = next_parameter(*nurbs, rule_, parameter_, stepped_, s.value() - stepped_);
  stepped_ = s.value();
  return axes.position_at_parameter(parameter_);
}

const planner::Segment& Interpolator::segment_at(DoubleDouble time) {
  while (segment_end_ <= time && segment_ + 1 < segments_.size()) {
    const std::size_t piece = segments_[segment_++].piece;
    if (segments_[segment_].piece != piece) length_before_ += chunk_->pieces[piece].axes().length();
    segment_begin_ = segment_end_;
    segment_end_ = segment_ + 1 < segments_.size() ? begin_ + segments_[segment_ + 1].begin : end_;
  }
  return segments_[segment_];
}

}  // namespace leadscrew::interpolator
