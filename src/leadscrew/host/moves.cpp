#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/nurbs.hpp>
#include <leadscrew/host/moves.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <string>
#include <utility>

namespace leadscrew::host {

namespace {

using gcode::Move;

constexpr int most_turns = 1'000'000;
constexpr double longest_dwell = 1e6;    // s
constexpr double start_accuracy = 1e-6;  // mm or degrees, between a curve's first point and the end of the move before
constexpr double rounding = 1e-9;        // mm or degrees, of arcs and curves beyond travel

Move move_of(Move::Kind kind, const base::AxisVector& end, double feed) {
  Move move;
  move.kind = kind;
  move.end = end;
  if (feed != rapid) move.feed = {gcode::Feed::Mode::units_per_second, feed};
  return move;
}

tl::unexpected<base::Diagnostic> wrong(std::string_view code, std::string message, std::string hint) {
  return base::failure(base::problem(code, std::move(message), std::move(hint)));
}

bool is_finite(const base::AxisVector& position) {
  return std::all_of(position.begin(), position.end(), [](double coordinate) { return std::isfinite(coordinate); });
}

base::Result<void> check_axes(const Move& move, const base::AxisVector& position, const machine::Machine& machine) {
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis) || position[base::index(axis)] == move.start[base::index(axis)]) continue;
    return wrong("move-axis", std::string("the machine has no axis ") + base::letter(axis), "leave it where it is");
  }
  return {};
}

base::Result<void> check_arc(Move& move) {
  if (move.turns == 0 || std::abs(move.turns) > most_turns)
    return wrong("arc-turns", "an arc of " + std::to_string(move.turns) + " turns",
                 "1 counterclockwise, -1 clockwise, more for whole turns before");
  const gcode::PlanePoint start = in_plane(move.start, move.plane), end = in_plane(move.end, move.plane);
  const gcode::ArcCircle circle =
      circle_by_center(start, end, {move.center_first, move.center_second}, move.turns > 0 ? 1 : -1,
                       std::abs(move.turns), gcode::arc_tolerance(false));
  if (circle.problem != gcode::ArcCircle::Problem::none)
    return wrong("arc-radius", "arc radius is 0 or differs by " + base::text(circle.difference, 6) + " mm at its ends",
                 "both ends lie on one circle around the centre");
  if (circle.end.first != end.first || circle.end.second != end.second)
    return wrong("arc-radius", "an arc that nearly closes ends beside its circle", "end it on the circle");
  move.center_first = circle.center.first;
  move.center_second = circle.center.second;
  return {};
}

base::Result<void> check_knots(const gcode::NurbsCurve& curve, std::size_t order) {
  if (curve.knots.size() != curve.points.size() + order)
    return wrong("knot-count", std::to_string(curve.knots.size()) + " knots",
                 "one for each control point and as many as the order");
  gcode::NurbsCurve so_far{curve.degree, curve.points, {}};
  for (const double knot : curve.knots) {
    if (!std::isfinite(knot)) return wrong("move-finite", "a knot is not a finite number", "");
    so_far.knots.push_back(knot);
    switch (judge_last_knot(so_far, true)) {
      case gcode::KnotProblem::none:
        break;
      case gcode::KnotProblem::decreases:
        return wrong("knot-order", "the knot " + base::text(knot, 9) + " is less than the one before",
                     "knots do not decrease");
      case gcode::KnotProblem::repeats:
        return wrong("knot-multiplicity", "the knot " + base::text(knot, 9) + " stands too often",
                     "as often as the order at an end, and once less between them");
    }
  }
  if (!knots_are_apart(curve))
    return wrong("knot-order", "knots with no room between them",
                 "neighbours are equal or at least 1e-12 of their range apart");
  return {};
}

base::Result<void> check_curve(Move& move, const machine::Machine& machine) {
  gcode::NurbsCurve& curve = move.curve;
  if (curve.degree < 1 || curve.degree > gcode::highest_degree)
    return wrong("curve-order", "a curve of degree " + std::to_string(curve.degree), "1 to 5");
  const auto order = static_cast<std::size_t>(curve.degree) + 1;
  if (curve.points.size() < order || curve.points.size() > gcode::most_control_points)
    return wrong("curve-points", std::to_string(curve.points.size()) + " control points",
                 "one more than the degree at least, at most " + std::to_string(gcode::most_control_points));
  for (const gcode::ControlPoint& point : curve.points) {
    if (!is_finite(point.position)) return wrong("move-finite", "a control point is not finite", "");
    if (!(point.weight >= gcode::least_weight && point.weight <= gcode::greatest_weight))
      return wrong("curve-weight", "a weight of " + base::text(point.weight, 9), "1e-9 to 1e9");
    if (auto moves = check_axes(move, point.position, machine); !moves) return moves;
  }
  if (curve.knots.empty()) set_uniform_knots(curve);
  if (auto knots = check_knots(curve, order); !knots) return knots;
  clamp_ends(curve);
  base::AxisVector& first = curve.points.front().position;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (std::abs(first[i] - move.start[i]) > start_accuracy)
      return wrong("curve-start", "the curve does not begin where the move before ends", "give its first point there");
  }
  first = move.start;
  move.end = curve.points.back().position;
  const bool moves = std::any_of(curve.points.begin(), curve.points.end(),
                                 [&](const gcode::ControlPoint& point) { return point.position != move.start; });
  if (!moves) move.kind = Move::Kind::line;
  return {};
}

tl::unexpected<base::Diagnostic> beyond_travel(base::Axis axis, double position) {
  return wrong("travel", std::string("axis ") + base::letter(axis) + " would be at " + base::text(position, 9),
               "stay within the travel of the machine");
}

base::Result<void> check_path(const Move& move, const machine::Machine& machine) {
  for (toolpath::Piece& piece : toolpath::pieces_of(move)) {
    if (const auto excess = check_travel(piece, machine, move.start, rounding))
      return beyond_travel(excess->axis, excess->position);
  }
  return {};
}

}  // namespace

Move line(const base::AxisVector& end, double feed) {
  return move_of(Move::Kind::line, end, feed);
}

Move arc(const base::AxisVector& end, gcode::Plane plane, double center_first, double center_second, int turns,
         double feed) {
  Move move = move_of(Move::Kind::arc, end, feed);
  move.plane = plane;
  move.center_first = center_first;
  move.center_second = center_second;
  move.turns = turns;
  return move;
}

Move curve(gcode::NurbsCurve curve, double feed) {
  Move move = move_of(Move::Kind::nurbs, {}, feed);
  move.curve = std::move(curve);
  return move;
}

Move dwell(double seconds) {
  Move move = move_of(Move::Kind::dwell, {}, rapid);
  move.dwell_seconds = seconds;
  return move;
}

base::Result<void> check_position(const base::AxisVector& position, const machine::Machine& machine) {
  if (!is_finite(position)) return wrong("move-finite", "a coordinate is not a finite number", "");
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const double coordinate = position[base::index(axis)];
    const machine::AxisLimits& limits = machine.limits(axis);
    if (coordinate < limits.travel_min || coordinate > limits.travel_max) return beyond_travel(axis, coordinate);
  }
  return {};
}

base::Result<void> put_behind(const base::AxisVector& start, const machine::Machine& machine, Move& move) {
  move.start = start;
  if (move.kind == Move::Kind::dwell) {
    move.end = start;
    if (move.dwell_seconds >= 0 && move.dwell_seconds <= longest_dwell) return {};
    return wrong("move-time", "a dwell of " + base::text(move.dwell_seconds, 9) + " s", "0 to 1e6");
  }
  if (move.kind == Move::Kind::event) return {};
  if (move.feed.mode != gcode::Feed::Mode::rapid && !(move.feed.value > 0 && std::isfinite(move.feed.value)))
    return wrong("move-feed", "a feed of " + base::text(move.feed.value, 9), "more than 0; infinite for a rapid");
  if (move.kind == Move::Kind::nurbs) {
    if (auto sound = check_curve(move, machine); !sound) return sound;
  }
  if (!is_finite(move.end) || !std::isfinite(move.center_first) || !std::isfinite(move.center_second))
    return wrong("move-finite", "a coordinate is not a finite number", "");
  if (auto moves = check_axes(move, move.end, machine); !moves) return moves;
  if (move.kind == Move::Kind::arc) {
    if (auto sound = check_arc(move); !sound) return sound;
  }
  return check_path(move, machine);
}

}  // namespace leadscrew::host
