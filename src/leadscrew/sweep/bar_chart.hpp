#pragma once
// A picture of bars, one below the other, for light and dark pages.

#include <string>
#include <vector>

namespace leadscrew::sweep {

struct Bar {
  std::string name;
  double value = 0;   ///< ≥ 0; the greatest takes the whole width
  std::string shown;  ///< behind the bar
};

/// An SVG with its own style.
std::string bar_chart(const std::string& title, const std::vector<Bar>& bars);

}  // namespace leadscrew::sweep
