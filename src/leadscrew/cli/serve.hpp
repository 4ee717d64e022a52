#pragma once
// `leadscrew serve`: the workbench on 127.0.0.1; and what `drive --serve` is asked for.

#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>
#include <leadscrew/serve/server.hpp>
#include <optional>

namespace leadscrew::cli {

struct Arguments;

struct ServeArguments {
  std::optional<int> port;  ///< none of drive: it is not served
  bool control = false;     ///< of drive: whoever knows the token may
};

void describe_serve(Command& command, Arguments& arguments);
/// --serve and --control, of drive.
void add_serve(Command& command, Arguments& arguments);

/// Until it is interrupted. Status: usage where this build cannot serve.
Status serve(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
