#include <algorithm>
#include <cmath>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/charts.hpp>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable;
using markup::tick_decimals;
using markup::tick_step;

constexpr double box_width = 400, box_height = 170, left = 46, gap = 60, margin = 20;
constexpr double title_height = 56, caption_height = 26, below = 48;
constexpr std::size_t columns = 2;
constexpr double air = 1.06;  // above the greatest value

/// Colours that read on white and on black, where a page does not tell which it is.
constexpr std::string_view style =
    "<style>text{font:500 12px system-ui,-apple-system,'Segoe UI',sans-serif;fill:#6b747c}.title{font-size:16px;"
    "font-weight:600}.name{font-size:13px;font-weight:600}path{fill:none}.grid{stroke:#7d868e;stroke-width:.5;"
    "opacity:.45}.wanted{stroke:#d2622f;stroke-width:1.5;stroke-dasharray:5 4}.line{stroke:#2481b5;stroke-width:1.3;"
    "stroke-linejoin:round}.end{text-anchor:end}.middle{text-anchor:middle}@media(prefers-color-scheme:dark){text{"
    "fill:#9aa5ad}.line{stroke:#5db6d4}.wanted{stroke:#ee8f66}}</style>\n";

/// The scale of values that all charts share: from 0, or from the least.
struct Scale {
  double least = 0, greatest = 0;
};

Scale scale_of(const std::vector<Chart>& charts) {
  Scale scale;
  for (const Chart& chart : charts) {
    for (const double value : chart.values) {
      scale.least = std::min(scale.least, value);
      scale.greatest = std::max(scale.greatest, value);
    }
    scale.greatest = std::max(scale.greatest, chart.wanted.value_or(0));
  }
  scale.greatest = scale.greatest > scale.least ? scale.least + air * (scale.greatest - scale.least) : scale.least + 1;
  return scale;
}

class Panel {
 public:
  Panel(const Chart& chart, const Scale& scale, double x, double y)
      : chart_(chart),
        scale_(scale),
        x_(x),
        y_(y),
        seconds_(std::max(chart.interval, chart.interval * static_cast<double>(chart.values.size()))) {}

  void put_all(std::string& out) const {
    put_text(out, "name", x_, y_ - 8, escaped(chart_.title));
    put_value_ticks(out);
    put_time_ticks(out);
    if (chart_.wanted)
      put(out, "<path class=\"wanted\" d=\"M", at(0, *chart_.wanted), "h", fixed(box_width, 0), "\"/>");
    put(out, "<path class=\"line\" d=\"");
    for (std::size_t k = 0; k < chart_.values.size(); ++k)
      put(out, k == 0 ? "M" : "L", at(chart_.interval * static_cast<double>(k), chart_.values[k]));
    out += "\"/>\n";
  }

 private:
  double across(double time) const { return x_ + box_width * time / seconds_; }
  double down(double value) const {
    return y_ + box_height * (scale_.greatest - value) / (scale_.greatest - scale_.least);
  }
  std::string at(double time, double value) const { return fixed(across(time), 1) + " " + fixed(down(value), 1); }

  static void put_text(std::string& out, std::string_view kind, double x, double y, const std::string& text) {
    put(out, "<text class=\"", kind, "\" x=\"", fixed(x, 1), "\" y=\"", fixed(y, 1), "\">", text, "</text>\n");
  }

  void put_value_ticks(std::string& out) const {
    const double step = tick_step(scale_.greatest - scale_.least, 5);
    for (double tick = std::ceil(scale_.least / step); tick * step <= scale_.greatest; ++tick) {
      put(out, "<path class=\"grid\" d=\"M", at(0, tick * step), "h", fixed(box_width, 0), "\"/>");
      put_text(out, "end", x_ - 8, down(tick * step) + 4, readable(tick * step));
    }
  }
  void put_time_ticks(std::string& out) const {
    const double step = tick_step(seconds_, 6);
    for (double tick = 0; tick * step <= seconds_; ++tick) {
      put(out, "<path class=\"grid\" d=\"M", fixed(across(tick * step), 1), " ", fixed(y_, 1), "v",
          fixed(box_height, 0), "\"/>");
      put_text(out, "middle", across(tick * step), y_ + box_height + 18,
               fixed(tick * step, tick_decimals(step)) + (tick == 0 ? " s" : ""));
    }
  }

  const Chart& chart_;
  Scale scale_;
  double x_, y_;  ///< of the upper left corner of its box
  double seconds_;
};

}  // namespace

base::Result<void> write_charts(const std::string& title, const std::string& unit, const std::vector<Chart>& charts,
                                const base::ByteSink& sink) {
  const Scale scale = scale_of(charts);
  const std::size_t rows = (charts.size() + columns - 1) / columns;
  const double down = caption_height + box_height + below;
  const double width = 2 * margin + columns * (left + box_width) + gap - left;
  const double height = title_height + static_cast<double>(rows) * down + 4;
  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(height, 0),
      "\" width=\"", fixed(width, 0), "\" height=\"", fixed(height, 0), "\" role=\"img\">\n<title>", escaped(title),
      "</title>\n", style, "<text class=\"title\" x=\"", fixed(margin, 0), "\" y=\"30\">", escaped(title), ", ",
      escaped(unit), "</text>\n");
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    const double x = margin + left + static_cast<double>(column) * (box_width + gap);
    const double y = title_height + caption_height + static_cast<double>(row) * down;
    Panel(charts[i], scale, x, y).put_all(out);
    if (auto written = sink(out); !written) return written;
    out.clear();
  }
  out += "</svg>\n";
  return sink(out);
}

}  // namespace leadscrew::report
