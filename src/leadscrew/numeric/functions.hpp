#pragma once
// Elementary functions of doubles by sums, products, quotients, square roots and powers of two alone, none of which any C
// library does differently: motion has the same bits on every processor, with every library, and in a browser. A decision
// of planning may hang on the last bit of a logarithm, and motion then differs by far more than that bit.

#include <cmath>
#include <leadscrew/numeric/sine.hpp>

namespace leadscrew::numeric {

/// Of radians; the error is below 0.75 units in the last place.
inline double sin(double angle) {
  return sines(angle).sine;
}
inline double cos(double angle) {
  return sines(angle).cosine;
}

/// The angle of (x, y), radians, −π … π, with y's sign. The error is below 1.7 units in the last place.
double atan2(double y, double x);
/// Radians; NaN beyond |x| = 1. The error is below 2.5 units in the last place of the angle or of 1.
double asin(double x);
double acos(double x);

/// √(x² + y² + z²) with squares scaled, so that they neither overflow nor lose digits: infinite where one is, else NaN where one is.
/// The error is below 1.5 units in the last place.
double scaled_hypot(double x, double y, double z);

/// √(x² + y² + z²) and √(x² + y²), without overflow on the way. The error is below 1.5 units in the last place.
inline double hypot(double x, double y, double z) {
  const double square = x * x + y * y + z * z;
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : scaled_hypot(x, y, z);
}
inline double hypot(double x, double y) {
  const double square = x * x + y * y;
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : scaled_hypot(x, y, 0);
}

/// The error is below 0.51 units in the last place.
double cbrt(double x);

/// Natural logarithm; −∞ of 0, NaN below. The error is below one unit in the last place.
double log(double x);
/// eˣ − 1, infinite from 709 on. The error is below three units in the last place.
double expm1(double x);

}  // namespace leadscrew::numeric
