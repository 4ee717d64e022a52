#pragma once
// The loops of a machine's axes, from what it tells of their drives.
//
// What a machine does not tell:
//
//   cascade   Kv = 40/s, a lag of 1 mm at 2.4 m/min, as machine tools have it, and a velocity gain five times as great,
//             with which the position loop has a damping of 1.1 and does not overshoot. The velocity loop is closed
//             once a servo period T, read as a difference of readings: its gain is at most 0.3/T, and Kv goes with it.
//             Torque for twice the acceleration the axis may have: as much to correct with as to move with.
//   PID       K = 10 mm/s a unit, τ = 20 ms: the drive of the published gains' reference calculation; P = 1/(4Kτ), with
//             which K/(s(τs + 1)) is critically damped.
//   both      velocity and acceleration fed forward whole, no friction, an encoder of one count a BLU at the screw.
//
// The velocity that is fed forward is that of the middle of the period to come, and what is read is that of the middle
// of the one before: while an axis speeds up, the cascade sees a·T missing and pulls P·T·a. Of the acceleration, the
// rest is fed forward.
//
// The play is the machine's backlash (machine::ScrewErrors), which no word makes good.

#include <leadscrew/machine/machine.hpp>
#include <leadscrew/servo/servo.hpp>

namespace leadscrew::servo {

/// For each axis the machine has, at its period.
ServoOptions loops_of(const machine::Machine& machine);

/// A loop's time constant at the longest: how far back in time a slide may be, seconds. 1/Kv of the slowest axis.
double longest_lag(const ServoOptions& options);

}  // namespace leadscrew::servo
