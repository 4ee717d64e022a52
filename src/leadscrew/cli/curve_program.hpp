#pragma once
// Curves of the studies in place of files: curve:NAME, or curve:NAME@FEED with a feed in mm/s. A file whose name begins
// like that is given as ./curve:…

#include <leadscrew/cli/options.hpp>
#include <leadscrew/study/curves.hpp>
#include <string>
#include <string_view>

namespace leadscrew::cli {

inline constexpr std::string_view curve_prefix = "curve:";

inline bool is_curve(std::string_view program) {
  return program.starts_with(curve_prefix);
}

/// Of a program that is_curve(): its text, and where it begins. Or, in a whole sentence, why there is no such curve.
Parsed<study::PartProgram> curve_program(std::string_view program);

/// For --help: how they are given, and which there are with their feeds.
std::string curves_text();

}  // namespace leadscrew::cli
