#pragma once
// The cycle: one call, one word.
//
// Time is an integer tick n and t = n·T. The segment of the motion that holds t gives s(t) in closed form, the curve of
// its piece gives the axes' positions; both in double-double, rounded once. Nothing is accumulated from word to word
// but the number of the tick and, from chunk to chunk, where the next begins (a fraction of a tick is as good as a
// whole one). No allocation, no lock, no clock, no exception; the only loop moves on through segments that have ended.

#include <cstddef>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::interpolator {

class Interpolator {
 public:
  /// Stands at `position` until a chunk is loaded.
  Interpolator(base::Period period, const base::AxisVector& position);

  /// Goes along NURBS curves by one of the published rules, for comparison; by arc length unless told otherwise.
  void step_by(StepRule rule) { rule_ = rule; }

  /// Does the next word lie beyond the end of the chunk (or is there none)? Then load the next chunk, or if there is
  /// none, stop asking: words stay at its end, at rest.
  bool wants_chunk() const;

  /// Goes on with this chunk from where the one before ends in time. It is not copied: it must live until the next is
  /// loaded.
  void load(const planner::Chunk& chunk);

  /// The word of this tick; moves on to the next tick.
  base::Word next();

  /// The tick of the next word.
  base::Tick tick() const { return tick_; }

 private:
  base::AxisVector position(const geometry::Curve& curve, numeric::DoubleDouble s);
  const planner::Segment& segment_at(numeric::DoubleDouble time);

  base::Period period_;
  base::Tick tick_{};
  const planner::Chunk* chunk_ = nullptr;
  std::size_t segment_ = 0;
  numeric::DoubleDouble now_;            ///< time of the next word, seconds
  numeric::DoubleDouble begin_;          ///< of the chunk, seconds
  numeric::DoubleDouble end_;            ///< of the chunk, seconds
  numeric::DoubleDouble segment_begin_;  ///< seconds
  numeric::DoubleDouble segment_end_;    ///< seconds
  double length_before_ = 0;             ///< travelled before the piece
  double length_after_ = 0;              ///< travelled when the chunk has ended
  base::AxisVector rest_;
  base::Line line_{};
  StepRule rule_ = StepRule::arc_length;
  const geometry::Curve* stepped_curve_ = nullptr;  ///< along which parameter steps are taken
  double parameter_ = 0;                            ///< where the last step ended
  double stepped_ = 0;                              ///< and its path length
};

}  // namespace leadscrew::interpolator
