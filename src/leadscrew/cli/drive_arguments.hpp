#pragma once
// What the command line asks `leadscrew drive` for, beside what other commands are asked for too.

#include <optional>
#include <string>

namespace leadscrew::cli {

struct DriveArguments {
  std::optional<std::string> trace, axes, state, resume, sink;  ///< files
  double look_ahead = 0.3;                                      ///< s
  double lead = 0.1;                                            ///< s
};

struct Arguments;
class Command;

/// The options of drive, which put their values into the arguments.
void describe_drive(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
