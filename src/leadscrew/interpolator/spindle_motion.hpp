#pragma once
// Where a simulated spindle is, in closed form between two commands: a ramp of constant acceleration to the speed that is
// asked for, in a time of its own that wanders against the clock's,
//
//     θ(t) = R(t + ε W(t)),   W(t) = ∫ w dt,   w(t) = Σ c_k sin(2π k t/P + φ_k),  k = 1, 2, 3,  Σ c_k = 1,
//
// so that its speed is R' (1 + ε w): never more than ε away from the ramp's, and 0 where that is.

#include <array>
#include <leadscrew/machine/spindle.hpp>
#include <limits>

namespace leadscrew::interpolator {

class SpindleMotion {
 public:
  /// Stands at its index at t = 0.
  explicit SpindleMotion(const machine::Spindle& spindle);

  /// From t on, s, not before the last command, it goes to this speed, revolutions per minute; below 0
  /// counterclockwise, 0 stops it. It takes up speed by its own acceleration, or by this one, revolutions per s², if that
  /// is less.
  void turn(double speed, double t, double acceleration = std::numeric_limits<double>::infinity());
  /// Of a tap: brakes by this acceleration, revolutions per s², > 0, so that it stands at this place, revolutions, if that
  /// must begin before `next`, s; exactly there if it can be, else as soon as it can. t: as turn()'s, ≤ next; where it is
  /// asked for from then on at `next` or later. Does nothing where it brakes to stand already.
  void stand_at(double place, double t, double next, double acceleration);
  /// Revolutions since t = 0, counterclockwise ones counted back; at a time not before the last command, s. Its index
  /// is at whole ones.
  double revolutions(double t) const;
  /// Revolutions per second; likewise.
  double speed(double t) const;
  /// Has it taken up the speed that was asked for last? Likewise.
  bool is_at_speed(double t) const;
  /// Does it stand, as it was told? Likewise.
  bool stands(double t) const { return to_ == 0 && is_at_speed(t); }

 private:
  struct Wave {
    double share, frequency, phase;  ///< 1, radians per s, radians
  };

  double own_time(double t) const;
  double wander(double t) const;
  double ramp_speed(double since) const;
  double turned(double since) const;

  double acceleration_;  ///< its own, revolutions per s²
  double ramp_;          ///< in force
  double wander_;
  std::array<Wave, 3> waves_;
  double begin_ = 0;          ///< of the ramp, by its own time, s
  double revolutions_ = 0;    ///< there
  double from_ = 0, to_ = 0;  ///< revolutions per s
};

}  // namespace leadscrew::interpolator
