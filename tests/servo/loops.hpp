#pragma once
// Loops for tests.

#include <leadscrew/servo/axis_loop.hpp>

namespace leadscrew::servo::testing {

inline AxisLoop pid_loop(const AxisOptions& axis, const PidOptions& pid, double period) {
  return {Axis::create(axis).value(), Pid::create(pid, period).value(), period};
}

/// Proportional alone: Kv = P·K.
inline AxisLoop proportional_loop(double kv, double time_constant, double period) {
  return pid_loop({.drive = velocity_drive(1, time_constant)}, {.gains = {.proportional = kv}}, period);
}

}  // namespace leadscrew::servo::testing
