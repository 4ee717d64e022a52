#pragma once
// A motion that has been planned to its end: how long it takes, and where its axes are at any time of it.
//
//   t ─▶ chunk ─▶ segment ─▶ s(t) ─▶ curve ─▶ q, q̇, q̈, q⃛        the same polynomials and curves as the cycle's,
//                                                               so that times which are ticks have its words' bits

#include <deque>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::pipeline {

/// Axes at one instant. Where acceleration or jerk steps, the value behind the step.
struct TrajectoryState {
  base::AxisVector position{};                        ///< mm or degrees
  base::AxisVector velocity{};                        ///< mm/s or degrees/s
  base::AxisVector acceleration{};                    ///< the same per s²
  base::AxisVector jerk{};                            ///< the same per s³
  double path_length = 0;                             ///< travelled, as base::Word::path_length
  double speed = 0;                                   ///< along the path, units of path_length per second
  double feed = 0;                                    ///< as base::Word::feed
  base::Line line{};                                  ///< of the block in motion
  base::MotionState state = base::MotionState::rest;  ///< of the plan
};

/// Memory grows with the path. Any number of threads may ask one at a time that nobody appends to.
class Trajectory {
 public:
  /// Rests at `position`, mm or degrees, and lasts no time.
  Trajectory(base::Period period, const base::AxisVector& position) : last_(period, position), period_(period) {}
  Trajectory(Trajectory&&) noexcept = default;
  Trajectory& operator=(Trajectory&&) noexcept = default;
  Trajectory(const Trajectory&) = delete;  // the interpolators look into the chunks that are kept here
  Trajectory& operator=(const Trajectory&) = delete;

  /// The next chunk of the planner: it goes on where the one before ends. The last must end at rest.
  void append(planner::Chunk chunk);
  /// Stands for so many seconds, ≥ 0, where the chunk before has ended at rest.
  void stand(double seconds);

  /// Seconds to rest at the end.
  double duration() const { return last_.end().value(); }
  /// Units of TrajectoryState::path_length.
  double length() const { return at(duration()).path_length; }
  /// At t seconds; before 0 as at 0, after duration() as there. A time that is a whole number of servo periods, to the
  /// last bit of its double, is that tick: `word(tick)` and this agree.
  TrajectoryState at(double t) const;
  /// The word of this tick ≥ 0, bit for bit as the cycle makes it.
  base::Word word(base::Tick tick) const;
  /// The first at rest at the end: that of the last word.
  base::Tick last_tick() const;
  /// All events, in order, each with the word in whose period it happens.
  void tell_events(const std::function<void(const base::PassedEvent&)>& sink) const;

 private:
  struct Part {
    planner::Chunk chunk;
    interpolator::Interpolator cycle;  ///< as it is when the chunk has been loaded
  };

  base::Word wait_at_end();
  interpolator::Interpolator cycle_at(numeric::DoubleDouble time) const;
  numeric::DoubleDouble exact(double t) const;
  base::Tick first_from(numeric::DoubleDouble time) const;

  std::deque<Part> parts_;           ///< places in it stay where they are
  interpolator::Interpolator last_;  ///< behind the last chunk
  base::Period period_;

  friend class TrajectoryWalk;
};

/// Trajectory::at() along times that rise, bit for bit, in a time that does not grow with what a chunk holds.
class TrajectoryWalk {
 public:
  /// The trajectory outlives it, and nobody appends meanwhile.
  explicit TrajectoryWalk(const Trajectory& trajectory)
      : trajectory_(trajectory), cycle_(trajectory.cycle_at(at_)), end_(cycle_.end()) {}

  /// At any t; where it is before the last, it begins anew there.
  TrajectoryState at(double t);

 private:
  const Trajectory& trajectory_;
  numeric::DoubleDouble at_ = 0;
  interpolator::Interpolator cycle_;
  numeric::DoubleDouble end_;  ///< of the chunk in which at_ lies
};

}  // namespace leadscrew::pipeline
