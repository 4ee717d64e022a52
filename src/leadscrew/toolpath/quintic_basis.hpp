#pragma once
// The six quintic B-splines that live on one interval of a knot sequence (de Boor, "A Practical Guide to Splines", ch.
// X), and what control points say of a spline's derivatives.

#include <array>
#include <cstddef>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/point.hpp>
#include <vector>

namespace leadscrew::toolpath {

inline constexpr std::size_t quintic_degree = 5;

using Six = std::array<double, quintic_degree + 1>;

/// Their values at u, t[5] ≤ u ≤ t[6]; t points at the 12 knots around the interval, t[5] < t[6].
Six quintic_values(const double* t, double u);
/// Their third derivatives by u.
Six quintic_third_derivatives(const double* t, double u);

/// Position and derivatives by u, as many as are known.
struct State {
  static constexpr std::size_t most = 5;  ///< position and four derivatives: what a quintic spline keeps at a knot
  std::array<geometry::Point, most> derivative{};
  std::size_t count = 1;  ///< 1 … most
};

/// A quintic B-spline, clamped at its first knot: knots[0] = … = knots[5] ≤ u ≤ knots[n], n the number of points.
struct QuinticSpline {
  std::vector<double> knots;
  std::vector<geometry::Point> points;

  std::size_t spans() const { return points.size() - quintic_degree; }
  double span_begin(std::size_t span) const { return knots[span + quintic_degree]; }
  double span_end(std::size_t span) const { return knots[span + quintic_degree + 1]; }
  /// The span in which u lies; at a knot the one that begins there, at the end the last.
  std::size_t span_at(double u) const;
  geometry::Point value(std::size_t span, double u) const;
  /// Position and four derivatives at the beginning of a span, or at the end of the last.
  State state(std::size_t span, double u) const;
};

/// The first control points of a spline that is clamped at t[0] = … = t[5] and begins with that state: as many as it
/// has derivatives, into `points`.
void begin_with(const State& state, const double* t, geometry::Point* points);

}  // namespace leadscrew::toolpath
