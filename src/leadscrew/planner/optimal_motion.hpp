#pragma once
// A section's motion: the optimal law of time as polynomials in time, proven before it leaves.

#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/section.hpp>

namespace leadscrew::planner {

/// The fastest motion over the section from rest to rest that was found, in segments along its pieces (Segment::piece
/// counts them). Velocity, acceleration and jerk of every axis stay inside their limits, evaluated eight times a
/// segment on what the cycle will evaluate; what an optimum leaves above a limit between its knots is planned again
/// with tightened rows, and in the last resort slowed down.
std::vector<Segment> plan_section(const Section& section, const machine::Machine& machine);

}  // namespace leadscrew::planner
