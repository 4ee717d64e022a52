// The path from four sides, each at equal scale in both directions, coloured by speed.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>
#include <leadscrew/report/path_thinning.hpp>
#include <leadscrew/report/path_view.hpp>

#include <algorithm>
#include <cmath>

namespace leadscrew::report {
namespace {

using markup::fixed;
using markup::put;
using markup::readable;
using markup::tick_decimals;
using markup::tick_step;

// A card in units of its SVG; the plot lies between the margins, which hold the ticks.
constexpr double card_width = 600, card_height = 420;
constexpr double left = 52, right = 14, above = 14, below = 34;
constexpr double plot_width = card_width - left - right, plot_height = card_height - above - below;
constexpr double border = 14;  // of the plot that the path leaves free
constexpr std::size_t most_points = 10000;

struct View {
  ViewSide side;
  std::string_view name;
  std::string_view across;  ///< axis to the right
  std::string_view upward;
};

constexpr std::array<View, 4> views = {{{ViewSide::top, "Top", "X", "Y"},
                                        {ViewSide::isometric, "Isometric", "", ""},
                                        {ViewSide::front, "Front", "X", "Z"},
                                        {ViewSide::right, "Right side", "Y", "Z"}}};

double fitting_scale(const SeenExtent& extent) {
  const double least = 1e-6;
  return std::min((plot_width - 2 * border) / std::max(extent.width(), least),
                  (plot_height - 2 * border) / std::max(extent.height(), least));
}

/// What a view must show: the path, and in the isometric view the box around it.
SeenExtent shown_extent(std::span<const PathPoint> path, ViewSide side) {
  if (side != ViewSide::isometric) return extent_of(path, side);
  const SeenExtent top = extent_of(path, ViewSide::top), front = extent_of(path, ViewSide::front);
  std::vector<PathPoint> corners;
  for (const double x : {top.left, top.right}) {
    for (const double y : {top.bottom, top.top}) {
      for (const double z : {front.bottom, front.top}) corners.push_back({{x, y, z}, 0});
    }
  }
  return extent_of(corners, side);
}

/// One scale for all sides, so that they can be compared; a side that would be lost in it gets its own. A path that
/// stands still is shown as in a window of 10 mm.
struct Scales {
  double common = 1;
  bool differ = false;

  double of(const SeenExtent& extent) const { return std::min(fitting_scale(extent), common * (differ ? 1e9 : 1)); }
};

Scales scales_of(std::span<const PathPoint> path) {
  double smallest = plot_height / 10 * 1e6, greatest = 0;
  for (const View& view : views) {
    const double scale = fitting_scale(shown_extent(path, view.side));
    smallest = std::min(smallest, scale);
    greatest = std::max(greatest, scale);
  }
  if (smallest > plot_height / 1e-2) smallest = plot_height / 10;
  return {smallest, greatest > 6 * smallest && greatest < 1e5 * smallest};
}

void put_ruler(std::string& out, const View& view, const Placement& placement) {
  const double step = tick_step(plot_width / placement.scale, 6);
  const int decimals = tick_decimals(step);
  const double bottom = above + plot_height;
  const auto label = [&](double value) {
    const std::string text = fixed(value, decimals);
    return value < -step / 2 ? "−" + text.substr(1) : text;
  };
  std::string lines, labels;
  const double first_x = std::ceil((left - placement.x0) / placement.scale / step) * step;
  for (int i = 0; i < 100; ++i) {
    const double value = first_x + i * step, x = placement.x(value);
    if (x > left + plot_width + 1e-9) break;
    put(lines, "M", fixed(x, 1), " ", fixed(above, 1), "v", fixed(plot_height, 1));
    put(labels, "<text text-anchor=\"middle\" x=\"", fixed(x, 1), "\" y=\"", fixed(bottom + 20, 1), "\">", label(value),
        "</text>");
  }
  const double first_y = std::ceil((placement.y0 - bottom) / placement.scale / step) * step;
  for (int i = 0; i < 100; ++i) {
    const double value = first_y + i * step, y = placement.y(value);
    if (y < above - 1e-9) break;
    put(lines, "M", fixed(left, 1), " ", fixed(y, 1), "h", fixed(plot_width, 1));
    put(labels, "<text text-anchor=\"end\" x=\"", fixed(left - 6, 1), "\" y=\"", fixed(y + 4, 1), "\">", label(value),
        "</text>");
  }
  put(out, "<path class=\"grid\" d=\"", lines, "\"/>\n<g class=\"ticks\">", labels, "</g>\n<text class=\"letter\" x=\"",
      fixed(left + plot_width - 4, 1), "\" y=\"", fixed(bottom - 6, 1), "\" text-anchor=\"end\">", view.across,
      "</text><text class=\"letter\" x=\"", fixed(left + 6, 1), "\" y=\"", fixed(above + 16, 1), "\">", view.upward,
      "</text>\n");
}

/// The box around the path, as floor and posts, and which way the axes point.
void put_box(std::string& out, std::span<const PathPoint> path, const Placement& placement) {
  const SeenExtent top = extent_of(path, ViewSide::top), front = extent_of(path, ViewSide::front);
  const auto corner = [&](double x, double y, double z) {
    const Seen seen = seen_from(ViewSide::isometric, {x, y, z});
    return fixed(placement.x(seen.right), 1) + " " + fixed(placement.y(seen.up), 1);
  };
  const auto edge = [&](const std::string& a, const std::string& b) { return "M" + a + "L" + b; };
  const double x[] = {top.left, top.right}, y[] = {top.bottom, top.top}, z[] = {front.bottom, front.top};
  std::string data;
  for (int i = 0; i < 2; ++i) {
    data += edge(corner(x[0], y[i], z[0]), corner(x[1], y[i], z[0]));
    data += edge(corner(x[i], y[0], z[0]), corner(x[i], y[1], z[0]));
    data += edge(corner(x[i], y[1], z[0]), corner(x[i], y[1], z[1]));
  }
  data += edge(corner(x[0], y[0], z[0]), corner(x[0], y[0], z[1]));
  data += edge(corner(x[0], y[1], z[1]), corner(x[1], y[1], z[1]));
  data += edge(corner(x[0], y[0], z[1]), corner(x[0], y[1], z[1]));
  put(out, "<path class=\"grid\" d=\"", data, "\"/>\n");

  constexpr double cx = 44, cy = card_height - 44, arm = 28, dx = arm * 0.866, dy = arm * 0.5;
  put(out, "<path class=\"triad\" d=\"M", fixed(cx, 1), " ", fixed(cy, 1), "l", fixed(dx, 1), " ", fixed(dy, 1), "M",
      fixed(cx, 1), " ", fixed(cy, 1), "l", fixed(dx, 1), " ", fixed(-dy, 1), "M", fixed(cx, 1), " ", fixed(cy, 1), "v",
      fixed(-arm, 1), "\"/><text class=\"letter\" x=\"", fixed(cx + dx + 5, 1), "\" y=\"", fixed(cy + dy + 6, 1),
      "\">X</text><text class=\"letter\" x=\"", fixed(cx + dx + 5, 1), "\" y=\"", fixed(cy - dy + 3, 1),
      "\">Y</text><text class=\"letter\" x=\"", fixed(cx, 1), "\" y=\"", fixed(cy - arm - 6, 1),
      "\" text-anchor=\"middle\">Z</text>\n");
}

/// Where the blocks are that lose most time, by their numbers in the table; the first on top.
void put_places(std::string& page, const View& view, std::span<const LostBlock> blocks, const Placement& placement) {
  for (std::size_t i = blocks.size(); i-- > 0;) {
    const Seen seen = seen_from(view.side, blocks[i].middle);
    const std::string rank = std::to_string(i + 1);
    put(page, "<a class=\"place\" data-place=\"", rank, "\" href=\"#lost", rank, "\"><circle cx=\"",
        fixed(placement.x(seen.right), 1), "\" cy=\"", fixed(placement.y(seen.up), 1), "\" r=\"8\"/><text x=\"",
        fixed(placement.x(seen.right), 1), "\" y=\"", fixed(placement.y(seen.up) + 4, 1), "\">", rank, "</text></a>");
  }
}

std::string diamond(double x, double y, double size) {
  const std::string side = fixed(size, 1);
  return "<path d=\"M" + fixed(x, 1) + " " + fixed(y - size, 1) + "l" + side + " " + side + "l-" + side + " " + side +
         "l-" + side + "-" + side + "z\"/>";
}

/// Where tools are inside surfaces: small diamonds, and large ones with the numbers of the table.
void put_gouges(std::string& page, const View& view, const Gouging& gouging, const Placement& placement) {
  constexpr double small = 3, large = 11;
  put(page, "<g class=\"gouges\">");
  for (const base::AxisVector& place : gouging.places) {
    const Seen seen = seen_from(view.side, place);
    page += diamond(placement.x(seen.right), placement.y(seen.up), small);
  }
  put(page, "</g>\n");
  for (std::size_t i = std::min(gouging.blocks.size(), most_gouges); i-- > 0;) {
    const Seen seen = seen_from(view.side, gouging.blocks[i].place);
    const double x = placement.x(seen.right), y = placement.y(seen.up);
    const std::string rank = std::to_string(i + 1);
    put(page, "<a class=\"place gouge\" data-place=\"gouge", rank, "\" href=\"#gouge", rank, "\">",
        diamond(x, y, large), "<text x=\"", fixed(x, 1), "\" y=\"", fixed(y + 4, 1), "\">", rank, "</text></a>");
  }
}

/// What the views show, each from its side.
struct Shown {
  std::vector<PathPoint> path;
  std::vector<PathPoint> framed;  ///< what has to be inside the views: the path, and where tools are inside surfaces
  Scales scales;
  SpeedScale speeds;
  std::vector<LostBlock> lost;
  std::optional<Gouging> gouging;
};

Shown shown_of(const PageContent& content, const base::AxisSet& axes) {
  const Recording& recording = content.recording;
  Shown shown;
  shown.path = thinned_to(recording.path(), axes, most_points, {0.001, 0.01 * recording.greatest_feed()});
  shown.framed = shown.path;
  shown.gouging = content.report.gouging;
  if (shown.gouging) {
    for (const base::AxisVector& place : shown.gouging->places) shown.framed.push_back({place, 0});
    for (const Gouge& gouge : shown.gouging->blocks) shown.framed.push_back({gouge.place, 0});
  }
  shown.scales = scales_of(shown.framed);
  shown.speeds = speed_scale(shown.path, recording.greatest_feed());
  shown.lost = recording.dearest_blocks();
  return shown;
}

void put_card(std::string& page, const View& view, const Shown& shown) {
  const SeenExtent extent = shown_extent(shown.framed, view.side);
  const Placement placement = centred(extent, shown.scales.of(extent), left, above, plot_width, plot_height);
  put(page, "<figure class=\"card\"><figcaption><b>", view.name, "</b> ");
  if (view.side == ViewSide::isometric) {
    put(page, "from the front, right and above");
  } else {
    put(page, view.across, view.upward, ", mm");
  }
  put(page, "</figcaption>\n<svg viewBox=\"0 0 ", fixed(card_width, 0), " ", fixed(card_height, 0),
      "\" role=\"img\" aria-label=\"Path, ", view.name, "\">\n");
  if (view.side == ViewSide::isometric) {
    put_box(page, shown.framed, placement);
  } else {
    put_ruler(page, view, placement);
  }
  put_strokes(page, shown.path, view.side, placement, shown.speeds, 1.5);
  put_places(page, view, shown.lost, placement);
  if (shown.gouging) put_gouges(page, view, *shown.gouging, placement);
  put(page, "</svg></figure>\n");
}

void put_color_bar(std::string& page, const SpeedScale& speeds, bool has_rapids) {
  const std::string_view rapids = has_rapids ? "<i class=\"rapid\"></i>rapids. " : "";
  constexpr std::string_view marks_text = "Ring: start; square: end.";
  if (!(speeds.greatest > 0)) return put(page, "<p class=\"note keys\">", rapids, marks_text, "</p>\n");
  put(page, "<div class=\"speeds\"><div class=\"bar\" aria-hidden=\"true\">");
  for (std::size_t i = 0; i < speed_levels; ++i) put(page, "<i class=\"v", std::to_string(i), "\"></i>");
  put(page, "</div><div class=\"marks\">");
  const double greatest = speeds.greatest * 60;
  constexpr double apart = 0.14;  // of the bar, so that marks do not touch
  std::vector<double> marks{0};
  const double step = tick_step(greatest, speeds.square_root ? 16 : 5);
  for (int i = 1; i < 40 && greatest > 0; ++i) {
    const double place = speeds.place(i * step / 60);
    if (place > 1 - apart) break;
    if (place > speeds.place(marks.back() / 60) + apart) marks.push_back(i * step);
  }
  if (greatest > 0) marks.push_back(greatest);
  for (const double mark : marks) {
    const double place = speeds.place(mark / 60);
    const char* edge = place > 0.99 ? " class=\"e\"" : place < 0.01 ? " class=\"b\"" : "";
    put(page, "<span", edge, " style=\"left:", fixed(place * 100, 1), "%\">", readable(mark, 3), "</span>");
  }
  put(page, "</div><p class=\"note keys\">", has_rapids ? "Speed of feed moves" : "Speed along the path", ", mm/min",
      speeds.square_root ? ", on a square-root scale. " : ". ", rapids, marks_text, "</p></div>\n");
}

}  // namespace

void put_path_section(std::string& page, const PageContent& content) {
  base::AxisSet axes;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    if (content.machine.has(axis)) axes.insert(axis);
  }
  put(page, "<section id=\"path\"><h2>Path</h2>\n");
  if (content.recording.path().empty() || axes.empty()) {
    put(page, "<p class=\"note\">", axes.empty() ? "The machine has none of the axes X Y Z." : "Nothing was recorded.",
        "</p></section>\n");
    return;
  }
  const Shown shown = shown_of(content, axes);
  put_color_bar(page, shown.speeds, has_rapids(shown.path));
  put(page, "<div class=\"views\">\n");
  for (const View& view : views) put_card(page, view, shown);
  const bool gouges = shown.gouging && !shown.gouging->blocks.empty();
  put(page, "</div>\n<p class=\"note\">",
      content.recording.shows_tip() ? "Positions of the tool’s tip in the workpiece. " : "Positions of the axes. ",
      shown.scales.differ ? "Each view has its own scale, equal in both directions."
                          : "All views are at the same scale.",
      shown.lost.empty() ? "" : " Numbers: the blocks that <a href=\"#losses\">lose most time</a>.",
      gouges ? " Diamonds: where <a href=\"#gouging\">the tool gouges</a>." : "", "</p></section>\n");
}

}  // namespace leadscrew::report
