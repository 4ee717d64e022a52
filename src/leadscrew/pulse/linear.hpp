#pragma once
// Straight lines: the DDA and point comparison for any number of axes, Bresenham's in a plane.

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

/// One axis a clock, the one that is furthest behind; of those that are equally far the first. Ends after Σ |way|
/// clocks.
///
/// In a plane, for the way (a, b) and x and y counted along it, that is the sign of F = |a|·y − |b|·x: above the line
/// F > 0, where x steps; below it y does. Of more axes the one that has most of its way left is found by products.
template <std::size_t axis_count>
class LinearPointComparison {
 public:
  static constexpr std::size_t axes = axis_count;

  /// Way of each axis, signed, |way| ≤ greatest_coordinate.
  constexpr explicit LinearPointComparison(const std::array<std::int64_t, axes>& way) {
    for (std::size_t i = 0; i < axes; ++i) {
      way_[i] = left_[i] = absolute(way[i]);
      sign_[i] = sign(way[i]);
      all_left_ += left_[i];
      whole_[i] = way_[i] > 0 ? way_[i] : 1;  // of no way nothing is left
    }
  }

  constexpr bool done() const { return all_left_ == 0; }

  constexpr Pulse<axes> step() {
    Pulse<axes> pulse;
    if (done()) return pulse;
    const std::size_t last = furthest_behind();
    for (std::size_t i = 0; i < axes; ++i) {
      // A mask, for a branch would go the wrong way.
      const std::int64_t steps = -static_cast<std::int64_t>(i == last);
      left_[i] += steps;
      pulse.step[i] = static_cast<std::int8_t>(sign_[i] & steps);
    }
    if constexpr (axes == 2) f_ += last == 0 ? -way_[1] : way_[0];
    --all_left_;
    return pulse;
  }

  /// F.
  constexpr std::int64_t deviation() const
    requires(axes == 2)
  {
    return f_;
  }
  constexpr std::int64_t left(std::size_t axis) const { return left_[axis]; }

 private:
  constexpr std::size_t furthest_behind() const {
    if constexpr (axes == 2) return f_ < 0 || way_[0] == 0;
    std::size_t last = 0;
    std::int64_t left = left_[0], whole = whole_[0];
    for (std::size_t i = 1; i < axes; ++i) {
      const std::int64_t is_further = (left * whole_[i] - left_[i] * whole) >> 63;
      last = is_further != 0 ? i : last;
      left ^= (left ^ left_[i]) & is_further;
      whole ^= (whole ^ whole_[i]) & is_further;
    }
    return last;
  }

  std::array<std::int64_t, axes> way_{}, whole_{}, left_{};
  std::array<std::int8_t, axes> sign_{};
  std::int64_t all_left_ = 0, f_ = 0;
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
