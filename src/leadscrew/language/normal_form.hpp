#pragma once
// The same program in one way of writing: capitals, a blank between words, numbers without zeros that say nothing.

#include <leadscrew/gcode/dialect.hpp>
#include <string>
#include <string_view>

namespace leadscrew::language {

/// A line, without its line feed, written in the way described above. Remarks, settings of parameters and statements of
/// flow stay as they are, and so does a line that holds something else. Where a dialect makes a difference between a
/// number with a point and one without, a point stays. The meaning stays the same.
std::string normal_form(std::string_view line, gcode::Dialect dialect);

}  // namespace leadscrew::language
