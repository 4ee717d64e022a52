#pragma once
// Random numbers for properties, as widely spread in the first case as in the last: RapidCheck's own ranges begin
// narrow.

#include <rapidcheck.h>

#include <cmath>
#include <initializer_list>
#include <vector>

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

/// What campaign/ draws its programs from.
struct RapidDraws {
  template <typename Whole>
  Whole any(Whole low, Whole high) const {
    return testing_support::any(low, high);
  }
  bool once_in(int times) const { return any(0, times) == 0; }
  bool either() const { return *rc::gen::arbitrary<bool>(); }
  double between(double least, double greatest) const { return testing_support::between(least, greatest); }
  double logarithmic(double low, double high) const { return testing_support::logarithmic(low, high); }
  template <typename Value>
  Value one_of(std::initializer_list<Value> values) const {
    return *rc::gen::elementOf(std::vector<Value>(values));
  }
};

}  // namespace leadscrew::testing_support
