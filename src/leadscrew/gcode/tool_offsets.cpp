// Tools as G10 sets them: by LinuxCNC's L1, L10 and L11, in the registers of Fanuc's and Haas' L1 and L10 to L13, and as
// Fanuc's lathes do, without L. The offset in force stays what it is until G43, or T of a lathe.

#include <bit>
#include <leadscrew/gcode/lathe_offsets.hpp>
#include <leadscrew/gcode/offsets.hpp>

namespace leadscrew::gcode {

namespace {

/// Fanuc numbers the tool noses of its lathes otherwise than LinuxCNC, whose numbers the tool table holds: 1 X+ Z+, 2 X+ Z-,
/// 3 X- Z-, 4 X- Z+, 5 Z+, 6 X+, 7 Z-, 8 X-, from the middle of the nose to the place that is programmed.
int orientation_of_nose(int number) {
  constexpr int orientations[] = {0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  return orientations[number];
}

}  // namespace

// LinuxCNC manual, G Codes, "G10 L1", "G10 L10", "G10 L11".
void Offsets::set_tool(const Block& block, int kind) {
  const std::optional<int> number = as_integer(block['P']);
  constexpr int most_registers = 9999;
  if (!number || *number < 1 || (has_registers() && *number > most_registers)) {
    error("bad-value", block.column_of('P'), "there is no tool P" + text(block['P']), "an integer of 1 or more");
    return;
  }
  if (!has_registers() && !tools_.find(*number)) {
    error("unknown-tool", block.column_of('P'), "tool " + std::to_string(*number) + " is not in the tool table",
          "give a tool table that holds it");
    return;
  }
  machine::Tool tool = tool_to_set(*number);
  if (has_registers() && (kind != 1 || options_.dialect != Dialect::fanuc_lathe)) {
    if (!set_register(block, kind, tool)) return;
  } else {
    tool.offset = offset_to_reach(block, kind, tool.offset);
    if (!set_shape(block, tool)) return;
  }
  tools_.set(std::move(tool));
}

// The tool of the table; where that has none, Fanuc's and Haas' registers hold what is said of it all the same.
machine::Tool Offsets::tool_to_set(int number) const {
  const machine::Tool* const found = tools_.find(number);
  return found ? *found : machine::Tool{.number = number};
}

// Of a tool as G10 L1, L10 and L11 tell it (LinuxCNC manual, G Codes).
bool Offsets::set_shape(const Block& block, machine::Tool& tool) {
  if (block.has('R')) tool.diameter = 2 * block['R'] * frame_.length_unit;
  if (block.has('I')) tool.front_angle = block['I'];
  if (block.has('J')) tool.back_angle = block['J'];
  return set_orientation(block, tool);
}

bool Offsets::set_orientation(const Block& block, machine::Tool& tool) {
  if (!block.has('Q')) return true;
  const std::optional<int> orientation = as_integer(block['Q']);
  if (!orientation || *orientation < 0 || *orientation > 9) {
    return error("bad-value", block.column_of('Q'), "the orientation of the tool is " + text(block['Q']),
                 "an integer from 0 to 9");
  }
  tool.orientation = options_.dialect == Dialect::fanuc_lathe ? orientation_of_nose(*orientation) : *orientation;
  return true;
}

// Fanuc: R of L10 is a length, of L11 and the older L1 its wear, of L12 a radius, of L13 its wear.
bool Offsets::set_register(const Block& block, int kind, machine::Tool& tool) {
  const std::string code = "G10 L" + std::to_string(kind), example = code + " P1 R" + (kind % 2 == 0 ? "50." : "-0.1");
  if (!takes_only(block, "R", "R alone is what " + code + " sets: " + example)) return false;
  if (!block.has('R')) return error("missing-word", block.column_of(Group::nonmodal), code + " lacks R", example);
  const double value = block['R'] * frame_.length_unit;
  const auto set = [&](double& held) { held = set_by_g10(held, value); };
  if (kind == 10) set(tool.offset[base::index(base::Axis::Z)]);
  if (kind == 11 || kind == 1) set(tool.wear[base::index(base::Axis::Z)]);
  if (kind == 12) tool.diameter = set_by_g10(tool.diameter, 2 * value);
  if (kind == 13) set(tool.radius_wear);
  return true;
}

// G10 P of Fanuc's lathes. Its words are absolute here: what U, W and C add to has been added.
void Offsets::set_lathe_offset(const Block& block) {
  const std::optional<LatheOffset> which = lathe_offset_of(block);
  if (!which) {
    error("bad-value", block.column_of('P'), "there is no offset P" + text(block['P']),
          "1 to 99 for wear, 10001 to 10099 for geometry, G10 L2 P1 for coordinates");
    return;
  }
  constexpr Letters values = "XYZRQ";
  if (!takes_only(block, values, "X, Z, R, Q, U, W and C belong to an offset")) return;
  if (!(block.words & values.bits)) {
    error("missing-word", block.column_of(Group::nonmodal), "G10 says nothing of the offset", "G10 P4 X0.1 Z0");
    return;
  }
  machine::Tool tool = tool_to_set(which->number);
  if (!set_orientation(block, tool)) return;
  base::AxisVector& offset = which->is_wear ? tool.wear : tool.offset;
  for_each_axis_word(block, [&](base::Axis axis, double value) { offset[base::index(axis)] = value; });
  if (block.has('R')) {
    const double radius = block['R'] * frame_.length_unit;
    if (which->is_wear) tool.radius_wear = radius;
    if (!which->is_wear) tool.diameter = 2 * radius;
  }
  tools_.set(std::move(tool));
}

// Whether G10 has no words but N, P, L and those; else the first of them is reported.
bool Offsets::takes_only(const Block& block, Letters words, const std::string& hint) {
  const std::uint32_t own = (row(Code::G10).words.bits | axis_letter_bits) & ~(letter_bit('P') | letter_bit('L'));
  const std::uint32_t others = block.words & own & ~words.bits;
  if (others == 0) return true;
  const auto letter = static_cast<std::size_t>(std::countr_zero(others));
  return error("unused-word", block.column[letter], std::string("nothing in this block takes ") + word_marks[letter],
               hint);
}

// L1: as given. L10: with it the tool stands at the coordinates given; L11: at those of G59.3 without shift.
base::AxisVector Offsets::offset_to_reach(const Block& block, int kind, const base::AxisVector& before) const {
  Frame there = frame_;
  there.set_tool({});
  if (kind == 11) {
    there.set_system(parameters_.system(Parameters::numbered_systems));
    there.set_shift({});
  }
  base::AxisVector offset = before;
  if (kind == 1) {
    for_each_axis_word(block, [&](base::Axis axis, double value) { offset[base::index(axis)] = value; });
    return offset;
  }
  // Coordinates that are not given stay, where the axes are turned: then the offset of all of them is another.
  const base::AxisVector stands = there.to_program(frame_.position);
  base::AxisVector short_by{};
  for_each_axis_word(block, [&](base::Axis axis, double value) {
    const std::size_t i = base::index(axis);
    short_by[i] = stands[i] - value;
  });
  const base::AxisVector in_machine = there.direction_to_machine(short_by);
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (block.has(base::letter(axis)) || !there.is_separate(axis)) offset[i] = in_machine[i];
  }
  return offset;
}

}  // namespace leadscrew::gcode
