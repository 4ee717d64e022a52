#include <array>
#include <cmath>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>

namespace leadscrew::toolpath {

namespace {

using base::Axis;
using base::index;
using geometry::Point;

double distance_in(const Point& start, const Point& end, Axis a, Axis b, Axis c) {
  const auto along = [&](Axis axis) { return end[index(axis)] - start[index(axis)]; };
  return std::hypot(along(a), along(b), along(c));
}

/// Spans of fits and blends are much shorter than their radii, and what is granted to a table of arc length is told by
/// the shorter of the two.
constexpr geometry::MapTolerance table_of_short_spans{1e-7, 1e-6, 1e-6};

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

/// What moves beside X Y Z goes on evenly with them.
double with_others(double length, const gcode::Move& move) {
  Point others = difference(to_millimetres(move.end), to_millimetres(move.start));
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) others[index(axis)] = 0;
  return std::hypot(length, norm(others));
}

std::size_t first_of(FeedAxes axes) {
  return index(axes == FeedAxes::xyz ? Axis::X : axes == FeedAxes::uvw ? Axis::U : Axis::A);
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

std::vector<geometry::Curve> curves_of(const gcode::Move& move, Length measure) {
  const bool by_feed = measure == Length::of_feed;
  std::vector<geometry::Curve> curves;
  if (move.kind == gcode::Move::Kind::line) {
    const double length =
        by_feed ? line_length(move.start, move.end) : distance(to_millimetres(move.start), to_millimetres(move.end));
    if (length > 0) curves.emplace_back(geometry::Line(move.start, move.end, length));
  } else if (move.kind == gcode::Move::Kind::arc) {
    const Turn turned = turn(move);
    const double way = arc_length(move, turned), length = by_feed ? way : with_others(way, move);
    if (way > 0) curves.push_back(arc(move, turned, length));
  } else if (move.kind == gcode::Move::Kind::nurbs) {
    const std::optional<Point> weights = by_feed ? std::nullopt : std::optional(weights_of_length());
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(form(move.curve), {}, weights))
      curves.emplace_back(piece);
  }
  return curves;
}

FeedAxes to_be_named(FeedAxes axes, std::span<const Point> points) {
  if (axes == FeedAxes::abc) return axes;  // in degrees
  const std::size_t first = first_of(axes);
  for (const Point& point : points) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      if ((i < first || i >= first + 3) && point[i] != points.front()[i]) return axes;
    }
  }
  return FeedAxes::none;
}

FeedAxes to_be_named(FeedAxes axes, const gcode::Move& move) {
  if (move.kind == gcode::Move::Kind::nurbs) return to_be_named(axes, form(move.curve).points);
  return to_be_named(axes, std::array{move.start, move.end});
}

std::vector<geometry::Nurbs> fitted_pieces(const geometry::NurbsForm& form) {
  return geometry::smooth_pieces(form, table_of_short_spans, weights_of_length());
}

std::optional<Piece> straight_piece(const Point& start, const Point& end) {
  const FeedAxes axes = to_be_named(feed_axes(start, end), std::array{start, end});
  const double length =
      axes == FeedAxes::none ? line_length(start, end) : distance(to_millimetres(start), to_millimetres(end));
  if (!(length > 0)) return std::nullopt;
  return Piece{geometry::Line(start, end, length), 0, {}, false, nullptr, axes};
}

double rate(const geometry::PointJet& jet, FeedAxes axes) {
  if (axes == FeedAxes::none) return 1;
  const std::size_t first = first_of(axes);
  return std::hypot(jet[first].first, jet[first + 1].first, jet[first + 2].first);
}

}  // namespace leadscrew::toolpath
