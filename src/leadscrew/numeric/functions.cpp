#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <leadscrew/numeric/functions.hpp>
#include <limits>

namespace leadscrew::numeric {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// ln 2 in two parts, the first so short that whole multiples of it up to 2¹⁵ are exact.
constexpr double ln_2 = 0x1.62e42fefap-1, ln_2_rest = 0x1.cf79abc9e3b3ap-40;

/// 1/3, 1/5, 1/7, …
template <std::size_t count>
constexpr auto odd_reciprocals = [] {
  std::array<double, count> all{};
  for (std::size_t k = 0; k < count; ++k) all[k] = 1 / static_cast<double>(2 * k + 3);
  return all;
}();

/// z/3 + z²/5 + z³/7 + …, an even number of terms: two by two, which halves the chain of sums.
template <std::size_t count>
double odd_series(double z) {
  static_assert(count % 2 == 0);
  const double square = z * z;
  double sum = 0;
  for (std::size_t k = count; k > 0; k -= 2)
    sum = (odd_reciprocals<count>[k - 2] + z * odd_reciprocals<count>[k - 1]) + square * sum;
  return z * sum;
}

/// atan x = Σ 2²ⁿ (n!)²/(2n + 1)! x²ⁿ⁺¹/(1 + x²)ⁿ⁺¹ (Euler), 0 ≤ x ≤ 1, to all digits.
constexpr DoubleDouble arc_tangent_by_series(DoubleDouble x) {
  const DoubleDouble ratio = x * x / (x * x + 1.0);
  DoubleDouble term = x / (x * x + 1.0), sum = term;
  for (int n = 1; n < 115; ++n) {
    term = term * ratio * DoubleDouble(2 * n) / DoubleDouble(2 * n + 1);
    sum = sum + term;
  }
  return sum;
}

constexpr double steps_of_tangent = 8;

/// Arc tangents of 0, 1/8, …, 1.
constexpr auto arc_tangents = [] {
  std::array<DoubleDouble, 9> all{};
  for (std::size_t j = 0; j < all.size(); ++j)
    all[j] = arc_tangent_by_series(static_cast<double>(j) / steps_of_tangent);
  return all;
}();

/// Of y/x, 0 ≤ y ≤ x: with t = y/x and c the nearest eighth, atan t = atan c + atan u, u = (t − c)/(1 + c t), |u| ≤ 1/16.
DoubleDouble arc_tangent(double y, double x) {
  const double t = y / x;
  if (!(t <= 1)) return no_number;
  const auto node = static_cast<std::size_t>(t * steps_of_tangent + 0.5);
  const double c = static_cast<double>(node) / steps_of_tangent;
  const double u = (t - c) / (1 + c * t);
  return quick_two_sum(arc_tangents[node].hi, u) + (u * odd_series<6>(-u * u) + arc_tangents[node].lo);
}

/// Squares and products of what is multiplied by it neither overflow nor lose digits.
double scale_for(double greatest) {
  constexpr double large = 0x1p500, small = 0x1p-450, scale = 0x1p600;
  return greatest > large ? 1 / scale : greatest < small ? scale : 1;
}

struct Parts {
  double mantissa = 0, exponent = 0;
};

/// x = mantissa · 2^exponent, ½ ≤ mantissa < 1, of a finite number above 0.
Parts parts_of(double x) {
  constexpr double least_normal = 0x1p-1022, scale = 0x1p54;
  const bool is_normal = x >= least_normal;
  const auto bits = std::bit_cast<std::uint64_t>(is_normal ? x : x * scale);
  constexpr std::uint64_t mantissa_bits = (std::uint64_t{1} << 52) - 1, half = std::uint64_t{1022} << 52;
  return {std::bit_cast<double>((bits & mantissa_bits) | half),
          static_cast<double>(static_cast<int>(bits >> 52) - 1022 - (is_normal ? 0 : 54))};
}

/// 2ᵏ, −1022 ≤ k ≤ 1023.
double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

}  // namespace

double atan2(double y, double x) {
  constexpr DoubleDouble half_turn = two_pi * 0.5, quarter_turn = two_pi * 0.25;
  if (std::isinf(x) || std::isinf(y))
    return atan2(std::copysign(std::isinf(y) ? 1 : 0, y), std::copysign(std::isinf(x) ? 1 : 0, x));
  const double scale = scale_for(std::max(std::abs(x), std::abs(y)));
  const double across = scale * std::abs(x), up = scale * std::abs(y);
  DoubleDouble angle = up > across ? quarter_turn - arc_tangent(across, up) : arc_tangent(up, across);
  if (across == 0 && up == 0) angle = 0;
  if (std::signbit(x)) angle = half_turn - angle;
  return std::copysign(angle.value(), y);
}

double asin(double x) {
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

double acos(double x) {
  return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

double scaled_hypot(double x, double y, double z) {
  const double greatest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  const double all = std::abs(x) + std::abs(y) + std::abs(z);
  if (greatest == infinity || !(all > 0)) return all;
  const double scale = scale_for(greatest), a = scale * x, b = scale * y, c = scale * z;
  return std::sqrt(a * a + b * b + c * c) / scale;
}

/// Of w 8ᵏ, 1/8 ≤ w < 1: a parabola's first digits, twice Halley's step, and Newton's from all digits of the cube.
double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const Parts parts = parts_of(std::abs(x));
  const int exponent = static_cast<int>(parts.exponent), thirds = (exponent > 0 ? exponent + 2 : exponent) / 3;
  const double w = parts.mantissa * power_of_two(exponent - 3 * thirds);
  double root = 0.3813 + w * (1.0719 - 0.469 * w);
  for (int step = 0; step < 2; ++step) {
    const double cube = root * root * root;
    root = root * (cube + 2 * w) / (2 * cube + w);
  }
  const DoubleDouble square = two_product(root, root), cube = two_product(square.hi, root);
  root = root + ((w - cube.hi) - (cube.lo + square.lo * root)) / (3 * square.hi);
  return std::copysign(root * power_of_two(thirds), x);
}

/// Of (1 + f) 2ᵏ, √½ ≤ 1 + f < √2, with s = f/(2 + f): ln(1 + f) = 2 atanh s = f − f²/2 + s (f²/2 + 2 (s²/3 + s⁴/5 + …)).
double log(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : no_number;
  if (x == infinity) return x;
  constexpr double root_of_half = 0x1.6a09e667f3bcdp-1;
  const Parts parts = parts_of(x);
  const bool is_low = parts.mantissa < root_of_half;
  const double f = (is_low ? 2 * parts.mantissa : parts.mantissa) - 1, k = is_low ? parts.exponent - 1 : parts.exponent;
  const double s = f / (2 + f), half_square = 0.5 * f * f;
  const double rest = s * (half_square + 2 * odd_series<10>(s * s));
  return k * ln_2 - ((half_square - (rest + k * ln_2_rest)) - f);
}

/// Of r + k ln 2, |r| ≤ ln 2/2: 2ᵏ (eʳ − 1) + (2ᵏ − 1).
double expm1(double x) {
  if (!(std::abs(x) < 709)) return x > 0 ? infinity : x < 0 ? -1 : x;
  const double k = std::floor(x * (1 / ln_2) + 0.5), r = (x - k * ln_2) - k * ln_2_rest;
  double sum = 1;
  for (int n = 16; n > 1; --n) sum = 1 + sum * r / n;
  const double power = std::ldexp(1.0, static_cast<int>(k));
  return power * (r * sum) + (power - 1);
}

}  // namespace leadscrew::numeric
