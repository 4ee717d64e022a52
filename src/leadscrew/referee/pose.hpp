#pragma once
// Where the tool's tip is in the workpiece, by quaternions: the referee's own way from axes to pose.
//
//     tool centre, with the linear axes at g:  c = g − tool, turned about each axis that carries the tool, the one nearest
//                                              the spindle first
//     in the machine:                          m = axes + (c − g)
//     in the workpiece:                        m, turned back about each axis that carries the workpiece, the one nearest
//                                              the bed first

#include <array>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::referee {

class Pose {
 public:
  /// Of a machine without a chain of rotary axes the tip is at the axes, whatever the tool.
  explicit Pose(const machine::Machine& machine);

  /// X, Y and Z become those of the tip in the workpiece, mm; all others stay. `tool`: its offset, mm.
  base::AxisVector tip_of(const base::AxisVector& axes, const std::array<double, 3>& tool) const;
  /// The unit vector from the tip to the spindle, seen from the workpiece; along Z without a chain.
  machine::Vector direction_of(const base::AxisVector& axes) const;

 private:
  struct Turn {
    std::size_t axis = 0;
    machine::Vector direction{}, point{};
    double sign = 1;
  };
  static machine::Vector rotated(const Turn& turn, double degrees, const machine::Vector& vector);
  static machine::Vector turned(const Turn& turn, double degrees, const machine::Vector& place);

  bool has_chain_ = false;
  machine::Vector gauge_{};
  std::vector<Turn> of_tool_, of_workpiece_;  // in the order in which they are applied
};

/// Between two unit vectors, degrees.
double angle_between(const machine::Vector& a, const machine::Vector& b);

}  // namespace leadscrew::referee
