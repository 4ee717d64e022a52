#pragma once
// The parameters that tell a program what the reader and the machine are doing: names such as #<_x> and #<_metric>, and
// numbers such as #5420 (LinuxCNC manual, "Predefined Named Parameters", "System Parameters" and "Numbered
// Parameters"). A program reads them and cannot set them.

#include <functional>
#include <leadscrew/gcode/part.hpp>
#include <optional>
#include <string_view>

namespace leadscrew::gcode {

/// The code that selects this plane.
Code plane_code(Plane plane);

class Predefined : Part {
 public:
  /// What the context holds must outlive it.
  explicit Predefined(const Context& context) : Part(context) {}

  /// Called before a place is told that rotary axes have a part in: they may not be known until then.
  void before_rotary(std::function<void()> settle) { settle_ = std::move(settle); }

  /// The value of a name, in capitals and without blanks; std::nullopt where it is not predefined.
  std::optional<double> get(std::string_view name) const;
  /// The value of a number; std::nullopt where it is not predefined.
  std::optional<double> get(int number) const {
    return number < first_number || number > last_number ? std::nullopt : of_number(number);
  }

  /// The first number of Fanuc's system variables.
  static constexpr int first_macro_number = 1000;
  /// The value of one of them; std::nullopt where it is not read.
  std::optional<double> of_macro(int number) const;
  /// Whether a program may set a system variable: offsets.
  static bool is_macro_offset(int number);

  /// Whether a program must not set it.
  static bool is_read_only(std::string_view name);
  static bool is_read_only(int number);
  /// A name of the host's settings, which no program can set: `_ini[section]name`, `_hal[pin]`.
  static bool is_of_host(std::string_view name);

  /// What a row of the table of names tells.
  double position(base::Axis axis) const;          ///< of the program's coordinates, in its units
  double machine_position(base::Axis axis) const;  ///< of the machine's, in the program's units
  bool has_tool_offset() const;                    ///< whether any axis has one
  int pocket_of(int tool) const;                   ///< in the tool table; 0 where it has none
  const ModalState& modal() const { return modal_; }
  const Frame& frame() const { return frame_; }
  const Parameters& parameters() const { return parameters_; }
  base::Line line() const { return reporter_.line(); }  ///< being read

 private:
  static constexpr int first_number = 5021;
  static constexpr int last_number = 5428;
  std::optional<double> of_number(int number) const;
  double tool_number(int number) const;

  std::function<void()> settle_;
};

}  // namespace leadscrew::gcode
