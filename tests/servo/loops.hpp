#pragma once
// Loops for tests.

#include <leadscrew/servo/axis_loop.hpp>
#include <leadscrew/servo/pulse_loop.hpp>

namespace leadscrew::servo::testing {

inline AxisLoop pid_loop(const AxisOptions& axis, const PidOptions& pid, double period) {
  return {SimulatedAxis::create(axis).value(), Pid::create(pid, period).value(), period};
}

/// Proportional alone: Kv = P·K.
inline AxisLoop proportional_loop(double kv, double time_constant, double period) {
  return pid_loop({.drive = velocity_drive(1, time_constant)}, {.gains = {.proportional = kv}}, period);
}

/// 10 V over 256 counts, an encoder of 200 holes; the motor makes up the rest of Kv.
inline PulseLoopOptions options_with(double kv, double time_constant, int bits = 16) {
  PulseLoopOptions options{.converter = 10.0 / 256, .amplifier = 4, .holes = 200, .time_constant = time_constant};
  options.motor = kv / (options.converter * options.amplifier * options.holes);
  options.counter_bits = bits;
  return options;
}

inline PulseLoop made(const PulseLoopOptions& options) {
  return PulseLoop::create(options).value();
}

}  // namespace leadscrew::servo::testing
