#pragma once
// The circle generator bare: two integrators that feed one another, both coordinates signed, without quadrants. What
// it drifts by is what the methods of interpolation are compared for, and whether one counter an axis can end an arc.

#include <leadscrew/pulse/circular_dda.hpp>
#include <limits>

namespace leadscrew::pulse {

/// How a remainder takes a negative integrand; the papers leave it open.
enum class Accumulation : std::uint8_t {
  sign_magnitude,  ///< the magnitude is added, the pulse gets the sign: Koren's figure of 10 001 BLU
  floor,           ///< the remainder stays in 0 … q − 1 and may borrow: two's complement
  symmetric,       ///< the remainder has a sign, stays between −q and q, and overflows at either
};

/// What a remainder overflows by: 1 at q and above, −1 below the least that it may be, 0 between.
constexpr std::int8_t carry_of(Accumulation accumulation, std::int64_t sum, std::int64_t capacity) {
  if (accumulation == Accumulation::sign_magnitude) return sum >= capacity ? 1 : 0;
  const std::int64_t least = accumulation == Accumulation::symmetric ? 1 - capacity : 0;
  return static_cast<std::int8_t>((sum >= capacity) - (sum < least));
}

class FreeCircle {
 public:
  static constexpr std::size_t axes = 2;

  /// Counterclockwise, without an end. capacity q > 0, ≥ |coordinates|; 0 ≤ preload < q, or −1, which with magnitudes
  /// is 0 where only r > q overflows; where remainders have signs, in the sense of their first integrands. Orders:
  /// x_first and parallel.
  constexpr FreeCircle(Point start, std::int64_t capacity, std::int64_t preload, Order order, Accumulation accumulation)
      : at_(start),
        capacity_(capacity),
        remainder_x_(accumulation == Accumulation::symmetric ? -preload : preload),
        remainder_y_(preload),
        is_parallel_(order == Order::parallel),
        accumulation_(accumulation) {}

  /// Along an arc, the counter of each axis loaded once with all steps that the axis has to make; at zero the axis
  /// stands still. The arc may end elsewhere than at its end, or never. Capacity R.
  constexpr FreeCircle(const Arc& arc, Preload preload, Order order, Accumulation accumulation)
      : FreeCircle(arc.start, root(arc.squared_radius(), 0), 0, order, accumulation) {
    remainder_x_ = remainder_y_ = preloaded(preload, capacity_, true);
    sense_ = static_cast<std::int64_t>(arc.direction);
    left_x_ = left_y_ = 0;
    int in = quadrant(arc.start, arc.direction);
    Point from = arc.start;
    for (int left = borders(arc); left >= 0; --left) {
      const Point to = left == 0 ? arc.end : border(in, arc.direction, capacity_);
      left_x_ += absolute(to.x - from.x);
      left_y_ += absolute(to.y - from.y);
      from = to;
      in = after(in, arc.direction);
    }
  }

  constexpr bool done() const { return left_x_ == 0 && left_y_ == 0; }

  constexpr Pulse<2> step() {
    const std::int64_t old_x = at_.x;
    const std::int8_t x = left_x_ > 0 ? overflow(remainder_x_, -sense_ * at_.y) : std::int8_t{0};
    at_.x += x;
    const std::int64_t integrand = sense_ * (is_parallel_ ? old_x : at_.x);
    const std::int8_t y = left_y_ > 0 ? overflow(remainder_y_, integrand) : std::int8_t{0};
    at_.y += y;
    left_x_ -= x != 0;
    left_y_ -= y != 0;
    return {{x, y}};
  }

  constexpr Point at() const { return at_; }

 private:
  constexpr std::int8_t overflow(std::int64_t& remainder, std::int64_t integrand) const {
    if (accumulation_ == Accumulation::sign_magnitude) {
      remainder += absolute(integrand);
      if (remainder < capacity_) return 0;
      remainder -= capacity_;
      return sign(integrand);
    }
    remainder += integrand;
    const std::int8_t carry = carry_of(accumulation_, remainder, capacity_);
    remainder -= carry * capacity_;
    return carry;
  }

  Point at_;
  std::int64_t capacity_, remainder_x_, remainder_y_, sense_ = 1;
  std::int64_t left_x_ = std::numeric_limits<std::int64_t>::max(), left_y_ = left_x_;
  bool is_parallel_;
  Accumulation accumulation_;
};

/// The generator for so many clocks and no counters: where it stands then shows what it drifts by.
class FreeArc {
 public:
  static constexpr std::size_t axes = 2;

  /// Of one coordinate: the remainder of its integrator.
  struct Axis {
    Integrator integrator;
    std::int64_t at = 0;

    /// The integrand has the pulse's sign.
    constexpr std::int8_t step(std::int64_t integrand, Accumulation accumulation) {
      if (accumulation != Accumulation::sign_magnitude) return step_signed(integrand, accumulation);
      if (!integrator.add(absolute(integrand))) return 0;
      at += sign(integrand);
      return sign(integrand);
    }

   private:
    constexpr std::int8_t step_signed(std::int64_t integrand, Accumulation accumulation) {
      const std::int64_t sum = integrator.remainder() + integrand, capacity = integrator.capacity();
      const std::int8_t carry = carry_of(accumulation, sum, capacity);
      integrator = {capacity, sum - carry * capacity};
      at += carry;
      return carry;
    }
  };

  /// From the arc's start on in its direction, clocks ≥ 0; of the options order, preload and the capacity, by default R.
  /// Which coordinate shrinks is told anew in each quadrant; the remainders are loaded once: where they have signs, in the
  /// sense of their first integrands. Preload::minus_one is for magnitudes.
  constexpr FreeArc(const Arc& arc, std::int64_t clocks, CircularDdaOptions options,
                    Accumulation accumulation = Accumulation::sign_magnitude)
      : sense_(static_cast<std::int64_t>(arc.direction)),
        left_(clocks),
        options_(options),
        accumulation_(accumulation) {
    const std::int64_t radius = root(arc.squared_radius(), 0);
    const std::int64_t capacity = options.capacity > 0 ? options.capacity : radius > 0 ? radius : 1;
    const bool x_lags = absolute(arc.start.y) < absolute(arc.start.x);
    x_ = {{capacity, preloaded(options.preload, capacity, x_lags)}, arc.start.x};
    y_ = {{capacity, preloaded(options.preload, capacity, !x_lags)}, arc.start.y};
    if (accumulation != Accumulation::symmetric) return;
    // An integrand that is 0 at the start grows by the other coordinate's first steps.
    const bool x_is_negative = of_x(at()) < 0 || (of_x(at()) == 0 && arc.start.x > 0);
    const bool y_is_negative = of_y(at()) < 0 || (of_y(at()) == 0 && arc.start.y > 0);
    if (x_is_negative) x_.integrator = {capacity, -x_.integrator.remainder()};
    if (y_is_negative) y_.integrator = {capacity, -y_.integrator.remainder()};
  }

  constexpr bool done() const { return left_ == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    --left_;
    const Point old = at();
    if (x_comes_first()) {
      const std::int8_t x = x_.step(of_x(old), accumulation_);
      return {{x, y_.step(of_y(sees_new() ? at() : old), accumulation_)}};
    }
    const std::int8_t y = y_.step(of_y(old), accumulation_);
    return {{x_.step(of_x(at()), accumulation_), y}};
  }

  constexpr Point at() const { return {x_.at, y_.at}; }
  constexpr const Axis& x() const { return x_; }
  constexpr const Axis& y() const { return y_; }
  constexpr std::int64_t left() const { return left_; }  ///< clocks
  constexpr Accumulation accumulation() const { return accumulation_; }
  /// Integrands at a place, with the signs of the pulses.
  constexpr std::int64_t of_x(Point at) const { return -sense_ * at.y; }
  constexpr std::int64_t of_y(Point at) const { return sense_ * at.x; }
  constexpr bool sees_new() const { return options_.order != Order::parallel; }
  constexpr bool x_comes_first() const {
    if (!sees_new() || options_.order == Order::x_first) return true;
    const bool x_shrinks = ((quadrant(at(), static_cast<Direction>(sense_)) & 1) == 0) == (sense_ > 0);
    return (options_.order == Order::shrinking_first) == x_shrinks;
  }

 private:
  Axis x_, y_;
  std::int64_t sense_, left_;
  CircularDdaOptions options_;
  Accumulation accumulation_;
};

}  // namespace leadscrew::pulse
