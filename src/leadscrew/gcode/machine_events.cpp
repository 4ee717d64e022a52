#include <leadscrew/gcode/machine_events.hpp>

namespace leadscrew::gcode {

using Kind = base::Event::Kind;

void MachineEvents::execute(const Block& block) {
  constexpr std::uint32_t groups =
      bit(Group::output) | bit(Group::tool) | bit(Group::spindle) | bit(Group::coolant) | bit(Group::nonmodal);
  if (!(block.words & (letter_bit('S') | letter_bit('T'))) && !(block.groups & groups)) return;
  if (block.has('S')) set_speed(block);
  if (block.has('T')) select_tool(block);
  if (block.has(Group::output)) set_output(block);
  if (block.is(Code::M6)) change_tool(block);
  if (block.has(Group::spindle)) turn_spindle(block);
  if (block.has(Group::coolant)) set_coolant(block);
  if (block.is(Code::G4)) dwell(block);
}

void MachineEvents::set_speed(const Block& block) {
  if (block['S'] < 0) {
    error("bad-value", block.column_of('S'), "the spindle speed is " + text(block['S']), "S must be 0 or more");
    return;
  }
  modal_.spindle_speed = block['S'];
  outbox_.emit_event(Kind::spindle_speed, modal_.spindle_speed);
}

void MachineEvents::select_tool(const Block& block) {
  const std::optional<int> tool = as_integer(block['T']);
  if (!tool || *tool < 0) {
    error("bad-value", block.column_of('T'), "the tool number is " + text(block['T']),
          "T must be an integer of 0 or more");
    if (!modal_.selected_tool) modal_.selected_tool = 0;
    return;
  }
  if (*tool != 0 && !tools_.tools().empty() && !tools_.find(*tool)) {
    reporter_.warning("unknown-tool", block.column_of('T'),
                      "tool " + std::to_string(*tool) + " is not in the tool table", "its offsets are not known");
  }
  modal_.selected_tool = tool;
  outbox_.emit_event(Kind::tool_prepare, *tool);
}

void MachineEvents::change_tool(const Block& block) {
  if (!modal_.selected_tool) {
    error("missing-word", block.column_of(Group::tool), "M6 changes to no tool", "select it with T before");
    modal_.selected_tool = 0;
  }
  modal_.loaded_tool = *modal_.selected_tool;
  outbox_.emit_event(Kind::tool_change, modal_.loaded_tool);
}

void MachineEvents::turn_spindle(const Block& block) {
  modal_.spindle = block.code(Group::spindle);
  switch (modal_.spindle) {
    case Code::M3:
      return outbox_.emit_event(Kind::spindle_clockwise, modal_.spindle_speed);
    case Code::M4:
      return outbox_.emit_event(Kind::spindle_counterclockwise, modal_.spindle_speed);
    default:
      return outbox_.emit_event(Kind::spindle_stop);
  }
}

void MachineEvents::set_output(const Block& block) {
  const Code code = block.code(Group::output);
  if (row(code).needs.bits & ~block.words) return;
  const bool analog = code == Code::M67 || code == Code::M68;
  const char letter = analog ? 'E' : 'P';
  const std::optional<int> output = as_integer(block[letter]);
  if (!output || *output < 0 || *output >= base::most_outputs) {
    error("bad-value", block.column_of(letter), "the number of the output is " + text(block[letter]),
          std::string(1, letter) + " must be an integer of 0 to " + std::to_string(base::most_outputs - 1));
    return;
  }
  switch (code) {
    case Code::M62:
      return outbox_.emit_event(Kind::digital_output_on_with_motion, 1, *output);
    case Code::M63:
      return outbox_.emit_event(Kind::digital_output_off_with_motion, 0, *output);
    case Code::M64:
      return outbox_.emit_event(Kind::digital_output_on, 1, *output);
    case Code::M65:
      return outbox_.emit_event(Kind::digital_output_off, 0, *output);
    case Code::M67:
      return outbox_.emit_event(Kind::analog_output_with_motion, block['Q'], *output);
    default:
      return outbox_.emit_event(Kind::analog_output, block['Q'], *output);
  }
}

void MachineEvents::set_coolant(const Block& block) {
  const Code code = block.code(Group::coolant);
  modal_.mist = code != Code::M9 && (modal_.mist || code == Code::M7);
  modal_.flood = code != Code::M9 && (modal_.flood || code == Code::M8);
  outbox_.emit_event(code == Code::M7   ? Kind::coolant_mist
                     : code == Code::M8 ? Kind::coolant_flood
                                        : Kind::coolant_off);
}

void MachineEvents::dwell(const Block& block) {
  if (!block.has('P')) return;
  if (block['P'] < 0) {
    error("bad-value", block.column_of('P'), "the dwell is " + text(block['P']) + " s", "P must be 0 or more");
    return;
  }
  outbox_.emit(Move::Kind::dwell).dwell_seconds = block['P'];
}

}  // namespace leadscrew::gcode
