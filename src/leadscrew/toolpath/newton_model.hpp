#pragma once
// The quadratic model of a barrier in the control points of a TimeSpline and the cube w of its interval, for Newton's
// method: a banded Hessian, since a term has four neighbouring points at most, bordered by a row for w.

#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/toolpath/corridor.hpp>
#include <vector>

namespace leadscrew::toolpath {

/// Gradient and Hessian in the control points, bordered by those in w.
template <std::size_t D>
struct NewtonModel {
  static constexpr std::size_t half_bandwidth = 4 * D - 1;
  numeric::BandedMatrix<half_bandwidth> hessian;
  std::vector<double> slope, border;
  double w_slope = 0, w_curvature = 0;
  std::vector<double> along_slope, along_border;

  void reset(std::size_t points);
  /// The first three points and the last three do not move.
  void fix_ends();
  /// Of every point, and of w, with every diagonal element made greater by `damping` times itself: along a line of many
  /// intervals only its ends say where points are, and the model is as good as singular. Returns the decrement, not finite
  /// where the model could not be solved.
  double solve(double damping, std::vector<Vector<D>>& step, double& w_step);
};

}  // namespace leadscrew::toolpath
