#pragma once
// Random numbers for properties, as widely spread in the first case as in the last: RapidCheck's own ranges begin
// narrow.

#include <rapidcheck.h>

#include <cmath>

namespace leadscrew::testing_support {

/// From `low` to just below `high`.
template <typename Whole>
Whole any(Whole low, Whole high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Whole>(low, high));
}

/// 0 < `low` to `high`, by magnitude.
inline double logarithmic(double low, double high) {
  return low * std::pow(high / low, any(0, 1000001) / 1e6);
}

/// By millionths of the range.
inline double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}

}  // namespace leadscrew::testing_support
