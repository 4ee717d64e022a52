#pragma once
// Where a curve turns on the spot: cusps, reversals, points of no speed, and turns too tight to tell from a corner.
//
// C′ = D/W² with D = N′W − NW′, a polynomial. If all Bernstein coefficients of D on an interval lie in front of one
// plane through 0, so does D: |C′| has no zero there and the tangent turns less than half a turn. Intervals where they
// do not are halved; those still left when shorter than 1e-6 mm hold a kink. A turn of radius 1e-5 mm passes the test
// long before.

#include <leadscrew/geometry/rational.hpp>
#include <vector>

namespace leadscrew::geometry {

struct Kinks {
  bool at_start = false, at_end = false;
  std::vector<double> inside;  ///< t, ascending, 0 < t < 1
};

/// Curves shorter than this have none inside, mm or degrees.
inline constexpr double shortest_examined = 1e-5;

/// The speed vanishes nowhere but at isolated points.
Kinks find_kinks(const RationalBezier& curve, const Metric& metric);

/// An upper bound of the curve's length, the better the shorter the curve.
double longest_possible(const RationalBezier& curve, const Metric& metric);

}  // namespace leadscrew::geometry
