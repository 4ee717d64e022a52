#pragma once
// Random machines with a spindle that wanders, and where it is at each word.

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <leadscrew/base/event.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/interpolator/spindle_motion.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <string>

#include "random_programs.hpp"

namespace leadscrew::testing_support {

/// Of three axes.
inline machine::Machine machine_with_spindle() {
  machine::Machine machine;
  machine.period = {*rc::gen::element<std::int64_t>(100'000, 500'000, 1'000'000, 2'000'000)};
  for (std::size_t i = 0; i < 3; ++i) {
    const double velocity = between(30, 500), acceleration = velocity * between(2, 20);
    machine.axes[i] = machine::AxisLimits{.travel_min = -10'000,
                                          .travel_max = 10'000,
                                          .velocity = velocity,
                                          .acceleration = acceleration,
                                          .jerk = acceleration * between(10, 100),
                                          .blu = 0.001};
  }
  machine.spindle = machine::Spindle{.acceleration = between(100, 20'000),
                                     .wander = 0.05,
                                     .wander_period = between(2, 20),
                                     .seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000))};
  machine.tolerance = *rc::gen::element(0.002, 0.01, 0.05);
  return machine;
}

/// The blocks by which it points the tool anywhere and has tool centre point control, for which it gets two rotary axes.
inline std::string point_tool(machine::Machine& machine) {
  const machine::KinematicsPreset preset =
      machine::kinematics_presets[*rc::gen::inRange<std::size_t>(0, machine::kinematics_presets.size())];
  machine.kinematics = preset.name;
  machine.rotary_chain = machine::preset_chain(preset.name);
  std::string turns = "G0";
  for (machine::RotaryAxis& axis : machine.rotary_chain->axes) {
    axis.point = {between(-50, 50), between(-50, 50), between(-50, 50)};
    machine.axes[base::index(axis.axis)] = machine::AxisLimits{-360, 360, 180, 1500, 30'000, 0.001};
    turns += std::string(" ") + base::letter(axis.axis) + std::to_string(between(-170, 170));
  }
  return turns + "\nG43.4\nG0 X0 Y0 Z0\n";
}

/// The least of the limits of X, Y and Z.
inline machine::Derivatives least_limits(const machine::Machine& machine) {
  machine::Derivatives least{1e9, 1e12, 1e12};
  for (std::size_t i = 0; i < 3; ++i) {
    const machine::AxisLimits& axis = *machine.axes[i];
    least = {std::min(least.velocity, axis.velocity), std::min(least.acceleration, axis.acceleration),
             std::min(least.jerk, axis.jerk)};
  }
  return least;
}

/// For a log.
inline std::string limits_with_spindle(const machine::Machine& machine) {
  return limits_of(machine) + "spindle " + std::to_string(machine.spindle->acceleration) + ' ' +
         std::to_string(machine.spindle->wander_period) + ' ' + std::to_string(machine.spindle->seed) + '\n';
}

/// Codes of what a program's reader finds, in order.
inline std::string problems_of(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  std::string codes;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {},
                       [&](const base::Diagnostic& problem) { codes += std::string(problem.code) + ' '; });
  for (gcode::Move move; reader.next(move);) {
  }
  return codes;
}

/// The spindle as it has turned up to each word, from the events alone; in a tap with what brakes it.
class SpindleOfEvents {
 public:
  explicit SpindleOfEvents(const machine::Machine& machine) : spindle_(*machine.spindle), period_(machine.period) {}

  /// Revolutions the way it was told to turn, at a word.
  double at(std::int64_t tick) const { return way_ * clockwise_at(tick); }
  double clockwise_at(std::int64_t tick) const { return spindle_.revolutions(time(tick)); }
  double way() const { return way_; }
  bool is_at_speed(std::int64_t tick) const { return spindle_.is_at_speed(time(tick)); }
  bool stands(std::int64_t tick) const { return spindle_.stands(time(tick)); }
  double speed(std::int64_t tick) const { return spindle_.speed(time(tick)); }
  /// Does an index pass between this word and the next?
  bool passes_index(std::int64_t tick) const { return std::floor(at(tick + 1)) > std::floor(at(tick)); }

  /// tap_acceleration: revolutions per s², of events in a tap.
  void obey(const base::PassedEvent& event, double tap_acceleration = 1e9) {
    using Kind = base::Event::Kind;
    const double t = time(base::count(event.tick));
    if (event.kind == Kind::spindle_clockwise || event.kind == Kind::spindle_counterclockwise) {
      way_ = event.kind == Kind::spindle_clockwise ? 1 : -1;
      spindle_.turn(way_ * event.value, t, tap_acceleration);
    } else if (event.kind == Kind::spindle_speed) {
      spindle_.turn(way_ * event.value, t);
    } else if (event.kind == Kind::program_end || event.kind == Kind::spindle_stop ||
               event.kind == Kind::spindle_orientation || event.kind == Kind::tool_change) {
      spindle_.turn(0, t);
    }
  }
  /// As SpindleMotion::stand_at(), between a word and the next.
  void stand_at(double clockwise, std::int64_t tick, double acceleration) {
    spindle_.stand_at(clockwise, time(tick), time(tick + 1), acceleration);
  }
  double seconds() const { return period_.seconds(); }

 private:
  double time(std::int64_t tick) const { return static_cast<double>(tick) * seconds(); }

  interpolator::SpindleMotion spindle_;
  base::Period period_;
  double way_ = 0;
};

}  // namespace leadscrew::testing_support
