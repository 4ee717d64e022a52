#include <algorithm>
#include <cmath>
#include <leadscrew/referee/pose.hpp>
#include <numbers>

namespace leadscrew::referee {

namespace {

machine::Vector cross(const machine::Vector& a, const machine::Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of whole quarters exactly what it is.
double half_of(double degrees) {
  return std::remainder(degrees, 720) * (std::numbers::pi / 360);
}

}  // namespace

Pose::Pose(const machine::Machine& machine) {
  if (!machine.rotary_chain) return;
  has_chain_ = true;
  gauge_ = machine.rotary_chain->tool_zero;
  std::array<machine::RotaryAxis, 2> axes = machine.rotary_chain->axes;
  std::sort(axes.begin(), axes.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
  for (const machine::RotaryAxis& each : axes) {
    const Turn turn{base::index(each.axis), each.direction, each.point, static_cast<double>(each.sign)};
    if (each.carries == machine::Carries::tool) {
      of_tool_.insert(of_tool_.begin(), turn);
    } else {
      of_workpiece_.push_back(turn);
    }
  }
}

/// By the unit quaternion (cos φ/2, e sin φ/2): v + 2w(u × v) + 2 u × (u × v).
machine::Vector Pose::rotated(const Turn& turn, double degrees, const machine::Vector& vector) {
  const double half = half_of(turn.sign * degrees), w = std::cos(half), s = std::sin(half);
  const double size = std::hypot(turn.direction[0], turn.direction[1], turn.direction[2]);
  machine::Vector u;
  for (std::size_t i = 0; i < 3; ++i) u[i] = s * turn.direction[i] / size;
  const machine::Vector once = cross(u, vector), twice = cross(u, once);
  machine::Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = vector[i] + 2 * (w * once[i] + twice[i]);
  return result;
}

/// The same about the axis where it lies.
machine::Vector Pose::turned(const Turn& turn, double degrees, const machine::Vector& place) {
  machine::Vector v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = place[i] - turn.point[i];
  const machine::Vector there = rotated(turn, degrees, v);
  machine::Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = place[i] + (there[i] - v[i]);
  return result;
}

machine::Vector Pose::direction_of(const base::AxisVector& axes) const {
  machine::Vector direction = {0, 0, 1};
  for (const Turn& turn : of_tool_) direction = rotated(turn, axes[turn.axis], direction);
  for (const Turn& turn : of_workpiece_) direction = rotated(turn, -axes[turn.axis], direction);
  return direction;
}

/// 2 atan(|a − b|/|a + b|): exact to rounding however small or near to 180° it is.
double angle_between(const machine::Vector& a, const machine::Vector& b) {
  const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const double together = std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
  return 2 * std::atan2(apart, together) * (180 / std::numbers::pi);
}

base::AxisVector Pose::tip_of(const base::AxisVector& axes, const std::array<double, 3>& tool) const {
  base::AxisVector pose = axes;
  if (!has_chain_) return pose;
  machine::Vector tip;
  for (std::size_t i = 0; i < 3; ++i) tip[i] = gauge_[i] - tool[i];
  for (const Turn& turn : of_tool_) tip = turned(turn, axes[turn.axis], tip);
  for (std::size_t i = 0; i < 3; ++i) tip[i] += axes[i] - gauge_[i];
  for (const Turn& turn : of_workpiece_) tip = turned(turn, -axes[turn.axis], tip);
  std::copy(tip.begin(), tip.end(), pose.begin());
  return pose;
}

}  // namespace leadscrew::referee
