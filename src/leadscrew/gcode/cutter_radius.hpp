#pragma once
// The radius of the cutter that D names, for cycles that keep to the inside of what they cut.

#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

class CutterRadius : Part {
 public:
  explicit CutterRadius(const Context& context) : Part(context) {}

  /// Of D of the block, or else the D given last before it, mm; 0 of D0. Nothing where it is not known, which has been
  /// reported; where there is no tool table at all, 0 with one warning.
  std::optional<double> of(const Block& block);

 private:
  bool told_of_table_ = false;
};

}  // namespace leadscrew::gcode
