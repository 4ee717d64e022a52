#pragma once
// The dialects of G-code that a machine's programs are written in.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace leadscrew::machine {

enum class Dialect : std::uint8_t {
  leadscrew,  ///< LinuxCNC's meanings, what LinuxCNC leaves free, and what every CAM writes where it is unambiguous
  linuxcnc,
  fanuc,
  haas,
  grbl,
  mach3,
  marlin,
  fanuc_lathe,  ///< Fanuc's lathes, G-code system A
  count,
};

constexpr std::size_t index(Dialect dialect) {
  return static_cast<std::size_t>(dialect);
}

/// As options and machine files call them, in order.
inline constexpr std::array<std::string_view, index(Dialect::count)> dialect_names = {
    "leadscrew", "linuxcnc", "fanuc", "haas", "grbl", "mach3", "marlin", "fanuc-lathe"};

/// "linuxcnc"
constexpr std::string_view name(Dialect dialect) {
  return dialect_names[index(dialect)];
}

/// The dialect of that name.
constexpr std::optional<Dialect> dialect_of(std::string_view name) {
  for (std::size_t i = 0; i < dialect_names.size(); ++i) {
    if (dialect_names[i] == name) return static_cast<Dialect>(i);
  }
  return std::nullopt;
}

}  // namespace leadscrew::machine
