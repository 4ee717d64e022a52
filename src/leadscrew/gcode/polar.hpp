#pragma once
// Polar words: `@` is a distance from the program's origin in X and Y, `^` an angle from +X towards +Y, in degrees
// (LinuxCNC manual, "Polar Coordinates"). They are read as X and Y words.
//
// In G90 a word that does not stand in the block keeps its value: @ the distance at which the tool stands, ^ its angle.
// In G91 both are added to those.

#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

/// The bits of @ and ^ in Block::words.
inline constexpr std::uint32_t polar_bits = letter_bit('Z') << 1 | letter_bit('Z') << 2;
/// Where they stand in Block::value and Block::column.
inline constexpr std::size_t polar_distance = 26;
inline constexpr std::size_t polar_angle = 27;

class Polar : Part {
 public:
  explicit Polar(const Context& context) : Part(context) {}

  /// Gives the block X and Y words, whose values are not known yet. Error: `bad-polar` where they stand already, beside
  /// G53, beside codes other than motions that take axes, and where another plane than that of G17 holds.
  void announce(Block& block);
  /// Gives them their values, by the modes that hold now. Error: `bad-polar` at the origin, in G91 or
  /// without ^.
  void resolve(Block& block);

  /// Whether the axis words of the block are a radius and an angle, by G16.
  bool applies(const Block& block) const;
  /// The block with the coordinates that they say, in G90.
  Block in_axes(const Block& block);

 private:
  static std::uint32_t column_of(const Block& block) {
    return block.column[block.words & letter_bit('Z') << 1 ? polar_distance : polar_angle];
  }
};

}  // namespace leadscrew::gcode
