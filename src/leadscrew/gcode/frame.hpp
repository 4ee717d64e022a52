#pragma once
// From coordinates of the program to those of the machine.
//
//     machine = R(program + shift) + origin + tool
//
// origin and R, a turn about Z, belong to the coordinate system in force (G54 … G59.3, G10 L2), shift to G92, tool to
// G43 (LinuxCNC, "Coordinate Systems": the G92 offset turns with the system).

#include <cstddef>
#include <leadscrew/base/axes.hpp>

namespace leadscrew::gcode {

/// An origin and a turn about Z.
struct CoordinateSystem {
  base::AxisVector origin{};  ///< mm or degrees, machine coordinates
  double rotation = 0;        ///< degrees, counterclockwise as seen from +Z
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

  bool is_rotated() const { return sine_ != 0 || cosine_ != 1; }
  /// origin + shift + tool: all there is between program and machine where nothing is rotated.
  const base::AxisVector& sum() const { return sum_; }

  /// Coordinates of the program, mm or degrees, from those of the machine, and back.
  base::AxisVector to_program(const base::AxisVector& machine) const;
  base::AxisVector to_machine(const base::AxisVector& program) const;
  /// Turns a vector from the program's X and Y to the machine's.
  void rotate(double& x, double& y) const;

 private:
  void combine();

  CoordinateSystem system_;
  base::AxisVector shift_{};
  base::AxisVector tool_{};
  base::AxisVector sum_{};
  double sine_ = 0;
  double cosine_ = 1;
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
double sine_of_degrees(double degrees);
double cosine_of_degrees(double degrees);

}  // namespace leadscrew::gcode
