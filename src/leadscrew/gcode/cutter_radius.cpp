#include <cmath>
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
  const std::optional<Cutter> cutter = of_tool(*number, column);
  return cutter ? before_scaling(std::fabs(cutter->radius), motion_column(block)) : std::nullopt;
}

double CutterRadius::scale() const {
  return std::fabs(frame_.transform().scale[0]);
}

// G51 scales what is programmed, and not the tool.
std::optional<double> CutterRadius::before_scaling(double radius, std::uint32_t column) {
  if (radius == 0 || scale() == std::fabs(frame_.transform().scale[1])) return radius / scale();
  error("unsupported-rotation", column, "the radius of the tool where G51 scales X and Y differently",
        "equal scales of X and Y, or D0");
  return std::nullopt;
}

std::optional<Cutter> CutterRadius::of_tool(int number, std::uint32_t column) {
  const machine::Tool* const tool = tools_.find(number);
  if (tool) return Cutter{tool->worn_radius(), tool->orientation};
  if (!tools_.tools().empty()) {
    error("unknown-tool", column, "tool " + std::to_string(number) + " is not in the tool table",
          "give a tool table that holds it, with its diameter");
    return std::nullopt;
  }
  if (!std::exchange(told_of_table_, true)) {
    reporter_.warning("no-tool-table", column,
                      "there is no tool table: the diameter of D" + std::to_string(number) + " is 0",
                      "give a tool table with the diameters of the tools");
  }
  return Cutter{};
}

std::optional<Cutter> CutterRadius::given(const Block& block) {
  if (!block.has('D')) return std::nullopt;  // missing-word
  Cutter cutter{block['D'] * frame_.length_unit / 2};
  if (!block.has('L')) return cutter;
  const std::optional<int> orientation = as_integer(block['L']);
  if (!orientation || *orientation < 0 || *orientation > 9) {
    error("bad-value", block.column_of('L'), "the orientation of the tool is " + text(block['L']),
          "an integer from 0 to 9");
    return std::nullopt;
  }
  cutter.orientation = *orientation;
  return cutter;
}

std::optional<Cutter> CutterRadius::of_compensation(const Block& block) {
  if (block.is(Code::G41_1) || block.is(Code::G42_1)) return given(block);
  const std::uint32_t column = block.has('D') ? block.column_of('D') : block.column_of(Group::cutter_radius);
  const bool is_of_fanuc = is_of_fanuc_family(options_.dialect);
  std::optional<int> number = 0;
  if (block.has('D')) number = as_integer(block['D']);
  if (!block.has('D') && is_of_fanuc && modal_.cutter) number = as_integer(*modal_.cutter);
  if (!number || *number < 0) {
    error("bad-value", column, "the tool number is " + text(block['D']), "D must be an integer of 0 or more");
    return std::nullopt;
  }
  if (is_of_fanuc && block.has('D')) modal_.cutter = block['D'];
  if (is_of_fanuc && *number == 0 && (block.has('D') || modal_.cutter)) return Cutter{};
  if (*number == 0) number = modal_.loaded_tool;
  if (*number != 0) return of_tool(*number, column);
  reporter_.warning("cutter-compensation", column, "no tool is loaded: its radius is 0",
                    "a tool called before it, or a D above 0");
  return Cutter{};
}

}  // namespace leadscrew::gcode
