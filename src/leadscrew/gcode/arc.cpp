#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_radius = 1e-6;       // mm; less is no circle
constexpr double harmless_shift = 1e-3;     // mm; by which a centre may always be moved
constexpr double harmless_shift_ratio = 2;  // and this many times the difference of the radii
constexpr double same = 8 * std::numeric_limits<double>::epsilon();

double distance(PlanePoint a, PlanePoint b) {
  return numeric::hypot(a.first - b.first, a.second - b.second);
}

PlanePoint middle(PlanePoint a, PlanePoint b) {
  return {a.first + (b.first - a.first) / 2, a.second + (b.second - a.second) / 2};
}

bool coincide(PlanePoint a, PlanePoint b) {
  return a.first == b.first && a.second == b.second;
}

// Rounding moves coordinates by units in the last place of the largest of them, not of the radius.
double rounding(PlanePoint start, PlanePoint end, PlanePoint center) {
  return same * std::max({std::fabs(start.first), std::fabs(start.second), std::fabs(end.first), std::fabs(end.second),
                          std::fabs(center.first), std::fabs(center.second)});
}

}  // namespace

double sweep(PlanePoint start, PlanePoint end, PlanePoint center, int direction) {
  if (coincide(start, end)) return 2 * pi;
  const double a = start.first - center.first, b = start.second - center.second;
  const double c = end.first - center.first, d = end.second - center.second;
  const double angle = numeric::atan2(direction * (a * d - b * c), a * c + b * d);
  return angle > 0 ? angle : angle + 2 * pi;
}

ArcCircle circle_by_center(PlanePoint start, PlanePoint end, PlanePoint center, int direction, int turns,
                           const ArcTolerance& tolerance) {
  ArcCircle circle{.center = center, .end = end};
  const double at_start = distance(start, center);
  const double at_end = distance(end, center);
  circle.difference = std::fabs(at_start - at_end);
  const double larger = std::max(at_start, at_end);
  if (!(std::min(at_start, at_end) >= least_radius) || !std::isfinite(larger)) {
    circle.problem = ArcCircle::Problem::zero_radius;
    return circle;
  }
  if (circle.difference > tolerance.most ||
      (circle.difference > tolerance.absolute && circle.difference > tolerance.relative * larger)) {
    circle.problem = ArcCircle::Problem::radii_differ;
    return circle;
  }
  circle.radius = at_start;
  if (circle.difference <= rounding(start, end, center)) return circle;

  const double chord = distance(start, end);
  const PlanePoint along{(end.first - start.first) / chord, (end.second - start.second) / chord};
  const PlanePoint mid = middle(start, end);
  const double shift = (center.first - mid.first) * along.first + (center.second - mid.second) * along.second;
  // Up to half a turn the ends hold the arc in place, wherever the centre goes.
  const bool short_arc = turns == 1 && sweep(start, end, center, direction) <= pi;
  if (short_arc || std::fabs(shift) <= std::max(harmless_shift, harmless_shift_ratio * circle.difference)) {
    circle.center = {center.first - shift * along.first, center.second - shift * along.second};
    circle.radius = distance(start, circle.center);
    return circle;
  }
  const double scale = at_start / at_end;
  circle.end = {center.first + scale * (end.first - center.first),
                center.second + scale * (end.second - center.second)};
  // A circle that closes to within rounding closes.
  if (distance(circle.end, start) <= rounding(start, end, center)) circle.end = start;
  return circle;
}

ArcCircle circle_by_radius(PlanePoint start, PlanePoint end, double radius, int direction,
                           const ArcTolerance& tolerance) {
  ArcCircle circle{.center = middle(start, end), .end = end};
  const double size = std::fabs(radius);
  if (!(size >= least_radius)) {
    circle.problem = ArcCircle::Problem::zero_radius;
    return circle;
  }
  if (coincide(start, end)) {
    circle.problem = ArcCircle::Problem::ends_coincide;
    return circle;
  }
  const double chord = distance(start, end);
  const double half = chord / 2;
  if (!(half - size <= tolerance.radius)) {
    circle.problem = ArcCircle::Problem::radius_too_small;
    circle.difference = half - size;
    return circle;
  }
  // The centre lies to the left of the chord from start to end for a short counterclockwise arc, and for a long
  // clockwise one.
  const double height = size > half ? std::sqrt((size - half) * (size + half)) : 0;
  const double left = (radius > 0) == (direction > 0) ? height : -height;
  const PlanePoint mid = middle(start, end);
  circle.center = {mid.first - left * ((end.second - start.second) / chord),
                   mid.second + left * ((end.first - start.first) / chord)};
  circle.radius = distance(start, circle.center);
  return circle;
}

PlaneBox arc_extent(PlanePoint start, PlanePoint end, PlanePoint center, int turns) {
  const double radius = distance(start, center);
  PlaneBox box{{std::min(start.first, end.first), std::min(start.second, end.second)},
               {std::max(start.first, end.first), std::max(start.second, end.second)}};
  const int direction = turns > 0 ? 1 : -1;
  const double angle = std::abs(turns) > 1 ? 2 * pi : sweep(start, end, center, direction);
  // The arc bulges beyond its ends in each of the four directions that it passes.
  const auto passes = [&](double first, double second) {
    return sweep(start, {center.first + radius * first, center.second + radius * second}, center, direction) < angle;
  };
  if (passes(1, 0)) box.high.first = center.first + radius;
  if (passes(0, 1)) box.high.second = center.second + radius;
  if (passes(-1, 0)) box.low.first = center.first - radius;
  if (passes(0, -1)) box.low.second = center.second - radius;
  return box;
}

}  // namespace leadscrew::gcode
