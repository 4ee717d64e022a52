#pragma once
// Which surface a move machines, for those who judge what becomes of it.

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/line.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <memory>

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

/// What a move has to do with one.
struct MachinedMove {
  enum class Part : std::uint8_t {
    approach,  ///< to over the first place, and down to it
    pass,
    link,  ///< from one pass to the next
    retract,
  };

  std::shared_ptr<const Machined> surface;  ///< null: nothing
  Part part = Part::approach;
  std::size_t pass = 0;  ///< number of the pass, from 0; of a link, that of the pass before it
};

}  // namespace leadscrew::gcode
