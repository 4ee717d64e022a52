#pragma once
// What can be said of a block before any of it is executed: which motion it does, and whether its words are those that
// its codes take.

#include <leadscrew/gcode/travel.hpp>

namespace leadscrew::gcode {

class BlockCheck : Part {
 public:
  BlockCheck(const Context& context, Travel& travel) : Part(context), travel_(travel) {}

  /// The motion that the block does; Code::none where it does none. Axis words belong to the motion that stands in the
  /// block, or else to a code that takes them, or else to the motion in force (NIST IR 6556, 3.3.4 and 3.5).
  Code motion_of(const Block& block);
  /// Reports words that nothing takes, that are missing, or of axes that the machine lacks.
  void check(const Block& block);

 private:
  bool repeats_motion(const Block& block) const;
  std::uint32_t motion_words(const Block& block) const;
  void check_words(const Block& block);
  [[gnu::cold]] void check_spindle(const Block& block);
  void check_axes(const Block& block);
  void check_presence(const Block& block);
  void check_threading(const Block& block);
  std::uint32_t vector_words(const Block& block) const;
  [[gnu::cold]] void check_vectors(const Block& block);
  void check_needs(const Block& block, Code code, std::uint32_t column);
  [[gnu::cold]] bool follows_digit(std::uint32_t column) const;
  std::string users_of(char letter) const;

  Travel& travel_;
};

/// Whether the block is executed under G43.5, and I, J and K of lines are the tool's direction.
bool has_vectors(const Block& block, const Frame& frame);

/// The plane, and the distance mode, in which the block is executed.
Plane plane_after(const Block& block, const ModalState& modal);
Distance distance_after(const Block& block, const ModalState& modal);

}  // namespace leadscrew::gcode
