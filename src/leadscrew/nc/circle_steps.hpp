#pragma once
// One step of each method by which "Interpolator for a computer numerical control system" has x′ = −y, y′ = x integrated,
// T in radians, ω = 1: eqs. 22 to 26 and the Runge-Kutta method that it compares with.

#include <array>
#include <cmath>
#include <cstdint>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::nc {

/// A place on the circle that is generated, of radius 10, in numbers of some kind.
template <typename Number>
struct CirclePoint {
  Number x = 10.0, y = 0.0;
};

/// Eq. 26.
template <typename Number>
CirclePoint<Number> euler(const CirclePoint<Number>& at, double t) {
  return {at.x - Number(t) * at.y, at.y + Number(t) * at.x};
}

/// Eqs. 24 and 25. The second coordinate by the trapezoid over the new and the old first one, as a program would.
template <typename Number>
CirclePoint<Number> tustin(const CirclePoint<Number>& at, double t) {
  const Number a = (1 - t * t / 4) / (1 + t * t / 4), b = t / (1 + t * t / 4), half = t / 2;
  const Number x = a * at.x - b * at.y;
  return {x, at.y + half * (at.x + x)};
}

/// Eq. 22.
template <typename Number>
CirclePoint<Number> state_transition(const CirclePoint<Number>& at, double t) {
  const Number a = numeric::cos(t), b = numeric::sin(t);
  return {a * at.x - b * at.y, a * at.y + b * at.x};
}

/// The classical rule of fourth order; only its last sum is cut.
template <typename Number>
CirclePoint<Number> runge_kutta(double x, double y, double t) {
  const double x1 = -y, y1 = x;
  const double x2 = -(y + t / 2 * y1), y2 = x + t / 2 * x1;
  const double x3 = -(y + t / 2 * y2), y3 = x + t / 2 * x2;
  const double x4 = -(y + t * y3), y4 = x + t * x3;
  return {x + t / 6 * (x1 + 2 * x2 + 2 * x3 + x4), y + t / 6 * (y1 + 2 * y2 + 2 * y3 + y4)};
}

/// Eqs. 23 and 24.
inline CirclePoint<double> heun(const CirclePoint<double>& at, double t) {
  return {at.x - t * at.y - t * t / 2 * at.x, at.y + t * at.x - t * t / 2 * at.y};
}

/// Eq. 27: x first, then y by the new x.
inline CirclePoint<double> x_first(const CirclePoint<double>& at, double t) {
  const double x = at.x - t * at.y;
  return {x, at.y + t * x};
}

enum class CircleRule : std::uint8_t { euler, heun, tustin, x_first, runge_kutta, state_transition };
inline constexpr std::array<CircleRule, 6> all_circle_rules = {CircleRule::euler,       CircleRule::heun,
                                                               CircleRule::tustin,      CircleRule::x_first,
                                                               CircleRule::runge_kutta, CircleRule::state_transition};

/// One step of t radians around (0, 0), counterclockwise where t > 0, by a rule.
inline CirclePoint<double> step_by(CircleRule rule, const CirclePoint<double>& at, double t) {
  switch (rule) {
    case CircleRule::euler:
      return euler(at, t);
    case CircleRule::heun:
      return heun(at, t);
    case CircleRule::tustin:
      return tustin(at, t);
    case CircleRule::x_first:
      return x_first(at, t);
    case CircleRule::runge_kutta:
      return runge_kutta<double>(at.x, at.y, t);
    case CircleRule::state_transition:
      break;
  }
  return state_transition(at, t);
}

/// Error of the radius after so many steps of t, by R.
template <typename Step>
double radius_error(const Step& step, double t, double count) {
  const CirclePoint<double> from;
  CirclePoint<double> at = from;
  for (double n = 0; n < count; ++n) at = step(at, t);
  return std::abs(numeric::hypot(at.x, at.y) / from.x - 1);
}

}  // namespace leadscrew::nc
