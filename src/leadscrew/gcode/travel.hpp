#pragma once
// The travel of the machine's axes: what leaves it, and what moves an axis that the machine lacks. Lines are judged by
// their ends, arcs and curves by how far they bulge; under tool centre point control all by how far they lead the axes
// between their ends (tip_travel.hpp).

#include <leadscrew/gcode/part.hpp>
#include <leadscrew/gcode/tip_travel.hpp>

namespace leadscrew::gcode {

class Travel : Part {
 public:
  explicit Travel(const Context& context);

  /// Whether a line from where the program stands to the target stays inside; reports what does not.
  bool inside_travel(const Block& block, const base::AxisVector& target);
  /// The same from another place than where the program stands, under tool centre point control.
  bool tip_inside(const Block& block, const base::AxisVector& start, const base::AxisVector& target);
  /// The same of its end alone, where the way there is no line.
  bool end_inside(const Block& block, const base::AxisVector& target) {
    return frame_.tip_control() ? tip_end_inside(block, target) : places_inside(block, frame_.position, target);
  }
  /// Whether the way there, of the tip, stays inside between its ends, which have been looked at.
  bool tip_way_inside(const Block& block, const TipPath& path);
  /// Whether an axis that reaches from low to high, mm or degrees, stays inside; reports it where it does not.
  bool bulge_inside(const Block& block, base::Axis axis, double low, double high);
  /// Whether a curve does.
  void curve_inside(const Block& block, const NurbsCurve& curve);
  /// Finds the axes that are outside, where the position was changed without a check.
  void note_outside();
  /// Whether the block fails because an axis is outside; says so unless that has been said.
  bool fails_outside(const Block& block);
  bool all_inside() const { return outside_.empty(); }

  /// Places of two axes are not looked at where they are programmed, since moves lead them elsewhere: cutter compensation.
  void release(base::Axis one, base::Axis other);
  /// Whether a move that leads a released axis from low to high, mm, stays inside; reports it where it does not, once until
  /// it does.
  bool released_inside(base::Axis axis, double low, double high, std::uint32_t column);
  /// They are looked at again.
  void restore();

  /// Makes the block fail for an axis that the machine lacks; true where that has not been said before.
  bool lacks(base::Axis axis);

  // With a margin for the rounding of inches; infinite for an axis that the machine lacks. mm and degrees.
  const base::AxisVector& low() const { return low_; }
  const base::AxisVector& high() const { return high_; }

 private:
  void set_limits(base::Axis axis);
  bool tip_end_inside(const Block& block, const base::AxisVector& target);
  bool places_inside(const Block& block, const base::AxisVector& from, const base::AxisVector& to);
  bool reach_inside(const Block& block, const AxesReach& reach);
  bool axis_inside(base::Axis axis, double value, std::uint32_t column);
  void report_travel(base::Axis axis, double value, std::uint32_t column);

  base::AxisVector low_{};
  base::AxisVector high_{};
  base::AxisSet released_;
  base::AxisSet outside_;           // axes whose position is outside
  base::AxisSet reported_outside_;  // those of them that have been reported
  base::AxisSet reported_lacking_;
};

}  // namespace leadscrew::gcode
