#pragma once
// The G and M codes and their modal groups (NIST IR 6556, table 4, and LinuxCNC's additions). Which G codes are read,
// with which words, is one table: codes.cpp.

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
extern const std::array<Group, 1000> g_groups;  // codes.cpp
}

/// The group of a G code from 0 to 999.
inline Group group_of_g(int code) {
  return detail::g_groups[static_cast<std::size_t>(code)];
}

/// The number of the group of an M code; 0 if it is not read here.
constexpr int group_of_m(int code) {
  switch (code) {
    case 0:
    case 1:
    case 2:
    case 30:
    case 60:
      return 4;
    case 62:
    case 63:
    case 64:
    case 65:
    case 67:
    case 68:
      return 5;
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

/// The letters that an M code of group 5 takes: a digital output, or an analog one and what it is set to.
constexpr const char* letters_of_output(int code) {
  return code <= 65 ? "P" : "EQ";
}

/// Whether LinuxCNC knows an M code that is not read here.
constexpr bool is_unsupported_m(int code) {
  return code == 19 || (48 <= code && code <= 53) ||
         (60 <= code && code <= 73 && code != 69 && group_of_m(code) == 0) || code == 98 || code == 99 ||
         (100 <= code && code <= 199);
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

/// "G38.2"
inline std::string g_name(int code) {
  std::string name = "G" + std::to_string(code / 10);
  if (code % 10 != 0) name += "." + std::to_string(code % 10);
  return name;
}

}  // namespace leadscrew::gcode
