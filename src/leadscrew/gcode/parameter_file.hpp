#pragma once
// The parameters that outlive a program, as LinuxCNC's .var files keep them (LinuxCNC manual, "Numbered Parameters
// Persistence"): a line for each, its number and its value, numbers ascending.
//
//     5161	0.5
//
// Kept are the places of G28 and G30, G92 (5210 … 5219), the coordinate system in force (5220) and all nine of them
// (5221 … 5390), and whatever other numbers stand in the file. Offsets are in mm and degrees.

#include <leadscrew/base/diagnostic.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::gcode {

/// A parameter and its value.
struct NumberedValue {
  int number = 0;    ///< 1 … Parameters::last
  double value = 0;  ///< finite

  friend bool operator==(const NumberedValue&, const NumberedValue&) = default;
};

/// What became of a text.
struct ParameterFileText {
  std::vector<NumberedValue> values;            ///< by ascending number; none where there are errors
  std::vector<base::Diagnostic> diagnostics{};  ///< in the order of the text
};

/// Reads the text of a parameter file; `file` is its name for diagnostics. Lines that do not begin with a number are
/// remarks. Errors: `bad-parameter-file`, `line-too-long`.
ParameterFileText read_parameter_file(std::string_view text, std::string_view file);

/// The text of a file with these values, which reads back as the same doubles.
std::string parameter_file_text(std::span<const NumberedValue> values);

}  // namespace leadscrew::gcode
