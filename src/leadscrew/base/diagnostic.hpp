#pragma once
// What went wrong, where, and what would be right: the one form in which every room reports a problem.

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace leadscrew::base {

/// How bad it is: errors alone keep a program from moving.
enum class Severity : std::uint8_t { note, warning, error };

/// "note", "warning" or "error".
constexpr std::string_view name(Severity severity) {
  return severity == Severity::note ? "note" : severity == Severity::warning ? "warning" : "error";
}

/// A place in a text. Lines and columns count from 1, columns in bytes; 0 means "not known".
struct Place {
  std::string file;         ///< its name, as it was given
  std::int64_t line = 0;    ///< from 1
  std::int64_t column = 0;  ///< in bytes, from 1
};

/// The value that a diagnostic is about, as data: whoever knows where a value was written finds the place by it, and
/// never by the words of the message.
struct Subject {
  std::optional<Axis> axis = {};          ///< whose it is
  std::string_view field = {};            ///< its name, such as machine::field::jerk; static storage; empty: none
  std::optional<std::size_t> entry = {};  ///< of a list, from 0
};

/// Printed as `part.ngc:12:7: error: arc radius differs by 0.31 mm at its ends [arc-radius]`, the line and a caret
/// under it.
struct Diagnostic {
  Severity severity = Severity::error;  ///< errors keep a program from moving
  std::string_view code;                ///< stable name such as "arc-radius"; refers to static storage
  std::string message;                  ///< what was found, with the values
  std::string hint;                     ///< what would be right; may be empty
  Place place;                          ///< where in the text
  std::string source;    ///< the line of text the place is in, or the part of it around the column; may be empty
  Subject subject = {};  ///< of which value, where it is about one
};

/// An error of a value, not of a text: it has no place.
inline Diagnostic problem(std::string_view code, std::string message, std::string hint, Subject subject = {}) {
  return {Severity::error, code, std::move(message), std::move(hint), {}, {}, subject};
}

}  // namespace leadscrew::base
