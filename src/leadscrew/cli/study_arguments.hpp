#pragma once
// What the command line asks `leadscrew study` for.

#include <leadscrew/cli/options.hpp>
#include <optional>
#include <string>

namespace leadscrew::cli {

struct StudyArguments {
  std::string name;  ///< of a study that there is, or "list"
  std::optional<std::string> picture;
  std::optional<std::string> words;  ///< folder
};

struct Arguments;

/// The options of study, which put their values into the arguments.
void describe_study(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
