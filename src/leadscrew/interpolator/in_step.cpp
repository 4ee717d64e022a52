// Lines in step with the simulated spindle. How long one takes, only the spindle knows: the line is the whole chunk, and
// its end is told when motion rests there.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/interpolator/tick_time.hpp>

namespace leadscrew::interpolator {

namespace {

constexpr double longer_than_any = 1e9;  // s

using Kind = base::Event::Kind;

/// Kinds as bits: of a switch GCC makes a jump through a table, which the cycle does without.
constexpr std::uint64_t bit(Kind kind) {
  return std::uint64_t{1} << static_cast<unsigned>(kind);
}
constexpr std::uint64_t clockwise = bit(Kind::spindle_clockwise);
constexpr std::uint64_t turns = clockwise | bit(Kind::spindle_counterclockwise) | bit(Kind::spindle_speed);

}  // namespace

/// Obeys the events that have been passed, at this time: that of a word, so that it is the same wherever chunks are cut.
void Interpolator::turn_spindle(numeric::DoubleDouble time) {
  for (; turned_ < passed_; ++turned_) {
    const planner::PlacedEvent& event = chunk_->event(turned_);
    const std::uint64_t kind = bit(event.kind);
    const bool stops = base::stops_spindle(event.kind);
    if (!stops && (kind & turns) == 0) continue;
    if (kind != bit(Kind::spindle_speed)) direction_ = stops ? 0 : kind == clockwise ? 1 : -1;
    const bool is_followed = thread_ && begins_at_depth();
    spindle_->turn(direction_ == 0 ? 0 : direction_ * event.value, time.value(),
                   is_followed ? chunk_->in_step->tap_acceleration : HUGE_VAL);
  }
}

void Interpolator::leave_chunk() {
  if (!spindle_) return;
  passed_ = events_of_part();
  turn_spindle(now_);
}

double Interpolator::spindle_speed() const {
  constexpr double seconds_per_minute = 60;
  return spindle_ ? std::fabs(spindle_->speed(now_.value())) * seconds_per_minute : 0;
}

/// Revolutions the way in which the thread is cut.
double Interpolator::turned(numeric::DoubleDouble time) const {
  return way() * spindle_->revolutions(time.value());
}

void Interpolator::begin_thread() {
  const planner::Chunk::InStep& step = *chunk_->in_step;
  Thread& thread = thread_.emplace(Thread{Follower(step.limits, period_.seconds(), step.tolerance)});
  thread.waits = step.waits_for_index;
  thread.begin = index_ + step.turns;
  end_ = begin_ + numeric::DoubleDouble(longer_than_any);
}

/// Where the line begins, revolutions the way in which it is cut: a tap comes back from where the spindle stands.
double Interpolator::begin_of(const Thread& thread) const {
  return begins_at_depth() ? way() * stood_at_ : thread.begin;
}

bool Interpolator::begins_at_depth() const {
  const planner::Chunk::InStep& step = *chunk_->in_step;
  return step.tap_acceleration > 0 && !step.waits_for_index;
}

/// Until the spindle has taken up its speed, and its index passes between this time and the next word's.
void Interpolator::wait_for_index(Thread& thread, numeric::DoubleDouble now) {
  if (!spindle_->is_at_speed(now.value())) return;
  const double turns = chunk_->in_step->turns, index = std::floor(turned(now_) - turns);
  if (!(index > std::floor(turned(now) - turns))) return;
  thread.waits = false;
  index_ = index;
  thread.begin = index + turns;
}

/// From this time to the next word's. A tap's spindle is braked in time; where it stands motion goes to the end by itself.
void Interpolator::follow_spindle(Thread& thread, numeric::DoubleDouble now, double length) {
  const planner::Chunk::InStep& step = *chunk_->in_step;
  const double begin = begin_of(thread), place = std::max(step.lead * (turned(now) - begin), 0.0);
  if (step.tap_acceleration > 0) {
    const double end = way() * (begin + length / step.lead);
    spindle_->stand_at(end, now.value(), now_.value(), step.tap_acceleration);
    if (spindle_->stands(now.value())) return thread.follower.go(length);
  }
  thread.follower.follow(place, length, Follower::Back::never);
}

base::Word Interpolator::next_in_step() {
  Thread& thread = *thread_;
  const planner::Segment& segment = segments_.front();
  const toolpath::Piece& piece = chunk_->pieces[segment.piece];
  const double s = thread.follower.s();
  base::Word word;
  word.tick = tick_;
  word.position = position(piece, segment.piece, numeric::DoubleDouble(s));
  word.path_length = length_before_ + s;
  word.speed = thread.follower.velocity();
  word.feed = word.speed * piece.feed_rate(s);
  word.line = piece.line_at(s);
  word.state = thread.waits ? base::MotionState::rest : base::MotionState::changing;
  pass_events(segment.piece, s);
  turn_spindle(now_);
  const numeric::DoubleDouble now = now_;
  const double length = piece.axes().length();
  tick_ = base::next(tick_);
  now_ = time_of(tick_, period_);
  if (thread.is_left) {
    thread.follower.stop();
  } else if (thread.waits) {
    wait_for_index(thread, now);
  } else {
    follow_spindle(thread, now, length);
  }
  const bool may_end = thread.is_left || thread.follower.s() == length;
  if (may_end && thread.follower.rests()) end_thread(piece);
  return word;
}

/// The next word lies at its end, or where it was left.
void Interpolator::end_thread(const toolpath::Piece& piece) {
  const double s = thread_->follower.s();
  if (thread_->is_left) {
    has_left_ = true;
    rest_ = position(piece, segments_.front().piece, numeric::DoubleDouble(s));
    line_ = piece.line_at(s);
    end_on_piece_ = s;
  } else {
    const planner::Chunk::InStep& step = *chunk_->in_step;
    stood_at_ = way() * (begin_of(*thread_) + s / step.lead);
    const bool was_in_step = thread_->follower.in_step();
    if (!was_in_step && threads_.out_of_step++ == 0) threads_.out_of_step_line = piece.line;
    threads_.lines += was_in_step;
    if (was_in_step && thread_->follower.run_in() > threads_.run_in) {
      threads_.run_in = thread_->follower.run_in();
      threads_.run_in_line = piece.line;
    }
  }
  thread_.reset();
  end_ = now_;
}

}  // namespace leadscrew::interpolator
