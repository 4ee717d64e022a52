#pragma once
// Texts that are no G-code: programs in Siemens' and Heidenhain's own languages, and files of surfaces.

#include <optional>
#include <string_view>

namespace leadscrew::gcode {

struct ForeignLanguage {
  std::string_view name;  ///< "Siemens Sinumerik", "Heidenhain Klartext", "a STEP file", "an IGES file"
  std::string_view hint;  ///< what makes G-code of it
};

/// The language that a line is surely written in where it is none of the dialects of G-code.
std::optional<ForeignLanguage> foreign_language(std::string_view line);

}  // namespace leadscrew::gcode
