#pragma once
// What of the command line would mend a problem: the rooms that find problems know no options.

#include <leadscrew/base/diagnostic.hpp>

namespace leadscrew::console {

/// The diagnostic with its hint in the words of the command line, where an option is the remedy.
base::Diagnostic with_options(base::Diagnostic problem);

}  // namespace leadscrew::console
