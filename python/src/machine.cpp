// Machine: of a file's text, changed in some of its values, and its kinematics.

#include <pybind11/stl.h>

#include <cmath>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/machine/machine.hpp>
#include <limits>

#include "arrays.hpp"
#include "bindings.hpp"
#include "problems.hpp"

namespace leadscrew::python {

namespace {

machine::Machine read_machine(const std::string& text, const std::string& file) {
  auto machine = config::read_machine(text, file);
  if (!machine) raise(machine.error());
  return std::move(*machine);
}

std::string axes_of_machine(const machine::Machine& machine) {
  std::string letters;
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) letters += base::letter(axis);
  }
  return letters;
}

/// Of all nine axes; 0 of those that it lacks.
Numbers limits_of(const machine::Machine& machine, double machine::AxisLimits::* limit) {
  base::AxisVector values{};
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) values[base::index(axis)] = machine.limits(axis).*limit;
  }
  return array_of(values);
}

constexpr std::pair<const char*, double machine::AxisLimits::*> limits[] = {
    {"travel_min", &machine::AxisLimits::travel_min},
    {"travel_max", &machine::AxisLimits::travel_max},
    {"velocity", &machine::AxisLimits::velocity},
    {"acceleration", &machine::AxisLimits::acceleration},
    {"jerk", &machine::AxisLimits::jerk},
    {"blu", &machine::AxisLimits::blu}};

void put_limits(machine::Machine& machine, double machine::AxisLimits::* limit, const base::AxisVector& values) {
  for (const base::Axis axis : base::all_axes) {
    const double value = values[base::index(axis)];
    if (machine.has(axis) && !std::isnan(value)) (*machine.axes[base::index(axis)]).*limit = value;
  }
}

/// One number for the drive of every axis, as its machine file's keys have it.
void put_into_drives(machine::Machine& machine, const py::dict& loops) {
  using Drive = machine::AxisDrive;
  const std::pair<const char*, std::optional<double> Drive::*> numbers[] = {
      {"position_gain", &Drive::position_gain},
      {"velocity_gain", &Drive::velocity_gain},
      {"velocity_integral", &Drive::velocity_integral},
      {"proportional", &Drive::proportional},
      {"integral", &Drive::integral},
      {"derivative", &Drive::derivative},
      {"gain", &Drive::gain},
      {"time_constant", &Drive::time_constant},
      {"velocity_forward", &Drive::velocity_forward},
      {"acceleration_forward", &Drive::acceleration_forward}};
  for (Drive& drive : machine.drives) {
    for (const auto& [name, number] : numbers) {
      if (loops.contains(name)) drive.*number = loops[name].cast<double>();
    }
    if (loops.contains("controller")) {
      const bool is_pid = loops["controller"].cast<std::string>() == "pid";
      drive.controller = is_pid ? Drive::Controller::pid : Drive::Controller::cascade;
    }
  }
}

/// Another machine, with these values in place of its own.
machine::Machine changed(const machine::Machine& from, const py::dict& values) {
  machine::Machine machine = from;
  for (const auto& [name, limit] : limits) {
    if (values.contains(name)) put_limits(machine, limit, axes_of(values[name].cast<Numbers>()));
  }
  if (values.contains("name")) machine.name = values["name"].cast<std::string>();
  if (values.contains("period_ns")) machine.period = {values["period_ns"].cast<std::int64_t>()};
  if (values.contains("tolerance")) machine.tolerance = values["tolerance"].cast<double>();
  if (values.contains("chord_error")) machine.chord_error = values["chord_error"].cast<double>();
  if (values.contains("smoothing")) {
    const bool is_least_time = values["smoothing"].cast<std::string>() == "least-time";
    machine.smoothing = is_least_time ? machine::Smoothing::least_time : machine::Smoothing::splines;
  }
  if (values.contains("dialect")) {
    const auto wanted = values["dialect"].cast<std::string>();
    for (std::size_t i = 0; i < machine::dialect_names.size(); ++i) {
      if (machine::dialect_names[i] == wanted) machine.dialect = static_cast<machine::Dialect>(i);
    }
  }
  if (values.contains("loops")) put_into_drives(machine, values["loops"]);
  if (const auto problems = machine::validate(machine); !problems.empty()) raise(problems);
  return machine;
}

kinematics::Chain chain_of(const machine::Machine& machine) {
  if (!machine.rotary_chain) {
    throw py::value_error("machine " + machine.name +
                          " is cartesian: expected one with a chain of rotary axes, such as table-table-ac.toml");
  }
  return kinematics::chain_of(machine);
}

kinematics::Vector vector_at(const Numbers& rows, std::size_t i) {
  const double* const at = rows.data() + 3 * i;
  return {at[0], at[1], at[2]};
}

/// Tips and directions, n × 3 each, while axes, n × 9, are there.
std::pair<Numbers, Numbers> forward(const machine::Machine& machine, const Numbers& axes, const Numbers& tool) {
  const kinematics::Chain chain = chain_of(machine);
  const auto count = static_cast<std::size_t>(axes.shape(0));
  Numbers tips = new_numbers(count, 3), directions = new_numbers(count, 3);
  double *tip = tips.mutable_data(), *direction = directions.mutable_data();
  const kinematics::Vector offset = vector_at(tool, 0);
  const double* const first = axes.data();
  const py::gil_scoped_release release;
  for (std::size_t i = 0; i < count; ++i) {
    base::AxisVector at;
    std::copy_n(first + base::axis_count * i, at.size(), at.begin());
    const auto pose = kinematics::pose_of(chain, at, offset);
    const auto along = kinematics::direction_of(chain, kinematics::angles_of(chain, at));
    for (std::size_t k = 0; k < 3; ++k) *tip++ = pose[k], *direction++ = along[k];
  }
  return {tips, directions};
}

/// Both pairs of angles that hold the tool there, n × 2 × 9; NaN where there is none.
Numbers inverse(const machine::Machine& machine, const Numbers& tips, const Numbers& directions, const Numbers& tool) {
  const kinematics::Chain chain = chain_of(machine);
  const auto count = static_cast<std::size_t>(tips.shape(0));
  Numbers found({static_cast<py::ssize_t>(count), py::ssize_t{2}, static_cast<py::ssize_t>(base::axis_count)});
  double* to = found.mutable_data();
  const kinematics::Vector offset = vector_at(tool, 0);
  const py::gil_scoped_release release;
  for (std::size_t i = 0; i < count; ++i) {
    const auto solutions = kinematics::solutions<double>(chain, vector_at(directions, i));
    for (std::size_t k = 0; k < 2; ++k) {
      base::AxisVector axes;
      axes.fill(std::numeric_limits<double>::quiet_NaN());
      if (k < solutions.count) {
        axes.fill(0);
        const kinematics::Vector tip = vector_at(tips, i);
        std::copy(tip.begin(), tip.end(), axes.begin());
        for (std::size_t turn = 0; turn < 2; ++turn)
          axes[base::index(chain.turns()[turn].axis)] = solutions.angles[k][turn];
        axes = kinematics::machine_of(chain, axes, offset);
      }
      to = std::copy(axes.begin(), axes.end(), to);
    }
  }
  return found;
}

}  // namespace

void bind_machine(py::module_& module) {
  py::class_<machine::Machine>(module, "Machine")
      .def_static("builtin", &machine::mill3)
      .def_static("of_text", &read_machine, py::arg("text"), py::arg("file"))
      .def_readonly("name", &machine::Machine::name)
      .def_readonly("tolerance", &machine::Machine::tolerance)
      .def_readonly("chord_error", &machine::Machine::chord_error)
      .def_readonly("kinematics", &machine::Machine::kinematics)
      .def_property_readonly("period_ns", [](const machine::Machine& machine) { return machine.period.nanoseconds; })
      .def_property_readonly("axes", &axes_of_machine)
      .def("limits",
           [](const machine::Machine& machine) {
             py::dict all;
             for (const auto& [name, limit] : limits) all[name] = limits_of(machine, limit);
             return all;
           })
      .def("changed", &changed, py::arg("values"))
      .def("forward", &forward, py::arg("axes"), py::arg("tool"))
      .def("inverse", &inverse, py::arg("tips"), py::arg("directions"), py::arg("tool"));
}

}  // namespace leadscrew::python
