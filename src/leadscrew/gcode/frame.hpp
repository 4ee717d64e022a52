#pragma once
// From coordinates of the program to those of the machine.
//
//     machine = R(Q(program) + shift) + origin + tool
//
// origin and R, a turn about Z, belong to the coordinate system in force (G54 … G59.3, G10 L2), shift to G92, tool to
// G43 (LinuxCNC, "Coordinate Systems": the G92 offset turns with the system). Q is what a program does to its own
// coordinates: mirror, scaling, turn (G51.1, G51, G68), in this order (Fanuc).
//
// In a tilted working plane (G68.2) the program's coordinates, behind Q, are those of the plane T, and the rest is the
// machine's kinematics for the rotary axes as they stand:
//
//     tip in the workpiece = R(T(Q(program)) + shift) + origin        machine = axes that hold the tip there, with the tool

#include <array>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <memory>

namespace leadscrew::kinematics {
struct Transformation;
}
namespace leadscrew::machine {
struct Machine;
}

namespace leadscrew::gcode {

struct PlaneInForce;
struct TiltedPlane;

/// An origin and a turn about Z.
struct CoordinateSystem {
  base::AxisVector origin{};  ///< mm or degrees, machine coordinates
  double rotation = 0;        ///< degrees, counterclockwise as seen from +Z
};

/// Mirror, scaling and turn of a program's X, Y and Z, in this order. mm and degrees.
struct ProgramTransform {
  std::array<bool, 3> mirrored{};
  std::array<double, 3> mirror_at{};
  std::array<double, 3> scale = {1, 1, 1};  ///< ≠ 0
  std::array<double, 3> scale_about{};
  double angle = 0;  ///< counterclockwise, from `first` to `second`
  std::size_t first = 0, second = 1;
  std::array<double, 3> turn_about{};  ///< scaled as other coordinates are
};

class Frame {
 public:
  base::AxisVector position{};  ///< where the program stands: machine coordinates, mm or degrees
  double length_unit = 1;       ///< mm in a unit of the program's length words: 1 or 25.4

  /// How many mm or degrees one unit of an axis word is.
  double unit(base::Axis axis) const { return base::is_rotary(axis) ? 1.0 : length_unit; }

  const CoordinateSystem& system() const { return system_; }
  const base::AxisVector& shift() const { return shift_; }
  const base::AxisVector& tool() const { return tool_; }
  void set_system(const CoordinateSystem& system);
  void set_shift(const base::AxisVector& shift);
  void set_tool(const base::AxisVector& tool);

  /// Tool centre point control: "machine coordinates" of X, Y and Z are those of the tool's tip in the workpiece, and the
  /// tool is not added to them. nullptr: they are the axes'.
  const kinematics::Transformation* tip_control() const { return tip_control_.get(); }
  /// Of the tool in force; the position stays the same place of the axes.
  void begin_tip_control(const machine::Machine& machine);
  void end_tip_control();
  /// G43.5: I, J and K of lines are the tool's direction; also where the machine cannot follow it.
  bool takes_vectors() const { return takes_vectors_; }
  void take_vectors() { takes_vectors_ = true; }
  /// Where the axes are while the program stands at a place.
  base::AxisVector axes_of(const base::AxisVector& place) const;

  /// A tilted working plane, of a machine with a chain of rotary axes. The position stays the same place.
  [[gnu::cold]] void begin_tilted_plane(const TiltedPlane& plane, const machine::Machine& machine);
  [[gnu::cold]] void end_tilted_plane();
  bool is_tilted() const { return plane_ != nullptr; }
  const PlaneInForce* tilted_plane() const { return plane_.get(); }
  /// In a tilted plane, after the position of a rotary axis has changed.
  [[gnu::cold]] void follow_rotary_axes() { combine(); }
  /// Of a tilted plane, seen from the workpiece as it lies with all rotary axes at 0: a unit vector.
  std::array<double, 3> plane_normal() const;
  /// In a tilted plane, or under tool centre point control: does the tool, from its tip to the spindle, point along the program's axis, within 1e-4 rad?
  bool is_tool_along(base::Axis axis) const;

  const ProgramTransform& transform() const { return transform_; }
  void set_transform(const ProgramTransform& transform);

  /// Whether machine coordinates are those of the program and offset(), and no more.
  bool is_offset_only() const { return offset_only_; }
  /// Where the program's zero is, machine coordinates.
  const base::AxisVector& offset() const { return offset_; }
  /// Whether an axis of X, Y and Z goes by itself: its coordinate depends on no other.
  bool is_separate(base::Axis axis) const;
  /// What one unit of the program is along the axis where it goes by itself: its scale, or 1.
  double scale(base::Axis axis) const;
  /// How lengths in a plane of two of X, Y and Z are scaled where circles remain circles of the same plane; 0 where they do not. Negative
  /// where they turn the other way.
  double circle_scale(base::Axis first, base::Axis second) const;

  /// Coordinates of the program, mm or degrees, from those of the machine, and back.
  base::AxisVector to_program(const base::AxisVector& machine) const;
  base::AxisVector to_machine(const base::AxisVector& program) const;
  /// The same of a difference of two places: without offsets.
  base::AxisVector direction_to_machine(const base::AxisVector& program) const;
  /// Coordinates of the program with Q done to them: those that shift and origin are added to.
  base::AxisVector transformed(const base::AxisVector& program) const;

 private:
  void combine();
  [[gnu::cold]] void combine_tilted();

  using Matrix = std::array<std::array<double, 3>, 3>;

  static base::AxisVector times(const Matrix& matrix, const base::AxisVector& vector);
  static Matrix inverse_of(const Matrix& matrix);

  CoordinateSystem system_;
  ProgramTransform transform_;
  base::AxisVector shift_{};
  base::AxisVector tool_{};
  std::shared_ptr<const kinematics::Transformation> tip_control_;
  bool takes_vectors_ = false;
  std::shared_ptr<const PlaneInForce> plane_;
  // Q(p) = transform_matrix_ p + transform_offset_; machine = matrix_ p + offset_; p = inverse_ (machine − offset_), of
  // X, Y and Z.
  Matrix transform_matrix_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> transform_offset_{};
  Matrix matrix_ = transform_matrix_;
  Matrix inverse_ = transform_matrix_;
  base::AxisVector offset_{};
  bool offset_only_ = true;
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
double sine_of_degrees(double degrees);
double cosine_of_degrees(double degrees);

}  // namespace leadscrew::gcode
