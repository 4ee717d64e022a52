#pragma once
// Quadruple precision (113 bits) by the compiler's own arithmetic, the judge of arithmetic with two doubles: GCC's own type, or long
// double where that has them, as on AArch64.

#include <leadscrew/numeric/double_double.hpp>
#include <limits>

namespace testing_support {

#ifdef __SIZEOF_FLOAT128__
using Quad = __float128;
#else
using Quad = long double;
static_assert(std::numeric_limits<Quad>::digits == 113);
#endif

inline Quad quad(leadscrew::numeric::DoubleDouble x) {
  return static_cast<Quad>(x.hi) + static_cast<Quad>(x.lo);
}

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

}  // namespace testing_support
