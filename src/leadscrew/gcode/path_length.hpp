#pragma once
// How long a move is, as feed counts it.

#include <leadscrew/gcode/move.hpp>

namespace leadscrew::gcode {

/// Of a line or an arc: along X Y Z, mm; along U V W where those stand still; along A B C, degrees, where all linear axes do
/// (RS274/NGC 2.1.2.5).
double path_length(const Move& move);

}  // namespace leadscrew::gcode
