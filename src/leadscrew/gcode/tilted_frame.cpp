// Coordinates in a tilted working plane.

#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/tilted_plane.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

using PlaneTurn = TiltedPlane::Matrix;
using PlacePoint = TiltedPlane::Vector;

PlacePoint product_of(const PlaneTurn& matrix, const PlacePoint& v) {
  PlacePoint result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  return result;
}

PlacePoint column_of(const PlaneTurn& matrix, std::size_t k) {
  return {matrix[0][k], matrix[1][k], matrix[2][k]};
}

void set_column(PlaneTurn& matrix, std::size_t k, const PlacePoint& v) {
  for (std::size_t i = 0; i < 3; ++i) matrix[i][k] = v[i];
}

PlacePoint turned_by_system(const CoordinateSystem& system, const PlacePoint& v) {
  const double c = cosine_of_degrees(system.rotation), s = sine_of_degrees(system.rotation);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

// What rotary axes that stand exactly leave of rounding, 1e-16, would keep an arc from being one of the machine. Of 1 m
// it is 1e-11 mm.
void straighten(PlaneTurn& matrix) {
  constexpr double rounding = 1e-14;
  for (std::size_t i = 0; i < 3; ++i) {
    double aside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != i) aside = std::fmax(aside, std::fmax(std::fabs(matrix[i][k]), std::fabs(matrix[k][i])));
    }
    if (aside > rounding) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != i) matrix[i][k] = matrix[k][i] = 0;
    }
    if (std::fabs(std::fabs(matrix[i][i]) - 1) < rounding) matrix[i][i] = std::copysign(1, matrix[i][i]);
  }
}

}  // namespace

void Frame::begin_tilted_plane(const TiltedPlane& plane, const machine::Machine& machine) {
  plane_ = std::make_shared<const PlaneInForce>(PlaneInForce{plane, kinematics::chain_of(machine)});
  combine();
}

void Frame::end_tilted_plane() {
  plane_ = nullptr;
  combine();
}

void Frame::combine_tilted() {
  const TiltedPlane& plane = plane_->plane;
  const auto angles = kinematics::angles_of(plane_->chain, position);
  for (std::size_t k = 0; k < 3; ++k) {
    PlacePoint axis = turned_by_system(system_, product_of(plane.turn, column_of(transform_matrix_, k)));
    if (!tip_control_) axis = kinematics::in_machine(plane_->chain, angles, axis);
    set_column(matrix_, k, axis);
  }
  straighten(matrix_);
  inverse_ = inverse_of(matrix_);
  PlacePoint zero = product_of(plane.turn, transform_offset_);
  for (std::size_t i = 0; i < 3; ++i) zero[i] += plane.origin[i] + shift_[i];
  zero = turned_by_system(system_, zero);
  base::AxisVector place = position;
  for (std::size_t i = 0; i < 3; ++i) place[i] = zero[i] + system_.origin[i];
  if (!tip_control_) place = kinematics::machine_of(plane_->chain, place, {tool_[0], tool_[1], tool_[2]});
  for (std::size_t i = 0; i < base::axis_count; ++i)
    offset_[i] = i < 3 ? place[i] : system_.origin[i] + shift_[i] + tool_[i];
  offset_only_ = false;
}

std::array<double, 3> Frame::plane_normal() const {
  return turned_by_system(system_, column_of(plane_->plane.turn, 2));
}

bool Frame::is_tool_along(base::Axis axis) const {
  constexpr double rounding = 1e-4;
  const PlacePoint column = column_of(transform_matrix_, base::index(axis));
  const PlacePoint wanted = turned_by_system(system_, plane_ ? product_of(plane_->plane.turn, column) : column);
  const kinematics::Chain& chain = plane_ ? plane_->chain : tip_control_->chain;
  const double length = numeric::hypot(wanted[0], wanted[1], wanted[2]);
  const auto held = kinematics::direction_of(chain, kinematics::angles_of(chain, position));
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) square += std::pow(wanted[i] / length - held[i], 2);
  return square < rounding * rounding;
}

}  // namespace leadscrew::gcode
