#pragma once
// `leadscrew study`: the published experiments made again, as a table or as JSON.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>

namespace leadscrew::cli {

/// Makes the experiment that the arguments name, or lists all. `not_kept` where a limit was passed or an experiment
/// could not be made.
Status study(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
