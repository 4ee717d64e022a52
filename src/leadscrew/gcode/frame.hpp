#pragma once
// From coordinates of the program to those of the machine, and the numbered parameters that keep the offsets between
// them.
//
//     machine = R(program + shift) + origin + tool
//
// origin and R, a turn about Z, belong to the coordinate system in force (G54 … G59.3, G10 L2), shift to G92, tool to
// G43 (LinuxCNC, "Coordinate Systems": the G92 offset turns with the system).

#include <array>
#include <bitset>
#include <cstddef>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

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

/// The parameters of a program: numbers 1 … 5602, and names. Offsets (5161 … 5390) are kept in mm and degrees, the
/// units of the machine, as LinuxCNC keeps them.
class Parameters {
 public:
  static constexpr int last = 5602;
  static constexpr std::size_t most_names = 10'000;
  static constexpr int g28_home = 5161;  ///< first of nine: axes X Y Z A B C U V W
  static constexpr int g30_home = 5181;
  static constexpr int g92_active = 5210;
  static constexpr int g92_shift = 5211;
  static constexpr int current_system = 5220;
  static constexpr int current_position = 5420;

  Parameters();

  std::optional<double> get(int number) const;  ///< std::nullopt where no value was ever given; 1 ≤ number ≤ last
  void set(int number, double value);
  std::optional<double> get(const std::string& name) const;
  /// False where there are too many names.
  bool set(const std::string& name, double value);

  static bool is_read_only(int number) {
    return number == current_system || (current_position <= number && number < current_position + 9);
  }

  /// Whether a parameter keeps a place or an offset.
  static bool is_offset(int number) { return g28_home <= number && number <= 5390; }

  base::AxisVector axes(int first) const;
  void set_axes(int first, const base::AxisVector& value);
  CoordinateSystem system(int number) const;  ///< 1 … 9: G54 … G59.3
  void set_system(int number, const CoordinateSystem& system);

 private:
  std::array<double, last + 1> numbered_{};
  std::bitset<last + 1> given_;
  std::unordered_map<std::string, double> named_;
};

}  // namespace leadscrew::gcode
