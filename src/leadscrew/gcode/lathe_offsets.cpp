#include <leadscrew/gcode/lathe_offsets.hpp>
#include <leadscrew/gcode/number.hpp>

namespace leadscrew::gcode {

std::optional<LatheOffset> lathe_offset_of(const Block& block) {
  constexpr int geometry = 10'000, last = 99;
  if (block.has('L') || !block.has('P')) return std::nullopt;
  const std::optional<int> p = as_integer(block['P']);
  if (!p) return std::nullopt;
  const LatheOffset which{*p < geometry ? *p : *p - geometry, *p < geometry};
  return 1 <= which.number && which.number <= last ? std::optional(which) : std::nullopt;
}

LatheOffsetValues values_of(LatheOffset which, const machine::ToolTable& tools) {
  const machine::Tool* const tool = tools.find(which.number);
  if (!tool) return {};
  if (which.is_wear) return {tool->wear, tool->radius_wear};
  return {tool->offset, tool->diameter / 2};
}

}  // namespace leadscrew::gcode
