#include <leadscrew/report/path_view.hpp>

#include <leadscrew/markup/markup.hpp>

#include <algorithm>
#include <cmath>

namespace leadscrew::report {
namespace {

using markup::fixed;
using markup::put;

constexpr double rapid_width = 0.6;  // of the strokes of feed moves
constexpr double per_unit = 10;      // strokes are drawn in tenths of a unit, so that coordinates are short integers

struct Pixel {
  long x = 0;
  long y = 0;
  friend bool operator==(Pixel, Pixel) = default;
};

Pixel pixel(Seen seen, const Placement& placement) {
  const auto tenths = [](double value) {
    return std::isfinite(value) ? std::lround(std::clamp(value * per_unit, -1e6, 1e6)) : 0L;
  };
  return {tenths(placement.x(seen.right)), tenths(placement.y(seen.up))};
}

/// One pair of a path's data, the sign serving as separator where there is one.
void put_pair(std::string& out, char command, Pixel pair) {
  if (command)
    out += command;
  else if (pair.x >= 0)
    out += ' ';
  out += std::to_string(pair.x);
  if (pair.y >= 0) out += ' ';
  out += std::to_string(pair.y);
}

struct Level {
  std::string data;
  Pixel pen;
};

void put_mark(std::string& out, std::string_view kind, Pixel at) {
  const std::string x = std::to_string(at.x), y = std::to_string(at.y);
  if (kind == "start") {
    put(out, "<circle class=\"mark\" cx=\"", x, "\" cy=\"", y, "\" r=\"45\"><title>start</title></circle>");
  } else {
    put(out, "<path class=\"mark\" d=\"M", x, " ", y, "m-38-38h76v76h-76z\"><title>end</title></path>");
  }
}

}  // namespace

Seen seen_from(ViewSide side, const base::AxisVector& position) {
  const double x = position[0], y = position[1], z = position[2];
  switch (side) {
    case ViewSide::top:
      return {x, y};
    case ViewSide::front:
      return {x, z};
    case ViewSide::right:
      return {y, z};
    case ViewSide::isometric:
      return {(x + y) / std::sqrt(2.0), (y - x + 2 * z) / std::sqrt(6.0)};
  }
  return {};
}

SeenExtent extent_of(std::span<const PathPoint> path, ViewSide side) {
  SeenExtent extent;
  bool first = true;
  for (const PathPoint& point : path) {
    const Seen seen = seen_from(side, point.position);
    if (!std::isfinite(seen.right) || !std::isfinite(seen.up)) continue;
    if (first) extent = {seen.right, seen.right, seen.up, seen.up};
    first = false;
    extent = {std::min(extent.left, seen.right), std::max(extent.right, seen.right), std::min(extent.bottom, seen.up),
              std::max(extent.top, seen.up)};
  }
  return extent;
}

Placement centred(const SeenExtent& extent, double scale, double x, double y, double width, double height) {
  return {scale, x + width / 2 - scale * (extent.left + extent.right) / 2,
          y + height / 2 + scale * (extent.bottom + extent.top) / 2};
}

void put_strokes(std::string& out, std::span<const PathPoint> path, ViewSide side, const Placement& placement,
                 const SpeedScale& speeds, double stroke_width) {
  if (path.empty()) return;
  std::array<Level, speed_levels> levels;
  Level rapids;
  Pixel from = pixel(seen_from(side, path[0].position), placement);
  const Pixel start = from;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Pixel to = pixel(seen_from(side, path[i].position), placement);
    if (to == from) continue;
    const double feed = path[i - 1].is_rapid ? path[i].feed : (path[i - 1].feed + path[i].feed) / 2;
    Level& level = path[i].is_rapid ? rapids : levels[speeds.level(feed)];
    const bool goes_on = !level.data.empty() && level.pen == from;
    if (!goes_on) put_pair(level.data, 'M', from);
    put_pair(level.data, goes_on ? '\0' : 'l', {to.x - from.x, to.y - from.y});
    level.pen = to;
    from = to;
  }
  put(out, "<g class=\"strokes\" transform=\"scale(.1)\" fill=\"none\" stroke-width=\"",
      fixed(stroke_width * per_unit, 1), "\" stroke-linejoin=\"round\" stroke-linecap=\"round\">");
  if (!rapids.data.empty()) {
    put(out, "<path class=\"rapid\" stroke-width=\"", fixed(rapid_width * stroke_width * per_unit, 1),
        "\" stroke-dasharray=\"45 35\" stroke-linecap=\"butt\" d=\"", rapids.data, "\"/>\n");
  }
  for (std::size_t i = speed_levels; i-- > 0;) {
    if (!levels[i].data.empty()) put(out, "<path class=\"v", std::to_string(i), "\" d=\"", levels[i].data, "\"/>\n");
  }
  put_mark(out, "start", start);
  put_mark(out, "end", from);
  out += "</g>\n";
}

bool has_rapids(std::span<const PathPoint> path) {
  return std::ranges::any_of(path, &PathPoint::is_rapid);
}

std::string stroke_rules(Background background) {
  std::string out;
  for (std::size_t i = 0; i < speed_levels; ++i) {
    put(out, ".v", std::to_string(i), "{stroke:", speed_color(i, background), "}");
  }
  return out;
}

}  // namespace leadscrew::report
