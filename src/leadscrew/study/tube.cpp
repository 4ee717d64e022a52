#include <algorithm>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/study/tube.hpp>
#include <numbers>
#include <optional>

namespace leadscrew::study {

namespace {

PlaneVector in_xy(const base::AxisVector& position) {
  return {position[base::index(base::Axis::X)], position[base::index(base::Axis::Y)]};
}

double angle_of(PlaneVector direction) {
  return std::atan2(direction.y, direction.x);
}

TubeLeg leg_of(const gcode::Move& move) {
  TubeLeg leg{in_xy(move.start), in_xy(move.end)};
  if (move.kind != gcode::Move::Kind::arc) return leg;
  leg.is_arc = true;
  leg.center = {move.center_first, move.center_second};
  leg.radius = norm(leg.from - leg.center);
  leg.first_angle = angle_of(leg.from - leg.center);
  leg.turn = angle_of(leg.to - leg.center) - leg.first_angle;
  const double side = move.turns > 0 ? 1 : -1;
  if (leg.turn * side <= 0) leg.turn += side * 2 * std::numbers::pi;
  return leg;
}

/// Whether a tube can be made of the move, whose tolerance and feed are those of the tube where it has legs.
bool fits(const gcode::Move& move, const Tube& tube) {
  using enum gcode::Move::Kind;
  if (move.kind != line && move.kind != arc) return false;
  if (move.kind == arc && (move.plane != gcode::Plane::XY || std::abs(move.turns) != 1)) return false;
  if (move.path_mode != gcode::PathMode::blend || !(move.tolerance > 0)) return false;
  if (move.feed.mode != gcode::Feed::Mode::units_per_second) return false;
  for (const base::Axis axis : base::all_axes) {
    const bool is_in_plane = axis == base::Axis::X || axis == base::Axis::Y;
    if (!is_in_plane && move.start[base::index(axis)] != move.end[base::index(axis)]) return false;
  }
  return tube.legs.empty() || move.tolerance == tube.tolerance;
}

}  // namespace

PlaneVector TubeLeg::at(double part) const {
  if (!is_arc) return from + part * (to - from);
  const double angle = first_angle + part * turn;
  return center + radius * PlaneVector{std::cos(angle), std::sin(angle)};
}

base::Result<Tube> tube_of(const PartProgram& program, const machine::Machine& machine) {
  std::optional<base::Diagnostic> first;
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.file = "study";
  options.start = program.start;
  gcode::Reader reader(gcode::text_source(program.text), machine, tools, options,
                       [&](const base::Diagnostic& diagnostic) {
                         if (!first && diagnostic.severity == base::Severity::error) first = diagnostic;
                       });
  const machine::AxisLimits& limits = machine.limits(base::Axis::X);
  Tube tube;
  tube.acceleration = limits.acceleration;
  tube.jerk = limits.jerk;
  for (gcode::Move move; reader.next(move);) {
    if (move.kind == gcode::Move::Kind::event) continue;
    if (!fits(move, tube) && !first)
      first = base::Diagnostic{.code = "no-tube", .message = "not a line or an arc in X and Y within one tolerance"};
    tube.tolerance = move.tolerance;
    tube.feed = std::min(move.feed.value, limits.velocity);
    tube.legs.push_back(leg_of(move));
  }
  if (first) return base::failure(*first);
  return tube;
}

}  // namespace leadscrew::study
