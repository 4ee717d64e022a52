#pragma once
// The time of a word, in double-double.

#include <leadscrew/base/time.hpp>
#include <leadscrew/numeric/double_double.hpp>

namespace leadscrew::interpolator {

inline constexpr numeric::DoubleDouble nanosecond = numeric::DoubleDouble(1) / numeric::DoubleDouble(1e9);  ///< s

/// n·T to the precision of a double-double, for any run shorter than 104 days: n·T in nanoseconds is exact.
inline numeric::DoubleDouble time_of(base::Tick tick, base::Period period) {
  return nanosecond * static_cast<double>(base::count(tick) * period.nanoseconds);
}

}  // namespace leadscrew::interpolator
