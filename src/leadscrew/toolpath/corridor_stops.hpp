#pragma once
// The time that legs take which are travelled as programmed, with a stop at the end of each: a motion through their
// corridor that takes longer is of no use.

#include <leadscrew/toolpath/corridor.hpp>

namespace leadscrew::toolpath {

/// s, from `begin` on the first leg to `end` on the last, mm; where motion goes on there, from or to the greatest speed.
/// Exact for lines from rest to rest; about, for arcs and for what is short beside a ramp that it shares.
double time_with_stops(const Corridor<3>& corridor, double begin, double end);

}  // namespace leadscrew::toolpath
