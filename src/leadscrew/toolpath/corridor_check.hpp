#pragma once
// That a motion stays in its corridor: Fréchet's distance, both ways, from above. Each place is matched to the nearest of
// the leg that is travelled at its time, or, where motion goes back along the leg, to the farthest that it has come to;
// each joint to where it is passed. The curve's parts lie in the hulls of their control points (Bézier).

#include <leadscrew/toolpath/corridor.hpp>

namespace leadscrew::toolpath {

/// Of each leg, the greatest distance over its margin: no place has more.
template <std::size_t D>
std::vector<double> shares_of_margins(const Corridor<D>& corridor, const TimeSpline<D>& motion);

}  // namespace leadscrew::toolpath
