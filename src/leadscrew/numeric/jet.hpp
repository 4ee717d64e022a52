#pragma once
// Jets: a value and its first three derivatives by one parameter, carried together through arithmetic. What geometry
// says of a curve and kinematics makes of it is said in jets, so that velocity, acceleration and jerk need no finite
// differences.

#include <array>
#include <cmath>

namespace leadscrew::numeric {

/// f, f′, f″, f‴ at one parameter value.
struct Jet {
  double value = 0;
  double first = 0;
  double second = 0;
  double third = 0;

  constexpr Jet() = default;
  constexpr Jet(double constant) : value(constant) {}  // NOLINT: a constant is a jet
  constexpr Jet(double f, double f1, double f2, double f3) : value(f), first(f1), second(f2), third(f3) {}

  /// The parameter itself, at u.
  static constexpr Jet parameter(double u) { return {u, 1, 0, 0}; }

  friend constexpr bool operator==(const Jet&, const Jet&) = default;
};

constexpr Jet operator-(const Jet& a) {
  return {-a.value, -a.first, -a.second, -a.third};
}
constexpr Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second, a.third + b.third};
}
constexpr Jet operator-(const Jet& a, const Jet& b) {
  return a + (-b);
}

/// Leibniz' rule.
constexpr Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2 * a.first * b.first + a.value * b.second,
          a.third * b.value + 3 * a.second * b.first + 3 * a.first * b.second + a.value * b.third};
}

/// h(f), given h and its derivatives at f.value (Faà di Bruno's formula).
constexpr Jet compose(const Jet& h, const Jet& f) {
  return {h.value, h.first * f.first, h.second * f.first * f.first + h.first * f.second,
          h.third * f.first * f.first * f.first + 3 * h.second * f.first * f.second + h.first * f.third};
}

/// f.value ≠ 0.
constexpr Jet reciprocal(const Jet& f) {
  const double r = 1 / f.value;
  return compose({r, -r * r, 2 * r * r * r, -6 * r * r * r * r}, f);
}
constexpr Jet operator/(const Jet& a, const Jet& b) {
  return a * reciprocal(b);
}

inline Jet sin(const Jet& f) {
  const double s = std::sin(f.value), c = std::cos(f.value);
  return compose({s, c, -s, -c}, f);
}
inline Jet cos(const Jet& f) {
  const double s = std::sin(f.value), c = std::cos(f.value);
  return compose({c, -s, -c, s}, f);
}

/// f.value > 0.
inline Jet sqrt(const Jet& f) {
  const double root = std::sqrt(f.value);
  return compose({root, 0.5 / root, -0.25 / (root * f.value), 0.375 / (root * f.value * f.value)}, f);
}

}  // namespace leadscrew::numeric
