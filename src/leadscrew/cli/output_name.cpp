#include <fmt/format.h>

#include <leadscrew/cli/output_name.hpp>

namespace leadscrew::cli {

Parsed<void> check_output_name(std::string_view option, const std::optional<std::string>& name) {
  if (!name || (!name->empty() && name->front() != '-')) return {};
  if (name->empty()) return tl::unexpected(fmt::format("{}: the name of the file is empty", option));
  return tl::unexpected(
      fmt::format("{} {}: is no file's name; one that begins with - is given as ./{}", option, *name, *name));
}

}  // namespace leadscrew::cli
