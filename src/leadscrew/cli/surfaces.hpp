#pragma once
// leadscrew surfaces FILE: faces of STEP and IGES files as a table, and as blocks of programs.

#include <cstddef>
#include <leadscrew/cli/options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::cli {

struct Arguments;

struct SurfacesArguments {
  std::string file;
  std::vector<std::size_t> faces;     ///< by number; empty: none, or all
  bool all = false;                   ///< every face that can be machined
  std::optional<double> approximate;  ///< mm
  std::optional<std::string> output;  ///< file of the blocks; none: standard output
};

void describe_surfaces(Command& command, Arguments& arguments);

/// Status: usage where this build cannot read such files.
Status surfaces(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
