#pragma once
// Random numbers of a case, by its seed and its number alone: case 700 000 is drawn without those before it, and is the same on
// every computer.
//
// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014): a counter through a mixer.

#include <cstdint>
#include <initializer_list>
#include <leadscrew/numeric/power.hpp>

namespace leadscrew::campaign {

/// From 0 < `low` to `high`, by magnitude: so many millionths of the way, 0 … 1 000 000; the same bits on every computer.
inline double by_magnitude(double low, double high, int millionths) {
  return low * numeric::pow(high / low, millionths / 1e6);
}

class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t number) : state_(mixed(mixed(seed) ^ (number * golden + 1))) {}

  /// From `low` to just below `high`; low < high.
  template <class Whole>
  Whole any(Whole low, Whole high) {
    const auto range = static_cast<std::uint64_t>(high - low);
    return static_cast<Whole>(low + static_cast<Whole>(next() % range));
  }
  /// Once in so many times.
  bool once_in(int times) { return any(0, times) == 0; }
  /// True or false, as often.
  bool either() { return once_in(2); }
  /// In a millionth of steps.
  double between(double least, double greatest) { return least + (greatest - least) * any(0, 1'000'001) / 1e6; }
  /// 0 < `low` to `high`, by magnitude.
  double logarithmic(double low, double high) { return by_magnitude(low, high, any(0, 1'000'001)); }
  /// One of them.
  template <class Value>
  Value one_of(std::initializer_list<Value> values) {
    return *(values.begin() + any<std::int64_t>(0, static_cast<std::int64_t>(values.size())));
  }

 private:
  static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

  static std::uint64_t mixed(std::uint64_t value) {
    value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9;
    value = (value ^ value >> 27) * 0x94D049BB133111EB;
    return value ^ value >> 31;
  }
  std::uint64_t next() { return mixed(state_ += golden); }

  std::uint64_t state_;
};

}  // namespace leadscrew::campaign
