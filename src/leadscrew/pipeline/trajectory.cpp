#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/tick_time.hpp>
#include <leadscrew/pipeline/trajectory.hpp>
#include <leadscrew/planner/section.hpp>
#include <limits>
#include <utility>

namespace leadscrew::pipeline {

using numeric::DoubleDouble;

namespace {

/// Of q(s(t)), by the chain rule.
void set_rates(TrajectoryState& state, const geometry::PointJet& q, const planner::PathState& s) {
  const double v = s.speed, a = s.acceleration, j = s.jerk;
  for (std::size_t i = 0; i < q.size(); ++i) {
    state.velocity[i] = q[i].first * v;
    state.acceleration[i] = q[i].second * v * v + q[i].first * a;
    state.jerk[i] = q[i].third * v * v * v + 3 * q[i].second * v * a + q[i].first * j;
  }
}

/// Of the next word of `cycle`.
TrajectoryState next_state(interpolator::Interpolator& cycle) {
  TrajectoryState state;
  if (const auto on_path = cycle.on_path()) {
    const planner::PathState& along = on_path->along;
    set_rates(state, planner::one_sided_jets(on_path->piece.axes(), along.s, planner::Side::right), along);
  }
  const base::Word word = cycle.next();
  state.position = word.position;
  state.path_length = word.path_length;
  state.speed = word.speed;
  state.feed = word.feed;
  state.line = word.line;
  state.state = word.state;
  return state;
}

}  // namespace

void Trajectory::append(planner::Chunk chunk) {
  // Nobody stops on the way; where the committed part is cut, the tail's first segment tells its end.
  if (chunk.stop_tail.size() > 1) chunk.stop_tail.resize(1);
  chunk.tail_events.clear();
  Part& part = parts_.emplace_back(Part{std::move(chunk), last_});
  part.cycle.load(part.chunk);
  last_ = part.cycle;
}

void Trajectory::stand(double seconds) {
  const base::Word rest = wait_at_end();
  planner::Chunk chunk;
  chunk.rest = rest.position;
  chunk.rest_line = rest.line;
  chunk.duration = DoubleDouble(seconds);
  planner::Segment& standing = chunk.segments.emplace_back();
  standing.state = base::MotionState::rest;
  standing.duration = chunk.duration;
  append(std::move(chunk));
  wait_at_end();
}

/// The word at rest behind the last chunk. Whatever comes next begins there, be it in the middle of a motion or a dwell.
base::Word Trajectory::wait_at_end() {
  last_.seek(last_.end());
  const base::Word rest = last_.next();
  last_.seek(last_.end());
  return rest;
}

/// The tick that t is, or else t. Ticks are multiples of 10 µs at least: no other double is so near to one by chance that
/// axes would move between the two.
DoubleDouble Trajectory::exact(double t) const {
  if (!(t > 0)) return DoubleDouble(0);
  if (t > duration() + period_.seconds()) return last_.end() + DoubleDouble(period_.seconds());
  const auto tick = static_cast<base::Tick>(std::llround(t / period_.seconds()));
  const double rounding = t * std::numeric_limits<double>::epsilon();
  return std::abs(t - base::seconds(tick, period_)) <= rounding ? interpolator::time_of(tick, period_)
                                                                : DoubleDouble(t);
}

/// One whose next word is that of this time.
interpolator::Interpolator Trajectory::cycle_at(DoubleDouble time) const {
  const auto part = std::upper_bound(parts_.begin(), parts_.end(), time,
                                     [](DoubleDouble t, const Part& p) { return t < p.cycle.end(); });
  interpolator::Interpolator cycle = part == parts_.end() ? last_ : part->cycle;
  cycle.seek(time);
  return cycle;
}

TrajectoryState Trajectory::at(double t) const {
  interpolator::Interpolator cycle = cycle_at(exact(t));
  return next_state(cycle);
}

TrajectoryState TrajectoryWalk::at(double t) {
  const DoubleDouble time = trajectory_.exact(t);
  if (time < at_ || end_ <= time) {
    cycle_ = trajectory_.cycle_at(time);
    end_ = cycle_.end();
  } else {
    cycle_.seek(time);
  }
  at_ = time;
  return next_state(cycle_);
}

base::Word Trajectory::word(base::Tick tick) const {
  base::Word word = cycle_at(interpolator::time_of(tick, period_)).next();
  word.tick = tick;
  return word;
}

base::Tick Trajectory::last_tick() const {
  return first_from(last_.end());
}

/// The first tick that is not before a time ≥ 0.
base::Tick Trajectory::first_from(DoubleDouble time) const {
  auto tick = static_cast<base::Tick>(std::llround(time.value() / period_.seconds()));
  while (base::count(tick) > 0 && time <= interpolator::time_of(base::Tick{base::count(tick) - 1}, period_))
    tick = base::Tick{base::count(tick) - 1};
  while (interpolator::time_of(tick, period_) < time) tick = base::next(tick);
  return tick;
}

void Trajectory::tell_events(const std::function<void(const base::PassedEvent&)>& sink) const {
  base::Tick tick{};
  for (const Part& part : parts_) {
    interpolator::Interpolator cycle = part.cycle;
    const DoubleDouble end = cycle.end();
    const std::size_t count = part.chunk.events.size();
    std::size_t told = 0;
    const auto tell_until = [&](std::size_t passed) {
      for (; told < passed; ++told) sink(planner::passed_at(tick, part.chunk.event(told)));
    };
    for (; told < count && interpolator::time_of(tick, period_) < end; tick = base::next(tick)) {
      cycle.seek(interpolator::time_of(tick, period_));
      cycle.next();
      tell_until(cycle.events_passed());
    }
    tick = first_from(end);
    tell_until(count);
  }
}

}  // namespace leadscrew::pipeline
