#pragma once
// One polynomial piece of a NURBS curve, in the two forms in which it is worked on.
//
// Both are homogeneous: q_i = origin_i + N_i(t) / W(t) for the coordinates that move, 0 ≤ t ≤ 1 between two knots. The
// origin is a point near by, so that rounding errors are of the size of the piece and not of its coordinates.

#include <array>
#include <cstddef>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/numeric/jet.hpp>
#include <utility>

namespace leadscrew::geometry {

/// Value and three derivatives by x of c[0] + c[1] x + … + c[degree] x^degree, by Horner's rule.
template <typename Coefficients, typename T>
numeric::Jet<3, T> polynomial_jet(const Coefficients& c, std::size_t degree, T x) {
  T value{}, first{}, half{}, sixth{};
  for (std::size_t k = degree + 1; k-- > 0;) {
    sixth = sixth * x + half;
    half = half * x + first;
    first = first * x + value;
    value = value * x + c[k];
  }
  return {value, first, 2 * half, 6 * sixth};
}

inline constexpr std::size_t most_coefficients = 6;  // degree 5
using Coefficients = std::array<double, most_coefficients>;

/// The polynomial's powers about another place (Horner's scheme, repeated).
inline Coefficients shifted(Coefficients c, double by) {
  for (std::size_t k = 0; k + 1 < most_coefficients; ++k) {
    for (std::size_t i = most_coefficients - 1; i-- > k;) c[i] += by * c[i + 1];
  }
  return c;
}

/// The coordinates that move somewhere on the curve, ascending. What follows counts these only, as slots.
struct Moving {
  std::array<std::uint8_t, base::axis_count> coordinate{};
  std::size_t count = 0;
};

/// The slots by which length is told, each times its weight.
struct Metric {
  std::array<std::uint8_t, base::axis_count> slot{};
  std::array<double, base::axis_count> weight{};
  std::size_t count = 0;

  void add(std::size_t of, double times) {
    slot[count] = static_cast<std::uint8_t>(of);
    weight[count++] = times;
  }

  friend bool operator==(const Metric&, const Metric&) = default;
};

/// By Bernstein coefficients.
struct RationalBezier {
  std::size_t degree = 0;
  std::size_t count = 0;  ///< slots
  bool rational = false;  ///< else W = 1
  Point origin{};         ///< by slot: the span's first control point
  std::array<Coefficients, base::axis_count> numerator{};
  /// The same about its last control point, which is exact where control points coincide there.
  Point end_origin{};
  std::array<Coefficients, base::axis_count> end_numerator{};
  Coefficients weight{};
  double parameter = 0;  ///< u = parameter + width·t
  double width = 0;
};

/// By powers of x, the parameter t counted from one end.
struct RationalTaylor {
  std::size_t degree = 0;
  std::size_t count = 0;
  bool rational = false;
  Point
      origin{};  ///< by slot: where C is at x = 0, to rounding. Near there C − origin is small, and so is what N/W loses
  std::array<Coefficients, base::axis_count> numerator{};
  Coefficients weight{};

  /// |dC/dx| by the metric.
  double speed(const Metric& metric, double x) const;
  /// N and W at x, and derivatives by x.
  numeric::Jet<> numerator_jet(std::size_t slot, double x) const;
  numeric::Jet<> weight_jet(double x) const;
  /// C − origin at x, and derivatives by x.
  numeric::Jet<> jet(std::size_t slot, double x) const { return numerator_jet(slot, x) / weight_jet(x); }
};

/// The curve between knots[span] < knots[span + 1], by blossoms (Ramshaw; Farin, "Curves and Surfaces for CAGD", 8.4).
RationalBezier bezier_of_span(const NurbsForm& form, const Moving& moving, bool rational, std::size_t span);

/// The parts before and after t, by de Casteljau's algorithm.
std::pair<RationalBezier, RationalBezier> split(const RationalBezier& curve, double t);

RationalTaylor from_start(const RationalBezier& curve);  ///< x = t
RationalTaylor from_end(const RationalBezier& curve);    ///< x = t − 1

}  // namespace leadscrew::geometry
