#pragma once
// A motion of nearly the least time in a corridor of X, Y and Z, planned in the coordinates that move, and proven.

#include <leadscrew/toolpath/corridor_start.hpp>
#include <optional>

namespace leadscrew::toolpath {

/// With an interval of about so many seconds to begin with. None where no motion was found that is proven to stay within
/// the margins.
std::optional<TimeSpline<3>> plan_in(const Corridor<3>& corridor, const CorridorEnds<3>& ends, double interval);

}  // namespace leadscrew::toolpath
