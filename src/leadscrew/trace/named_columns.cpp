#include <algorithm>
#include <leadscrew/trace/named_columns.hpp>

namespace leadscrew::trace {

std::vector<NamedColumn> named_columns(base::AxisSet axes, const MoreColumns& columns) {
  const bool has_linear = std::ranges::any_of(
      base::all_axes, [&](base::Axis axis) { return axes.contains(axis) && !base::is_rotary(axis); });
  std::vector<NamedColumn> named = {
      {"t", "s"}, {"line", ""}, {"s", has_linear ? "mm" : "deg"}, {"feed", has_linear ? "mm/s" : "deg/s"}};
  const auto add_axes = [&](std::string_view prefix, std::string_view linear, std::string_view rotary) {
    for (const base::Axis axis : base::all_axes) {
      if (!axes.contains(axis)) continue;
      named.push_back({std::string(prefix) + base::letter(axis), base::is_rotary(axis) ? rotary : linear});
    }
  };
  add_axes("", "mm", "deg");
  for (const SlideColumn& column : slide_columns_of(columns)) add_axes(column.name, column.linear, column.rotary);
  if (columns.power) named.push_back({"power", ""});
  for (const PoseColumn& column : pose_columns) {
    if (columns.pose) named.push_back({std::string(column.name), column.unit});
  }
  return named;
}

}  // namespace leadscrew::trace
