#pragma once
// Moves of a program as ways of the tool, seen from the workpiece as it lies with all rotary axes at 0.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/gouging/sweep.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>

namespace leadscrew::gouging {

/// Where the tool is while the axes, or its tip, are at a place of a move's coordinates.
class MovePoses {
 public:
  explicit MovePoses(const machine::Machine& machine);

  /// tool: of moves that are not of the tip, X, Y and Z of the offset in force, mm. Others have their own.
  Pose at(const gcode::Move& move, const base::AxisVector& place, const Vector& tool) const;

 private:
  std::optional<kinematics::Chain> chain_;
};

/// The place of a curve, at knots[degree] ≤ u ≤ knots[n].
base::AxisVector place_on(const gcode::NurbsCurve& curve, double u);

/// A line, arc or curve; it refers to the move and the poses, which must outlive it.
Way way_of(const gcode::Move& move, const MovePoses& poses, const Vector& tool);

}  // namespace leadscrew::gouging
