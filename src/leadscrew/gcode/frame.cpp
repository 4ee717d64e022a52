#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t x_axis = base::index(base::Axis::X);
constexpr std::size_t y_axis = base::index(base::Axis::Y);

void turn(double sine, double cosine, double& x, double& y) {
  const double turned = cosine * x - sine * y;
  y = sine * x + cosine * y;
  x = turned;
}

// First parameter of a coordinate system; the tenth is its rotation.
int first_of_system(int number) {
  return 5201 + 20 * number;
}

}  // namespace

double sine_of_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);
  if (std::fmod(within, 90.0) == 0) {
    const int quarter = static_cast<int>(within / 90.0);
    return quarter % 2 == 0 ? 0.0 : (quarter == 1 || quarter == -3) ? 1.0 : -1.0;
  }
  return std::sin(within * (std::numbers::pi / 180));
}

double cosine_of_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);
  if (std::fmod(within, 90.0) == 0) {
    const int quarter = static_cast<int>(within / 90.0);
    return quarter % 2 != 0 ? 0.0 : quarter == 0 ? 1.0 : -1.0;
  }
  return std::cos(within * (std::numbers::pi / 180));
}

void Frame::combine() {
  for (std::size_t i = 0; i < base::axis_count; ++i) sum_[i] = system_.origin[i] + shift_[i] + tool_[i];
}

void Frame::set_system(const CoordinateSystem& system) {
  system_ = system;
  sine_ = sine_of_degrees(system.rotation);
  cosine_ = cosine_of_degrees(system.rotation);
  combine();
}

void Frame::set_shift(const base::AxisVector& shift) {
  shift_ = shift;
  combine();
}

void Frame::set_tool(const base::AxisVector& tool) {
  tool_ = tool;
  combine();
}

void Frame::rotate(double& x, double& y) const {
  turn(sine_, cosine_, x, y);
}

base::AxisVector Frame::to_program(const base::AxisVector& machine) const {
  base::AxisVector program;
  if (!is_rotated()) {
    for (std::size_t i = 0; i < base::axis_count; ++i) program[i] = machine[i] - sum_[i];
    return program;
  }
  for (std::size_t i = 0; i < base::axis_count; ++i) program[i] = machine[i] - system_.origin[i] - tool_[i];
  turn(-sine_, cosine_, program[x_axis], program[y_axis]);
  for (std::size_t i = 0; i < base::axis_count; ++i) program[i] -= shift_[i];
  return program;
}

base::AxisVector Frame::to_machine(const base::AxisVector& program) const {
  base::AxisVector machine;
  if (!is_rotated()) {
    for (std::size_t i = 0; i < base::axis_count; ++i) machine[i] = program[i] + sum_[i];
    return machine;
  }
  for (std::size_t i = 0; i < base::axis_count; ++i) machine[i] = program[i] + shift_[i];
  turn(sine_, cosine_, machine[x_axis], machine[y_axis]);
  for (std::size_t i = 0; i < base::axis_count; ++i) machine[i] += system_.origin[i] + tool_[i];
  return machine;
}

Parameters::Parameters() {
  const base::AxisVector zero{};
  set_axes(g28_home, zero);
  set_axes(g30_home, zero);
  set(g92_active, 0);
  set_axes(g92_shift, zero);
  set(current_system, 1);
  for (int system = 1; system <= 9; ++system) set_system(system, {});
}

std::optional<double> Parameters::get(int number) const {
  const auto i = static_cast<std::size_t>(number);
  return given_[i] ? std::optional<double>(numbered_[i]) : std::nullopt;
}

void Parameters::set(int number, double value) {
  const auto i = static_cast<std::size_t>(number);
  numbered_[i] = value;
  given_[i] = true;
}

std::optional<double> Parameters::get(const std::string& name) const {
  const auto found = named_.find(name);
  return found == named_.end() ? std::nullopt : std::optional<double>(found->second);
}

bool Parameters::set(const std::string& name, double value) {
  const auto found = named_.find(name);
  if (found != named_.end()) {
    found->second = value;
    return true;
  }
  if (named_.size() >= most_names) return false;
  named_.emplace(name, value);
  return true;
}

base::AxisVector Parameters::axes(int first) const {
  base::AxisVector value;
  for (std::size_t i = 0; i < base::axis_count; ++i) value[i] = numbered_[static_cast<std::size_t>(first) + i];
  return value;
}

void Parameters::set_axes(int first, const base::AxisVector& value) {
  for (std::size_t i = 0; i < base::axis_count; ++i) set(first + static_cast<int>(i), value[i]);
}

CoordinateSystem Parameters::system(int number) const {
  const int first = first_of_system(number);
  return {axes(first), numbered_[static_cast<std::size_t>(first) + base::axis_count]};
}

void Parameters::set_system(int number, const CoordinateSystem& system) {
  const int first = first_of_system(number);
  set_axes(first, system.origin);
  set(first + static_cast<int>(base::axis_count), system.rotation);
}

}  // namespace leadscrew::gcode
