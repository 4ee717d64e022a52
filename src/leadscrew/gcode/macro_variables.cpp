// The system variables of Fanuc's macros that are read (Fanuc custom macro B, "System Variables"): modal information,
// positions, and offsets, which have the same numbers as LinuxCNC's.

#include <leadscrew/gcode/predefined.hpp>

namespace leadscrew::gcode {

namespace {

// The number of the code in force.
double decimal_of(Code code) {
  return row(code).tenths / 10.0;
}

bool is_of_nine(int number, int first) {
  return first <= number && number < first + static_cast<int>(base::axis_count);
}

}  // namespace

bool Predefined::is_macro_offset(int number) {
  return Parameters::first_system <= number && number <= Parameters::last_system;
}

std::optional<double> Predefined::of_macro(int number) const {
  constexpr int block_end = 5001, in_machine = 5021, in_program = 5041, skipped_at = 5061, tool_offsets = 5081;
  const auto axis = [&](int first) { return static_cast<base::Axis>(number - first); };
  if (is_of_nine(number, block_end)) return position(axis(block_end));
  if (is_of_nine(number, in_machine)) return machine_position(axis(in_machine));
  if (is_of_nine(number, in_program)) return position(axis(in_program));
  if (is_of_nine(number, skipped_at)) return parameters_.get(number).value_or(0);
  if (is_of_nine(number, tool_offsets)) {
    return frame_.tool()[base::index(axis(tool_offsets))] / frame_.unit(axis(tool_offsets));
  }
  if (is_macro_offset(number)) return parameters_.get(number).value_or(0);
  switch (number) {
    case 4001:
      return decimal_of(modal_.motion);
    case 4002:
      return decimal_of(plane_code(modal_.plane));
    case 4003:
      return modal_.distance == Distance::absolute ? 90 : 91;
    case 4005:
      return modal_.feed_mode == FeedMode::inverse_time ? 93 : modal_.feed_mode == FeedMode::per_revolution ? 95 : 94;
    case 4006:
      return frame_.length_unit == 1 ? 21 : 20;
    case 4010:
      return modal_.retract == Retract::initial_level ? 98 : 99;
    case 4014:
      return 53 + modal_.system;
    case 4109:
      return modal_.feed_word;
    case 4119:
      return modal_.spindle_speed;
    case 4120:
      return modal_.selected_tool.value_or(0);
    default:
      return std::nullopt;
  }
}

}  // namespace leadscrew::gcode
