#include <cmath>
#include <leadscrew/toolpath/builder.hpp>
#include <limits>

namespace leadscrew::toolpath {

namespace {

using base::Axis;
using base::index;

double distance(const gcode::Move& move, Axis a, Axis b, Axis c) {
  const auto along = [&](Axis axis) { return move.end[index(axis)] - move.start[index(axis)]; };
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

double line_length(const gcode::Move& move) {
  const double tip = distance(move, Axis::X, Axis::Y, Axis::Z);
  if (tip > 0) return tip;
  const double secondary = distance(move, Axis::U, Axis::V, Axis::W);
  return secondary > 0 ? secondary : distance(move, Axis::A, Axis::B, Axis::C);
}

double speed(const gcode::Feed& feed, double length) {
  switch (feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      return feed.value;
    case gcode::Feed::Mode::per_second:
      return feed.value * length;
    case gcode::Feed::Mode::rapid:
      break;
  }
  return std::numeric_limits<double>::infinity();
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

double feed_length(const gcode::Move& move) {
  if (move.kind == gcode::Move::Kind::line) return line_length(move);
  if (move.kind == gcode::Move::Kind::arc) return arc_length(move, turn(move));
  if (move.kind == gcode::Move::Kind::nurbs) return geometry::feed_length(form(move.curve));
  return 0;
}

void Builder::push(const gcode::Move& move) {
  switch (move.kind) {
    case gcode::Move::Kind::line: {
      const double length = line_length(move);
      if (length > 0) settle(geometry::Line(move.start, move.end, length), move, length);
      break;
    }
    case gcode::Move::Kind::arc: {
      const Turn turned = turn(move);
      const double length = arc_length(move, turned);
      if (length > 0) settle(arc(move, turned, length), move, length);
      break;
    }
    case gcode::Move::Kind::nurbs: {
      const std::vector<geometry::Nurbs> pieces = geometry::smooth_pieces(form(move.curve));
      double length = 0;
      for (const geometry::Nurbs& piece : pieces) length += piece.length();
      for (const geometry::Nurbs& piece : pieces) settle(piece, move, length);
      break;
    }
    case gcode::Move::Kind::dwell:
      settled_.emplace_back(Dwell{move.start, move.dwell_seconds, move.line});
      return;
    case gcode::Move::Kind::event:
      settled_.emplace_back(move.event);
      return;
  }
  if (move.path_mode != gcode::PathMode::exact_stop || settled_.empty()) return;
  if (auto* const last = std::get_if<Piece>(&settled_.back())) last->stop = true;
}

void Builder::settle(const geometry::Curve& curve, const gcode::Move& move, double feed_length) {
  settled_.emplace_back(Piece{curve, speed(move.feed, feed_length), move.line});
}

std::optional<Element> Builder::pop() {
  if (settled_.empty()) return std::nullopt;
  std::optional<Element> element(std::move(settled_.front()));
  settled_.pop_front();
  return element;
}

}  // namespace leadscrew::toolpath
