#pragma once
// docs/gcode.md, made from the table of codes and its neighbours.

#include <string>

namespace leadscrew::language {

/// The page as a whole, in Markdown.
std::string code_page();

}  // namespace leadscrew::language
