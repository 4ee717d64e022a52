#pragma once
// What the command line asks `leadscrew drive` for: drive::Options.

#include <leadscrew/cli/options.hpp>

namespace leadscrew::cli {

struct Arguments;

/// The options of drive, which put their values into the arguments.
void describe_drive(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
