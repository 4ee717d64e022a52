#pragma once
// Which interpolators of pulse/ a firmware has: one for lines, one for arcs, with registers of so many bits. The build
// says both: -DMETHOD=koren -DREGISTER_BITS=16.

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/linear.hpp>

namespace leadscrew::embedded {

template <int bits>
struct RegisterOf;
template <>
struct RegisterOf<16> {
  using Type = std::int16_t;
};
template <>
struct RegisterOf<32> {
  using Type = std::int32_t;
};

/// Cycles from step to step on an ATmega328P: a step over a border of quadrants takes less.
template <typename Register>
inline constexpr std::uint16_t least_period = 80 * 8 * sizeof(Register);

/// Koren's program: integrators that begin half full, Y's fed with X's new coordinate (eq. 27); q the radius, and of a
/// line its longer component.
template <typename Number>
struct koren {
  using Register = Number;
  using Circle = pulse::BasicCircularDda<Register>;
  using Line = pulse::LinearDda<2, Register>;
  static constexpr Circle circle(const pulse::BasicArc<Register>& arc) {
    return Circle(arc, {pulse::Order::x_first, pulse::Preload::half});
  }
  static constexpr Line line(pulse::BasicPoint<Register> delta) {
    const Register a = pulse::absolute(delta.x), b = pulse::absolute(delta.y), longer = a > b ? a : b;
    return Line({delta.x, delta.y}, longer > 0 ? longer : Register{1}, pulse::Preload::half);
  }
};

template <typename Number>
struct point_comparison {
  using Register = Number;
  using Circle = pulse::CircularSearch<pulse::Search::point_comparison, pulse::OnCircle::outward, Register>;
  using Line = pulse::LinearPointComparison<2, Register>;
  static constexpr Circle circle(const pulse::BasicArc<Register>& arc) { return Circle(arc); }
  static constexpr Line line(pulse::BasicPoint<Register> delta) { return Line({delta.x, delta.y}); }
};

/// Arcs by a search for the least error, lines by Bresenham's.
template <pulse::Search search, typename Number>
struct LeastError {
  using Register = Number;
  using Circle = pulse::CircularSearch<search, pulse::OnCircle::outward, Register>;
  using Line = pulse::BasicLinearBresenham<Register>;
  static constexpr Circle circle(const pulse::BasicArc<Register>& arc) { return Circle(arc); }
  static constexpr Line line(pulse::BasicPoint<Register> delta) { return Line(delta); }
};
template <typename Number>
using least_error = LeastError<pulse::Search::least_error, Number>;
template <typename Number>
using improved = LeastError<pulse::Search::improved_least_error, Number>;

}  // namespace leadscrew::embedded
