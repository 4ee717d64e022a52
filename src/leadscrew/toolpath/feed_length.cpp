#include <cmath>
#include <leadscrew/toolpath/feed_length.hpp>

namespace leadscrew::toolpath {

namespace {

using base::Axis;
using base::index;
using geometry::Point;

double distance_in(const Point& start, const Point& end, Axis a, Axis b, Axis c) {
  const auto along = [&](Axis axis) { return end[index(axis)] - start[index(axis)]; };
  return std::hypot(along(a), along(b), along(c));
}

struct Turn {
  double radius = 0;
  numeric::DoubleDouble sweep;
};

Turn turn(const gcode::Move& move) {
  const std::size_t first = index(gcode::first_axis(move.plane)), second = index(gcode::second_axis(move.plane));
  const double x = move.start[first] - move.center_first, y = move.start[second] - move.center_second;
  return {std::hypot(x, y), geometry::sweep_angle(x, y, move.end[first] - move.center_first,
                                                  move.end[second] - move.center_second, move.turns)};
}

double arc_length(const gcode::Move& move, const Turn& turn) {
  const std::size_t normal = index(gcode::normal_axis(move.plane));
  return geometry::Arc::way(turn.radius, turn.sweep, move.end[normal] - move.start[normal]);
}

geometry::Curve arc(const gcode::Move& move, const Turn& turn, double length) {
  return geometry::Arc(move.start, move.end, index(gcode::first_axis(move.plane)),
                       index(gcode::second_axis(move.plane)), move.center_first, move.center_second, turn.sweep,
                       length);
}

geometry::NurbsForm form(const gcode::NurbsCurve& curve) {
  geometry::NurbsForm form{curve.degree, curve.knots, {}, {}};
  for (const gcode::ControlPoint& point : curve.points) {
    form.points.push_back(point.position);
    form.weights.push_back(point.weight);
  }
  return form;
}

}  // namespace

FeedAxes feed_axes(const Point& start, const Point& end) {
  if (distance_in(start, end, Axis::X, Axis::Y, Axis::Z) > 0) return FeedAxes::xyz;
  if (distance_in(start, end, Axis::U, Axis::V, Axis::W) > 0) return FeedAxes::uvw;
  return distance_in(start, end, Axis::A, Axis::B, Axis::C) > 0 ? FeedAxes::abc : FeedAxes::none;
}

double line_length(const Point& start, const Point& end) {
  switch (feed_axes(start, end)) {
    case FeedAxes::xyz:
      return distance_in(start, end, Axis::X, Axis::Y, Axis::Z);
    case FeedAxes::uvw:
      return distance_in(start, end, Axis::U, Axis::V, Axis::W);
    case FeedAxes::abc:
      return distance_in(start, end, Axis::A, Axis::B, Axis::C);
    case FeedAxes::none:
      break;
  }
  return 0;
}

double feed_length(const gcode::Move& move) {
  if (move.kind == gcode::Move::Kind::line) return line_length(move.start, move.end);
  if (move.kind == gcode::Move::Kind::arc) return arc_length(move, turn(move));
  if (move.kind == gcode::Move::Kind::nurbs) return geometry::feed_length(form(move.curve));
  return 0;
}

std::vector<geometry::Curve> curves_of(const gcode::Move& move) {
  std::vector<geometry::Curve> curves;
  if (move.kind == gcode::Move::Kind::line) {
    const double length = line_length(move.start, move.end);
    if (length > 0) curves.emplace_back(geometry::Line(move.start, move.end, length));
  } else if (move.kind == gcode::Move::Kind::arc) {
    const Turn turned = turn(move);
    const double length = arc_length(move, turned);
    if (length > 0) curves.push_back(arc(move, turned, length));
  } else if (move.kind == gcode::Move::Kind::nurbs) {
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(form(move.curve))) curves.emplace_back(piece);
  }
  return curves;
}

}  // namespace leadscrew::toolpath
