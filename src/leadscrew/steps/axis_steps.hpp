#pragma once
// The steps of one axis, period by period, in blocks of bounded size.
//
//   BLU                    A step from k to k + 1 is due at the first tick at which the reference has reached k + 1/2;
//   k+1 ┤       ┌────      one back, from k + 1 to k, when it has come back to k + 1/2 − h. The hysteresis h is far
//       ┤     ╱            below anything that matters but above the rounding of words, so that a reference that
//   k+½ ┤┈┈┈┈╱┈┈┈┈┈┈       stands on k + 1/2 makes at most one step. The count of steps is an integer that is
//       ┤  ╱ │             carried on, and how many are due depends on it and on the words alone: none is lost or
//   k   ┤──── ───▶ t       made twice at the seams of periods and blocks, whatever is rounded in between.
//
// Where the reference moves nearly evenly, as it does in all periods with many steps, its cubic is written as
//
//   p(x)/p(1) = x + x(1−x)(α(1−x) − βx),   |α| + |β| ≤ 1/4,
//
// so the crossing of u is x = u − u(1−u)(α(1−u) − βu) but for 0.01, and two steps of Newton leave less than 1e-8:
// no branches, and no step waits for the one before, so that the processor finds several at a time. All other periods
// are cut where the reference turns, and their crossings are bracketed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/steps/reference.hpp>
#include <leadscrew/steps/step_event.hpp>
#include <leadscrew/steps/step_timing.hpp>
#include <span>

namespace leadscrew::steps {

/// A servo period on the step clock.
struct TickSpan {
  std::int64_t base = 0;  ///< the last whole tick at or before the period's begin
  double offset = 0;      ///< of the begin from there, ticks; 0 ≤ offset < 1
  double length = 0;      ///< of the period, ticks; up to 2·10⁵
};

class AxisSteps {
 public:
  static constexpr std::size_t capacity = 256;  ///< of the block of steps that are known but not taken yet

  AxisSteps() = default;
  AxisSteps(base::Axis axis, const StepTicks& ticks)
      : axis_(axis), setup_(ticks.setup), pitch_(ticks.pitch()), turn_(ticks.reversal()) {}

  /// Stands at the nearest BLU, as if it had come there from where the position is not.
  void stand(double position) {
    count_ = std::llround(position);
    direction_ = position < static_cast<double>(count_) ? 1 : -1;
  }

  /// Goes on with the next period; all steps of the one before must have been taken.
  void begin(const Span& span, const TickSpan& ticks);
  /// Makes the next block of this period's steps, if the one before has been taken.
  void fill();
  /// Will there be more steps in this period than those known?
  bool has_more() const { return part_ < parts_; }
  /// Those known, in order.
  std::span<const StepEvent> known() const { return {events_.data() + taken_, made_ - taken_}; }
  /// Takes away so many of them.
  void take(std::size_t count) { taken_ += count; }

  std::int64_t count() const { return count_; }                    ///< where the steps lead to, BLU
  std::int64_t steps() const { return steps_; }                    ///< made so far
  std::int64_t postponed() const { return postponed_; }            ///< that were not made when they were due
  std::int64_t greatest_delay() const { return greatest_delay_; }  ///< of those, ticks

 private:
  /// A piece of the period in which the reference does not turn.
  struct Part {
    double x_begin, x_end;
    double displacement_begin, displacement_end;  ///< from the period's begin, BLU
  };

  void add_part(double x_begin, double x_end, double displacement_begin, double displacement_end);
  void begin_part();
  void even_ticks(double first, std::size_t count);
  void bracketed_ticks(double first, std::size_t count);
  std::size_t place(std::size_t count);
  std::int64_t earliest() const;
  bool are_apart(std::size_t count, std::int64_t earliest) const;
  std::size_t place_as_due(std::size_t count);
  std::size_t place_apart(std::size_t count, std::int64_t earliest);

  base::Axis axis_ = base::Axis::X;
  std::int64_t setup_ = 0, pitch_ = 2, turn_ = 2;
  std::int64_t count_ = 0;
  int direction_ = 1;      ///< of the last step
  std::int64_t last_ = 0;  ///< its tick
  std::int64_t steps_ = 0, postponed_ = 0, greatest_delay_ = 0;

  Span span_;
  TickSpan ticks_;
  std::int64_t final_tick_ = 0;  ///< of the period
  bool even_ = false;
  std::array<Part, 4> parts_of_span_{};
  int part_ = 0, parts_ = 0;
  int part_direction_ = 1;
  std::int64_t due_ = 0;  ///< steps of the part that are still to be made
  double x_ = 0;          ///< where the last crossing was found

  std::array<std::int32_t, capacity> due_ticks_{};  ///< from the base
  std::array<StepEvent, capacity> events_{};
  std::size_t made_ = 0, taken_ = 0;
};

}  // namespace leadscrew::steps
