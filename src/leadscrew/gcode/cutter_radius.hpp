#pragma once
// The radius of the cutter that D names, for cycles that keep to the inside of what they cut, and for cutter compensation.

#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

/// What cutter compensation asks of a tool.
struct Cutter {
  double radius = 0;    ///< mm; negative: the path is on the other side
  int orientation = 0;  ///< of a lathe tool, as in machine::Tool
};

class CutterRadius : Part {
 public:
  explicit CutterRadius(const Context& context) : Part(context) {}

  /// Of D of the block, or else the D given last before it, in the program's lengths of X and Y, mm: what G51 makes as
  /// large as the tool. 0 of D0. Nothing where it is not known, which has been reported; where there is no tool table at
  /// all, 0 with one warning.
  std::optional<double> of(const Block& block);
  /// By how much G51 scales that.
  double scale() const;
  /// Of G41, G41.1, G42 or G42.1: half of D, and L, or those of the tool that D names, without D of
  /// the tool in the spindle (LinuxCNC manual, G Codes, "G41, G42"; Fanuc: of the D given last). Nothing where it is not
  /// known, which has been reported.
  std::optional<Cutter> of_compensation(const Block& block);

 private:
  std::optional<double> before_scaling(double radius, std::uint32_t column);
  std::optional<Cutter> given(const Block& block);
  std::optional<Cutter> of_tool(int number, std::uint32_t column);

  bool told_of_table_ = false;
};

}  // namespace leadscrew::gcode
