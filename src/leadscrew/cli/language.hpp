#pragma once
// `leadscrew explain`: what a block means, in words. `leadscrew format`: a program in one way of writing.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/console/console.hpp>

namespace leadscrew::cli {

void describe_explain(Command& command, Arguments& arguments);
void describe_format(Command& command, Arguments& arguments);

Status explain(const Arguments& arguments, Console& console);
Status format(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
