#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/offsets.hpp>

namespace leadscrew::gcode {

namespace {

// Calls f(axis, value of its word in mm or degrees) for each axis word.
template <class F>
void for_each_axis_word(const Block& block, const Frame& frame, F&& f) {
  for (const base::Axis axis : base::all_axes) {
    const char letter = base::letter(axis);
    if (block.has(letter)) f(axis, block[letter] * frame.unit(axis));
  }
}

// The first parameter of the place that G28, G28.1, G30 or G30.1 is about.
int home_of(const Block& block) {
  return block.is(Code::G28) || block.is(Code::G28_1) ? Parameters::g28_home : Parameters::g30_home;
}

}  // namespace

void Offsets::set_tool_length(const Block& block) {
  if (!block.has(Group::tool_length)) return;
  const Code code = block.code(Group::tool_length);
  base::AxisVector offset{};
  if (code == Code::G43_1) {
    offset = frame_.tool();
    for_each_axis_word(block, frame_, [&](base::Axis axis, double value) { offset[base::index(axis)] = value; });
  } else if (code == Code::G43) {
    std::optional<int> number = modal_.loaded_tool;
    if (block.has('H')) number = as_integer(block['H']);
    // LinuxCNC manual, G Codes, "G43": H0 is the tool in the spindle. With Fanuc it is no offset.
    const bool is_of_spindle = options_.dialect == Dialect::leadscrew || options_.dialect == Dialect::linuxcnc;
    if (number == 0 && is_of_spindle) number = modal_.loaded_tool;
    if (!number || *number < 0) {
      error("bad-value", block.column_of('H'), "the tool number is " + text(block['H']),
            "H must be an integer of 0 or more");
      return;
    }
    const machine::Tool* const tool = *number == 0 ? nullptr : tools_.find(*number);
    if (*number != 0 && !tool && tools_.tools().empty()) {
      note_missing_table(block);
    } else if (*number != 0 && !tool) {
      error("unknown-tool", block.has('H') ? block.column_of('H') : block.column_of(Group::tool_length),
            "tool " + std::to_string(*number) + " is not in the tool table", "give a tool table that holds it");
      return;
    }
    if (tool) offset = tool->offset;
  }
  frame_.set_tool(offset);
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
  if (parameters_.get(Parameters::g92_active).value_or(0) != 0) {
    frame_.set_shift(parameters_.axes(Parameters::g92_shift));
  }
}

void Offsets::select_system(int number) {
  modal_.system = number;
  parameters_.set(Parameters::current_system, number);
  frame_.set_system(parameters_.system(number));
}

// G10 L2 sets a system, G10 L20 sets it so that the tool stands at the coordinates given.
void Offsets::set_system(const Block& block) {
  if (!block.has('L') || !block.has('P')) return;
  const std::optional<int> kind = as_integer(block['L']);
  if (kind == 1 || kind == 10 || kind == 11) {
    error("unsupported-code", block.column_of('L'), "G10 L" + std::to_string(*kind) + " is not supported",
          "set tools in the tool table; L2 and L20 are supported");
    return;
  }
  if (kind != 2 && kind != 20) {
    error("bad-value", block.column_of('L'), "G10 has L" + text(block['L']), "L2 or L20");
    return;
  }
  const std::optional<int> which = as_integer(block['P']);
  if (!which || *which < 0 || *which > 9) {
    error("bad-value", block.column_of('P'), "there is no coordinate system P" + text(block['P']),
          "0 for the one in force, 1 to 9 for G54 to G59.3");
    return;
  }
  const int number = *which == 0 ? modal_.system : *which;
  CoordinateSystem system = parameters_.system(number);
  if (kind == 2) {
    for_each_axis_word(block, frame_, [&](base::Axis axis, double value) { system.origin[base::index(axis)] = value; });
    if (block.has('R')) system.rotation = block['R'];
  } else if (block.has('R')) {
    error("unused-word", block.column_of('R'), "G10 L20 does not take R", "R belongs to G10 L2");
    return;
  } else {
    Frame there = frame_;
    there.set_system(system);
    base::AxisVector program = there.to_program(frame_.position);
    for_each_axis_word(block, frame_, [&](base::Axis axis, double value) { program[base::index(axis)] = value; });
    const base::AxisVector reached = there.to_machine(program);
    for (const base::Axis axis : base::all_axes) {
      const std::size_t i = base::index(axis);
      const bool given = block.has(base::letter(axis)) || !there.is_separate(axis);
      if (given) system.origin[i] += frame_.position[i] - reached[i];
    }
  }
  parameters_.set_system(number, system);
  if (number == modal_.system) frame_.set_system(system);
}

void Offsets::set_shift(const Block& block) {
  const Code code = block.code(Group::nonmodal);
  base::AxisVector shift{};
  if (code == Code::G92) {
    shift = frame_.shift();
    const base::AxisVector before = frame_.to_program(frame_.position);
    base::AxisVector after = before;
    for_each_axis_word(block, frame_, [&](base::Axis axis, double value) { after[base::index(axis)] = value; });
    const base::AxisVector from = frame_.transformed(before), to = frame_.transformed(after);
    for (std::size_t i = 0; i < base::axis_count; ++i) shift[i] += from[i] - to[i];
    parameters_.set_axes(Parameters::g92_shift, shift);
  } else if (code == Code::G92_1) {
    parameters_.set_axes(Parameters::g92_shift, shift);
  } else if (code == Code::G92_3) {
    shift = parameters_.axes(Parameters::g92_shift);
  }
  parameters_.set(Parameters::g92_active, code == Code::G92 || code == Code::G92_3);
  frame_.set_shift(shift);
}

// By the point of the axis words, if there are any, to the stored place; with axis words, those axes only (LinuxCNC).
void Offsets::go_home(const Block& block) {
  const base::AxisVector home = parameters_.axes(home_of(block));
  const bool all = !(block.words & axis_letter_bits);
  if (!all && !has_form(options_.dialect, Form::home_by_letters))
    motion_.line_to(block, motion_.target_of(block), Feed{});
  base::AxisVector target = frame_.position;
  for (const base::Axis axis : base::all_axes) {
    if (machine_.has(axis) && (all || block.has(base::letter(axis))))
      target[base::index(axis)] = home[base::index(axis)];
  }
  motion_.line_to(block, target, Feed{});
}

void Offsets::set_home(const Block& block) {
  parameters_.set_axes(home_of(block), frame_.position);
}

}  // namespace leadscrew::gcode
