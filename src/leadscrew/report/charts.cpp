#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/charts.hpp>
#include <span>
#include <utility>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable;
using markup::tick_decimals;
using markup::tick_step;

constexpr double box_width = 400, box_height = 170, left = 46, gap = 60, margin = 20;
constexpr double title_height = 56, caption_height = 26, below = 48, key_height = 22;
constexpr std::size_t columns = 2;
constexpr double air = 1.06;  // above the greatest value

/// Colours that read on white and on black, where a page does not tell which it is.
constexpr std::string_view style =
    "<style>text{font:500 12px system-ui,-apple-system,'Segoe UI',sans-serif;fill:#6b747c}.title{font-size:16px;"
    "font-weight:600}.name{font-size:13px;font-weight:600}path{fill:none}.grid{stroke:#7d868e;stroke-width:.5;"
    "opacity:.45}.wanted{stroke:#d2622f;stroke-width:1.5;stroke-dasharray:5 4}.line{stroke-width:1.3;"
    "stroke-linejoin:round}.end{text-anchor:end}.middle{text-anchor:middle}@media(prefers-color-scheme:dark){text{"
    "fill:#9aa5ad}.wanted{stroke:#ee8f66}}";
constexpr std::array<std::pair<std::string_view, std::string_view>, curve_colors> colors = {{{"#2481b5", "#5db6d4"},
                                                                                             {"#2f9360", "#6cc79a"},
                                                                                             {"#8f5fc0", "#b995e6"},
                                                                                             {"#c2417c", "#ea86b3"},
                                                                                             {"#8a7a1c", "#cdbb52"},
                                                                                             {"#1d9a9a", "#5fd0cf"},
                                                                                             {"#9a5f45", "#cf9a80"},
                                                                                             {"#5f7fa8", "#9cb6d8"},
                                                                                             {"#6b747c", "#a9b3ba"}}};

std::string style_of_sheet() {
  std::string light, dark;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    put(light, ".c", std::to_string(i), "{stroke:", colors[i].first, "}");
    put(dark, ".c", std::to_string(i), "{stroke:", colors[i].second, "}");
  }
  return std::string(style) + light + "@media(prefers-color-scheme:dark){" + dark + "}</style>\n";
}

/// A scale of values: from 0, or from the least.
struct Scale {
  double least = 0, greatest = 0;
};

Scale scale_of(std::span<const Chart> charts) {
  Scale scale;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    scale.least = std::min(scale.least, value);
    scale.greatest = std::max(scale.greatest, value);
  };
  for (const Chart& chart : charts) {
    for (const Curve& curve : chart.curves) {
      for (const Curve::Sample& sample : curve.samples) include(sample.value);
    }
    for (const double level : chart.levels) include(level);
  }
  const double more = (air - 1) * (scale.greatest - scale.least);
  if (scale.least < 0) scale.least -= more;
  scale.greatest = scale.greatest > scale.least ? scale.greatest + more : scale.least + 1;
  return scale;
}

double last_time(const Chart& chart) {
  double last = 0;
  for (const Curve& curve : chart.curves) {
    if (!curve.samples.empty()) last = std::max(last, curve.samples.back().time);
  }
  return last > 0 ? last : 1;
}

class Panel {
 public:
  Panel(const Chart& chart, const Scale& scale, double x, double y)
      : chart_(chart), scale_(scale), x_(x), y_(y), seconds_(last_time(chart)) {}

  void put_all(std::string& out) const {
    put_text(out, "name", x_, y_ - 8, escaped(chart_.title));
    put_value_ticks(out);
    put_time_ticks(out);
    for (const double level : chart_.levels)
      put(out, "<path class=\"wanted\" d=\"M", at(0, level), "h", fixed(box_width, 0), "\"/>");
    for (std::size_t i = chart_.curves.size(); i-- > 0;) put_curve(out, chart_.curves[i]);
  }

 private:
  double across(double time) const { return x_ + box_width * time / seconds_; }
  double down(double value) const {
    return y_ + box_height * (scale_.greatest - value) / (scale_.greatest - scale_.least);
  }
  std::string at(double time, double value) const { return fixed(across(time), 1) + " " + fixed(down(value), 1); }

  void put_curve(std::string& out, const Curve& curve) const {
    put(out, "<path class=\"line c", std::to_string(curve.color), "\" d=\"");
    for (std::size_t k = 0; k < curve.samples.size(); ++k)
      put(out, k == 0 ? "M" : "L", at(curve.samples[k].time, curve.samples[k].value));
    out += "\"/>\n";
  }

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

void put_keys(std::string& out, const std::vector<ChartKey>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double x = margin + left + static_cast<double>(i % columns) * (box_width + gap);
    const std::size_t row = i / columns;
    const double y = title_height + key_height * static_cast<double>(row);
    put(out, "<path class=\"line c", std::to_string(keys[i].color), "\" d=\"M", fixed(x, 1), " ", fixed(y - 4, 1),
        "h26\"/><text x=\"", fixed(x + 34, 1), "\" y=\"", fixed(y, 1), "\">", escaped(keys[i].name), "</text>\n");
  }
}

}  // namespace

Curve evenly_spaced(const std::vector<double>& values, double interval) {
  Curve curve;
  for (const double value : values)
    curve.samples.push_back({interval * static_cast<double>(curve.samples.size()), value});
  return curve;
}

base::Result<void> write_charts(const ChartSheet& sheet, const base::ByteSink& sink) {
  const std::vector<Chart>& charts = sheet.charts;
  const auto rows_of = [](std::size_t count) {
    const std::size_t rows = (count + columns - 1) / columns;
    return static_cast<double>(rows);
  };
  const double down = caption_height + box_height + below;
  const double width = 2 * margin + columns * (left + box_width) + gap - left;
  const double above = title_height + key_height * rows_of(sheet.keys.size());
  const double height = above + rows_of(charts.size()) * down + 4;
  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(height, 0),
      "\" width=\"", fixed(width, 0), "\" height=\"", fixed(height, 0), "\" role=\"img\">\n<title>",
      escaped(sheet.title), "</title>\n", style_of_sheet(), "<text class=\"title\" x=\"", fixed(margin, 0),
      "\" y=\"30\">", escaped(sheet.title), "</text>\n");
  put_keys(out, sheet.keys);
  const Scale common = scale_of(charts);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    const double x = margin + left + static_cast<double>(column) * (box_width + gap);
    const double y = above + caption_height + static_cast<double>(row) * down;
    Panel(charts[i], sheet.same_scale ? common : scale_of(std::span(charts).subspan(i, 1)), x, y).put_all(out);
    if (auto written = sink(out); !written) return written;
    out.clear();
  }
  out += "</svg>\n";
  return sink(out);
}

}  // namespace leadscrew::report
