#pragma once
// Faces of STEP and IGES files as a table, as JSON, and as blocks of a program.

#include <leadscrew/exchange/faces.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/style.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::results {

inline constexpr std::string_view surfaces_schema = "leadscrew.surfaces/1";

/// A line of each face: number, type, degrees, points, area, size, and why it cannot be machined.
std::string surfaces_text(const std::string& file, const exchange::Faces& faces, const Style& style);

/// faces: null where the file could not be read; written: the numbers of the faces that were written as blocks.
std::string surfaces_json(const std::string& file, const exchange::Faces* faces,
                          const std::vector<std::size_t>& written, const Diagnostics& diagnostics);

/// The faces that are asked for, or all of them where none is, each with a comment: surface D7 is face 7. The program is in mm.
std::string surface_blocks(const std::string& file, const exchange::Faces& faces,
                           const std::vector<std::size_t>& numbers);

/// Why a face cannot be written: an error, or a warning where all faces are written that can be.
base::Diagnostic refusal_of(const std::string& file, const exchange::Face& face, base::Severity severity);

}  // namespace leadscrew::results
