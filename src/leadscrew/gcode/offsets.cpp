#include <cmath>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/offsets.hpp>

namespace leadscrew::gcode {

namespace {

constexpr int most_of_fanuc = 300;  // G54.1 P
constexpr int most_of_haas = 99;    // G154 P
const char* levels_of_g10(Dialect dialect) {
  if (dialect == Dialect::fanuc_lathe)
    return "L1, L2 or L20; no L for a tool's offset: G10 P10004 X0 for geometry, P4 for wear";
  if (is_of_fanuc_family(dialect)) return "L1, L2, L10, L11, L12, L13 or L20";
  const bool is_of_linuxcnc = dialect == Dialect::linuxcnc || dialect == Dialect::leadscrew;
  return is_of_linuxcnc ? "L0, L1, L2, L10, L11 or L20" : "L1, L2, L10, L11 or L20";
}

// The first parameter of the place that G28, G28.1, G30 or G30.1 is about.
int home_of(const Block& block) {
  return block.is(Code::G28) || block.is(Code::G28_1) ? Parameters::g28_home : Parameters::g30_home;
}

}  // namespace

std::optional<int> system_set_by(const Block& block, Dialect dialect, int in_force) {
  const bool is_further = is_further_system(block['L'], dialect);
  const int least = is_further ? 1 : 0, most = is_further ? most_of_fanuc : Parameters::numbered_systems;
  const std::optional<int> which = as_integer(block['P']);
  if (!which || *which < least || *which > most) return std::nullopt;
  if (is_further) return Parameters::numbered_systems + *which;
  return *which == 0 ? in_force : *which;
}

bool sets_shift_of_all(const Block& block, Dialect dialect) {
  return is_of_fanuc_family(dialect) && block.has('L') && block.has('P') && as_integer(block['L']) == 2 &&
         as_integer(block['P']) == 0;
}

void Offsets::set_tool_length(const Block& block) {
  if (!block.has(Group::tool_length)) return;
  const Code code = block.code(Group::tool_length);
  if (frame_.tip_control() || frame_.takes_vectors()) frame_.end_tip_control();
  if (code == Code::G43_5) frame_.take_vectors();
  base::AxisVector offset{};
  if (code == Code::G43_1) {
    offset = frame_.tool();
    for_each_axis_word(block, [&](base::Axis axis, double value) { offset[base::index(axis)] = value; });
  } else if (code != Code::G49) {
    bool known = false;
    const machine::Tool* const tool = tool_of(block, known);
    if (!known) return;
    if (tool) offset = tool->worn_offset();
    for (std::size_t i = 0; i < base::axis_count; ++i) {
      if (code == Code::G44) offset[i] = -offset[i];
      if (code == Code::G43_2) offset[i] += frame_.tool()[i];
    }
  }
  frame_.set_tool(offset);
  const bool is_of_tip = code == Code::G43_4 || code == Code::G43_5;
  if (is_of_tip) modal_.tip_by_m = false;
  if (is_of_tip || modal_.tip_by_m) begin_tip_control(block.column_of(Group::tool_length));
}

// LinuxCNC's configurations of five axes have these (its manual, "Switchable Kinematics").
void Offsets::switch_tip_control(const Block& block) {
  if (block.is(Code::M428) && !frame_.tip_control()) {
    begin_tip_control(block.column_of(Group::user));
    modal_.tip_by_m = frame_.tip_control() != nullptr;
  } else if (block.is(Code::M429)) {
    if (frame_.tip_control()) frame_.end_tip_control();
    modal_.tip_by_m = false;
  }
}

// From here on the program says where the tip is (Fanuc, "Tool center point control", type 1): its coordinates are those
// of the workpiece as it lies with all rotary axes at 0.
void Offsets::begin_tip_control(std::uint32_t column) {
  if (!machine_.rotary_chain) {
    error("tip-control", column, "tool centre point control on a machine whose rotary axes have no kinematics",
          "kinematics = \"table-table-ac\" in the machine file, or another of its names");
    return;
  }
  if (fails_beside_contour(column, "tool centre point control")) return;
  frame_.begin_tip_control(machine_);
}

// Places of the machine's axes are none of the program's.
bool Offsets::fails_under_tip_control(const Block& block) {
  if (!frame_.tip_control()) return false;
  const Code code = block.code(Group::nonmodal);
  error("tip-control", block.column_of(Group::nonmodal), name(code) + " while tool centre point control is on",
        "G49 before it");
  return true;
}

// The tool whose offset G43, G43.2 or G44 takes; nullptr where that is none. `known`: nothing was wrong.
const machine::Tool* Offsets::tool_of(const Block& block, bool& known) {
  std::optional<int> number = modal_.loaded_tool;
  if (block.has('H')) number = as_integer(block['H']);
  // LinuxCNC manual, G Codes, "G43": H0 is the tool in the spindle. With Fanuc it is no offset.
  const bool is_of_spindle = options_.dialect == Dialect::leadscrew || options_.dialect == Dialect::linuxcnc;
  if (number == 0 && is_of_spindle) number = modal_.loaded_tool;
  if (!number || *number < 0) {
    error("bad-value", block.column_of('H'), "the tool number is " + text(block['H']),
          "H must be an integer of 0 or more");
    return nullptr;
  }
  const machine::Tool* const tool = *number == 0 ? nullptr : tools_.find(*number);
  if (*number != 0 && !tool && (tools_.tools().empty() || has_registers())) {
    note_missing_table(block);
  } else if (*number != 0 && !tool) {
    error("unknown-tool", block.has('H') ? block.column_of('H') : block.column_of(Group::tool_length),
          "tool " + std::to_string(*number) + " is not in the tool table", "give a tool table that holds it");
    return nullptr;
  }
  known = true;
  return tool;
}

// Said once: without a table no tool has an offset.
void Offsets::note_missing_table(const Block& block) {
  if (std::exchange(told_of_table_, true)) return;
  reporter_.warning("no-tool-table", block.column_of(Group::tool_length),
                    "there is no tool table: the offset of " + name(block.code(Group::tool_length)) + " is 0",
                    "give a tool table with the lengths of the tools");
}

void Offsets::begin() {
  select_system(static_cast<int>(parameters_.get(Parameters::current_system).value_or(1)));
  if (are_shifted()) {
    frame_.set_shift(parameters_.axes(Parameters::g92_shift));
  }
}

void Offsets::select_system(int number) {
  modal_.system = number;
  if (number <= Parameters::numbered_systems) parameters_.set(Parameters::current_system, number);
  frame_.set_system(shifted_system(number));
}

// With Fanuc's external offset, which is 0 elsewhere: Haas' is G52.
CoordinateSystem Offsets::shifted_system(int number) const {
  CoordinateSystem system = parameters_.system(number);
  if (!has_registers() || options_.dialect == Dialect::haas) return system;
  const base::AxisVector shift = parameters_.axes(Parameters::external_offset);
  for (std::size_t i = 0; i < base::axis_count; ++i) system.origin[i] += shift[i];
  return system;
}

void Offsets::select_system(const Block& block) {
  const Code code = block.code(Group::system);
  if (code == Code::G110) return select_system(Parameters::numbered_systems + block.further_system);
  if (code != Code::G54_1 && code != Code::G154) {
    select_system(static_cast<int>(index(code) - index(Code::G54)) + 1);
    return;
  }
  if (!block.has('P')) return;
  const int most = code == Code::G154 ? most_of_haas : most_of_fanuc;
  const std::optional<int> which = as_integer(block['P']);
  if (!which || *which < 1 || *which > most) {
    error("bad-value", block.column_of('P'), name(code) + " has P" + text(block['P']),
          "an integer from 1 to " + std::to_string(most));
    return;
  }
  select_system(Parameters::numbered_systems + *which);
}

std::optional<int> Offsets::system_of(const Block& block, int kind) {
  const std::optional<int> number = system_set_by(block, options_.dialect, modal_.system);
  if (number) return number;
  const char* hint = "0 for the one in force, 1 to 9 for G54 to G59.3";
  if (has_registers()) hint = "1 to 6 for G54 to G59, 0 for the offset that shifts all of them";
  if (is_further_system(kind, options_.dialect)) hint = "1 to 300 for G54.1 P1 to P300";
  error("bad-value", block.column_of('P'), "there is no coordinate system P" + text(block['P']), hint);
  return std::nullopt;
}

// G10 L2 sets a system, G10 L20 sets it so that the tool stands at the coordinates given; with Fanuc and Haas, L20 sets
// one of G54.1 or G154 as L2 sets the others.
void Offsets::set_system(const Block& block) {
  if (!block.has('L')) {
    if (block.has('P') && options_.dialect == Dialect::fanuc_lathe) set_lathe_offset(block);
    return;
  }
  const std::optional<int> kind = as_integer(block['L']);
  const bool is_of_linuxcnc = options_.dialect == Dialect::linuxcnc || options_.dialect == Dialect::leadscrew;
  if (kind == 0 && is_of_linuxcnc) return;  // reloads the table, which holds what G10 L1 has told of tools
  if (!block.has('P')) return;
  if (kind && is_of_tool(*kind)) return set_tool(block, *kind);
  if (kind != 2 && kind != 20) {
    error("bad-value", block.column_of('L'), "G10 has L" + text(block['L']), levels_of_g10(options_.dialect));
    return;
  }
  if (sets_shift_of_all(block, options_.dialect)) return set_shift_of_all(block);
  const std::optional<int> which = system_of(block, *kind);
  if (!which) return;
  const int number = *which;
  const Letters words = "XYZABCUVWR";
  if (has_registers() && !takes_only(block, words, "axes, and R, belong to a coordinate system")) return;
  CoordinateSystem system = parameters_.system(number);
  if (kind == 2 || has_registers()) {
    for_each_axis_word(block, [&](base::Axis axis, double value) {
      double& held = system.origin[base::index(axis)];
      held = set_by_g10(held, value);
    });
    if (block.has('R')) system.rotation = set_by_g10(system.rotation, block['R']);
  } else if (block.has('R')) {
    error("unused-word", block.column_of('R'), "G10 L20 does not take R", "R belongs to G10 L2");
    return;
  } else {
    Frame there = frame_;
    there.set_system(system);
    base::AxisVector program = there.to_program(frame_.position);
    for_each_axis_word(block, [&](base::Axis axis, double value) { program[base::index(axis)] = value; });
    const base::AxisVector reached = there.to_machine(program);
    for (const base::Axis axis : base::all_axes) {
      const std::size_t i = base::index(axis);
      const bool given = block.has(base::letter(axis)) || !there.is_separate(axis);
      if (given) system.origin[i] += frame_.position[i] - reached[i];
    }
  }
  parameters_.set_system(number, system);
  if (number == modal_.system) frame_.set_system(shifted_system(number));
}

// Fanuc's external offset; Haas keeps it in the register of G52.
void Offsets::set_shift_of_all(const Block& block) {
  if (!takes_only(block, "XYZABCUVW", "axes belong to the offset of all systems, R to one of them")) return;
  const bool is_local = options_.dialect == Dialect::haas;
  base::AxisVector shift = is_local ? frame_.shift() : parameters_.axes(Parameters::external_offset);
  for_each_axis_word(block, [&](base::Axis axis, double value) {
    double& held = shift[base::index(axis)];
    held = set_by_g10(held, value);
  });
  if (is_local) return put_local(shift);
  parameters_.set_axes(Parameters::external_offset, shift);
  frame_.set_system(shifted_system(modal_.system));
}

// Whether G10 of this L sets a tool. Lathes of Fanuc do that without L.
bool Offsets::is_of_tool(int kind) const {
  if (kind == 1) return true;
  const int last = options_.dialect == Dialect::fanuc_lathe ? 0 : has_registers() ? 13 : 11;
  return 10 <= kind && kind <= last;
}

// Fanuc and Haas keep geometry and wear in registers, whether or not there is such a tool.
bool Offsets::has_registers() const {
  return is_of_fanuc_family(options_.dialect);
}

// Under G91 what G10 gives in Fanuc's and Haas' dialects is added to what is held.
double Offsets::set_by_g10(double held, double given) const {
  return has_registers() && modal_.distance == Distance::incremental ? held + given : given;
}

void Offsets::set_local(const Block& block) {
  base::AxisVector shift = frame_.shift();
  for_each_axis_word(block, [&](base::Axis axis, double value) { shift[base::index(axis)] = value; });
  put_local(shift);
}

void Offsets::put_local(const base::AxisVector& shift) {
  parameters_.set_axes(Parameters::g92_shift, shift);
  parameters_.set(Parameters::g92_active, 1);
  frame_.set_shift(shift);
}

void Offsets::set_shift(const Block& block) {
  const Code code = block.code(Group::nonmodal);
  base::AxisVector shift{};
  if (code == Code::G92 || code == Code::G50_turn) {
    shift = frame_.shift();
    const base::AxisVector before = frame_.to_program(frame_.position);
    base::AxisVector after = before;
    for_each_axis_word(block, [&](base::Axis axis, double value) { after[base::index(axis)] = value; });
    const base::AxisVector from = frame_.transformed(before), to = frame_.transformed(after);
    for (std::size_t i = 0; i < base::axis_count; ++i) shift[i] += from[i] - to[i];
    parameters_.set_axes(Parameters::g92_shift, shift);
  } else if (code == Code::G92_1) {
    parameters_.set_axes(Parameters::g92_shift, shift);
  } else if (code == Code::G92_3) {
    shift = parameters_.axes(Parameters::g92_shift);
  }
  const bool is_on = code != Code::G92_1 && code != Code::G92_2;
  parameters_.set(Parameters::g92_active, is_on);
  frame_.set_shift(shift);
}

void Offsets::put_shift_in_force(bool is_in_force) {
  parameters_.set(Parameters::g92_active, is_in_force);
  frame_.set_shift(is_in_force ? parameters_.axes(Parameters::g92_shift) : base::AxisVector{});
}

// By the point of the axis words, if there are any, to the stored place; with axis words, those axes only (LinuxCNC).
void Offsets::go_home(const Block& block) {
  if (fails_under_tip_control(block)) return;
  const base::AxisVector home = parameters_.axes(home_of(block));
  const bool all = !(block.words & axis_letter_bits);
  if (!has_form(options_.dialect, Form::home_by_letters)) motion_.line_to(block, motion_.target_of(block), Feed{});
  base::AxisVector target = frame_.position;
  for (const base::Axis axis : base::all_axes) {
    if (machine_.has(axis) && (all || block.has(base::letter(axis))))
      target[base::index(axis)] = home[base::index(axis)];
  }
  motion_.line_to(block, target, Feed{});
}

void Offsets::set_home(const Block& block) {
  if (fails_under_tip_control(block)) return;
  parameters_.set_axes(home_of(block), frame_.position);
}

}  // namespace leadscrew::gcode
