#pragma once
// Circular interpolation by two integrators, each fed with the coordinate of the other axis.
//
//   +--------+  Δx = ∓ (overflow)      y ──▶ X integrator ──▶ Δx ──▶ x      x ──▶ Y integrator ──▶ Δy ──▶ y
//
// Both remainders are accumulated without a sign; the quadrant gives the pulses theirs. The arc is travelled quadrant
// by quadrant, each with counters of the steps that are left, at whose zero an axis stops.

#include <leadscrew/pulse/arc.hpp>
#include <leadscrew/pulse/integrator.hpp>

namespace leadscrew::pulse {

/// Which of the two integrators sees the other's new coordinate.
enum class Order : std::uint8_t {
  parallel,         ///< none: registers clocked together, as in hardware; Euler's method
  x_first,          ///< Y's: Koren's program, eq. 27
  shrinking_first,  ///< that of the axis whose coordinate grows
  growing_first,    ///< that of the axis whose coordinate shrinks
};

struct CircularDdaOptions {
  Order order = Order::x_first;
  Preload preload = Preload::half;  ///< at the start of every quadrant
  int places = 0;  ///< binary places of the radius in the capacity, 0 … 16: 0 as published; more where feed on circles
                   ///< of irrational radius is to be exact
  int bits = 0;    ///< of the registers, where the capacity is 2ⁿ: every coordinate of the arc below it, places 0; 0
                   ///< where it is the radius
};

class CircularDda {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit CircularDda(const Arc& arc, CircularDdaOptions options = {})
      : arc_(arc),
        options_(options),
        radius_(root(arc.squared_radius(), 0)),
        capacity_(options.bits > 0 ? std::int64_t{1} << options.bits : root(arc.squared_radius(), options.places)),
        at_(arc.start),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    if (capacity_ < 1) capacity_ = 1;
    load();
    pass_on();
  }

  constexpr bool done() const { return left_x_ == 0 && left_y_ == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    bool steps_x = false, steps_y = false;
    // A counter may be left with an integrand that is 0: then nothing would ever overflow.
    if (left_x_ == 0 && at_.x == 0) {
      steps_y = true;
    } else if (left_y_ == 0 && at_.y == 0) {
      steps_x = true;
    } else if (x_is_first_) {
      steps_x = left_x_ > 0 && x_.add(absolute(at_.y) << options_.places);
      const std::int64_t integrand = absolute(is_parallel() || !steps_x ? at_.x : at_.x + sign_x_);
      steps_y = left_y_ > 0 && y_.add(integrand << options_.places);
    } else {
      steps_y = left_y_ > 0 && y_.add(absolute(at_.x) << options_.places);
      const std::int64_t integrand = absolute(steps_y ? at_.y + sign_y_ : at_.y);
      steps_x = left_x_ > 0 && x_.add(integrand << options_.places);
    }
    const Pulse<2> pulse{{steps_x ? sign_x_ : std::int8_t{0}, steps_y ? sign_y_ : std::int8_t{0}}};
    at_.x += pulse.step[0];
    at_.y += pulse.step[1];
    left_x_ -= steps_x;
    left_y_ -= steps_y;
    pass_on();
    return pulse;
  }

  constexpr Point at() const { return at_; }
  constexpr const Integrator& x() const { return x_; }
  constexpr const Integrator& y() const { return y_; }
  constexpr std::int64_t left_x() const { return left_x_; }
  constexpr std::int64_t left_y() const { return left_y_; }
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3

 private:
  constexpr bool is_parallel() const { return options_.order == Order::parallel; }

  /// Into the next quadrant, if this one is done and another follows.
  constexpr void pass_on() {
    while (borders_ > 0 && done()) {
      quadrant_ = after(quadrant_, arc_.direction);
      --borders_;
      load();
    }
  }

  constexpr void load() {
    const Point target = borders_ == 0 ? arc_.end : border(quadrant_, arc_.direction, radius_);
    left_x_ = absolute(target.x - at_.x);
    left_y_ = absolute(target.y - at_.y);
    sign_x_ = sign(target.x - at_.x);
    sign_y_ = sign(target.y - at_.y);
    const bool x_shrinks = ((quadrant_ & 1) == 0) == arc_.is_counterclockwise();
    x_is_first_ = options_.order == Order::x_first || options_.order == Order::parallel ||
                  (options_.order == Order::shrinking_first) == x_shrinks;
    const bool x_lags = absolute(at_.y) < absolute(at_.x);
    x_ = {capacity_, preloaded(options_.preload, capacity_, x_lags)};
    y_ = {capacity_, preloaded(options_.preload, capacity_, !x_lags)};
  }

  Arc arc_;
  CircularDdaOptions options_;
  std::int64_t radius_, capacity_;
  Point at_;
  int quadrant_, borders_;  ///< where it is; how many are still to be passed
  bool x_is_first_ = true;
  std::int8_t sign_x_ = 0, sign_y_ = 0;
  std::int64_t left_x_ = 0, left_y_ = 0;
  Integrator x_, y_;
};

}  // namespace leadscrew::pulse
