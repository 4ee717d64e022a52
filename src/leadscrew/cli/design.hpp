#pragma once
// `leadscrew design`: sizes of digital integrators, their clocks and feed words.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>

namespace leadscrew::cli {

/// As text or JSON. `rejected` where no register would hold what is asked for.
Status design(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
