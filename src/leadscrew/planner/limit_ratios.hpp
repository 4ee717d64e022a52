#pragma once
// What a motion asks of the axes over what they can.

#include <array>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::planner {

/// Largest value over limit of one axis.
struct AxisRatios {
  double velocity = 0, acceleration = 0, jerk = 0;

  friend bool operator==(const AxisRatios&, const AxisRatios&) = default;
};
using LimitRatios = std::array<AxisRatios, base::axis_count>;

/// Raises the ratios of every axis the machine has to those at one instant, where these are larger.
void raise_limit_ratios(const geometry::PointJet& jet, const PathState& at, const machine::Machine& machine,
                        LimitRatios& ratios);

/// What a chunk's motion asks of each axis over what the axis can, evaluated from jets of the path and the polynomials
/// of time, at both ends of every segment, and inside where curvature couples the two. Raises `ratios` where it is
/// larger.
void raise_limit_ratios(const Chunk& chunk, const machine::Machine& machine, LimitRatios& ratios);

}  // namespace leadscrew::planner
