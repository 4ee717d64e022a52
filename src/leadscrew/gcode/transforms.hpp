#pragma once
// What a program does to its own coordinates: mirror (G50.1, G51.1), scaling (G50, G51), turn (G68, G69), and the
// reading of axis words as a radius and an angle (G15, G16). Fanuc 0i operator's manual.

#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

class Transforms : Part {
 public:
  explicit Transforms(const Context& context) : Part(context) {}

  /// The codes of the block that belong here. Errors: missing-word, bad-value.
  void set(const Block& block);

 private:
  void set_mirror(const Block& block, ProgramTransform& transform) const;
  bool set_scale(const Block& block, ProgramTransform& transform);
  bool set_turn(const Block& block, ProgramTransform& transform);
  std::array<double, 3> center_of(const Block& block) const;
};

}  // namespace leadscrew::gcode
