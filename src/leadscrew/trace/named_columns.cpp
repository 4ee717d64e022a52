#include <algorithm>
#include <leadscrew/trace/named_columns.hpp>

namespace leadscrew::trace {

std::vector<NamedColumn> named_columns(base::AxisSet axes, const MoreColumns& columns) {
  const bool has_linear = std::ranges::any_of(
      base::all_axes, [&](base::Axis axis) { return axes.contains(axis) && !base::is_rotary(axis); });
  std::vector<NamedColumn> named = {
      {"t", "s"}, {"line", ""}, {"s", has_linear ? "mm" : "deg"}, {"feed", has_linear ? "mm/s" : "deg/s"}};
  const auto add_axes = [&](const std::string& prefix) {
    for (const base::Axis axis : base::all_axes) {
      if (axes.contains(axis)) named.push_back({prefix + base::letter(axis), base::is_rotary(axis) ? "deg" : "mm"});
    }
  };
  add_axes("");
  if (columns.actual) add_axes("actual_");
  if (columns.power) named.push_back({"power", ""});
  return named;
}

}  // namespace leadscrew::trace
