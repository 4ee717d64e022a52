#pragma once
// What each word beside a code says: a neighbour of the table of codes (gcode/codes.cpp), which says which words a code
// takes.

#include <leadscrew/gcode/codes.hpp>
#include <string_view>

namespace leadscrew::language {

/// A quantity of words.
struct WordMeaning {
  std::string_view meaning;  ///< "radius"
  std::string_view unit;     ///< "mm or inches"; empty of plain numbers
};

/// Of a letter beside a code; of the letter by itself where the code does not take it, or for Code::none. Empty where
/// the letter means nothing there.
WordMeaning meaning_of(gcode::Code code, char letter);

/// Whether a code other than Code::none takes a letter, in any dialect, so that its meaning is told.
bool takes(gcode::Code code, char letter);

/// Whether a letter beside a code belongs to it under G43.5 alone: I, J and K of lines.
bool is_of_tool_vector(gcode::Code code, char letter);

/// A small program in which a code stands: of the first dialect of its row; without an error where the code is read.
std::string_view example_of(gcode::Code code);

}  // namespace leadscrew::language
