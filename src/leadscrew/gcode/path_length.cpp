#include <cstdlib>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/path_length.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

double span_of_three(const Move& move, base::Axis axis) {
  const std::size_t i = base::index(axis);
  return numeric::hypot(move.end[i] - move.start[i], move.end[i + 1] - move.start[i + 1],
                        move.end[i + 2] - move.start[i + 2]);
}

}  // namespace

double path_length(const Move& move) {
  if (move.kind == Move::Kind::arc) {
    const PlanePoint start = in_plane(move.start, move.plane), end = in_plane(move.end, move.plane);
    const PlanePoint center{move.center_first, move.center_second};
    const int direction = move.turns > 0 ? 1 : -1;
    const double angle =
        sweep(start, end, center, direction) + (std::abs(move.turns) - 1) * sweep(start, start, center, direction);
    const double radius = numeric::hypot(start.first - center.first, start.second - center.second);
    const std::size_t normal = base::index(normal_axis(move.plane));
    return numeric::hypot(radius * angle, move.end[normal] - move.start[normal]);
  }
  for (const base::Axis axis : {base::Axis::X, base::Axis::U}) {
    if (const double length = span_of_three(move, axis); length > 0) return length;
  }
  return span_of_three(move, base::Axis::A);
}

}  // namespace leadscrew::gcode
