#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/tilted_plane.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>

namespace leadscrew::gcode {

double sine_of_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);
  if (std::fmod(within, 90.0) == 0) {
    const int quarter = static_cast<int>(within / 90.0);
    return quarter % 2 == 0 ? 0.0 : (quarter == 1 || quarter == -3) ? 1.0 : -1.0;
  }
  return numeric::sin(within * (std::numbers::pi / 180));
}

double cosine_of_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);
  if (std::fmod(within, 90.0) == 0) {
    const int quarter = static_cast<int>(within / 90.0);
    return quarter % 2 != 0 ? 0.0 : quarter == 0 ? 1.0 : -1.0;
  }
  return numeric::cos(within * (std::numbers::pi / 180));
}

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

constexpr Matrix3 identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

Matrix3 turn(double degrees, std::size_t first, std::size_t second) {
  Matrix3 result = identity;
  result[first][first] = result[second][second] = cosine_of_degrees(degrees);
  result[second][first] = sine_of_degrees(degrees);
  result[first][second] = -sine_of_degrees(degrees);
  return result;
}

}  // namespace

Frame::Matrix Frame::inverse_of(const Matrix& m) {
  Matrix cofactors{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactors[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
  const double determinant = m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = cofactors[j][i] / determinant;
  }
  return result;
}

// Of X, Y and Z; the others as they are.
base::AxisVector Frame::times(const Matrix& matrix, const base::AxisVector& vector) {
  base::AxisVector result = vector;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = matrix[i][0] * vector[0] + matrix[i][1] * vector[1] + matrix[i][2] * vector[2];
  }
  return result;
}

void Frame::combine() {
  if (plane_) return combine_tilted();
  const Matrix rotation = turn(system_.rotation, 0, 1);
  matrix_ = product(rotation, transform_matrix_);
  offset_only_ = matrix_ == identity;
  inverse_ = offset_only_ ? identity : inverse_of(matrix_);
  base::AxisVector inner = shift_;
  for (std::size_t i = 0; i < 3; ++i) inner[i] += transform_offset_[i];
  const base::AxisVector turned = system_.rotation == 0 ? inner : times(rotation, inner);
  for (std::size_t i = 0; i < base::axis_count; ++i) offset_[i] = system_.origin[i] + turned[i] + tool_[i];
  for (std::size_t i = 0; tip_control_ && i < 3; ++i) offset_[i] -= tool_[i];
}

base::AxisVector Frame::axes_of(const base::AxisVector& place) const {
  return tip_control_ ? tip_control_->axes_of(place) : place;
}

void Frame::begin_tip_control(const machine::Machine& machine) {
  tip_control_ = std::make_shared<const kinematics::Transformation>(
      kinematics::Transformation{kinematics::chain_of(machine), {tool_[0], tool_[1], tool_[2]}});
  position = tip_control_->tip_of(position);
  combine();
}

void Frame::end_tip_control() {
  position = axes_of(position);
  tip_control_ = nullptr;
  takes_vectors_ = false;
  combine();
}

void Frame::set_system(const CoordinateSystem& system) {
  system_ = system;
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

// Q(p) = c' + T(c + S(M(p) − c) − c') with c' = c + S(M(t) − c), for the mirror M, the scaling S about c, and the turn T
// about t.
void Frame::set_transform(const ProgramTransform& transform) {
  transform_ = transform;
  Matrix scaling{};
  std::array<double, 3> offset{}, about{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mirror = transform.mirrored[i] ? -1 : 1;
    const double mirrored_zero = transform.mirrored[i] ? 2 * transform.mirror_at[i] : 0;
    scaling[i][i] = transform.scale[i] * mirror;
    offset[i] = transform.scale_about[i] + transform.scale[i] * (mirrored_zero - transform.scale_about[i]);
    about[i] = scaling[i][i] * transform.turn_about[i] + offset[i];
  }
  const Matrix turning = turn(transform.angle, transform.first, transform.second);
  transform_matrix_ = product(turning, scaling);
  for (std::size_t i = 0; i < 3; ++i) {
    transform_offset_[i] = about[i];
    for (std::size_t k = 0; k < 3; ++k) transform_offset_[i] += turning[i][k] * (offset[k] - about[k]);
  }
  combine();
}

bool Frame::is_separate(base::Axis axis) const {
  const std::size_t i = base::index(axis);
  if (i >= 3) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k != i && (matrix_[i][k] != 0 || matrix_[k][i] != 0)) return false;
  }
  return true;
}

double Frame::scale(base::Axis axis) const {
  const std::size_t i = base::index(axis);
  return i < 3 ? matrix_[i][i] : 1;
}

double Frame::circle_scale(base::Axis first, base::Axis second) const {
  const std::size_t a = base::index(first), b = base::index(second);
  if (!is_separate(base::all_axes[3 - a - b])) return 0;
  const double along = matrix_[a][a] * matrix_[a][a] + matrix_[b][a] * matrix_[b][a];
  const double determinant = matrix_[a][a] * matrix_[b][b] - matrix_[a][b] * matrix_[b][a];
  const double across = matrix_[a][b] * matrix_[a][b] + matrix_[b][b] * matrix_[b][b];
  const double slant = matrix_[a][a] * matrix_[a][b] + matrix_[b][a] * matrix_[b][b];
  constexpr double rounding = 1e-12;
  if (std::fabs(along - across) > rounding * along || std::fabs(slant) > rounding * along) return 0;
  return std::copysign(std::sqrt(along), determinant);
}

base::AxisVector Frame::to_program(const base::AxisVector& machine) const {
  base::AxisVector program;
  for (std::size_t i = 0; i < base::axis_count; ++i) program[i] = machine[i] - offset_[i];
  return offset_only_ ? program : times(inverse_, program);
}

base::AxisVector Frame::to_machine(const base::AxisVector& program) const {
  base::AxisVector machine = direction_to_machine(program);
  for (std::size_t i = 0; i < base::axis_count; ++i) machine[i] += offset_[i];
  return machine;
}

base::AxisVector Frame::direction_to_machine(const base::AxisVector& program) const {
  return offset_only_ ? program : times(matrix_, program);
}

base::AxisVector Frame::transformed(const base::AxisVector& program) const {
  base::AxisVector result = times(transform_matrix_, program);
  for (std::size_t i = 0; i < 3; ++i) result[i] += transform_offset_[i];
  return result;
}

}  // namespace leadscrew::gcode
