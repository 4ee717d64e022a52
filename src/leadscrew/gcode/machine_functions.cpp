#include <leadscrew/gcode/machine_functions.hpp>

namespace leadscrew::gcode {

using Kind = base::Event::Kind;

void MachineFunctions::set_overrides(const Block& block) {
  const bool on = block.value_or('P', 1) != 0;
  switch (block.code(Group::overrides)) {
    case Code::M50:
      modal_.feed_override = on;
      return outbox_.emit_event(Kind::feed_override, on);
    case Code::M51:
      modal_.speed_override = on;
      return outbox_.emit_event(Kind::spindle_override, on);
    case Code::M52:
      modal_.adaptive_feed = on;
      return outbox_.emit_event(Kind::adaptive_feed, on);
    case Code::M53:
      modal_.feed_hold = on;
      return outbox_.emit_event(Kind::feed_hold, on);
    case Code::M48:
      modal_.feed_override = modal_.speed_override = true;
      return outbox_.emit_event(Kind::overrides_on);
    default:
      modal_.feed_override = modal_.speed_override = false;
      return outbox_.emit_event(Kind::overrides_off);
  }
}

void MachineFunctions::set_tool_number(const Block& block) {
  if (!block.has('Q')) return;
  const std::optional<int> tool = as_integer(block['Q']);
  if (!tool || *tool < 0) {
    error("bad-value", block.column_of('Q'), "the tool number is " + text(block['Q']),
          "Q must be an integer of 0 or more");
    return;
  }
  if (*tool != 0 && !tools_.tools().empty() && !tools_.find(*tool)) {
    error("unknown-tool", block.column_of('Q'), "tool " + std::to_string(*tool) + " is not in the tool table",
          "give a tool table that holds it");
    return;
  }
  modal_.loaded_tool = *tool;
}

// Fanuc's lathes: T0102 is tool 1 with offset 2, T0100 tool 1 with none. The turret turns at once, while the spindle may.
void MachineFunctions::turn_turret(const Block& block) {
  constexpr int most = 999'999, offsets = 100;
  const std::optional<int> number = as_integer(block['T']);
  if (!number || *number < 0 || *number > most) {
    error("bad-value", block.column_of('T'), "the tool number is " + text(block['T']),
          "T must be an integer, with two digits for the offset: T0101");
    return;
  }
  const int tool = *number / offsets, offset = *number % offsets;
  if (tool != 0 && tool != modal_.loaded_tool) {
    modal_.selected_tool = modal_.loaded_tool = tool;
    outbox_.emit_event(Kind::turret_indexing, tool);
  }
  const machine::Tool* const found = offset == 0 ? nullptr : tools_.find(offset);
  frame_.set_tool(found ? found->worn_offset() : base::AxisVector{});
  modal_.cutter = offset;  // whose nose it is
  if (found || offset == 0) return;
  if (!tools_.tools().empty()) {
    reporter_.warning("unknown-tool", block.column_of('T'),
                      "tool " + std::to_string(offset) + " is not in the tool table", "its offset is taken for 0");
  } else if (!std::exchange(told_of_table_, true)) {
    reporter_.warning("no-tool-table", block.column_of('T'),
                      "there is no tool table: the offset of T" + text(block['T']) + " is 0",
                      "give a tool table with the offsets of the tools");
  }
}

void MachineFunctions::orient_spindle(const Block& block) {
  modal_.spindle = Code::M5;
  const double angle = block.value_or('R', 0);
  if (!(0 <= angle && angle <= 360)) {
    error("bad-value", block.column_of('R'), "the spindle's angle is " + text(angle),
          "R must be from 0 to 360 degrees");
    return;
  }
  if (block.has('Q') && !(block['Q'] > 0)) {
    error("bad-value", block.column_of('Q'), "the timeout is " + text(block['Q']) + " s", "Q must be above 0");
    return;
  }
  const double turn = block.value_or('P', 0);
  if (turn != 0 && turn != 1 && turn != 2) {
    error("bad-value", block.column_of('P'), "M19 has P" + text(turn),
          "0 for the shortest way, 1 for clockwise, 2 for counterclockwise");
    return;
  }
  modal_.spindle = Code::M5;  // it stands (LinuxCNC)
  outbox_.emit_event(Kind::spindle_orientation, angle, static_cast<std::int32_t>(turn), block.value_or('Q', 0));
}

void MachineFunctions::wait_for_input(const Block& block) {
  const std::uint32_t column = block.column_of(Group::output);
  const bool digital = block.has('P'), analog = block.has('E');
  if (digital == analog) {
    error(digital ? "ambiguous-word" : "missing-word", column,
          digital ? "M66 asks for two inputs" : "M66 names no input", "give P, a digital one, or E, an analog one");
    return;
  }
  const char letter = digital ? 'P' : 'E';
  const std::optional<int> input = as_integer(block[letter]);
  if (!input || *input < 0 || *input >= base::most_outputs) {
    error("bad-value", block.column_of(letter), "the number of the input is " + text(block[letter]),
          std::string(1, letter) + " must be an integer of 0 to " + std::to_string(base::most_outputs - 1));
    return;
  }
  constexpr int at_once = 0, off = 4, last = off;
  const std::optional<int> wait = as_integer(block.value_or('L', at_once));
  if (!wait || *wait < at_once || *wait > last || (analog && *wait != at_once)) {
    error("bad-value", block.column_of('L'), "M66 has L" + text(block['L']),
          analog ? "an analog input is read at once: L0" : "an integer from 0 to 4");
    return;
  }
  if (*wait != at_once && !(block.value_or('Q', 0) > 0)) {
    error("bad-value", block.has('Q') ? block.column_of('Q') : column, "M66 waits for no time",
          "give Q, the seconds it waits at most");
    return;
  }
  set_input(*wait == at_once || *wait == off ? 0 : -1);
  outbox_.emit_event(digital ? Kind::digital_input : Kind::analog_input, *wait, *input,
                     *wait == at_once ? 0 : block['Q']);
}

void MachineFunctions::set_input(double value) {
  constexpr int found = 5399;
  parameters_.set(found, value);
}

void MachineFunctions::call_builder(const Block& block) {
  constexpr double absent = -1;
  outbox_.emit_event(Kind::user_function, block.value_or('P', absent), block.user_code, block.value_or('Q', absent));
}

}  // namespace leadscrew::gcode
