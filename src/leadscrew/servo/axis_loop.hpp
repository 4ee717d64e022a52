#pragma once
// A position loop, period by period: read the encoder, make a command, hold it.
//
//   Setpoint ─▶ Controller ─u─▶ SimulatedAxis ─▶ slide
//                   ▲                  │
//                   └───── reading ────┘

#include <leadscrew/servo/cascade.hpp>
#include <leadscrew/servo/pid.hpp>
#include <leadscrew/servo/simulated_axis.hpp>
#include <utility>
#include <variant>

namespace leadscrew::servo {

using Controller = std::variant<Pid, Cascade>;

class AxisLoop {
 public:
  /// period: seconds, > 0; the one the controller was made for.
  AxisLoop(SimulatedAxis axis, Controller controller, double period)
      : axis_(std::move(axis)), controller_(std::move(controller)), period_(period) {}

  /// One period. No allocation, no unbounded loop.
  void follow(const Setpoint& setpoint) {
    const double reading = axis_.reading();
    // Not std::visit, whose call goes through a table of pointers.
    if (Pid* const pid = std::get_if<Pid>(&controller_)) {
      command_ = pid->command(setpoint, reading);
    } else if (Cascade* const cascade = std::get_if<Cascade>(&controller_)) {
      command_ = cascade->command(setpoint, reading);
    }
    current_ = axis_.current(command_);
    axis_.advance(command_, period_);
  }

  const SimulatedAxis& axis() const { return axis_; }
  /// That of the last period, units; what the axis' own limit leaves of it is the axis' affair.
  double command() const { return command_; }
  /// Of the motor as that command was given (SimulatedAxis::current), mm/s².
  double current() const { return current_; }

 private:
  SimulatedAxis axis_;
  Controller controller_;
  double period_;
  double command_ = 0, current_ = 0;
};

}  // namespace leadscrew::servo
