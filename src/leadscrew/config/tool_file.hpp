#pragma once
// Tool tables in files, in LinuxCNC's format (gcode/tool_table.hpp).

#include <cstddef>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace leadscrew::config {

/// A table, or one problem or more in the order of the text.
using ToolsOrProblems = tl::expected<machine::ToolTable, std::vector<base::Diagnostic>>;

/// Bytes of a tool table.
inline constexpr std::size_t largest_tool_table = 16 << 20;

/// `file` is for places. Codes: `input-too-large` and those of gcode::read_tool_table().
ToolsOrProblems read_tools(std::string_view text, const std::string& file);

/// The file at `path`. Codes: `io-open`, `io-read`, and those of read_tools().
ToolsOrProblems load_tools(const std::string& path);

}  // namespace leadscrew::config
