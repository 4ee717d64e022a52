#pragma once
// A slow motion in a corridor, from which that of least time is looked for: control points on the legs themselves, as
// far apart as corners, feed and acceleration allow. Between control points on both sides of a corner the spline cuts
// it, by less than 0.4 of the distance between them times |t⁺ − t⁻|.

#include <leadscrew/toolpath/corridor.hpp>

namespace leadscrew::toolpath {

/// What the legs take at their feeds and the greatest speed of the slowest axis, s.
template <std::size_t D>
double seconds_by_feed(const Corridor<D>& corridor);

/// The interval, s, that suits a corridor: short beside what a corner takes, (P/j)^(1/3) times a constant, or a small part of
/// what the legs take at their feeds, if that is more; and so short that motion leaves its margin P only by little between the places looked at, a h²/32 a half interval apart.
template <std::size_t D>
double suitable_interval(const Corridor<D>& corridor);

/// Where on the first leg it begins and where on the last one it ends, mm from its start; of an end in motion, the three
/// control points there, the middle one at that place.
template <std::size_t D>
struct CorridorEnds {
  double begin = 0, end = 0;
  std::array<Vector<D>, 3> points_at_begin{}, points_at_end{};
};

/// With control points about `interval` seconds apart. The spline's own interval is the least that keeps every limit.
template <std::size_t D>
TimeSpline<D> start_motion(const Corridor<D>& corridor, double interval, const CorridorEnds<D>& ends);

}  // namespace leadscrew::toolpath
