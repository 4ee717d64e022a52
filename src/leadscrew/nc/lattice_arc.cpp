#include <algorithm>
#include <cmath>
#include <leadscrew/nc/lattice_arc.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::nc {

namespace {

constexpr double least_radius = 1;        // steps
constexpr double small_radius = 2;        // steps; below, an end beside the circle is another circle's
constexpr std::int64_t search_width = 2;  // steps to each side of the true centre

double length(pulse::Point from, pulse::Point to) {
  return std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
}

/// Ends off the circle cost most: beyond half a step they take it out of the bounds of its method.
double cost(const TrueArc& arc, pulse::Point center, pulse::Point start, pulse::Point end) {
  const double beside = std::abs(length(center, start) - length(center, end));
  const double moved =
      std::hypot(static_cast<double>(center.x) - arc.center_x, static_cast<double>(center.y) - arc.center_y);
  const double other_radius = std::abs(length(center, start) - arc.radius);
  return 4 * std::max(0.0, beside - 0.5) + beside / 4 + moved + other_radius;
}

pulse::Point best_center(const TrueArc& arc, pulse::Point start, pulse::Point end) {
  const pulse::Point nearest{std::llround(arc.center_x), std::llround(arc.center_y)};
  pulse::Point best = nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::int64_t dx = -search_width; dx <= search_width; ++dx) {
    for (std::int64_t dy = -search_width; dy <= search_width; ++dy) {
      const pulse::Point tried{nearest.x + dx, nearest.y + dy};
      if (tried == start || tried == end) continue;
      if (const double costs = cost(arc, tried, start, end); costs < least) {
        least = costs;
        best = tried;
      }
    }
  }
  return best;
}

}  // namespace

double sweep(const pulse::Arc& arc) {
  const double sense = static_cast<double>(arc.direction);
  const double from = std::atan2(static_cast<double>(arc.start.y), static_cast<double>(arc.start.x));
  const double to = std::atan2(static_cast<double>(arc.end.y), static_cast<double>(arc.end.x));
  const double angle = sense * (to - from);
  return arc.start != arc.end && angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

std::optional<pulse::Arc> on_lattice(const TrueArc& arc, pulse::Point start, pulse::Point end) {
  if (arc.radius < least_radius) return std::nullopt;
  const pulse::Point center = best_center(arc, start, end);
  const pulse::Arc placed{
      {start.x - center.x, start.y - center.y}, {end.x - center.x, end.y - center.y}, arc.direction};
  if (std::abs(sweep(placed) - arc.sweep) > std::numbers::pi / 2) return std::nullopt;
  const double beside = std::abs(length(center, start) - length(center, end));
  if (arc.radius < small_radius && beside > 0.5) return std::nullopt;
  return placed;
}

}  // namespace leadscrew::nc
