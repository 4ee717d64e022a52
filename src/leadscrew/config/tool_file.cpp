#include <leadscrew/config/load_text.hpp>
#include <leadscrew/config/tool_file.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <utility>

namespace leadscrew::config {

ToolsOrProblems read_tools(std::string_view text, const std::string& file) {
  if (text.size() > largest_tool_table) {
    base::Diagnostic problem = base::problem("input-too-large", "is larger than 16 MiB", "is this a tool table?");
    problem.place.file = file;
    return tl::unexpected(std::vector{std::move(problem)});
  }
  gcode::ToolTableText read = gcode::read_tool_table(text, file);
  if (!read.diagnostics.empty()) return tl::unexpected(std::move(read.diagnostics));
  return std::move(read.table);
}

ToolsOrProblems load_tools(const std::string& path) {
  const auto text = load_text(path, largest_tool_table + 1);
  if (!text) return tl::unexpected(std::vector{text.error()});
  return read_tools(*text, path);
}

}  // namespace leadscrew::config
