#pragma once
// What an interpolator's path on the lattice comes to, kept in integers: the squares of the distances that count are
// exact, and as quick to keep as the path is to make.

#include <algorithm>
#include <cmath>
#include <leadscrew/pulse/arc.hpp>
#include <utility>

namespace leadscrew::study {

struct LatticePath {
  std::int64_t clocks = 0;  ///< until the interpolator was done
  std::int64_t pulses = 0;  ///< of them with a step
  std::int64_t least = 0;   ///< of what was measured at each place, the start included
  std::int64_t greatest = 0;
  bool ends = false;  ///< done within the clocks it was given, where it was to end
};

/// From `start` on. `measure`: of a place, an integer; `watch` sees the interpolator before each clock.
template <pulse::Interpolator State, typename Measure, typename Watch>
LatticePath follow(State state, pulse::Point start, pulse::Point end, std::int64_t most_clocks, const Measure& measure,
                   Watch&& watch) {
  LatticePath path;
  pulse::Point at = start;
  path.least = path.greatest = measure(at);
  while (!state.done() && path.clocks < most_clocks) {
    watch(std::as_const(state));
    const auto pulse = state.step();
    ++path.clocks;
    path.pulses += (pulse.step[0] | pulse.step[1]) != 0;
    at.x += pulse.step[0];
    at.y += pulse.step[1];
    const std::int64_t found = measure(at);
    path.least = std::min(path.least, found);
    path.greatest = std::max(path.greatest, found);
  }
  path.ends = state.done() && at == end;
  return path;
}

/// x² + y² along an arc.
template <pulse::Interpolator State, typename Watch>
LatticePath follow_arc(State state, const pulse::Arc& arc, Watch&& watch) {
  const std::int64_t most_clocks = 40 * pulse::root(arc.squared_radius(), 0) + 100;
  const auto square = [](pulse::Point at) { return at.x * at.x + at.y * at.y; };
  return follow(std::move(state), arc.start, arc.end, most_clocks, square, watch);
}
template <pulse::Interpolator State>
LatticePath follow_arc(State state, const pulse::Arc& arc) {
  return follow_arc(std::move(state), arc, [](const State&) {});
}

/// Greatest |√(x² + y²) − R| of such a path, BLU.
inline double radial_error(const LatticePath& path, std::int64_t squared_radius) {
  const double radius = std::sqrt(static_cast<double>(squared_radius));
  return std::max(std::sqrt(static_cast<double>(path.greatest)) - radius,
                  radius - std::sqrt(static_cast<double>(path.least)));
}

/// a·y − b·x along the line from the origin to (a, b).
template <pulse::Interpolator State>
LatticePath follow_line(State state, pulse::Point delta) {
  const std::int64_t most_clocks = 8 * (pulse::absolute(delta.x) + pulse::absolute(delta.y)) + 1000;
  const auto cross = [delta](pulse::Point at) { return delta.x * at.y - delta.y * at.x; };
  return follow(std::move(state), {}, delta, most_clocks, cross, [](const State&) {});
}

/// Greatest distance of such a path from its line, BLU.
inline double line_error(const LatticePath& path, pulse::Point delta) {
  const double length = std::hypot(static_cast<double>(delta.x), static_cast<double>(delta.y));
  return static_cast<double>(std::max(path.greatest, -path.least)) / length;
}

}  // namespace leadscrew::study
