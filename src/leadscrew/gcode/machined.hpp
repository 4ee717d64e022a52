#pragma once
// A surface that a block machines, for those who judge what becomes of it.

#include <leadscrew/base/line.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/surfaces/passes.hpp>

namespace leadscrew::gcode {

/// A surface as one block (G6.5) has it machined.
struct Machined {
  base::Line line{};              ///< of the block
  int number = 0;                 ///< D of the surface
  surfaces::Machining machining;  ///< in the coordinates of the block's moves, mm
  machine::Tool tool;             ///< its shape, and its holder's
  /// Coordinates of the moves, and so of the surface, are the tip's in the workpiece (Move::is_of_tip); else those of X, Y and Z of
  /// the machine.
  bool is_of_tip = false;
};

}  // namespace leadscrew::gcode
