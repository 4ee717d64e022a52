#pragma once
// Files that belong to the command: installed beside it, or in the build tree.

#include <filesystem>
#include <initializer_list>
#include <leadscrew/base/result.hpp>
#include <optional>
#include <string>

namespace leadscrew::files {

/// Where the running command is. Error: `io-open`.
base::Result<std::filesystem::path> command_folder();

/// The first regular file of these names, as seen from the command's folder; none where there is none.
std::optional<std::filesystem::path> beside_command(std::initializer_list<std::string> names);

}  // namespace leadscrew::files
