#pragma once
// A motion in X and Y as a uniform cubic B-spline in time: its jerk is constant from knot to knot, its acceleration
// linear, so that limits that hold for differences of control points hold everywhere:
//
//     jerk Δ³c/h³      acceleration Δ²c/h² at the knots      velocity within the hull of Δc/h      h: the interval, s
//
// Times are counted in intervals; knot k is at time k.

#include <array>
#include <cstddef>
#include <leadscrew/study/tube.hpp>
#include <vector>

namespace leadscrew::study {

struct TubeMotion {
  std::vector<PlaneVector> points;  ///< control points, mm, intervals() + 3; three times the same at either end: rest
  std::vector<double> passes;       ///< when it passes each joint of the tube, in intervals
  double interval = 0;              ///< s

  std::size_t intervals() const { return points.size() - 3; }
  double seconds() const { return static_cast<double>(intervals()) * interval; }
  /// Position at a knot, mm.
  PlaneVector knot(std::size_t k) const { return 1.0 / 6 * (points[k] + 4.0 * points[k + 1] + points[k + 2]); }
  /// Position at a time, 0 … intervals(), mm.
  PlaneVector at(double time) const;
  /// There, mm per interval.
  PlaneVector velocity(double time) const;
  /// Words a period apart, the first at rest at the beginning, the last at the end: the motion slowed down so that it
  /// takes a whole number of periods. mm.
  std::vector<PlaneVector> words(double period) const;
};

/// The four control points from `first` on that make the position at a time, and by how much each.
struct SplineWeights {
  std::size_t first = 0;
  std::array<double, 4> weights{};
};
SplineWeights position_weights(double time, std::size_t intervals);

/// From rest to rest along each leg, with the share of the time told for each leg (> 0, any scale). The interval is the
/// least that keeps every limit of the tube.
TubeMotion stopping_motion(const Tube& tube, std::size_t intervals, const std::vector<double>& shares);

}  // namespace leadscrew::study
