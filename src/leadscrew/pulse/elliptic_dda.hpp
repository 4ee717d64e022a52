#pragma once
// Ellipses by the two integrators of circular interpolation, each fed with a share of the coordinate of the other axis:
//
//   x = a cos θ, y = b sin θ        dx/dθ = −(a/b) y        dy/dθ = (b/a) x
//
//   y ──▶ (a/b)·y ──▶ X integrator ──▶ Δx ──▶ x      x ──▶ (b/a)·x ──▶ Y integrator ──▶ Δy ──▶ y
//
// The teaching interpolator's paper names them as what the same DDA makes besides circles. Integrands and capacity are
// taken a'b' times, a'/b' being a/b in lowest terms, so that all of them are whole: a'²·y and b'²·x against q·a'b'.
// Nothing is rounded, and where a = b these are the registers of the circle.
//
// A clock is 1/q radian of θ. The integrands are a and b where the other coordinate is greatest, so that q is at least
// the longer of the two. As along arcs of circles there are counters of the steps that are left in each quadrant, at
// whose zero an axis stops.

#include <leadscrew/pulse/circular_dda.hpp>
#include <numeric>

namespace leadscrew::pulse {

/// Half the axes of an ellipse about the origin, along X and along Y, BLU.
struct SemiAxes {
  std::int64_t x = 0, y = 0;

  constexpr std::int64_t longer() const { return x > y ? x : y; }
  /// Their ratio in lowest terms; both > 0.
  constexpr SemiAxes lowest_terms() const {
    const std::int64_t common = std::gcd(x, y);
    return {x / common, y / common};
  }
  /// What integrands and capacity are taken times: a'b'.
  constexpr std::int64_t scale() const { return lowest_terms().x * lowest_terms().y; }

  friend constexpr bool operator==(const SemiAxes&, const SemiAxes&) = default;
};

/// Greatest q·a'b': sums of a remainder and an integrand fit in a register.
inline constexpr std::int64_t greatest_scaled_capacity = std::int64_t{1} << 61;

class EllipticDda {
 public:
  static constexpr std::size_t axes = 2;

  /// One axis: its integrator and the counter of its steps.
  struct Axis {
    Integrator integrator;
    std::int64_t factor = 0;  ///< of the integrand: a'² of X, b'² of Y
    std::int64_t at = 0;
    std::int64_t left = 0;  ///< steps in this quadrant
    std::int8_t sign = 0;

    /// With the other axis there.
    constexpr std::int64_t integrand(std::int64_t other) const { return factor * absolute(other); }

    /// A counter may be left with an integrand that is 0 where the other axis has arrived: then it steps all the same.
    constexpr std::int8_t step(std::int64_t integrand, bool is_alone) {
      if (left == 0) return 0;
      if ((integrand > 0 || !is_alone) && !integrator.add(integrand)) return 0;
      --left;
      at += sign;
      return sign;
    }
  };

  /// An arc about the origin, its start and end on the ellipse or half a BLU beside it; the end is reached all the same.
  /// Semi-axes 1 … greatest_coordinate. Of the options order, preload and the capacity q, at least the longer semi-axis,
  /// which it is by default; q·a'b' ≤ greatest_scaled_capacity.
  constexpr EllipticDda(const Arc& arc, SemiAxes semi_axes, CircularDdaOptions options)
      : arc_(arc),
        semi_axes_(semi_axes),
        options_(options),
        capacity_(semi_axes.scale() * (options.capacity > 0 ? options.capacity : semi_axes.longer())),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    const SemiAxes least = semi_axes.lowest_terms();
    x_.factor = least.x * least.x;
    y_.factor = least.y * least.y;
    x_.at = arc.start.x;
    y_.at = arc.start.y;
    load();
    pass_on();
  }

  constexpr bool done() const { return x_.left == 0 && y_.left == 0; }

  constexpr Pulse<2> step() {
    const bool x_is_first = x_comes_first();
    Axis& first = x_is_first ? x_ : y_;
    Axis& second = x_is_first ? y_ : x_;
    const bool is_alone = x_.left == 0 || y_.left == 0;
    const std::int64_t old = first.at;
    const std::int8_t one = first.step(first.integrand(second.at), is_alone);
    const std::int8_t other = second.step(second.integrand(sees_new() ? first.at : old), is_alone);
    if (done()) pass_on();
    return x_is_first ? Pulse<2>{{one, other}} : Pulse<2>{{other, one}};
  }

  constexpr Point at() const { return {x_.at, y_.at}; }
  constexpr const Axis& x() const { return x_; }
  constexpr const Axis& y() const { return y_; }
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3
  /// Is its integrator the one that is clocked first in this quadrant?
  constexpr bool x_comes_first() const {
    const bool x_shrinks = ((quadrant_ & 1) == 0) == arc_.is_counterclockwise();
    return !sees_new() || options_.order == Order::x_first || (options_.order == Order::shrinking_first) == x_shrinks;
  }
  /// Does the second integrator see the first axis' new coordinate?
  constexpr bool sees_new() const { return options_.order != Order::parallel; }

 private:
  /// Into the next quadrant, if another follows.
  constexpr void pass_on() {
    while (borders_ > 0 && done()) {
      quadrant_ = after(quadrant_, arc_.direction);
      --borders_;
      load();
    }
  }

  constexpr void load() {
    const Point target = borders_ == 0 ? arc_.end : border();
    const bool x_lags = x_.integrand(y_.at) < y_.integrand(x_.at);
    load(x_, target.x, x_lags);
    load(y_, target.y, !x_lags);
  }
  constexpr void load(Axis& axis, std::int64_t target, bool lags) const {
    axis.integrator = {capacity_, preloaded(options_.preload, capacity_, lags)};
    axis.left = absolute(target - axis.at);
    axis.sign = sign(target - axis.at);
  }

  /// Where the ellipse leaves this quadrant.
  constexpr Point border() const {
    const Point of_unit_circle = pulse::border(quadrant_, arc_.direction, std::int64_t{1});
    return {of_unit_circle.x * semi_axes_.x, of_unit_circle.y * semi_axes_.y};
  }

  Arc arc_;
  SemiAxes semi_axes_;
  CircularDdaOptions options_;
  std::int64_t capacity_;  ///< q·a'b'
  int quadrant_, borders_;
  Axis x_, y_;
};

}  // namespace leadscrew::pulse
