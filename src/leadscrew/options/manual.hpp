#pragma once
// Manual pages of a program and its commands, made of their options as data: NAME, SYNOPSIS, OPTIONS, EXAMPLES, NOTES,
// EXIT STATUS, SEE ALSO, in the macros of man(7).

#include <leadscrew/options/options.hpp>
#include <string>

namespace leadscrew::options {

/// The page program-command(1); of null, program(1). It holds no date, so that it is the same whenever it is made.
std::string manual_page(const Program& program, const Command* command);

}  // namespace leadscrew::options
