#pragma once
// Motion along a line in step with a spindle, within limits of velocity, acceleration and jerk whatever the spindle does.
//
// What the spindle asks for is a place on the line, p = lead · revolutions, known each period and no earlier. Its speed w
// and acceleration are estimated from the last places (a fading memory of third order: a steady spindle is followed
// without lag). The wanted speed is the spindle's and what makes good the error e:
//
//     v = w + f(e),   f(e) = k·e near 0, then the root of it by which e can be braked away
//     a = dw/dt + g(v − speed),   likewise for speed by jerk
//
//     s                 spindle ╱      ╭── end: three phases of constant jerk, as late as they lead to rest there
//       │                     ╱  ─╯
//       │     run-in ╲      ╱
//       │             ╭───╯  in step: |s − p| ≤ tolerance
//       └────────────╯──────────────▶ t
//
// Between two periods jerk is constant, so that positions are those of one smooth motion, and no difference of them shows
// more than its derivatives. Before a period is taken, the stop from where it leads is looked at: only where that keeps
// velocity and the line's end it is taken; else motion goes to rest there. So a stop within limits lies ahead at all times.
// Plain values, no allocation, no loop that is not bounded: for the cycle.

#include <array>
#include <leadscrew/machine/derivatives.hpp>

namespace leadscrew::interpolator {

class Follower {
 public:
  /// At rest at s = 0. Limits along the line, its units, s; > 0. period: s, > 0. tolerance: by how much s may leave the
  /// spindle's place in step, > 0. memory: s, of the estimate of the spindle, ≥ 0; at least four periods.
  Follower(const machine::Derivatives& limits, double period, double tolerance, double memory = 0);

  enum class Back : bool { never, with_spindle };
  /// A period in step with a spindle that asks for `place` as it begins. Motion rests at `end`, ≥ s, where the spindle
  /// leads there, and stays; infinite: nowhere. Before, it turns back with the spindle, or waits for it at rest: the same in
  /// all calls. Behind stop() as that.
  void follow(double place, double end, Back back = Back::with_spindle);
  /// A period on the way to rest, as soon as the limits allow. There it stays.
  void stop();
  /// A period on the way to rest at `end`: in motion, first to rest where the limits allow, and from there.
  void go(double end);

  /// On the line, units of its length.
  double s() const { return s_; }
  double velocity() const { return v_; }      ///< units/s
  double acceleration() const { return a_; }  ///< units/s²
  /// Has motion come to rest: at the end that was asked for, or by stop()?
  bool rests() const { return rests_; }
  /// Length of the run-in so far: where s left the tolerance about the spindle's place last, before the end was made for.
  double run_in() const { return run_in_; }
  /// Was s within the tolerance about the spindle's place when the end was made for, or is it?
  bool in_step() const { return in_step_; }

 private:
  struct Phase {
    double jerk = 0, duration = 0;
  };
  /// From s, v and a on, phase by phase, to rest.
  struct Manoeuvre {
    std::array<Phase, 3> phases{};
    double s = 0, v = 0, a = 0;  ///< where it begins
    double elapsed = 0;
    double end = 0;  ///< where it rests
  };
  enum class Task { none, ending, approaching, stopping, going, pausing };

  void estimate(double place);
  double wanted_acceleration() const;
  bool may_take(double jerk, Back back, double end) const;
  void move(double jerk);
  double within_velocity(double jerk) const;
  void begin(Task task, const std::array<Phase, 3>& phases, double end);
  void begin_braking(Task task, double jerk, double end);
  void begin_line(Task task, double end);
  bool end_at(double end);
  void begin_stop(Task task);
  bool go_on();
  void go_on_to(double end);

  machine::Derivatives limits_;
  double period_, tolerance_, memory_;
  double s_ = 0, v_ = 0, a_ = 0;
  double place_ = 0, speed_ = 0, change_ = 0;  ///< of the spindle, as estimated
  int places_ = 0;                             ///< that have been taken: 0, 1, 2 or more
  Task task_ = Task::none;
  Manoeuvre manoeuvre_;
  double run_in_ = 0;
  bool in_step_ = false;
  bool rests_ = true;
  bool is_stopped_ = false;  ///< for good
};

}  // namespace leadscrew::interpolator
