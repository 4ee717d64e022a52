#pragma once
// The four cubic B-splines that live on one interval of a knot sequence, as polynomials there (de Boor, "A Practical
// Guide to Splines", ch. X): B_j(u) = Σ_p m[j][p] u^p, 0 ≤ u ≤ 1.
//
// Coefficients, since a window looks at every interval hundreds of times. toolpath/quintic_basis has values by the
// recursion at single places: another order of operations, which gives other last bits, and another cost.

#include <array>
#include <vector>

namespace leadscrew::planner {

using Four = std::array<double, 4>;

struct CubicBasis {
  std::array<Four, 4> m{};
  double h = 0;  ///< width of the interval

  /// knots t[0] … t[5] around the interval from t[2] to t[3]; t[2] < t[3].
  explicit CubicBasis(const std::array<double, 6>& t);
  CubicBasis() = default;

  /// B_j, dB_j/ds, d²B_j/ds² at u.
  Four value(double u) const;
  Four slope(double u) const;
  Four bend(double u) const;
};

inline double dot(const Four& a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The same spline with one knot more (Boehm): strictly between two of `knots`. The spline is clamped at its first
/// knot: `c` has two coefficients more than there are knots, less those of knots beyond its last interval.
void insert_knot(std::vector<double>& knots, std::vector<double>& c, double s);

}  // namespace leadscrew::planner
