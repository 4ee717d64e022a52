#pragma once
// What became of a probing move: the answer of the machine, or of the one that is simulated.

#include <cstdint>
#include <leadscrew/base/axes.hpp>

namespace leadscrew::gcode {

/// How G38.2 … G38.5 and G31 are read.
enum class ProbingMoves : std::uint8_t {
  simulated,   ///< they end where the simulated probe of the machine changes its state, or where they lead
  programmed,  ///< they lead to the point programmed; what follows is read as if they had ended as simulated
  /// They lead to the point programmed, and a probe of the machine ends them: Reader::probed() says where. Without that
  /// they have found what they look for at the point programmed.
  real,
};

/// Where a probing move has ended.
struct Probed {
  bool found = false;       ///< what it looks for: contact, or loss of it
  bool at_once = false;     ///< it was found before the move began
  base::AxisVector at{};    ///< where that was, or else where the move leads; machine coordinates, mm or degrees
  base::AxisVector rest{};  ///< where motion has come to rest
};

}  // namespace leadscrew::gcode
