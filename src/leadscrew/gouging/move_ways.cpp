#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/move_ways.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <numbers>

namespace leadscrew::gouging {

namespace {

using base::AxisVector;
using gcode::Move;

constexpr double bend_of_step = 0.5;   // rad
constexpr double turn_of_step = 10.0;  // degrees of a rotary axis
constexpr double parts_of_span = 8;

AxisVector on_line(const AxisVector& from, const AxisVector& to, double t) {
  AxisVector place;
  for (std::size_t k = 0; k < place.size(); ++k) place[k] = t < 1 ? from[k] + t * (to[k] - from[k]) : to[k];
  return place;
}

struct Arc {
  std::size_t first = 0, second = 1;
  double radius = 0, begin = 0, turned = 0;  // mm, radians
};

Arc arc_of(const Move& move) {
  Arc arc;
  arc.first = base::index(gcode::first_axis(move.plane));
  arc.second = base::index(gcode::second_axis(move.plane));
  const double x = move.start[arc.first] - move.center_first, y = move.start[arc.second] - move.center_second;
  const double ex = move.end[arc.first] - move.center_first, ey = move.end[arc.second] - move.center_second;
  arc.radius = std::hypot(x, y);
  arc.begin = std::atan2(y, x);
  const double whole = 2 * std::numbers::pi;
  double turned = std::atan2(x * ey - y * ex, x * ex + y * ey);
  // Counterclockwise 0 < turned ≤ 2π, and whole turns besides
  const bool is_closed = move.start[arc.first] == move.end[arc.first] && move.start[arc.second] == move.end[arc.second];
  if (is_closed) turned = 0;
  if (move.turns > 0 && turned <= 0) turned += whole;
  if (move.turns < 0 && turned >= 0) turned -= whole;
  arc.turned = turned + (move.turns > 0 ? move.turns - 1 : move.turns + 1) * whole;
  return arc;
}

AxisVector on_arc(const Move& move, const Arc& arc, double t) {
  if (t >= 1) return move.end;
  AxisVector place = on_line(move.start, move.end, t);
  const double angle = arc.begin + t * arc.turned;
  place[arc.first] = move.center_first + arc.radius * std::cos(angle);
  place[arc.second] = move.center_second + arc.radius * std::sin(angle);
  return place;
}

/// Of t, so that no rotary axis turns by more than turn_of_step.
double most_step_of(const AxisVector& from, const AxisVector& to) {
  double most = 1;
  for (const base::Axis axis : base::all_axes) {
    const double turn = std::abs(to[base::index(axis)] - from[base::index(axis)]);
    if (base::is_rotary(axis) && turn > turn_of_step) most = std::min(most, turn_of_step / turn);
  }
  return most;
}

}  // namespace

MovePoses::MovePoses(const machine::Machine& machine) {
  if (machine.rotary_chain) chain_ = kinematics::chain_of(machine);
}

Pose MovePoses::at(const Move& move, const AxisVector& place, const Vector& tool) const {
  if (!chain_) return {{place[0] - tool[0], place[1] - tool[1], place[2] - tool[2]}, {0, 0, 1}};
  const Vector axis = kinematics::direction_of(*chain_, kinematics::angles_of(*chain_, place));
  const AxisVector tip = move.is_of_tip ? place : kinematics::pose_of(*chain_, place, tool);
  return {{tip[0], tip[1], tip[2]}, axis};
}

/// De Boor's algorithm on w P and w.
AxisVector place_on(const gcode::NurbsCurve& curve, double u) {
  constexpr std::size_t size = base::axis_count + 1;
  const auto p = static_cast<std::size_t>(curve.degree);
  const std::size_t n = curve.points.size();
  const auto above = std::upper_bound(curve.knots.begin() + static_cast<std::ptrdiff_t>(p) + 1,
                                      curve.knots.begin() + static_cast<std::ptrdiff_t>(n), u);
  const auto span = static_cast<std::size_t>(above - curve.knots.begin()) - 1;
  std::array<std::array<double, size>, gcode::highest_degree + 1> d;
  for (std::size_t j = 0; j <= p; ++j) {
    const gcode::ControlPoint& point = curve.points[j + span - p];
    for (std::size_t k = 0; k + 1 < size; ++k) d[j][k] = point.weight * point.position[k];
    d[j][size - 1] = point.weight;
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = curve.knots[j + span - p], high = curve.knots[j + 1 + span - r];
      const double x = high > low ? (u - low) / (high - low) : 0;
      for (std::size_t k = 0; k < size; ++k) d[j][k] = (1 - x) * d[j - 1][k] + x * d[j][k];
    }
  }
  AxisVector place;
  for (std::size_t k = 0; k + 1 < size; ++k) place[k] = d[p][k] / d[p][size - 1];
  return place;
}

Way way_of(const Move& move, const MovePoses& poses, const Vector& tool) {
  const double by_turn = most_step_of(move.start, move.end);
  if (move.kind == Move::Kind::nurbs) {
    const gcode::NurbsCurve& curve = move.curve;
    const double begin = curve.knots[static_cast<std::size_t>(curve.degree)], end = curve.knots[curve.points.size()];
    double shortest = end - begin;
    for (std::size_t k = static_cast<std::size_t>(curve.degree); k < curve.points.size(); ++k) {
      const double span = curve.knots[k + 1] - curve.knots[k];
      if (span > 1e-6 * (end - begin)) shortest = std::min(shortest, span);
    }
    return {[&move, &poses, tool, begin, end](double t) {
              return poses.at(move, place_on(move.curve, t < 1 ? begin + t * (end - begin) : end), tool);
            },
            shortest / (end - begin) / parts_of_span};
  }
  if (move.kind == Move::Kind::arc) {
    const Arc arc = arc_of(move);
    return {[&move, &poses, tool, arc](double t) { return poses.at(move, on_arc(move, arc, t), tool); },
            std::min(by_turn, bend_of_step / std::max(std::abs(arc.turned), bend_of_step))};
  }
  return {[&move, &poses, tool](double t) { return poses.at(move, on_line(move.start, move.end, t), tool); }, by_turn};
}

}  // namespace leadscrew::gouging
