#pragma once
// Moves that a host gives: made from the few numbers that each needs, and checked as the reader checks a block.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <limits>

namespace leadscrew::host {

/// The feed of a move that is as fast as the axes allow.
inline constexpr double rapid = std::numeric_limits<double>::infinity();

/// Straight in all axes to `end`, mm or degrees. `feed`: mm/s (degrees/s where only rotary axes move), counted as
/// gcode::Feed says; > 0, or `rapid`.
gcode::Move line(const base::AxisVector& end, double feed);
/// Circular in the plane about a centre, mm, in the direction and with the turns of gcode::Move::turns; straight in all
/// other axes.
gcode::Move arc(const base::AxisVector& end, gcode::Plane plane, double center_first, double center_second, int turns,
                double feed);
/// Along a curve that begins where the move before ends; without knots they are uniform (gcode::set_uniform_knots).
gcode::Move curve(gcode::NurbsCurve curve, double feed);
/// Stand still, so many seconds ≥ 0.
gcode::Move dwell(double seconds);

/// Is it finite and inside travel in each axis of the machine? Codes: `move-finite`, `travel`.
base::Result<void> check_position(const base::AxisVector& position, const machine::Machine& machine);

/// Puts the move behind `start`: sets its start, and what follows from it, and checks it. Codes: `move-finite` (a number
/// is none), `move-feed`, `move-axis` (the machine lacks one that moves), `arc-radius`, `arc-turns`, `curve-order`,
/// `curve-points`, `curve-weight`, `curve-start`, `knot-count`, `knot-order`, `knot-multiplicity`, `move-time`, `travel`.
base::Result<void> put_behind(const base::AxisVector& start, const machine::Machine& machine, gcode::Move& move);

}  // namespace leadscrew::host
