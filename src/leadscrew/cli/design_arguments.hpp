#pragma once
// What the command line asks `leadscrew design` for: a question of results/sizing.hpp.

#include <leadscrew/cli/options.hpp>

namespace leadscrew::cli {

struct Arguments;

/// The options of design, which put their values into the arguments.
void describe_design(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
