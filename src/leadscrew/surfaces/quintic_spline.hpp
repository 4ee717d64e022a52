#pragma once
// A B-spline of degree 5 through nodes with their first and second derivatives: between two nodes the quintic polynomial that
// has those of both, so that it is C2 throughout.
//
// A node t between a and b, at which three knots lie, has three control points: the blossom f(t, t, t, x, y) at (x, y) =
// (a, a), (a, b), (b, b), which is of f, f′ and f″ at t alone (Piegl and Tiller, "The NURBS Book", ch. 2; Ramshaw, "Blossoms are
// polar forms"):
//
//     f(t, t, t, x, y) = f + f′ ((x − t) + (y − t))/5 + f″ (x − t)(y − t)/20

#include <array>
#include <cstddef>
#include <leadscrew/numeric/jet.hpp>
#include <span>
#include <vector>

namespace leadscrew::surfaces {

/// A clamped B-spline of degree 5 with control points of N coordinates.
template <std::size_t N>
struct QuinticSpline {
  std::vector<double> knots;                  ///< 6 more than points
  std::vector<std::array<double, N>> points;  ///< three a node
};

/// By its parameter, ascending, one for each node; two nodes or more, and as many of `jets`: all coordinates by that parameter.
template <std::size_t N>
QuinticSpline<N> quintic_spline(std::span<const double> parameters,
                                std::span<const std::array<numeric::Jet<2>, N>> jets) {
  QuinticSpline<N> spline;
  spline.knots.reserve(3 * parameters.size() + 6);
  spline.points.reserve(3 * parameters.size());
  const std::size_t last = parameters.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const double t = parameters[k], a = parameters[k > 0 ? k - 1 : 0] - t, b = parameters[k < last ? k + 1 : last] - t;
    for (int i = 0; i < (k == 0 || k == last ? 6 : 3); ++i) spline.knots.push_back(t);
    const std::array<std::array<double, 2>, 3> places = {{{a, a}, {a, b}, {b, b}}};
    for (const auto& [x, y] : places) {
      std::array<double, N>& point = spline.points.emplace_back();
      for (std::size_t i = 0; i < N; ++i) {
        const numeric::Jet<2>& f = jets[k][i];
        point[i] = f[0] + f[1] * (x + y) / 5 + f[2] * x * y / 20;
      }
    }
  }
  return spline;
}

}  // namespace leadscrew::surfaces
