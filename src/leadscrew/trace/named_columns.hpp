#pragma once
// The columns of a trace of words by name and unit: what header lines and side files say.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/trace/writer.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::trace {

struct NamedColumn {
  std::string name;
  std::string_view unit;  ///< "s", "mm", "deg", "mm/s", "deg/s", "mm/s²" or "deg/s²"; empty of a number
};

/// In the order in which all formats have them. Path length and feed are in degrees where the machine has rotary axes
/// only.
std::vector<NamedColumn> named_columns(base::AxisSet axes, const MoreColumns& columns);

}  // namespace leadscrew::trace
