#pragma once
// The G and M codes and their modal groups (NIST IR 6556, table 4, and LinuxCNC's additions).

#include <array>
#include <cstdint>
#include <string>

namespace leadscrew::gcode {

/// Modal groups, by the standard's numbers. Two codes of one group cannot stand in one block.
enum class Group : std::uint8_t {
  nonmodal = 0,
  motion = 1,
  plane = 2,
  distance = 3,
  arc_distance = 4,
  feed_mode = 5,
  units = 6,
  cutter_radius = 7,
  tool_length = 8,
  retract = 10,
  system = 12,
  path = 13,
  spindle_mode = 14,
  count = 15,
  unsupported = 0xFE,  ///< a code of the dialect that is not read here
  unknown = 0xFF,
};

constexpr std::size_t index(Group group) {
  return static_cast<std::size_t>(group);
}
constexpr std::uint32_t bit(Group group) {
  return std::uint32_t{1} << index(group);
}

/// A G code times ten: G38.2 is 382.
using GCode = std::int16_t;

namespace detail {

struct CodeGroup {
  GCode code;
  Group group;
};

inline constexpr CodeGroup g_codes[] = {
    {0, Group::motion},          {10, Group::motion},       {20, Group::motion},        {30, Group::motion},
    {800, Group::motion},        {810, Group::motion},      {820, Group::motion},       {830, Group::motion},
    {850, Group::motion},        {50, Group::motion},       {51, Group::motion},        {52, Group::motion},
    {53, Group::motion},         {62, Group::motion},       {40, Group::nonmodal},      {100, Group::nonmodal},
    {280, Group::nonmodal},      {281, Group::nonmodal},    {300, Group::nonmodal},     {301, Group::nonmodal},
    {530, Group::nonmodal},      {920, Group::nonmodal},    {921, Group::nonmodal},     {922, Group::nonmodal},
    {923, Group::nonmodal},      {170, Group::plane},       {180, Group::plane},        {190, Group::plane},
    {900, Group::distance},      {910, Group::distance},    {901, Group::arc_distance}, {911, Group::arc_distance},
    {930, Group::feed_mode},     {940, Group::feed_mode},   {200, Group::units},        {210, Group::units},
    {400, Group::cutter_radius}, {430, Group::tool_length}, {431, Group::tool_length},  {490, Group::tool_length},
    {980, Group::retract},       {990, Group::retract},     {540, Group::system},       {550, Group::system},
    {560, Group::system},        {570, Group::system},      {580, Group::system},       {590, Group::system},
    {591, Group::system},        {592, Group::system},      {593, Group::system},       {610, Group::path},
    {611, Group::path},          {640, Group::path},        {970, Group::spindle_mode},
};

inline constexpr GCode unsupported_g_codes[] = {60,  61,  70,  80,  171, 181, 191, 330, 331, 382, 383, 384,
                                                385, 410, 411, 420, 421, 432, 520, 700, 710, 711, 712, 720,
                                                721, 722, 730, 740, 760, 840, 860, 870, 880, 890, 950, 960};

constexpr std::array<Group, 1000> make_g_groups() {
  std::array<Group, 1000> groups{};
  for (Group& group : groups) group = Group::unknown;
  for (const GCode code : unsupported_g_codes) groups[static_cast<std::size_t>(code)] = Group::unsupported;
  for (const CodeGroup& entry : g_codes) groups[static_cast<std::size_t>(entry.code)] = entry.group;
  return groups;
}
inline constexpr std::array<Group, 1000> g_groups = make_g_groups();

}  // namespace detail

/// The group of a G code from 0 to 999.
constexpr Group group_of_g(int code) {
  return detail::g_groups[static_cast<std::size_t>(code)];
}

/// The number of the group of an M code; 0 if it is not read here.
constexpr int group_of_m(int code) {
  switch (code) {
    case 0:
    case 1:
    case 2:
    case 30:
      return 4;
    case 6:
      return 6;
    case 3:
    case 4:
    case 5:
      return 7;
    case 7:
    case 8:
    case 9:
      return 8;
    default:
      return 0;
  }
}

/// Whether LinuxCNC knows an M code that is not read here.
constexpr bool is_unsupported_m(int code) {
  return code == 19 || (48 <= code && code <= 53) || (60 <= code && code <= 73 && code != 69) || code == 98 ||
         code == 99 || (100 <= code && code <= 199);
}

constexpr bool is_drill_cycle(GCode motion) {
  return motion >= 810 && motion <= 890;
}
constexpr bool is_arc(GCode motion) {
  return motion == 20 || motion == 30;
}

/// Curves: G5 and G5.1 stand in one block; G5.2 up to G5.3, and G6.2, in many.
inline constexpr GCode cubic_spline = 50;
inline constexpr GCode quadratic_spline = 51;
inline constexpr GCode nurbs_begin = 52;
inline constexpr GCode nurbs_end = 53;
inline constexpr GCode nurbs_with_knots = 62;
constexpr bool is_curve(GCode motion) {
  return (cubic_spline <= motion && motion <= nurbs_end) || motion == nurbs_with_knots;
}

/// "G38.2"
inline std::string g_name(int code) {
  std::string name = "G" + std::to_string(code / 10);
  if (code % 10 != 0) name += "." + std::to_string(code % 10);
  return name;
}

}  // namespace leadscrew::gcode
