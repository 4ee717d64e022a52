#pragma once
// What the command says of itself: help, manual pages, completion of shells, version.

#include <leadscrew/cli/options.hpp>
#include <optional>
#include <string>
#include <variant>

namespace leadscrew::cli {

struct AboutArguments {
  std::optional<std::string> command;  ///< of help; none: the program itself
  bool manual = false;                 ///< as a manual page
  std::string shell;                   ///< of completion
  bool version = false;
};

struct Arguments;

/// Of the options of help and completion, and of those without a command, which put their values into the arguments.
void describe_help(Command& command, Arguments& arguments);
void describe_completion(Command& command, Arguments& arguments);
void describe_itself(Command& itself, Arguments& arguments);

/// Empty where the command has work to do. Null asks for what stands before commands.
std::optional<Answer> answer_about(options::Program& program, const Command* command, const Arguments& arguments);

}  // namespace leadscrew::cli
