#include "waveform_picture.hpp"

#include <leadscrew/markup/markup.hpp>

namespace leadscrew::hardware {

namespace {

using markup::fixed;
using markup::put;

constexpr double left = 116, top = 44, column = 46, row = 30, height = 18, slope = 4, margin = 16;

std::string place(double x, double y) {
  return fixed(x, 1) + " " + fixed(y, 1);
}

/// Half a column high, half a column low.
void put_clock(std::string& out, double y, std::size_t count) {
  put(out, "<path class=\"wave\" d=\"M", place(left, y));
  for (std::size_t k = 0; k < count; ++k) {
    put(out, "v-", fixed(height, 1), "h", fixed(column / 2, 1), "v", fixed(height, 1), "h", fixed(column / 2, 1));
  }
  out += "\"/>\n";
}

void put_bit(std::string& out, double y, const Signal& signal) {
  const auto level = [&](std::size_t k) { return y - (signal.values[k].value_or(0) != 0 ? height : 0); };
  put(out, "<path class=\"wave\" d=\"M", place(left, level(0)));
  for (std::size_t k = 0; k < signal.values.size(); ++k) {
    put(out, "V", fixed(level(k), 1), "H", fixed(left + column * static_cast<double>(k + 1), 1));
  }
  out += "\"/>\n";
}

/// A box for as long as the value stays.
void put_value(std::string& out, double y, const Signal& signal) {
  const std::size_t count = signal.values.size();
  for (std::size_t from = 0, to = 0; from < count; from = to) {
    while (to < count && signal.values[to] == signal.values[from]) ++to;
    const double x = left + column * static_cast<double>(from), width = column * static_cast<double>(to - from);
    const double middle = y - height / 2;
    if (!signal.values[from]) {
      put(out, "<path class=\"rule\" d=\"M", place(x, middle), "h", fixed(width, 1), "\"/>\n");
      continue;
    }
    put(out, "<path class=\"wave\" d=\"M", place(x, middle), "l", place(slope, -height / 2), "h",
        fixed(width - 2 * slope, 1), "l", place(slope, height / 2), "l", place(-slope, height / 2), "h",
        fixed(2 * slope - width, 1), "z\"/>");
    const std::int64_t value = *signal.values[from];
    put(out, "<text x=\"", fixed(x + width / 2, 1), "\" y=\"", fixed(y - 4, 1), "\" text-anchor=\"middle\">",
        value < 0 ? "−" : "", std::to_string(value < 0 ? -value : value), "</text>\n");
  }
}

}  // namespace

std::string waveform_svg(const std::string& title, const std::vector<Signal>& signals) {
  const std::size_t count = signals.front().values.size();
  const double width = left + column * static_cast<double>(count) + margin;
  const double tall = top + row * static_cast<double>(signals.size() + 1) + margin;
  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(tall, 0),
      "\" width=\"", fixed(width, 0), "\" height=\"", fixed(tall, 0), "\" role=\"img\">\n<title>", title, "</title>\n",
      "<style>text{font:500 13px system-ui,-apple-system,'Segoe UI',sans-serif;fill:#6b747c}.title{font-size:16px;",
      "font-weight:600}.wave{fill:none;stroke:#3b8ea5;stroke-width:1.5;stroke-linejoin:round}.rule{fill:none;stroke:#"
      "7d868e;stroke-opacity:.4}",
      "@media(prefers-color-scheme:dark){text{fill:#9aa5ad}.wave{stroke:#5db6d4}}</style>\n<text class=\"title\" x=\"",
      fixed(margin, 0), "\" y=\"26\">", title, "</text>\n<path class=\"rule\" d=\"");
  for (std::size_t k = 0; k <= count; ++k) {
    put(out, "M", place(left + column * static_cast<double>(k), top), "V", fixed(tall - margin, 1));
  }
  out += "\"/>\n";
  double y = top + row - (row - height) / 2;
  const auto put_name = [&](const std::string& name) {
    put(out, "<text x=\"", fixed(left - 10, 1), "\" y=\"", fixed(y - 4, 1), "\" text-anchor=\"end\">", name,
        "</text>\n");
  };
  put_name("clk");
  put_clock(out, y, count);
  for (const Signal& signal : signals) {
    y += row;
    put_name(signal.name);
    if (signal.is_bit)
      put_bit(out, y, signal);
    else
      put_value(out, y, signal);
  }
  return out + "</svg>\n";
}

}  // namespace leadscrew::hardware
