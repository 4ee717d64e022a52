#pragma once
// The quintic polynomial with value and two derivatives at both ends.

#include <array>
#include <leadscrew/numeric/jet.hpp>

namespace leadscrew::surfaces {

/// Coefficients of powers of x, 0 … 1; derivatives of a and b are by a parameter that is `width` from a to b.
inline std::array<double, 6> hermite_powers(const numeric::Jet<2>& a, const numeric::Jet<2>& b, double width) {
  const double a1 = a[1] * width, a2 = a[2] * width * width / 2, b1 = b[1] * width, b2 = b[2] * width * width / 2;
  const double p = b[0] - a[0] - a1 - a2, q = b1 - a1 - 2 * a2, r = b2 - a2;
  return {a[0], a1, a2, 10 * p - 4 * q + r, -15 * p + 7 * q - 2 * r, 6 * p - 3 * q + r};
}

inline double hermite_value(const numeric::Jet<2>& a, const numeric::Jet<2>& b, double width, double x) {
  const std::array<double, 6> c = hermite_powers(a, b, width);
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

/// With two derivatives by that parameter.
inline numeric::Jet<2> hermite_jet(const numeric::Jet<2>& a, const numeric::Jet<2>& b, double width, double x) {
  const std::array<double, 6> c = hermite_powers(a, b, width);
  numeric::Jet<2> jet;
  jet[0] = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
  jet[1] = (c[1] + x * (2 * c[2] + x * (3 * c[3] + x * (4 * c[4] + x * 5 * c[5])))) / width;
  jet[2] = (2 * c[2] + x * (6 * c[3] + x * (12 * c[4] + x * 20 * c[5]))) / (width * width);
  return jet;
}

}  // namespace leadscrew::surfaces
