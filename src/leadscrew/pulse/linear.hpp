#pragma once
// Straight lines: the DDA for any number of axes; point comparison and Bresenham's in a plane.

#include <leadscrew/pulse/integrator.hpp>

namespace leadscrew::pulse {

/// An integrator an axis, whose integrand is the axis' way, and a counter of the steps that are left.
template <std::size_t axis_count>
class LinearDda {
 public:
  static constexpr std::size_t axes = axis_count;

  /// Way of each axis, signed, |way| ≤ greatest_coordinate. capacity q ≥ the largest of them: 2ⁿ for n-bit registers,
  /// where a line takes 2ⁿ clocks; or its length rounded up, where feed is the rate of the clock. The line ends at its
  /// end whatever the preload.
  constexpr LinearDda(const std::array<std::int64_t, axes>& way, std::int64_t capacity, Preload preload)
      : LinearDda(way, capacity, 0) {
    std::int64_t longest = 0;
    for (const std::int64_t integrand : integrand_) longest = integrand > longest ? integrand : longest;
    for (std::size_t i = 0; i < axes; ++i)
      integrator_[i] = {capacity, preloaded(preload, capacity, integrand_[i] < longest)};
  }
  constexpr LinearDda(const std::array<std::int64_t, axes>& way, std::int64_t capacity, std::int64_t preload) {
    for (std::size_t i = 0; i < axes; ++i) {
      integrand_[i] = left_[i] = absolute(way[i]);
      sign_[i] = sign(way[i]);
      integrator_[i] = {capacity, preload};
    }
  }

  constexpr bool done() const {
    std::int64_t left = 0;
    for (const std::int64_t of_axis : left_) left |= of_axis;
    return left == 0;
  }

  constexpr Pulse<axes> step() {
    Pulse<axes> pulse;
    for (std::size_t i = 0; i < axes; ++i) {
      const bool steps = left_[i] > 0 && integrator_[i].add(integrand_[i]);
      left_[i] -= steps;
      pulse.step[i] = steps ? sign_[i] : std::int8_t{0};
    }
    return pulse;
  }

  constexpr std::int64_t integrand(std::size_t axis) const { return integrand_[axis]; }
  constexpr std::int64_t left(std::size_t axis) const { return left_[axis]; }
  constexpr const Integrator& integrator(std::size_t axis) const { return integrator_[axis]; }

 private:
  std::array<std::int64_t, axes> integrand_{}, left_{};
  std::array<std::int8_t, axes> sign_{};
  std::array<Integrator, axes> integrator_{};
};

/// The smallest q that a line of this squared length may have: its length, rounded up.
constexpr std::int64_t capacity_for(std::int64_t squared_length) {
  const std::int64_t nearest = root(squared_length, 0);
  const std::int64_t capacity = nearest * nearest < squared_length ? nearest + 1 : nearest;
  return capacity > 0 ? capacity : 1;
}

/// F = |a|·y − |b|·x beside the line to (a, b), x and y counted along it: above it F > 0, where x steps; below it y
/// does. On it, x steps, so that a line along an axis needs no exception. One axis a clock; ends after |a| + |b|
/// clocks.
class LinearPointComparison {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit LinearPointComparison(Point way)
      : a_(absolute(way.x)),
        b_(absolute(way.y)),
        left_x_(a_),
        left_y_(b_),
        sign_x_(sign(way.x)),
        sign_y_(sign(way.y)) {}

  constexpr bool done() const { return left_x_ == 0 && left_y_ == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    const bool along_x = left_x_ > 0 && (deviation_ >= 0 || left_y_ == 0);
    deviation_ += along_x ? -b_ : a_;
    left_x_ -= along_x;
    left_y_ -= !along_x;
    return along_x ? Pulse<2>{{sign_x_, 0}} : Pulse<2>{{0, sign_y_}};
  }

  constexpr std::int64_t deviation() const { return deviation_; }  ///< F
  constexpr std::int64_t left_x() const { return left_x_; }
  constexpr std::int64_t left_y() const { return left_y_; }

 private:
  std::int64_t a_, b_, left_x_, left_y_, deviation_ = 0;
  std::int8_t sign_x_, sign_y_;
};

/// Bresenham's line: the longer axis steps at every clock, the other where the line is half a BLU away; so do the
/// methods of least error, for on a line the nearest of three points is one of two. Ends after max(|a|, |b|) clocks.
class LinearBresenham {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit LinearBresenham(Point way)
      : is_steep_(absolute(way.y) > absolute(way.x)),
        long_(is_steep_ ? absolute(way.y) : absolute(way.x)),
        short_(is_steep_ ? absolute(way.x) : absolute(way.y)),
        left_(long_),
        deviation_(-long_),
        sign_x_(sign(way.x)),
        sign_y_(sign(way.y)) {}

  constexpr bool done() const { return left_ == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    --left_;
    deviation_ += 2 * short_;
    const bool both = deviation_ > 0;
    deviation_ -= both ? 2 * long_ : 0;
    return {{both || !is_steep_ ? sign_x_ : std::int8_t{0}, both || is_steep_ ? sign_y_ : std::int8_t{0}}};
  }

  /// Twice the distance from the line along the shorter axis, times the longer way, less that way.
  constexpr std::int64_t deviation() const { return deviation_; }
  constexpr std::int64_t left() const { return left_; }  ///< steps of the longer axis

 private:
  bool is_steep_;
  std::int64_t long_, short_, left_, deviation_;
  std::int8_t sign_x_, sign_y_;
};

}  // namespace leadscrew::pulse
