#pragma once
// Which angles of the rotary axes hold the tool in a direction: two pairs, or none. Asked at the vertices of a path only;
// along it the rotary axes themselves are told (pose.hpp).
//
// With u₁, u₂ the directions of the turns and O the tool's, the points u₁, u₂ and x = W₂ ez make a triangle on the sphere
// whose sides are known: γ from u₁ to u₂, κ from u₂ to x, and η from u₁ to x, for turning about u₁ does not change it.
// With s half their sum, its angles at u₁ and u₂ are (half-angle formulas of spherical trigonometry)
//
//     tan² β/2 = sin(s − γ) sin(s − η) / (sin s sin(s − κ))  = f₁ f₃ / (f₄ f₂)     f₁, f₂ = sin((η ∓ (γ − κ))/2)
//     tan² ω/2 = sin(s − γ) sin(s − κ) / (sin s sin(s − η))  = f₁ f₂ / (f₄ f₃)     f₃, f₄ = sin(((γ + κ) ∓ η)/2)
//
// and x on one side of the arc from u₁ to u₂ or on the other gives the two pairs:
//
//     W₁ turns by  azimuth of O about u₁, from u₂, ∓ β        W₂ by  ∓ ω − azimuth of ez about u₂, from u₁
//
// Every f is linear in sin η/2 and cos η/2, which come from O without cancellation: h = |O across u₁| and O·u₁ give
// cos : sin = N + O·u₁ : h, N = |O|, where O·u₁ ≥ 0, and h : N − O·u₁ elsewhere. So angles stay as exact as O is however near a
// pole, where γ − κ is 0 or γ + κ is π; O need not be a unit vector.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/numeric/elementary.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::kinematics {

/// Nearer to a pole than this, radians, a direction is the pole: nothing is left of the angle about it.
inline constexpr double least_pole_angle = 5e-14;

/// A direction that is out of reach by no more, radians, is held as nearly as can be: vectors of programs have six decimals.
inline constexpr double reach_rounding = 1e-6;

/// Angles of the rotary axes.
template <typename T>
struct Solutions {
  std::size_t count = 0;  ///< 0, 1 (at a pole) or 2
  /// −180° < each ≤ 180°. At a pole the first angle of the pair is free, and 0 here.
  std::array<Angles<T>, 2> angles{};
  bool is_pole = false;  ///< Is the direction along the first turn?
  double miss = 0;       ///< by so much it is out of reach, degrees; > 0 where count is 0
};

namespace detail {

inline double value_of(double x) {
  return x;
}
inline double value_of(const numeric::DoubleDouble& x) {
  return x.value();
}
template <std::size_t N, typename T>
double value_of(const numeric::Jet<N, T>& x) {
  return value_of(x[0]);
}

inline double in_degrees(double radians) {
  return radians * numeric::degrees_of_radian.hi;
}
inline numeric::DoubleDouble in_degrees(const numeric::DoubleDouble& radians) {
  return radians * numeric::degrees_of_radian;
}
template <std::size_t N, typename T>
numeric::Jet<N, T> in_degrees(const numeric::Jet<N, T>& radians) {
  numeric::Jet<N, T> degrees;
  for (std::size_t k = 0; k <= N; ++k) degrees[k] = in_degrees(radians[k]);
  return degrees;
}

/// −180 < result ≤ 180
template <typename T>
T wrapped(const T& degrees) {
  const double turns = std::ceil((value_of(degrees) - 180) / 360);
  return degrees - T(360 * turns);
}

/// The half-angle of a right triangle of these squares of legs, twice: degrees.
template <typename T>
T doubled_angle(const T& opposite, const T& adjacent) {
  using numeric::atan2, std::sqrt;
  return in_degrees(T(2.0) * atan2(sqrt(opposite), sqrt(adjacent)));
}

/// A direction seen from the first turn.
template <typename T>
struct SeenFromFirst {
  T along, across, aside;           ///< O·u₁, and its parts towards u₂ and normal to both
  T half_cosine, half_sine;         ///< of η, times a common factor
  double angle = 0, from_pole = 0;  ///< η; η or π − η, whichever is less, radians
};

template <typename T>
SeenFromFirst<T> seen_from_first(const Chain& chain, const Vector3<T>& direction) {
  using numeric::hypot;
  const Cones& cones = chain.cones();
  SeenFromFirst<T> seen{
      dot(chain.turns()[0].direction, direction), dot(cones.across, direction), dot(cones.normal, direction), {}, {}};
  const double h = numeric::hypot(value_of(seen.across), value_of(seen.aside)), k = value_of(seen.along);
  seen.angle = numeric::atan2(h, k);
  seen.from_pole = numeric::atan2(h, std::abs(k));
  const bool is_pole = seen.from_pole < least_pole_angle;
  const T off = is_pole ? T(0.0) : hypot(seen.across, seen.aside);
  const T length = is_pole ? (k < 0 ? -seen.along : seen.along) : hypot(off, seen.along);
  seen.half_cosine = k < 0 ? off : length + seen.along;
  seen.half_sine = k < 0 ? length - seen.along : off;
  return seen;
}

/// How far η is outside what the cones reach, radians; ≤ 0 inside.
inline double miss_of(const Cones& cones, double angle) {
  const double least = 2 * std::abs(numeric::atan2(cones.difference_sine, cones.difference_cosine));
  const double sum = 2 * numeric::atan2(cones.sum_sine, cones.sum_cosine);
  return std::max(least - angle, angle - std::min(sum, numeric::two_pi.hi - sum));
}

template <typename T>
T not_below_zero(const T& x) {
  return value_of(x) > 0 ? x : T(0.0);
}

}  // namespace detail

/// Of a direction from the tip to the spindle, seen from the workpiece; finite, not 0, of any length. Jets have no derivatives
/// at poles, nor at the ends of reach.
template <typename T>
Solutions<T> solutions(const Chain& chain, const Vector3<T>& direction) {
  using numeric::atan2;
  const Cones& cones = chain.cones();
  const auto seen = detail::seen_from_first(chain, direction);
  Solutions<T> result;
  const double miss = detail::miss_of(cones, seen.angle);
  if (!(miss <= reach_rounding)) {
    result.miss = detail::in_degrees(miss);
    return result;
  }
  using detail::scaled;
  const T& c = seen.half_cosine;
  const T& s = seen.half_sine;
  const T f1 = detail::not_below_zero(scaled(s, cones.difference_cosine) - scaled(c, cones.difference_sine));
  const T f2 = detail::not_below_zero(scaled(s, cones.difference_cosine) + scaled(c, cones.difference_sine));
  const T f3 = detail::not_below_zero(scaled(c, cones.sum_sine) - scaled(s, cones.sum_cosine));
  const T f4 = detail::not_below_zero(scaled(c, cones.sum_sine) + scaled(s, cones.sum_cosine));
  const T omega = detail::doubled_angle<T>(f1 * f2, f3 * f4);
  result.is_pole = seen.from_pole < least_pole_angle;
  result.count = result.is_pole ? 1 : 2;
  for (std::size_t k = 0; k < result.count; ++k) {
    const double side = k == 0 ? 1 : -1;
    Angles<T>& angles = result.angles[k];
    if (!result.is_pole) {
      const T beta = detail::doubled_angle<T>(f1 * f3, f2 * f4);
      angles[0] = detail::in_degrees(T(atan2(seen.aside, seen.across))) - scaled(beta, side);
    }
    angles[1] = scaled(omega, -side) - T(cones.tool_azimuth);
    for (std::size_t i = 0; i < 2; ++i) {
      const double sense = chain.turns()[i].sign * (i < chain.table_count() ? -1 : 1);
      angles[i] = detail::wrapped(scaled(angles[i], sense));
    }
  }
  return result;
}

/// The angle between a direction and the nearer end of the first turn's axis, about which the first angle is free: degrees,
/// 0 … 90. Not every machine can hold a tool there.
inline double angle_from_pole(const Chain& chain, const Vector& direction) {
  return detail::in_degrees(detail::seen_from_first<double>(chain, direction).from_pole);
}

}  // namespace leadscrew::kinematics
