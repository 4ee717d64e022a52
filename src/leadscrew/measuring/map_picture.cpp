#include <algorithm>
#include <cmath>
#include <cstdint>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/measuring/map_picture.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/report/path_view.hpp>

namespace leadscrew::measuring {

namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable_distance;

constexpr double width = 800, margin = 24;
constexpr double title_height = 46, heading_height = 30, legend_height = 56, section_height = 150, gap = 34;
constexpr double tallest_map = 420;
constexpr double cell = 3;  // of the map, in units of the picture
constexpr double bar_width = 192;
constexpr double steps_shown = 3;  // on either side of the section's ridge

/// Height to the place on the ramp of colours; the square root of it where most of what is left is much lower than the tallest.
struct HeightScale {
  double top = 0;
  bool square_root = false;
  double allowed = 0;  // of cuts

  std::size_t level(double height) const {
    const double part = top > 0 ? std::clamp(height / top, 0.0, 1.0) : 0;
    const auto levels = static_cast<double>(report::speed_levels);
    return std::min(static_cast<std::size_t>((square_root ? std::sqrt(part) : part) * levels),
                    report::speed_levels - 1);
  }
};

HeightScale scale_of(const Pictured& pictured) {
  const Findings& found = pictured.measurement->findings();
  return {std::max(0.0, found.ridge.height), found.ridges > 0 && found.mean_ridge < 0.25 * found.ridge.height,
          pictured.allowed_cut};
}

/// Where the two parameters lie in the picture: u to the right, v up.
struct MapPlace {
  double left = margin, top = 0, wide = 0, high = 0;

  double x(const Measurement& measurement, double u) const {
    const surfaces::Range& range = measurement.target().u;
    return left + wide * (u - range.from) / (range.to - range.from);
  }
  double y(const Measurement& measurement, double v) const {
    const surfaces::Range& range = measurement.target().v;
    return top + high * (1 - (v - range.from) / (range.to - range.from));
  }
};

double length_of_line(const PlaceTree& map, bool of_u) {
  double length = 0;
  const std::size_t count = of_u ? map.columns() : map.rows(), middle = (of_u ? map.rows() : map.columns()) / 2;
  const auto at = [&](std::size_t k) { return of_u ? map.at(k, middle).s : map.at(middle, k).s; };
  for (std::size_t k = 1; k < count; ++k) length += numeric::distance(at(k), at(k - 1));
  return length;
}

/// As wide to high as the surface is long both ways.
MapPlace place_of(const Measurement& measurement, double top) {
  const double u = std::max(length_of_line(measurement.map(), true), 1e-9);
  const double v = std::max(length_of_line(measurement.map(), false), 1e-9);
  const double scale = std::min((width - 2 * margin) / u, tallest_map / v);
  MapPlace place;
  place.top = top;
  place.wide = std::max(u * scale, 24.0);
  place.high = std::max(v * scale, 24.0);
  return place;
}

/// Of the places in a cell of the picture: the greatest height, the least, and whether one was not reached.
struct CellHeights {
  double most = no_place, least = 0;
  bool unreached = false;
};

enum : std::int8_t { empty_cell = -1, unreached_cell = -2, cut_cell = -3 };

int kind_of(const CellHeights& heights, const HeightScale& scale) {
  if (heights.unreached) return unreached_cell;
  if (heights.least < -scale.allowed) return cut_cell;
  return heights.most == no_place ? int{empty_cell} : static_cast<int>(scale.level(heights.most));
}

/// Places from … to − 1 of a line of the grid.
struct Places {
  std::size_t from = 0, to = 0;
};

/// Those that fall into a cell, or the one beside it where none does.
Places places_in(std::size_t cell_number, std::size_t cells, std::size_t places) {
  const std::size_t from = cell_number * places / cells;
  return {from, std::max(from + 1, (cell_number + 1) * places / cells)};
}

/// Those within half a step as well, so that every cell has a ridge in it.
Places widened(const Places& places, double half_step, std::size_t count) {
  const auto more = static_cast<std::size_t>(half_step);
  return {places.from - std::min(places.from, more), std::min(count, places.to + more)};
}

CellHeights heights_in(const PlaceTree& map, const Places& columns, const Places& rows, double reach) {
  CellHeights heights;
  for (std::size_t j = rows.from; j < rows.to; ++j) {
    for (std::size_t i = columns.from; i < columns.to; ++i) {
      const double height = map.at(i, j).height;
      if (height == no_place) continue;
      heights.unreached = heights.unreached || height >= reach;
      if (height < reach) heights.most = std::max(heights.most, height);
      heights.least = std::min(heights.least, height);
    }
  }
  return heights;
}

std::vector<CellHeights> cells_of(const Measurement& measurement, std::size_t columns, std::size_t rows) {
  const PlaceTree& map = measurement.map();
  const Target& target = measurement.target();
  const bool across_u = target.across == Target::Across::u;
  const double length = std::max(length_of_line(map, across_u), 1e-9);
  const double places_per_step = target.step * static_cast<double>(across_u ? map.columns() : map.rows()) / length;
  const double half = std::min(places_per_step / 2, 64.0);
  std::vector<CellHeights> cells;
  for (std::size_t row = 0; row < rows; ++row) {
    const Places j = places_in(row, rows, map.rows());
    for (std::size_t column = 0; column < columns; ++column) {
      const Places i = places_in(column, columns, map.columns());
      cells.push_back(heights_in(map, i, j, target.reach));
      cells.back().most =
          std::max(cells.back().most, target.across == Target::Across::u
                                          ? heights_in(map, widened(i, half, map.columns()), j, target.reach).most
                                          : heights_in(map, i, widened(j, half, map.rows()), target.reach).most);
    }
  }
  return cells;
}

/// Cells of one kind that lie side by side are one stroke.
void put_map(std::string& out, const Measurement& measurement, const MapPlace& place, const HeightScale& scale) {
  const auto columns = static_cast<std::size_t>(std::ceil(place.wide / cell)),
             rows = static_cast<std::size_t>(std::ceil(place.high / cell));
  const std::vector<CellHeights> cells = cells_of(measurement, columns, rows);
  const double wide = place.wide / static_cast<double>(columns), high = place.high / static_cast<double>(rows);
  std::vector<std::string> strokes(report::speed_levels + 4);
  for (std::size_t row = 0; row < rows; ++row) {
    const double y = place.top + place.high - (static_cast<double>(row) + 0.5) * high;
    for (std::size_t column = 0, end = 0; column < columns; column = end) {
      const int kind = kind_of(cells[row * columns + column], scale);
      for (end = column + 1; end < columns && kind_of(cells[row * columns + end], scale) == kind;) ++end;
      const int stroke = kind + 4;
      put(strokes[static_cast<std::size_t>(stroke)], "M", fixed(place.left + static_cast<double>(column) * wide, 1),
          " ", fixed(y, 1), "h", fixed(static_cast<double>(end - column) * wide + 0.3, 1));
    }
  }
  put(out, "<g shape-rendering=\"crispEdges\" stroke-width=\"", fixed(high + 0.3, 2), "\">\n");
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    if (strokes[k].empty() || k == 3) continue;
    put(out, "<path class=\"",
        k == 1   ? "cut"
        : k == 2 ? "missed"
                 : "v" + std::to_string(k - 4),
        "\" d=\"", strokes[k], "\"/>\n");
  }
  put(out, "</g>\n<rect class=\"rule\" x=\"", fixed(place.left, 1), "\" y=\"", fixed(place.top, 1), "\" width=\"",
      fixed(place.wide, 1), "\" height=\"", fixed(place.high, 1), "\"/>\n");
}

void put_peak(std::string& out, const Measurement& measurement, const MapPlace& place, const Peak& peak, bool is_cut) {
  const double x = place.x(measurement, peak.u), y = place.y(measurement, peak.v);
  put(out, "<path class=\"peak\" d=\"M", fixed(x - 6, 1), " ", fixed(y, 1), is_cut ? "h12l-6 10z" : "h12l-6 -10z",
      "\"><title>", is_cut ? "deepest cut " : "tallest ridge ", readable_distance(std::abs(peak.height)),
      "</title></path>\n");
}

void put_legend(std::string& out, const Measurement& measurement, const HeightScale& scale, double y) {
  constexpr double step = bar_width / report::speed_levels;
  out += "<g stroke-width=\"8\">";
  for (std::size_t k = 0; k < report::speed_levels; ++k)
    put(out, "<path class=\"v", std::to_string(k), "\" d=\"M", fixed(margin + step * static_cast<double>(k), 1), " ",
        fixed(y, 1), "h", fixed(step + 0.3, 1), "\"/>");
  put(out, "</g>\n<text x=\"", fixed(margin, 1), "\" y=\"", fixed(y + 21, 1), "\">0</text><text x=\"",
      fixed(margin + bar_width, 1), "\" y=\"", fixed(y + 21, 1), "\" text-anchor=\"end\">",
      readable_distance(scale.top), scale.square_root ? " (square root)" : "", "</text>\n");
  double x = margin + bar_width + 40;
  const auto key = [&](const std::string& mark, const std::string& text) {
    put(out, mark, "<text x=\"", fixed(x + 20, 1), "\" y=\"", fixed(y + 4, 1), "\">", text, "</text>\n");
    x += 32 + 7.2 * static_cast<double>(text.size());
  };
  const auto stroke = [&](const std::string& kind) {
    return "<path class=\"" + kind + "\" stroke-width=\"8\" d=\"M" + fixed(x, 1) + " " + fixed(y, 1) + "h14\"/>";
  };
  const auto triangle = [&](bool is_cut) {
    return "<path class=\"peak\" d=\"M" + fixed(x + 1, 1) + " " + fixed(is_cut ? y - 5 : y + 5, 1) +
           (is_cut ? "h12l-6 10z\"/>" : "h12l-6 -10z\"/>");
  };
  const Findings& found = measurement.findings();
  if (found.ridge.exists()) key(triangle(false), "tallest");
  if (found.cut.exists()) key(triangle(true), "deepest cut");
  if (-found.cut.height > scale.allowed) key(stroke("cut"), "cut deeper than allowed");
  if (found.not_reached > 0) key(stroke("missed"), "not reached");
}

/// Heights along the line of the grid that runs across the passes through the tallest ridge.
struct Section {
  std::vector<double> along, height;  // mm
  double left = 0, right = 0;         // of what is shown
  double low = 0, high = 0;
};

std::size_t nearest(const std::vector<double>& lines, double at) {
  const auto found = std::lower_bound(lines.begin(), lines.end(), at);
  return static_cast<std::size_t>(std::min(found, lines.end() - 1) - lines.begin());
}

Section section_of(const Measurement& measurement) {
  const PlaceTree& map = measurement.map();
  const Peak& ridge = measurement.findings().ridge;
  const bool along_v = measurement.target().across != Target::Across::u;
  const std::size_t line = along_v ? nearest(measurement.lines().u, ridge.u) : nearest(measurement.lines().v, ridge.v);
  const std::size_t middle =
      along_v ? nearest(measurement.lines().v, ridge.v) : nearest(measurement.lines().u, ridge.u);
  const auto at = [&](std::size_t k) -> const GridPlace& { return along_v ? map.at(line, k) : map.at(k, line); };
  Section section;
  double length = 0, centre = 0;
  for (std::size_t k = 0; k < (along_v ? map.rows() : map.columns()); ++k) {
    if (k > 0) length += numeric::distance(at(k).s, at(k - 1).s);
    if (k == middle) centre = length;
    section.along.push_back(length);
    section.height.push_back(at(k).height);
  }
  const double half = std::min(steps_shown * measurement.target().step, length / 2);
  centre = std::clamp(centre, half, length - half);
  section.left = centre - half, section.right = centre + half;
  section.high = ridge.height;
  for (std::size_t k = 0; k < section.along.size(); ++k) {
    if (section.along[k] < section.left || section.along[k] > section.right || section.height[k] == no_place) continue;
    if (section.height[k] < measurement.target().reach) section.high = std::max(section.high, section.height[k]);
    section.low = std::min(section.low, section.height[k]);
  }
  return section;
}

void put_section(std::string& out, const Pictured& pictured, double top) {
  const Section section = section_of(*pictured.measurement);
  const double high = std::max({section.high, pictured.scallop, 1e-6}) * 1.12, low = std::min(section.low * 1.12, 0.0);
  const double wide = width - 2 * margin - 60, left = margin + 60;
  const auto x = [&](double at) { return left + wide * (at - section.left) / (section.right - section.left); };
  const auto y = [&](double h) { return top + section_height * (high - h) / (high - low); };
  std::string line;
  for (std::size_t k = 0; k < section.along.size(); ++k) {
    if (section.along[k] < section.left || section.along[k] > section.right || section.height[k] == no_place) continue;
    put(line, line.empty() ? "" : " ", fixed(x(section.along[k]), 1), " ",
        fixed(y(std::min(section.height[k], high)), 2));
  }
  put(out, "<text x=\"", fixed(margin, 1), "\" y=\"", fixed(top - 10, 1),
      "\">Across the passes, through the tallest ridge</text>\n");
  if (!line.empty()) {
    const std::size_t space = line.find(' '), last = line.rfind(' ', line.rfind(' ') - 1);
    const std::string first_x = line.substr(0, space),
                      last_x = line.substr(last == std::string::npos ? 0 : last + 1, line.rfind(' ') - last - 1);
    put(out, "<path class=\"left\" d=\"M", first_x, " ", fixed(y(0), 2), " L", line, " L", last_x, " ", fixed(y(0), 2),
        "z\"/><polyline class=\"edge\" points=\"", line, "\"/>\n");
  }
  put(out, "<path class=\"rule\" d=\"M", fixed(left, 1), " ", fixed(y(0), 1), "h", fixed(wide, 1), "\"/><text x=\"",
      fixed(left - 8, 1), "\" y=\"", fixed(y(0) + 4, 1), "\" text-anchor=\"end\">0</text>\n");
  const double level = pictured.scallop > 0 ? pictured.scallop : section.high;
  put(out, "<path class=\"rule\" stroke-dasharray=\"5 4\" d=\"M", fixed(left, 1), " ", fixed(y(level), 1), "h",
      fixed(wide, 1), "\"/><text x=\"", fixed(left - 8, 1), "\" y=\"", fixed(y(level) + 4, 1),
      "\" text-anchor=\"end\">", readable_distance(level), "</text>\n");
  const double length = markup::tick_step((section.right - section.left) / 4, 1),
               drawn = wide * length / (section.right - section.left);
  put(out, "<path class=\"rule\" d=\"M", fixed(left + wide - drawn, 1), " ", fixed(top + section_height + 12, 1),
      "v10m0-5h", fixed(drawn, 1), "m0-5v10\"/><text x=\"", fixed(left + wide - drawn - 8, 1), "\" y=\"",
      fixed(top + section_height + 21, 1), "\" text-anchor=\"end\">", markup::readable(length), " mm</text>\n");
}

void put_measured_style(std::string& out) {
  put(out,
      "<style>text{font:500 13px system-ui,-apple-system,'Segoe "
      "UI',sans-serif;fill:#6b747c}.title{font-size:16px;font-weight:600}",
      ".rule{stroke:#7d868e;fill:none}.cut{stroke:#d6402b}.missed{stroke:#9aa5ad;stroke-opacity:.45}.peak{fill:#d6402b;"
      "stroke:#fff;stroke-width:1.5}",
      ".left{fill:#3b8ea5;fill-opacity:.25}.edge{fill:none;stroke:#3b8ea5;stroke-width:1.5}",
      report::stroke_rules(report::Background::either),
      "@media(prefers-color-scheme:dark){text{fill:#9aa5ad}.cut{stroke:#ff7a5c}.peak{fill:#ff7a5c;stroke:#13171a}.left{"
      "fill:#5db6d4}.edge{stroke:#5db6d4}",
      report::stroke_rules(report::Background::dark), "}</style>\n");
}

}  // namespace

base::Result<void> write_map_svg(const std::string& title, const std::vector<Pictured>& surfaces,
                                 const base::ByteSink& sink) {
  std::string body;
  double y = title_height;
  for (const Pictured& pictured : surfaces) {
    const Measurement& measurement = *pictured.measurement;
    const HeightScale scale = scale_of(pictured);
    put(body, "<text x=\"", fixed(margin, 1), "\" y=\"", fixed(y + 12, 1), "\">", escaped(pictured.title, 100),
        "</text>\n");
    const MapPlace place = place_of(measurement, y + heading_height);
    put_map(body, measurement, place, scale);
    if (measurement.findings().ridge.exists()) put_peak(body, measurement, place, measurement.findings().ridge, false);
    if (measurement.findings().cut.exists()) put_peak(body, measurement, place, measurement.findings().cut, true);
    y = place.top + place.high + 26;
    put_legend(body, measurement, scale, y);
    y += legend_height;
    if (measurement.findings().ridge.exists()) {
      put_section(body, pictured, y);
      y += section_height + 26;
    }
    y += gap;
  }
  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(y, 0), "\" width=\"",
      fixed(width, 0), "\" height=\"", fixed(y, 0), "\" role=\"img\">\n<title>", escaped(title), "</title>\n");
  put_measured_style(out);
  put(out, "<text class=\"title\" x=\"", fixed(margin, 0), "\" y=\"28\">", escaped(title, 80), "</text>\n", body,
      "</svg>\n");
  return sink(out);
}

}  // namespace leadscrew::measuring
