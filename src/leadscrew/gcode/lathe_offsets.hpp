#pragma once
// The offsets that G10 without L sets on Fanuc's lathes (Fanuc 0i operator's manual for lathes, "Programmable data input"):
// of the tool's geometry, which the tool table holds, and of its wear, which is added to that.

#include <leadscrew/gcode/block.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <optional>

namespace leadscrew::gcode {

/// Which of them.
struct LatheOffset {
  int number = 0;        ///< 1 … 99, the last two digits of T
  bool is_wear = false;  ///< P is the number; of geometry it is 10000 more
};

/// The one that P names; std::nullopt where there is none, or G10 has L.
std::optional<LatheOffset> lathe_offset_of(const Block& block);

/// What it holds.
struct LatheOffsetValues {
  base::AxisVector offset{};  ///< mm
  double nose_radius = 0;     ///< mm
};
LatheOffsetValues values_of(LatheOffset which, const machine::ToolTable& tools);

}  // namespace leadscrew::gcode
