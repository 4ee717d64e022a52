#pragma once
// How far an interpolator's lattice path is from the true curve.

#include <algorithm>
#include <cmath>
#include <leadscrew/pulse/arc.hpp>

namespace leadscrew::pulse::testing {

struct Trace {
  double worst = 0;         ///< distance of a lattice point from the curve, BLU
  std::int64_t clocks = 0;  ///< until it was done
  std::int64_t pulses = 0;  ///< clocks with a step
  bool ends = false;        ///< done, and where it was to end
};

/// From `start` on, at most so many clocks; `distance` of a point from the curve.
template <Interpolator State, typename Distance>
Trace trace(State state, Point start, Point end, std::int64_t most_clocks, const Distance& distance) {
  Trace result;
  Point at = start;
  while (!state.done() && result.clocks < most_clocks) {
    const auto pulse = state.step();
    ++result.clocks;
    result.pulses += pulse.step[0] != 0 || pulse.step[1] != 0;
    at.x += pulse.step[0];
    at.y += pulse.step[1];
    result.worst = std::max(result.worst, distance(at));
  }
  result.ends = state.done() && at == end && state.step() == Pulse<2>{};
  return result;
}

template <Interpolator State>
Trace trace_arc(State state, const Arc& arc) {
  const double radius = std::sqrt(static_cast<double>(arc.squared_radius()));
  const auto distance = [&](Point at) {
    return std::abs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) - radius);
  };
  return trace(std::move(state), arc.start, arc.end, static_cast<std::int64_t>(40 * radius) + 100, distance);
}

template <Interpolator State>
Trace trace_line(State state, Point end) {
  const double a = static_cast<double>(end.x), b = static_cast<double>(end.y), length = std::hypot(a, b);
  const auto distance = [&](Point at) {
    return std::abs(a * static_cast<double>(at.y) - b * static_cast<double>(at.x)) / length;
  };
  return trace(std::move(state), {}, end, static_cast<std::int64_t>(8 * length) + 1000, distance);
}

}  // namespace leadscrew::pulse::testing
