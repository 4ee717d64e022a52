#pragma once
// Faces of STEP and IGES files as rational B-spline surfaces.
//
//     part.step ──▶ leadscrew-exchange ──lines of JSON──▶ Faces ──▶ results: a table, blocks of a program
//                   (OpenCASCADE)
//
// OpenCASCADE is read by a program of its own, `leadscrew-exchange`, which only builds with LEADSCREW_EXCHANGE make. So the
// command starts without fifty more libraries, and what a broken file does to them is a diagnostic.

#include <leadscrew/base/result.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::exchange {

/// Why a face is no surface that a program can have.
struct Refusal {
  std::string code;  ///< "face-trimmed", "face-degree", "face-inexact", "face-size", "face-normal", "face-net"
  std::string why;   ///< with what was found
  std::string hint;  ///< what would help; may be empty

  friend bool operator==(const Refusal&, const Refusal&) = default;
};

/// One face of the file.
struct Face {
  std::size_t number = 0;                     ///< from 1, in the order of the file's shapes
  std::string type;                           ///< "plane", "cylinder", "B-spline", …
  bool is_reversed = false;                   ///< u and v are exchanged, so that Su × Sv points out of the part
  std::optional<double> deviation;            ///< mm: by which the form was approximated; empty: it is exact
  std::optional<double> area;                 ///< mm²
  surfaces::Vector low{}, high{};             ///< corners of a box around it, mm
  std::optional<surfaces::SurfaceForm> form;  ///< of the whole face; mm
  std::optional<Refusal> refusal;             ///< why there is no form, or why it cannot be machined
};

struct Faces {
  std::string format;       ///< "STEP" or "IGES"
  std::string length_unit;  ///< that the file is written in, such as "mm" or "inch"
  std::vector<Face> faces;  ///< in mm
};

/// The program that reads files for this one, in the folder of this program or in ../libexec/leadscrew of it; empty: none is
/// installed.
std::string reading_program();

/// Reads a file by the reading program. tolerance: mm, > 0: what cannot be converted exactly, or has too high a degree, is
/// approximated within it; none: such faces are refused. Errors: `io-open`, `io-read`, `input-too-large`,
/// `exchange-not-built` where `program` is empty, `exchange-format` of what is neither STEP nor IGES, `exchange-read` where it
/// cannot be read, or the reading program fails, `exchange-faces` where there are none; interruption.
base::Result<Faces> read_faces(const std::string& program, const std::string& file, std::optional<double> tolerance);

/// "STEP" or "IGES" by how a text begins; empty for neither.
std::string_view format_of(std::string_view beginning);

}  // namespace leadscrew::exchange
