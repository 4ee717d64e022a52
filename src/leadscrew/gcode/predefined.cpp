#include <algorithm>
#include <array>
#include <leadscrew/gcode/predefined.hpp>

namespace leadscrew::gcode {

namespace {

using base::Axis;

// LinuxCNC's release whose language is read.
constexpr double language_major = 2.9;
constexpr double language_minor = 0;

// First of nine: axes X Y Z A B C U V W.
constexpr int machine_position_number = 5021;
constexpr int active_tool_offset_number = 5081;
constexpr int tool_number_number = 5400;
constexpr int tool_offset_number = 5401;
constexpr int tool_diameter_number = 5410;
constexpr int tool_front_angle_number = 5411;
constexpr int tool_back_angle_number = 5412;
constexpr int tool_orientation_number = 5413;

struct PredefinedRow {
  std::string_view name;
  double (*value)(const Predefined&);
};

// The number of the code in force, times ten.
double number_of(Code code) {
  return row(code).tenths;
}

double system_number(int system) {
  if (system > Parameters::numbered_systems) return number_of(Code::G54_1);
  return number_of(static_cast<Code>(index(Code::G54) + static_cast<std::size_t>(system) - 1));
}

template <Axis axis>
double at_program(const Predefined& p) {
  return p.position(axis);
}
template <Axis axis>
double at_machine(const Predefined& p) {
  return p.machine_position(axis);
}

constexpr double always_off(const Predefined&) {
  return 0;
}

// In the order of the alphabet. Spindles, coolant and overrides are as the program has left them.
constexpr PredefinedRow predefined_rows[] = {
    {"_A", at_program<Axis::A>},
    {"_ABSOLUTE", [](const Predefined& p) -> double { return p.modal().distance == Distance::absolute; }},
    {"_ABS_A", at_machine<Axis::A>},
    {"_ABS_B", at_machine<Axis::B>},
    {"_ABS_C", at_machine<Axis::C>},
    {"_ABS_U", at_machine<Axis::U>},
    {"_ABS_V", at_machine<Axis::V>},
    {"_ABS_W", at_machine<Axis::W>},
    {"_ABS_X", at_machine<Axis::X>},
    {"_ABS_Y", at_machine<Axis::Y>},
    {"_ABS_Z", at_machine<Axis::Z>},
    {"_ADAPTIVE_FEED", [](const Predefined& p) -> double { return p.modal().adaptive_feed; }},
    {"_B", at_program<Axis::B>},
    {"_C", at_program<Axis::C>},
    {"_CALL_LEVEL", [](const Predefined& p) -> double { return static_cast<double>(p.parameters().calls()); }},
    {"_CCOMP", [](const Predefined& p) -> double { return number_of(p.modal().cutter_side); }},
    {"_COORD_SYSTEM", [](const Predefined& p) -> double { return system_number(p.modal().system); }},
    {"_CURRENT_POCKET", [](const Predefined& p) -> double { return p.pocket_of(p.modal().loaded_tool); }},
    {"_CURRENT_TOOL", [](const Predefined& p) -> double { return p.modal().loaded_tool; }},
    {"_FEED", [](const Predefined& p) -> double { return p.modal().feed_word; }},
    {"_FEED_HOLD", [](const Predefined& p) -> double { return p.modal().feed_hold; }},
    {"_FEED_OVERRIDE", [](const Predefined& p) -> double { return p.modal().feed_override; }},
    {"_FLOOD", [](const Predefined& p) -> double { return p.modal().flood; }},
    {"_IJK_ABSOLUTE_MODE", [](const Predefined& p) -> double { return p.modal().arc_distance == Distance::absolute; }},
    {"_IMPERIAL", [](const Predefined& p) -> double { return p.frame().length_unit != 1; }},
    {"_INCREMENTAL", [](const Predefined& p) -> double { return p.modal().distance == Distance::incremental; }},
    {"_INVERSE_TIME", [](const Predefined& p) -> double { return p.modal().feed_mode == FeedMode::inverse_time; }},
    {"_LATHE_DIAMETER_MODE", [](const Predefined& p) -> double { return p.modal().diameters; }},
    {"_LATHE_RADIUS_MODE", [](const Predefined& p) -> double { return !p.modal().diameters; }},
    {"_LINE", [](const Predefined& p) -> double { return static_cast<double>(base::number(p.line())); }},
    {"_METRIC", [](const Predefined& p) -> double { return p.frame().length_unit == 1; }},
    {"_MIST", [](const Predefined& p) -> double { return p.modal().mist; }},
    {"_MOTION_MODE", [](const Predefined& p) -> double { return number_of(p.modal().motion); }},
    {"_PLANE", [](const Predefined& p) -> double { return number_of(plane_code(p.modal().plane)); }},
    {"_REMAP_LEVEL", always_off},
    {"_RETRACT_OLD_Z", [](const Predefined& p) -> double { return p.modal().retract == Retract::initial_level; }},
    {"_RETRACT_R_PLANE", [](const Predefined& p) -> double { return p.modal().retract == Retract::r_level; }},
    {"_RPM", [](const Predefined& p) -> double { return p.modal().spindle_speed; }},
    {"_SELECTED_POCKET",
     [](const Predefined& p) -> double {
       return p.modal().selected_tool ? p.pocket_of(*p.modal().selected_tool) : -1;
     }},
    {"_SELECTED_TOOL", [](const Predefined& p) -> double { return p.modal().selected_tool.value_or(-1); }},
    {"_SPEED_OVERRIDE", [](const Predefined& p) -> double { return p.modal().speed_override; }},
    {"_SPINDLE_CSS_MODE", [](const Predefined& p) -> double { return p.modal().constant_surface_speed; }},
    {"_SPINDLE_CW", [](const Predefined& p) -> double { return p.modal().spindle == Code::M3; }},
    {"_SPINDLE_ON",
     [](const Predefined& p) -> double { return p.modal().spindle == Code::M3 || p.modal().spindle == Code::M4; }},
    {"_SPINDLE_RPM_MODE", [](const Predefined& p) -> double { return !p.modal().constant_surface_speed; }},
    {"_TASK", always_off},
    {"_TOOL_OFFSET", [](const Predefined& p) -> double { return p.has_tool_offset(); }},
    {"_U", at_program<Axis::U>},
    {"_UNITS_PER_MINUTE", [](const Predefined& p) -> double { return p.modal().feed_mode == FeedMode::per_minute; }},
    {"_UNITS_PER_REV", [](const Predefined& p) -> double { return p.modal().feed_mode == FeedMode::per_revolution; }},
    {"_V", at_program<Axis::V>},
    {"_VALUE", [](const Predefined& p) -> double { return p.parameters().returned().value_or(0); }},
    {"_VALUE_RETURNED", [](const Predefined& p) -> double { return p.parameters().returned().has_value(); }},
    {"_VMAJOR", [](const Predefined&) -> double { return language_major; }},
    {"_VMINOR", [](const Predefined&) -> double { return language_minor; }},
    {"_W", at_program<Axis::W>},
    {"_X", at_program<Axis::X>},
    {"_Y", at_program<Axis::Y>},
    {"_Z", at_program<Axis::Z>},
};
static_assert(std::ranges::is_sorted(predefined_rows, {}, &PredefinedRow::name));

const PredefinedRow* predefined_row(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(predefined_rows, name, {}, &PredefinedRow::name);
  return found != std::end(predefined_rows) && found->name == name ? found : nullptr;
}

// The axis of one of nine numbers, if it is one.
std::optional<Axis> axis_of_number(int number, int first) {
  if (number < first || number >= first + static_cast<int>(base::axis_count)) return std::nullopt;
  return static_cast<Axis>(number - first);
}

}  // namespace

Code plane_code(Plane plane) {
  constexpr Code codes[] = {Code::G17, Code::G18, Code::G19, Code::G17_1, Code::G18_1, Code::G19_1};
  return codes[static_cast<std::size_t>(plane)];
}

double Predefined::position(base::Axis axis) const {
  if (settle_ && base::is_rotary(axis)) settle_();
  return frame_.to_program(frame_.position)[base::index(axis)] / frame_.unit(axis);
}

double Predefined::machine_position(base::Axis axis) const {
  if (settle_) settle_();
  return frame_.axes_of(frame_.position)[base::index(axis)] / frame_.unit(axis);
}

bool Predefined::has_tool_offset() const {
  return std::ranges::any_of(frame_.tool(), [](double offset) { return offset != 0; });
}

int Predefined::pocket_of(int tool) const {
  const machine::Tool* const found = tools_.find(tool);
  return found ? found->pocket : 0;
}

std::optional<double> Predefined::get(std::string_view name) const {
  const PredefinedRow* const found = predefined_row(name);
  return found ? std::optional<double>(found->value(*this)) : std::nullopt;
}

bool Predefined::is_of_host(std::string_view name) {
  return name.starts_with("_INI[") || name.starts_with("_HAL[");
}

bool Predefined::is_read_only(std::string_view name) {
  return predefined_row(name) != nullptr || is_of_host(name);
}

bool Predefined::is_read_only(int number) {
  return axis_of_number(number, machine_position_number) || axis_of_number(number, active_tool_offset_number) ||
         axis_of_number(number, Parameters::current_position) ||
         (tool_number_number <= number && number <= tool_orientation_number);
}

std::optional<double> Predefined::of_number(int number) const {
  if (const auto axis = axis_of_number(number, Parameters::current_position)) return position(*axis);
  if (const auto axis = axis_of_number(number, machine_position_number)) return machine_position(*axis);
  if (const auto axis = axis_of_number(number, active_tool_offset_number)) {
    return frame_.tool()[base::index(*axis)] / frame_.unit(*axis);
  }
  if (tool_number_number <= number && number <= tool_orientation_number) return tool_number(number);
  return std::nullopt;
}

// Of the loaded tool: its number, offsets, diameter, front angle, back angle and orientation.
double Predefined::tool_number(int number) const {
  if (number == tool_number_number) return modal_.loaded_tool;
  const machine::Tool* const tool = tools_.find(modal_.loaded_tool);
  if (!tool) return 0;
  if (const auto axis = axis_of_number(number, tool_offset_number)) {
    return tool->offset[base::index(*axis)] / frame_.unit(*axis);
  }
  switch (number) {
    case tool_diameter_number:
      return tool->diameter / frame_.length_unit;
    case tool_front_angle_number:
      return tool->front_angle;
    case tool_back_angle_number:
      return tool->back_angle;
    default:
      return tool->orientation;
  }
}

}  // namespace leadscrew::gcode
