// The G codes that are read: one row a code. A code that does something of its own is a row here, a handler of the
// Interpreter, and the file that holds the handler.

#include <leadscrew/gcode/interpreter.hpp>
#include <vector>

namespace leadscrew::gcode {

namespace {

// Codes of the dialect that are not read.
constexpr GCode unsupported[] = {60,  61,  70,  80,  171, 181, 191, 330, 331, 382, 383, 384,
                                 385, 410, 411, 420, 421, 432, 520, 700, 710, 711, 712, 720,
                                 721, 722, 730, 740, 760, 840, 860, 870, 880, 890, 950, 960};

constexpr bool takes_axes = true;

}  // namespace

// Codes without a handler are modes, which set_modes and what it calls know; G4, which comes before them in the order
// of execution; and G53, which says how the axis words are read.
struct Interpreter::CodeTable {
  using In = Interpreter;

  // clang-format off
  static constexpr Code rows[] = {
    // code group               words    repeated_by  axis words  handler
    {  0, Group::motion,         "",      "",          false,      &In::straight},
    { 10, Group::motion,         "",      "",          false,      &In::straight},
    { 20, Group::motion,         "IJKRP", "IJKR",      false,      &In::arc},
    { 30, Group::motion,         "IJKRP", "IJKR",      false,      &In::arc},
    { 50, Group::motion,         "IJPQ",  "IJ",        false,      &In::spline},
    { 51, Group::motion,         "IJ",    "IJ",        false,      &In::spline},
    { 52, Group::motion,         "PL",    "",          false,      &In::nurbs},
    { 53, Group::motion,         "",      "",          false,      &In::end_nurbs},
    { 62, Group::motion,         "PKR",   "KR",        false,      &In::add_to_nurbs_with_knots},
    {800, Group::motion,         "",      "",          false,      nullptr},
    {810, Group::motion,         "RL",    "",          false,      &In::drill},
    {820, Group::motion,         "RLP",   "",          false,      &In::drill},
    {830, Group::motion,         "RLQ",   "",          false,      &In::drill},
    {850, Group::motion,         "RL",    "",          false,      &In::drill},

    { 40, Group::nonmodal,       "P",     "",          false,      nullptr},
    {100, Group::nonmodal,       "PLR",   "",          takes_axes, &In::set_system},
    {280, Group::nonmodal,       "",      "",          takes_axes, &In::go_home},
    {281, Group::nonmodal,       "",      "",          false,      &In::set_home},
    {300, Group::nonmodal,       "",      "",          takes_axes, &In::go_home},
    {301, Group::nonmodal,       "",      "",          false,      &In::set_home},
    {530, Group::nonmodal,       "",      "",          false,      nullptr},
    {920, Group::nonmodal,       "",      "",          takes_axes, &In::set_shift},
    {921, Group::nonmodal,       "",      "",          false,      &In::set_shift},
    {922, Group::nonmodal,       "",      "",          false,      &In::set_shift},
    {923, Group::nonmodal,       "",      "",          false,      &In::set_shift},

    {170, Group::plane,          "",      "",          false,      nullptr},
    {180, Group::plane,          "",      "",          false,      nullptr},
    {190, Group::plane,          "",      "",          false,      nullptr},
    {900, Group::distance,       "",      "",          false,      nullptr},
    {910, Group::distance,       "",      "",          false,      nullptr},
    {901, Group::arc_distance,   "",      "",          false,      nullptr},
    {911, Group::arc_distance,   "",      "",          false,      nullptr},
    {930, Group::feed_mode,      "",      "",          false,      nullptr},
    {940, Group::feed_mode,      "",      "",          false,      nullptr},
    {200, Group::units,          "",      "",          false,      nullptr},
    {210, Group::units,          "",      "",          false,      nullptr},
    {400, Group::cutter_radius,  "",      "",          false,      nullptr},
    {430, Group::tool_length,    "H",     "",          false,      nullptr},
    {431, Group::tool_length,    "",      "",          takes_axes, nullptr},
    {490, Group::tool_length,    "",      "",          false,      nullptr},
    {980, Group::retract,        "",      "",          false,      nullptr},
    {990, Group::retract,        "",      "",          false,      nullptr},
    {540, Group::system,         "",      "",          false,      nullptr},
    {550, Group::system,         "",      "",          false,      nullptr},
    {560, Group::system,         "",      "",          false,      nullptr},
    {570, Group::system,         "",      "",          false,      nullptr},
    {580, Group::system,         "",      "",          false,      nullptr},
    {590, Group::system,         "",      "",          false,      nullptr},
    {591, Group::system,         "",      "",          false,      nullptr},
    {592, Group::system,         "",      "",          false,      nullptr},
    {593, Group::system,         "",      "",          false,      nullptr},
    {610, Group::path,           "",      "",          false,      nullptr},
    {611, Group::path,           "",      "",          false,      nullptr},
    {640, Group::path,           "PQ",    "",          false,      nullptr},
    {970, Group::spindle_mode,   "",      "",          false,      nullptr},
  };
  // clang-format on

  static constexpr std::array<Group, 1000> make_groups() {
    std::array<Group, 1000> groups{};
    for (Group& group : groups) group = Group::unknown;
    for (const GCode code : unsupported) groups[static_cast<std::size_t>(code)] = Group::unsupported;
    for (const Code& row : rows) groups[static_cast<std::size_t>(row.code)] = row.group;
    return groups;
  }

  static constexpr std::array<std::uint8_t, 1000> make_numbers() {
    std::array<std::uint8_t, 1000> numbers{};
    std::uint8_t number = 0;
    for (const Code& row : rows) numbers[static_cast<std::size_t>(row.code)] = number++;
    return numbers;
  }
};

namespace detail {
constinit const std::array<Group, 1000> g_groups = Interpreter::CodeTable::make_groups();
}

const Interpreter::Code& Interpreter::row_of(GCode code) {
  static constexpr std::array<std::uint8_t, 1000> numbers = CodeTable::make_numbers();
  return CodeTable::rows[numbers[static_cast<std::size_t>(code)]];
}

std::string Interpreter::users_of(char letter) {
  std::vector<std::string> users;
  for (const Code& row : CodeTable::rows) {
    if (row.words.has(letter)) users.push_back(g_name(row.code));
  }
  for (const int code : {62, 63, 64, 65, 67, 68}) {
    if (Letters(letters_of_output(code)).has(letter)) users.push_back("M" + std::to_string(code));
  }
  if (users.empty()) return "no supported code takes it";
  std::string text = std::string(1, letter) + " belongs to " + users.front();
  for (std::size_t i = 1; i < users.size(); ++i) text += (i + 1 < users.size() ? ", " : " and ") + users[i];
  return text;
}

}  // namespace leadscrew::gcode
