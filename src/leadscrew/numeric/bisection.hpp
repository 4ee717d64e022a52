#pragma once
// Bisection: where a condition that holds at first holds no more.

#include <cstddef>

namespace leadscrew::numeric {

/// Two neighbouring places: the condition holds at `from`, or that is where it was looked for, and not at `to`.
struct Bracket {
  double from = 0, to = 0;
};

/// Halves from … to at most so often, and no further than to a width of `relative` times its end.
template <typename IsBefore>
constexpr Bracket bisect(double from, double to, int halvings, const IsBefore& is_before, double relative = 0) {
  for (int k = 0; k < halvings && to - from > relative * to; ++k) {
    const double middle = (from + to) / 2;
    (is_before(middle) ? from : to) = middle;
  }
  return {from, to};
}

/// The last of the indices low … high at which the condition holds. It holds at `low`, and behind an index at which it
/// does not it does not either.
template <typename Holds>
constexpr std::size_t last_index(std::size_t low, std::size_t high, const Holds& holds) {
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (holds(middle)) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

}  // namespace leadscrew::numeric
