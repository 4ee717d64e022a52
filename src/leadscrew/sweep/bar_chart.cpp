#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/sweep/bar_chart.hpp>

namespace leadscrew::sweep {

std::string bar_chart(const std::string& title, const std::vector<Bar>& bars) {
  constexpr double width = 800, names = 220, values = 210, row = 24, top = 44, thick = 14;
  double most = 0;
  for (const Bar& bar : bars) most = std::max(most, bar.value);
  const double height = top + row * static_cast<double>(bars.size()) + 12;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\">\n"
      "<style>text{{font:13px system-ui,sans-serif;fill:#333c43}}.title{{font-weight:600;font-size:15px}}"
      ".name{{text-anchor:end}}.value{{fill:#5b6870}}rect{{fill:#2f7fb5}}"
      "@media(prefers-color-scheme:dark){{text{{fill:#d5dce1}}.value{{fill:#9aa5ad}}rect{{fill:#5aa9dd}}}}</style>\n"
      "<text class=\"title\" x=\"12\" y=\"26\">{2}</text>\n",
      width, height, markup::escaped(title));
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double y = top + row * static_cast<double>(k);
    const double length = most > 0 ? (width - names - values) * bars[k].value / most : 0;
    text += fmt::format(
        "<text class=\"name\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text><rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.1f}\" "
        "height=\"{:.0f}\" rx=\"2\"/><text class=\"value\" x=\"{:.1f}\" y=\"{:.0f}\">{}</text>\n",
        names - 10, y + thick, markup::escaped(bars[k].name), names, y + 3, length, thick, names + length + 8,
        y + thick, markup::escaped(bars[k].shown));
  }
  return text + "</svg>\n";
}

}  // namespace leadscrew::sweep
