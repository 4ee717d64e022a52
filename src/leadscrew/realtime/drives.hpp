#pragma once
// The drives, simulated: they go where they are told, period by period. Before the first word they go by themselves to
// where it will be, on a straight line:
//
//      way per      .-'-.           An approach that is called off lets go of its acceleration, then brakes, all
//      period     /      \          axes in the same time, as fast as the limits of every axis allow: so it stays
//                /.       \         on its line. Limits are those of differences from period to period, which is
//              .'  '.      '.       what a referee sees.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/machine/machine.hpp>

namespace leadscrew::realtime {

/// One call a servo period. Neither allocates nor locks.
class Drives {
 public:
  /// At rest. Axes that the machine lacks stay where they are.
  Drives(const machine::Machine& machine, base::Period period, const base::AxisVector& position);

  /// A period, to there.
  void follow(const base::AxisVector& word);
  /// From rest on a straight line to rest at `target`, one period a call, no faster than `feed`, mm/s by the linear
  /// axes (degrees/s where only rotary axes move), infinite for none. True when they stand: there, or where it was
  /// called off.
  bool approach(const base::AxisVector& target, double feed);
  /// The approach, if there is one, ends on its line as soon as the limits allow; at its target once it slows down.
  void call_off();

  const base::AxisVector& position() const { return position_; }
  bool at_rest() const { return rests_; }

 private:
  void brake();
  void plan_to_brake();
  void plan_to_approach(const base::AxisVector& target, double feed);
  void move(const base::AxisVector& step);

  std::array<machine::AxisLimits, base::axis_count> limits_{};  ///< per period, its square and its cube
  double period_ = 0;                                           ///< s
  base::AxisSet axes_;
  base::AxisVector position_{};
  base::AxisVector step_{};    ///< of the last period
  base::AxisVector change_{};  ///< of the step, in the last period
  bool rests_ = true;
  // Of braking and of an approach.
  std::int64_t tick_ = 0;                ///< of it; 0: not begun
  std::int64_t release_ = 0, fall_ = 0;  ///< periods to let go, and to brake or to travel
  base::AxisVector from_{}, way_{};
  bool called_off_ = false;
};

}  // namespace leadscrew::realtime
