#include <leadscrew/gcode/cutter_radius.hpp>

namespace leadscrew::gcode {

std::optional<double> CutterRadius::of(const Block& block) {
  const std::uint32_t column = block.has('D') ? block.column_of('D') : motion_column(block);
  if (!block.has('D') && !modal_.cutter) {
    error("missing-word", column, "the cycle lacks D, and none stood before it",
          "D1 for the diameter of tool 1; D0 to have the middle of the tool go where it is said");
    return std::nullopt;
  }
  const double given = block.has('D') ? block['D'] : *modal_.cutter;
  const std::optional<int> number = as_integer(given);
  if (!number || *number < 0) {
    error("bad-value", column, "the tool number is " + text(given), "D must be an integer of 0 or more");
    return std::nullopt;
  }
  modal_.cutter = given;
  if (*number == 0) return 0;
  const machine::Tool* const tool = tools_.find(*number);
  if (tool) return tool->diameter / 2;
  if (!tools_.tools().empty()) {
    error("unknown-tool", column, "tool " + std::to_string(*number) + " is not in the tool table",
          "give a tool table that holds it, with its diameter");
    return std::nullopt;
  }
  if (!std::exchange(told_of_table_, true)) {
    reporter_.warning("no-tool-table", column, "there is no tool table: the diameter of D" + text(given) + " is 0",
                      "give a tool table with the diameters of the tools");
  }
  return 0;
}

}  // namespace leadscrew::gcode
