#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string_view>

namespace leadscrew::machine {

namespace {

using base::problem;
using base::text;

void check_limit(std::vector<base::Diagnostic>& problems, const base::Subject& limit, std::string_view what,
                 double value) {
  if (value > 0 && std::isfinite(value)) return;
  problems.push_back(
      problem("machine-limit",
              std::string("axis ") + base::letter(*limit.axis) + ": " + std::string(what) + " is " + text(value),
              "give a number above 0", limit));
}

void check_axis(std::vector<base::Diagnostic>& problems, base::Axis axis, const Machine& machine) {
  const AxisLimits& limits = machine.limits(axis);
  if (!(limits.travel_min < limits.travel_max) || !std::isfinite(limits.travel_min) ||
      !std::isfinite(limits.travel_max)) {
    problems.push_back(problem("machine-travel",
                               std::string("axis ") + base::letter(axis) + ": travel from " + text(limits.travel_min) +
                                   " to " + text(limits.travel_max),
                               "the first must be the smaller", {.axis = axis, .field = field::travel}));
  }
  check_limit(problems, {.axis = axis, .field = field::velocity}, "the greatest velocity", limits.velocity);
  check_limit(problems, {.axis = axis, .field = field::acceleration}, "the greatest acceleration", limits.acceleration);
  check_limit(problems, {.axis = axis, .field = field::jerk}, "the greatest jerk", limits.jerk);
  check_limit(problems, {.axis = axis, .field = field::blu}, "the basic length unit", limits.blu);
  check_step_times(axis, limits.step_times, problems);
  check_drive(axis, machine.drive(axis), problems);
}

void check_screws(std::vector<base::Diagnostic>& problems, const Machine& machine) {
  for (const base::Axis axis : base::all_axes) {
    check_screw(axis, machine.screw(axis), problems);
    if (machine.has(axis) || machine.screw(axis).none()) continue;
    problems.push_back(
        problem("pitch-axis", std::string("axis ") + base::letter(axis) + ": its screw has errors, but it is not there",
                "give errors for axes of the machine", {.axis = axis}));
  }
}

}  // namespace

Machine mill3() {
  Machine machine;
  machine.name = "mill3";
  const AxisLimits limits{
      .travel_min = -500, .travel_max = 500, .velocity = 200, .acceleration = 1000, .jerk = 20000, .blu = 0.001};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) machine.axes[base::index(axis)] = limits;
  return machine;
}

std::vector<base::Diagnostic> validate(const Machine& machine) {
  std::vector<base::Diagnostic> problems;
  check_kinematics(machine, problems);
  if (!base::is_valid(machine.period)) {
    problems.push_back(problem(
        "machine-period", "a servo period of " + text(static_cast<double>(machine.period.nanoseconds) / 1e3) + " us",
        "between 10 and 20000 us", {.field = field::period}));
  }
  if (!(machine.tolerance >= 0 && std::isfinite(machine.tolerance))) {
    problems.push_back(problem("machine-tolerance", "tolerance is " + text(machine.tolerance), "0 or more",
                               {.field = field::tolerance}));
  }
  if (!(machine.chord_error > 0 && std::isfinite(machine.chord_error))) {
    problems.push_back(problem("machine-chord-error", "chord error is " + text(machine.chord_error), "above 0",
                               {.field = field::chord_error}));
  }
  bool any = false;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    any = true;
    check_axis(problems, axis, machine);
  }
  check_screws(problems, machine);
  if (machine.laser) check_laser(*machine.laser, problems);
  if (machine.probe) check_probe(machine, problems);
  if (machine.spindle) check_spindle(*machine.spindle, problems);
  if (!any)
    problems.push_back(problem("machine-axes", "the machine has no axis", "give at least one, such as [axis.X]",
                               {.field = field::axes}));
  return problems;
}

}  // namespace leadscrew::machine
