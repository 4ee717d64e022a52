#pragma once
// Roots, sines and arc tangents of double-doubles, to about 100 bits; sine and cosine of an angle in degrees for every
// scalar that formulas of rotary axes are told in: double, DoubleDouble, and jets of either.
//
// Degrees are reduced before they become radians: θ − 90 k with a whole k is exact, so that quarter turns have the sines
// 0, 1, 0 and −1 to the last bit, and an angle of many turns is as good as a small one.

#include <array>
#include <cstddef>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/jet.hpp>
#include <type_traits>

namespace leadscrew::numeric {

inline constexpr DoubleDouble radians_of_degree = two_pi / DoubleDouble(360);
inline constexpr DoubleDouble degrees_of_radian = DoubleDouble(360) / two_pi;

/// Of one angle.
template <typename T>
struct SinePair {
  T sine{}, cosine{};
};

/// a ≥ 0. The error is below 2⁻¹⁰⁰ of the root.
DoubleDouble sqrt(DoubleDouble a);
/// √(x² + y²), where neither square overflows or underflows.
DoubleDouble hypot(DoubleDouble x, DoubleDouble y);
/// √(x² + y² + z²), where no square overflows or underflows.
DoubleDouble hypot(DoubleDouble x, DoubleDouble y, DoubleDouble z);

/// Of radians, |angle| ≤ 2²⁰; errors are below 2⁻¹⁰⁰, of the smaller one too where it is no smaller than 2⁻⁴⁰.
SinePair<DoubleDouble> sine_cosine(DoubleDouble angle);
/// The first of sine_cosine().
DoubleDouble sin(DoubleDouble angle);
/// The second of sine_cosine().
DoubleDouble cos(DoubleDouble angle);
/// The angle of (x, y), radians, −π … π; 0 of (0, 0). The error is below 2⁻⁹⁸ of the angle.
DoubleDouble atan2(DoubleDouble y, DoubleDouble x);

/// Of an angle in degrees, |angle| ≤ 2⁴⁰. Errors are below one unit in the last place; quarter turns are exact.
SinePair<double> sines_of_degrees(double angle);
/// Of two angles, each to the last bit as alone.
SinePair<Pair> sines_of_degrees(Pair angles);
/// Of an angle in degrees, |angle| ≤ 2⁴⁰. Errors are below 2⁻¹⁰⁰; quarter turns are exact.
SinePair<DoubleDouble> sines_of_degrees(DoubleDouble angle);

/// Of an angle in degrees with its derivatives, given sine and cosine of its value: s′ = c φ′, c′ = −s φ′ with φ = angle·π/180.
template <std::size_t N, typename T>
SinePair<Jet<N, T>> sines_of_degrees(const Jet<N, T>& angle, const T& s, const T& c) {
  Jet<N, T> radians;
  for (std::size_t k = 1; k <= N; ++k) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Pair>) {
      radians[k] = angle[k] * radians_of_degree.hi;
    } else {
      radians[k] = angle[k] * T(radians_of_degree);
    }
  }
  if constexpr (N == 3) {
    return {compose<T>({s, c, -s, -c}, radians), compose<T>({c, -s, -c, s}, radians)};
  } else {
    const auto both = sine_cosine_from<N, T>(s, c, radians);
    return {both.sine, both.cosine};
  }
}
template <std::size_t N, typename T>
SinePair<Jet<N, T>> sines_of_degrees(const Jet<N, T>& angle) {
  const auto [s, c] = sines_of_degrees(angle[0]);
  return sines_of_degrees<N, T>(angle, s, c);
}

/// Of two angles of their own, each as alone: where both are doubles, or jets of doubles, side by side.
template <typename T>
std::array<SinePair<T>, 2> sines_of_both_degrees(const T& first, const T& second) {
  if constexpr (std::is_same_v<T, double>) {
    const auto [s, c] = sines_of_degrees(Pair{first, second});
    return {SinePair<T>{s[0], c[0]}, SinePair<T>{s[1], c[1]}};
  } else if constexpr (requires { requires std::is_same_v<std::remove_cvref_t<decltype(first[0])>, double>; }) {
    const auto [s, c] = sines_of_degrees(Pair{first[0], second[0]});
    return {sines_of_degrees(first, s[0], c[0]), sines_of_degrees(second, s[1], c[1])};
  } else {
    return {sines_of_degrees(first), sines_of_degrees(second)};
  }
}

}  // namespace leadscrew::numeric
