#pragma once
// Two numbers that are worked on together, as any vector unit holds them: each gives the same bits as alone.

#include <bit>
#include <cmath>
#include <type_traits>

namespace leadscrew::numeric {

using Pair = double __attribute__((vector_size(16)));
using PairBits = long long __attribute__((vector_size(16)));  ///< and what comparisons of pairs give: all bits or none

/// The number itself, or both of a pair the same.
template <typename T>
constexpr T all(double value) {
  if constexpr (std::is_same_v<T, Pair>) {
    return Pair{value, value};
  } else {
    return value;
  }
}

inline double magnitude(double value) {
  return std::abs(value);
}
inline Pair magnitude(Pair values) {
  return std::bit_cast<Pair>(std::bit_cast<PairBits>(values) & 0x7fff'ffff'ffff'ffff);
}

inline double root(double value) {
  return std::sqrt(value);
}
inline Pair root(Pair values) {
  return Pair{std::sqrt(values[0]), std::sqrt(values[1])};
}

inline bool any(PairBits mask) {
#if defined(__SSE2__)
  return __builtin_ia32_movmskpd(std::bit_cast<Pair>(mask)) != 0;
#else
  return (mask[0] | mask[1]) != 0;
#endif
}

/// The second of one pair and the first of the next.
inline Pair between(Pair before, Pair behind) {
  return Pair{before[1], behind[0]};
}

}  // namespace leadscrew::numeric
