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

}  // namespace leadscrew::gcode
