#include <algorithm>
#include <leadscrew/servo/machine_loops.hpp>

namespace leadscrew::servo {

namespace {

using machine::AxisDrive;

AxisOptions mechanics_of(const machine::Machine& machine, base::Axis axis) {
  const AxisDrive& told = machine.drive(axis);
  AxisOptions options;
  options.friction = told.friction.value_or(0);
  options.breakaway = told.breakaway.value_or(0);
  options.backlash = machine.screw(axis).backlash;
  options.encoder_resolution = told.encoder_counts ? 1 / *told.encoder_counts : machine.limits(axis).blu;
  options.encoder_place = told.encoder == AxisDrive::Encoder::slide ? EncoderPlace::slide : EncoderPlace::screw;
  return options;
}

/// The command is the acceleration that the motor's current gives, mm/s².
LoopOptions cascade_of(const machine::Machine& machine, base::Axis axis) {
  constexpr double usual_gain = 200, share_of_rate = 0.3, gain_ratio = 5;  // 1/s
  const AxisDrive& told = machine.drive(axis);
  LoopOptions loop{mechanics_of(machine, axis), {}};
  loop.axis.drive = {1, told.damping.value_or(0)};
  loop.axis.command_limit = told.acceleration.value_or(2 * machine.limits(axis).acceleration);
  CascadeOptions cascade;
  cascade.velocity_gain = told.velocity_gain.value_or(std::min(usual_gain, share_of_rate / machine.period.seconds()));
  cascade.position_gain = told.position_gain.value_or(cascade.velocity_gain / gain_ratio);
  cascade.integral_gain = told.velocity_integral.value_or(0);
  cascade.velocity_forward = told.velocity_forward.value_or(1);
  const double given = cascade.velocity_forward * cascade.velocity_gain * machine.period.seconds();
  cascade.acceleration_forward = told.acceleration_forward.value_or(1) * std::max(0.0, 1 - given);
  cascade.limit = loop.axis.command_limit;
  loop.controller = cascade;
  return loop;
}

LoopOptions pid_of(const machine::Machine& machine, base::Axis axis) {
  constexpr double usual_gain = 10, usual_time_constant = 20;  // mm/s, ms
  const AxisDrive& told = machine.drive(axis);
  const double gain = told.gain.value_or(usual_gain);
  const double time_constant = told.time_constant.value_or(usual_time_constant) / 1000;
  LoopOptions loop{mechanics_of(machine, axis), {}};
  loop.axis.drive = velocity_drive(gain, time_constant);
  PidOptions pid;
  pid.gains.proportional = told.proportional.value_or(1 / (4 * gain * time_constant));
  pid.gains.integral = told.integral.value_or(0);
  pid.gains.derivative = told.derivative.value_or(0);
  pid.velocity_forward = told.velocity_forward.value_or(1) / gain;
  pid.acceleration_forward = told.acceleration_forward.value_or(1) * time_constant / gain;
  if (told.command_limit) loop.axis.command_limit = pid.limit = *told.command_limit;
  loop.controller = pid;
  return loop;
}

double lag_of(const LoopOptions& loop) {
  if (const auto* cascade = std::get_if<CascadeOptions>(&loop.controller)) return 1 / cascade->position_gain;
  const auto* pid = std::get_if<PidOptions>(&loop.controller);
  const double gain = loop.axis.drive.damping > 0 ? loop.axis.drive.acceleration / loop.axis.drive.damping : 1;
  return pid != nullptr ? 1 / (gain * std::max(pid->gains.proportional, 1e-3)) : 0;
}

}  // namespace

ServoOptions loops_of(const machine::Machine& machine) {
  ServoOptions options;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const bool is_pid = machine.drive(axis).controller == AxisDrive::Controller::pid;
    options[base::index(axis)] = is_pid ? pid_of(machine, axis) : cascade_of(machine, axis);
  }
  return options;
}

double longest_lag(const ServoOptions& options) {
  double lag = 0;
  for (const auto& loop : options) {
    if (loop) lag = std::max(lag, lag_of(*loop));
  }
  return lag;
}

}  // namespace leadscrew::servo
