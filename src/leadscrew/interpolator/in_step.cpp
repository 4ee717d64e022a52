// Lines in step with the simulated spindle. How long one takes, only the spindle knows: the line is the whole chunk, and
// its end is told when motion rests there.

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
constexpr std::uint64_t stops = bit(Kind::spindle_stop) | bit(Kind::spindle_orientation) | bit(Kind::program_end);
constexpr std::uint64_t obeyed = clockwise | bit(Kind::spindle_counterclockwise) | bit(Kind::spindle_speed) | stops;

}  // namespace

/// Obeys the events that have been passed, at this time: that of a word, so that it is the same wherever chunks are cut.
void Interpolator::turn_spindle(numeric::DoubleDouble time) {
  for (; turned_ < passed_; ++turned_) {
    const planner::PlacedEvent& event = chunk_->event(turned_);
    const std::uint64_t kind = bit(event.kind);
    if ((kind & obeyed) == 0) continue;
    if (kind != bit(Kind::spindle_speed)) direction_ = (kind & stops) != 0 ? 0 : kind == clockwise ? 1 : -1;
    spindle_->turn(direction_ == 0 ? 0 : direction_ * event.value, time.value());
  }
}

void Interpolator::leave_chunk() {
  if (!spindle_) return;
  passed_ = events_of_part();
  turn_spindle(now_);
}

/// Revolutions the way in which the thread is cut.
double Interpolator::turned(numeric::DoubleDouble time) const {
  return (direction_ < 0 ? -1 : 1) * spindle_->revolutions(time.value());
}

void Interpolator::begin_thread() {
  const planner::Chunk::InStep& step = *chunk_->in_step;
  Thread& thread = thread_.emplace(Thread{Follower(step.limits, period_.seconds(), step.tolerance)});
  thread.waits = step.waits_for_index;
  thread.begin = index_ + step.turns;
  end_ = begin_ + numeric::DoubleDouble(longer_than_any);
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
  const planner::Chunk::InStep& step = *chunk_->in_step;
  const double turned_now = turned(now_), length = piece.axes().length();
  tick_ = base::next(tick_);
  now_ = time_of(tick_, period_);
  if (thread.is_left) {
    thread.follower.stop();
  } else if (!thread.waits) {
    thread.follower.follow(step.lead * (turned_now - thread.begin), length);
  } else if (const double index = std::floor(turned(now_) - step.turns); index > std::floor(turned_now - step.turns)) {
    thread.waits = false;
    index_ = index;
    thread.begin = index + step.turns;
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
    ++threads_.lines;
    if (thread_->follower.run_in() > threads_.run_in) {
      threads_.run_in = thread_->follower.run_in();
      threads_.run_in_line = piece.line;
    }
  }
  thread_.reset();
  end_ = now_;
}

}  // namespace leadscrew::interpolator
