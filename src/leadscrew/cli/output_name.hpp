#pragma once
// Names of files to be written, as options give them.

#include <leadscrew/cli/quantity.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::cli {

/// Says in a whole sentence why an option's text, if it is given, can be no file: it is empty, or the next option was
/// taken for it.
Parsed<void> check_output_name(std::string_view option, const std::optional<std::string>& name);

}  // namespace leadscrew::cli
