#pragma once
// The circle generator bare: two integrators that feed one another, both coordinates signed, without quadrants,
// counters or an end. What it drifts by is what the methods of interpolation are compared for.

#include <leadscrew/pulse/circular_dda.hpp>

namespace leadscrew::pulse {

/// How a remainder takes a negative integrand; the papers leave it open.
enum class Accumulation : std::uint8_t {
  sign_magnitude,  ///< the magnitude is added, the pulse gets the sign: Koren's figure of 10 001 BLU
  floor,           ///< the remainder stays in 0 … q − 1 and may borrow: two's complement
};

/// Counterclockwise.
class FreeCircle {
 public:
  static constexpr std::size_t axes = 2;

  /// capacity q > 0, ≥ |coordinates|; 0 ≤ preload < q, or −1, which with magnitudes is 0 where only r > q overflows.
  /// Orders: x_first and parallel.
  constexpr FreeCircle(Point start, std::int64_t capacity, std::int64_t preload, Order order, Accumulation accumulation)
      : at_(start),
        capacity_(capacity),
        remainder_x_(preload),
        remainder_y_(preload),
        is_parallel_(order == Order::parallel),
        accumulation_(accumulation) {}

  constexpr bool done() const { return false; }

  constexpr Pulse<2> step() {
    const std::int64_t old_x = at_.x;
    const std::int8_t x = overflow(remainder_x_, -at_.y);
    at_.x += x;
    const std::int8_t y = overflow(remainder_y_, is_parallel_ ? old_x : at_.x);
    at_.y += y;
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
    const auto carry = static_cast<std::int8_t>((remainder >= capacity_) - (remainder < 0));
    remainder -= carry * capacity_;
    return carry;
  }

  Point at_;
  std::int64_t capacity_, remainder_x_, remainder_y_;
  bool is_parallel_;
  Accumulation accumulation_;
};

}  // namespace leadscrew::pulse
