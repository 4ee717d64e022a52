#pragma once
// A motion in time without the knots that it does not need: where jerk hardly changes for long, its path is a spline of few
// long spans. Each knot of a path is a place where jerk may have to change, and a window of the planner reaches over only so
// many of them.
//
//     q‴:  ▁▁▁▁▁▂▂▂▂▂▂█▇▃▁▁▁▁▁▁   knots  |,,,,,,,|,,,|||||,,,|,,,,,|   those that stay

#include <cstddef>
#include <leadscrew/toolpath/corridor.hpp>
#include <vector>

namespace leadscrew::toolpath {

/// A twice continuously differentiable cubic spline from knots[1] to the last but one; point i belongs to knots[i], and
/// the spline near it is of knots[i - 2] to knots[i + 2].
struct SparseSpline {
  std::vector<double> knots;
  std::vector<Vector<3>> points;  ///< as many
};

/// How far such a spline may be from the motion.
struct Nearness {
  double tolerance = 0;          ///< mm
  Vector<3> jerk_step{};         ///< of the third derivative, in each coordinate, mm for each cube of an interval
  std::size_t longest_span = 1;  ///< intervals; 1: all knots stay
};

/// The motion from knot `first` to knot `last`, at least one interval; knots are times of the motion. At both ends position and
/// two derivatives are the motion's.
SparseSpline without_needless_knots(const TimeSpline<3>& motion, std::size_t first, std::size_t last,
                                    const Nearness& near);

}  // namespace leadscrew::toolpath
