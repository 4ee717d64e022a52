#pragma once
// Powers of doubles by sums, products and quotients alone, as functions.hpp has its functions, and to the nearest double: what a
// C library rounds to the nearest, too, it has alike.

#include <leadscrew/numeric/double_double.hpp>

namespace leadscrew::numeric {

/// eˣ, |x| ≤ 700. The error is below 2⁻⁹⁴ of it.
DoubleDouble exp(DoubleDouble x);
/// Natural logarithm, 1e-300 ≤ x ≤ 1e300. The error is below 2⁻⁹⁴ of it or of 1.
DoubleDouble fine_log(double x);

/// baseˣ, 1e-300 ≤ base ≤ 1e300, |x ln base| ≤ 700: the double that is nearest, unless two are as near to within 2⁻²⁸ of their distance.
double pow(double base, double x);

}  // namespace leadscrew::numeric
