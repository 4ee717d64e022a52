#pragma once
// Numbers of steps and words from decimals of millimetres and feeds.

#include <cmath>
#include <cstdint>

namespace leadscrew::numeric {

inline constexpr double seconds_per_minute = 60;
inline constexpr double quotient_rounding = 1e-9;  ///< of a quotient of decimals that is meant to be whole

/// A count as a real number; exact up to 2⁵³.
constexpr double real(std::int64_t count) {
  return static_cast<double>(count);
}

/// The least whole number that is not below a quotient of decimals, which may be meant to be whole: 600/0.01 is 60 000.
inline std::int64_t rounded_up(double value) {
  return static_cast<std::int64_t>(std::ceil(value * (1 - quotient_rounding)));
}

}  // namespace leadscrew::numeric
