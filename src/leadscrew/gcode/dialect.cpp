#include <array>
#include <leadscrew/gcode/dialect.hpp>

namespace leadscrew::gcode {

namespace {
constexpr std::array<std::string_view, index(Dialect::count)> dialect_names = {"leadscrew", "linuxcnc", "fanuc", "haas",
                                                                               "grbl",      "mach3",    "marlin"};
}  // namespace

std::string_view name(Dialect dialect) {
  return dialect_names[index(dialect)];
}

std::optional<Dialect> dialect_of(std::string_view name) {
  for (std::size_t i = 0; i < dialect_names.size(); ++i) {
    if (dialect_names[i] == name) return static_cast<Dialect>(i);
  }
  return std::nullopt;
}

}  // namespace leadscrew::gcode
