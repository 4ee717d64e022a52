#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/machine_events.hpp>
#include <numbers>

namespace leadscrew::gcode {

using Kind = base::Event::Kind;

namespace {

constexpr double mm_in_metre = 1000;
constexpr double mm_in_foot = 304.8;

}  // namespace

void MachineEvents::execute(const Block& block) {
  constexpr std::uint32_t groups = bit(Group::output) | bit(Group::tool) | bit(Group::spindle) | bit(Group::coolant) |
                                   bit(Group::nonmodal) | bit(Group::spindle_mode) | bit(Group::overrides) |
                                   bit(Group::user);
  if (!(block.words & (letter_bit('S') | letter_bit('T'))) && !(block.groups & groups)) return;
  if (block.has(Group::spindle_mode)) set_spindle_mode(block);
  if (block.has('S')) set_speed(block);
  if (block.has('T')) options_.dialect == Dialect::fanuc_lathe ? functions_.turn_turret(block) : select_tool(block);
  if (block.has(Group::output)) set_output(block);
  if (block.is(Code::M6)) change_tool(block);
  if (block.is(Code::M61)) functions_.set_tool_number(block);
  if (block.has(Group::spindle)) turn_spindle(block);
  if (block.has(Group::coolant)) set_coolant(block);
  if (block.has(Group::overrides)) functions_.set_overrides(block);
  if (block.is(Code::M100)) functions_.call_builder(block);
  if (block.is(Code::G4)) dwell(block);
}

void MachineEvents::set_spindle_mode(const Block& block) {
  const bool constant_surface = block.is(Code::G96);
  if (constant_surface && block.has('D') && !(block['D'] > 0)) {
    error("bad-value", block.column_of('D'), "the largest speed is " + text(block['D']), "D must be above 0");
    return;
  }
  modal_.constant_surface_speed = constant_surface;
  if (constant_surface) modal_.is_plain = false;
  // With LinuxCNC the limit is G96's own; with Fanuc, G50's.
  const bool keeps = is_of_fanuc_family(options_.dialect);
  if (constant_surface && (!keeps || block.has('D'))) {
    modal_.most_spindle_speed = block.value_or('D', std::numeric_limits<double>::infinity());
  }
}

// LinuxCNC manual, G Codes, "G96, G97": the surface passes the tool at S metres or feet a minute, on the circle that
// the tool stands on:
//
//     speed = S / (2 π |X|),  at most D
//
// On the axis itself no speed is enough, so there it is the largest.
double MachineEvents::speed_on_surface() const {
  constexpr double fastest = 100'000;  // revolutions per minute; faster than any lathe turns
  const double x = std::fabs(frame_.to_program(frame_.position)[base::index(base::Axis::X)]);
  const double most = std::min(modal_.most_spindle_speed, fastest);
  const double circle = 2 * std::numbers::pi * x;
  return modal_.surface_speed < most * circle ? modal_.surface_speed / circle : modal_.surface_speed > 0 ? most : 0;
}

void MachineEvents::follow_surface() {
  const double speed = speed_on_surface();
  if (speed == modal_.spindle_speed) return;
  modal_.spindle_speed = speed;
  outbox_.emit_event(Kind::spindle_speed, speed);
}

void MachineEvents::set_speed(const Block& block) {
  if (block['S'] < 0) {
    error("bad-value", block.column_of('S'), "the spindle speed is " + text(block['S']), "S must be 0 or more");
    return;
  }
  if (block.is(Code::G50) || block.is(Code::G50_turn)) {
    modal_.most_spindle_speed = block['S'];
    return;
  }
  modal_.spindle_speed = block['S'];
  if (modal_.constant_surface_speed) {
    modal_.surface_speed_word = block['S'];
    modal_.surface_speed_line = modal_.line;
    modal_.surface_speed = block['S'] * (frame_.length_unit == 1 ? mm_in_metre : mm_in_foot);
    modal_.spindle_speed = speed_on_surface();
  }
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
    const std::string message = "tool " + std::to_string(*tool) + " is not in the tool table";
    if (options_.dialect == Dialect::linuxcnc) {
      error("unknown-tool", block.column_of('T'), message, "LinuxCNC selects tools of its table alone");
    } else {
      reporter_.warning("unknown-tool", block.column_of('T'), message, "its offsets are not known");
    }
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
  modal_.spindle = Code::M5;  // it stands (LinuxCNC manual, M Codes, "M6")
  outbox_.emit_event(Kind::tool_change, modal_.loaded_tool);
}

void MachineEvents::turn_spindle(const Block& block) {
  if (block.is(Code::M19)) return functions_.orient_spindle(block);
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
  if (code == Code::M66) return functions_.wait_for_input(block);
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
