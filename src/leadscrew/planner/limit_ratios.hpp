#pragma once
// How much of every limit a motion uses, evaluated from jets of the path and the polynomials of time.

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::planner {

template <typename T>
constexpr constraints::PathRatesOf<T> rates(const PathStateOf<T>& at) {
  return {at.speed, at.acceleration, at.jerk};
}

/// Of a chunk's motion, at both ends of every segment, inside where curvature couples path and time, and on both sides
/// of where q‴ jumps; feed left out, which may have been overridden. Raises `ratios` where it is larger.
void raise_limit_ratios(const Chunk& chunk, const constraints::Constraints& constraints,
                        constraints::LimitRatios& ratios);

}  // namespace leadscrew::planner
