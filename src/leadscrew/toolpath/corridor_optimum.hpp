#pragma once
// A motion of nearly the least time in a corridor. A barrier is followed (corridor_barrier.hpp) while t grows; at each t
// Newton's method runs, with passing times and legs of knots that follow the motion. That is not convex: a step is taken
// only where the barrier really falls. Where it falls no farther, a motion is found that is no slower than the start and
// inside; how near to the least time, `study tube` says, whose optimiser shares no code with this one.

#include <leadscrew/toolpath/corridor.hpp>
#include <optional>

namespace leadscrew::toolpath {

/// From a start that keeps its limits; none where that is not inside the margins.
template <std::size_t D>
std::optional<TimeSpline<D>> least_time(const Corridor<D>& corridor, const TimeSpline<D>& start);

}  // namespace leadscrew::toolpath
