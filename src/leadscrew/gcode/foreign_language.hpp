#pragma once
// Part programs in languages that are not read: Siemens' and Heidenhain's own.

#include <optional>
#include <string_view>

namespace leadscrew::gcode {

/// The language that a line is surely written in where it is none of the dialects of G-code: "Siemens Sinumerik",
/// "Heidenhain Klartext".
std::optional<std::string_view> foreign_language(std::string_view line);

}  // namespace leadscrew::gcode
