#pragma once
// The font of G47: characters as strokes of lines, quarter and half circles, on a grid of 8 by 12. A small letter is a
// capital of three quarters of the size.
//
//     "000c5c)5606"      a P: from 0 0 to 0 12 to 5 12, clockwise half a circle to 5 6, to 0 6
//
// Two digits are a place, x and y, with a to c for 10 to 12; what is before them says how the stroke gets there: ( and )
// by half a circle, < and > by a quarter, ( and < counterclockwise. A blank begins another stroke.

#include <leadscrew/gcode/arc.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace leadscrew::gcode {

struct Stroke {
  struct Step {
    PlanePoint to;
    PlanePoint center;  ///< of an arc
    int turn = 0;       ///< 0 a line, 1 counterclockwise, −1 clockwise
  };
  PlanePoint start;
  std::vector<Step> steps;
};

/// Of a character that is one high, with its lower left corner at 0 0 and the next one's at `character_pitch` 0; empty of a
/// blank. Nothing of a character that the font lacks: it has those of ASCII from 32 to 126.
std::optional<std::vector<Stroke>> strokes_of(char character);
inline constexpr double character_pitch = 1;

}  // namespace leadscrew::gcode
