#pragma once
// The dialects of G-code that are read.

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace leadscrew::gcode {

enum class Dialect : std::uint8_t {
  leadscrew,  ///< LinuxCNC's meanings, what LinuxCNC leaves free, and what every CAM writes where it is unambiguous
  linuxcnc,
  fanuc,
  haas,
  grbl,
  mach3,
  marlin,
  count,
};

constexpr std::size_t index(Dialect dialect) {
  return static_cast<std::size_t>(dialect);
}

/// As options and machine files call it: "linuxcnc".
std::string_view name(Dialect dialect);
/// The dialect of that name.
std::optional<Dialect> dialect_of(std::string_view name);

/// A set of dialects.
struct Dialects {
  std::uint8_t bits = 0;

  constexpr Dialects() = default;
  constexpr Dialects(std::initializer_list<Dialect> dialects) {
    for (const Dialect dialect : dialects) bits |= static_cast<std::uint8_t>(1u << index(dialect));
  }
  constexpr bool has(Dialect dialect) const { return (bits >> index(dialect)) & 1u; }
  constexpr bool empty() const { return bits == 0; }
  friend constexpr Dialects operator|(Dialects a, Dialects b) {
    a.bits |= b.bits;
    return a;
  }
};

}  // namespace leadscrew::gcode
