#pragma once
// Numbers of twice double's precision: an unevaluated sum of two doubles, |lo| ≤ ulp(hi)/2 (Dekker, "A floating-point
// technique for extending the available precision", Numer. Math. 18, 1971; error-free transformations after Knuth and
// Møller).
//
// Words are differenced three times by whoever judges them, and at short periods a rounding error of a few units in the
// last place would pass for jerk. Time, path length and axis positions are therefore carried in this form through the
// cycle and rounded once, at the end. Needs round-to-nearest doubles and no contraction (-ffp-contract=off).

namespace leadscrew::numeric {

struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : hi(value) {}  // NOLINT: a double is one
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

  constexpr double value() const { return hi + lo; }
};

/// a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b exactly, for |a| ≥ |b| or a = 0.
constexpr DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// A double beside its two halves of at most 26 bits each (Veltkamp), for products with several partners. |value| <
/// 2⁹⁹⁶.
struct Split {
  double value = 0;
  double high = 0;
  double low = 0;

  constexpr Split() = default;
  constexpr Split(double x) : value(x) {    // NOLINT: a double is one
    const double scaled = 134217729.0 * x;  // 2²⁷ + 1
    high = scaled - (scaled - x);
    low = x - high;
  }
};

/// a · b exactly, unless it overflows.
constexpr DoubleDouble two_product(const Split& a, const Split& b) {
  const double product = a.value * b.value;
#ifdef __FMA__
  return {product, __builtin_fma(a.value, b.value, -product)};
#else
  return {product, ((a.high * b.high - product) + a.high * b.low + a.low * b.high) + a.low * b.low};
#endif
}

constexpr DoubleDouble operator-(DoubleDouble a) {
  return {-a.hi, -a.lo};
}

constexpr DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble sum = two_sum(a.hi, b);
  return quick_two_sum(sum.hi, sum.lo + a.lo);
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  DoubleDouble sum = two_sum(a.hi, b.hi);
  const DoubleDouble low = two_sum(a.lo, b.lo);
  sum = quick_two_sum(sum.hi, sum.lo + low.hi);
  return quick_two_sum(sum.hi, sum.lo + low.lo);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + (-b);
}

constexpr DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble product = two_product(a.hi, b);
  return quick_two_sum(product.hi, product.lo + a.lo * b);
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.hi, b.hi);
  return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Long division, two quotient digits and a correction.
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.hi / b.hi;
  DoubleDouble rest = a - b * first;
  const double second = rest.hi / b.hi;
  rest = rest - b * second;
  return quick_two_sum(first, second) + rest.hi / b.hi;
}

constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
  return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
constexpr bool operator<=(DoubleDouble a, DoubleDouble b) {
  return !(b < a);
}

/// 2π to 32 digits.
inline constexpr DoubleDouble two_pi{6.283185307179586, 2.4492935982947064e-16};

}  // namespace leadscrew::numeric
