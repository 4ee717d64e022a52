#pragma once
// A double beside the sum of the rounding errors that were made on the way to it: compensated arithmetic (Ogita, Rump and
// Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005). For words under kinematics, which are to be
// rounded once: a few additional bits are enough for that, and neither sums nor products are normalised, so that they
// cost a third of a double-double's.

#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/elementary.hpp>

namespace leadscrew::numeric {

/// sum + error. Where sums cancel, |error| may be many units in the last place of the sum; products of two errors are left
/// out.
struct Compensated {
  double sum = 0;
  double error = 0;

  constexpr Compensated() = default;
  constexpr Compensated(double value) : sum(value) {}  // NOLINT: a double is one
  constexpr Compensated(double value, double rounding_error) : sum(value), error(rounding_error) {}

  /// Rounded once.
  constexpr double value() const { return sum + error; }

  friend constexpr Compensated operator-(Compensated a) { return {-a.sum, -a.error}; }
  friend constexpr Compensated operator+(Compensated a, Compensated b) {
    const DoubleDouble total = two_sum(a.sum, b.sum);
    return {total.hi, total.lo + (a.error + b.error)};
  }
  friend constexpr Compensated operator-(Compensated a, Compensated b) { return a + (-b); }
  friend constexpr Compensated operator*(Compensated a, double b) {
    const DoubleDouble product = two_product(a.sum, b);
    return {product.hi, product.lo + a.error * b};
  }
  friend constexpr Compensated operator*(Compensated a, Compensated b) {
    const DoubleDouble product = two_product(a.sum, b.sum);
    return {product.hi, product.lo + (a.sum * b.error + a.error * b.sum)};
  }
};

/// Of an angle in degrees, |angle| ≤ 2⁴⁰, its error far below 1. Errors are below 2⁻⁵⁸; quarter turns are exact.
SinePair<Compensated> sines_of_degrees(Compensated angle);

}  // namespace leadscrew::numeric
