// The path as a picture of its own, for pages that show files as images.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/path_thinning.hpp>
#include <leadscrew/report/path_view.hpp>
#include <leadscrew/report/report.hpp>

#include <algorithm>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable;
using markup::tick_step;

constexpr double width = 800;
constexpr double margin = 24;
constexpr double title_height = 46;
constexpr double legend_height = 58;
constexpr std::size_t most_points = 10000;  // at worst 24 bytes each

base::AxisSet linear_axes() {
  base::AxisSet axes;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) axes.insert(axis);
  return axes;
}

bool is_flat(std::span<const PathPoint> path) {
  const SeenExtent top = extent_of(path, ViewSide::top);
  return extent_of(path, ViewSide::front).height() <= 1e-3 * std::max(top.width(), top.height());
}

/// Greyer than black on white and than white on black, so that it reads on both where a page does not tell which it is.
void put_style(std::string& out) {
  put(out,
      "<style>text{font:500 13px system-ui,-apple-system,'Segoe UI',sans-serif;fill:#6b747c}.title{font-size:16px;",
      "font-weight:600}.mark{stroke:#7d868e;stroke-width:14}.rule,.rapid{stroke:#7d868e;fill:none}",
      stroke_rules(Background::either), "@media(prefers-color-scheme:dark){text{fill:#9aa5ad}",
      stroke_rules(Background::dark), "}</style>\n");
}

constexpr double bar_width = 192;

void put_color_bar(std::string& out, const SpeedScale& speeds, double x, double y) {
  constexpr double step = bar_width / speed_levels;
  out += "<g stroke-width=\"8\">";
  for (std::size_t i = 0; i < speed_levels; ++i) {
    const double left = x + step * static_cast<double>(i);
    put(out, "<path class=\"v", std::to_string(i), "\" d=\"M", fixed(left, 1), " ", fixed(y, 1), "h",
        fixed(step + 0.3, 1), "\"/>");
  }
  put(out, "</g>\n<text x=\"", fixed(x, 1), "\" y=\"", fixed(y + 21, 1), "\">0</text><text x=\"",
      fixed(x + bar_width, 1), "\" y=\"", fixed(y + 21, 1), "\" text-anchor=\"end\">",
      readable(speeds.greatest * 60, 3), " mm/min</text>\n");
}

void put_rapid_key(std::string& out, double x, double y) {
  put(out, "<path class=\"rapid\" stroke-dasharray=\"4.5 3.5\" d=\"M", fixed(x, 1), " ", fixed(y, 1),
      "h44\"/><text x=\"", fixed(x, 1), "\" y=\"", fixed(y + 21, 1), "\">rapids</text>\n");
}

void put_scale_bar(std::string& out, double scale, double right, double y) {
  const double length = tick_step(150 / scale, 1);
  const double drawn = length * scale;
  put(out, "<path class=\"rule\" d=\"M", fixed(right - drawn, 1), " ", fixed(y - 5, 1), "v10m0-5H", fixed(right, 1),
      "m0-5v10\"/><text x=\"", fixed(right, 1), "\" y=\"", fixed(y + 21, 1), "\" text-anchor=\"end\">",
      readable(length), " mm</text>\n");
}

}  // namespace

base::Result<void> write_path_svg(const std::string& title, const Recording& recording, const base::ByteSink& sink) {
  const std::vector<PathPoint> path =
      thinned_to(recording.path(), linear_axes(), most_points, {0.001, 0.01 * recording.greatest_feed()});
  const SpeedScale speeds = speed_scale(path, recording.greatest_feed());
  const ViewSide side = is_flat(path) ? ViewSide::top : ViewSide::isometric;
  const SeenExtent extent = extent_of(path, side);

  const bool is_point = std::max(extent.width(), extent.height()) < 1e-6;
  const double greatest = is_point ? 10 : std::max(extent.width(), extent.height());  // mm
  const double wide = std::max(extent.width(), greatest * 1e-3), high = std::max(extent.height(), greatest * 1e-3);
  const double available_width = width - 2 * margin;
  const double picture = std::clamp(available_width * high / wide, 120.0, 520.0);
  const double scale = std::min(available_width / wide, picture / high);
  const double height = title_height + picture + legend_height;
  const Placement placement = centred(extent, scale, margin, title_height, available_width, picture);

  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(height, 0),
      "\" width=\"", fixed(width, 0), "\" height=\"", fixed(height, 0), "\" role=\"img\">\n<title>", escaped(title),
      "</title>\n");
  put_style(out);
  put(out, "<text class=\"title\" x=\"", fixed(margin, 0), "\" y=\"28\">", escaped(title, 80), "</text>\n");
  put_strokes(out, path, side, placement, speeds, 1.4);
  const bool has_colors = speeds.greatest > 0;
  if (has_colors) put_color_bar(out, speeds, margin, height - 32);
  if (has_rapids(path)) put_rapid_key(out, margin + (has_colors ? bar_width + 30 : 0), height - 32);
  put_scale_bar(out, scale, width - margin, height - 32);
  out += "</svg>\n";
  return sink(out);
}

}  // namespace leadscrew::report
