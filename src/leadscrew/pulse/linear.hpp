#pragma once
// Straight lines: the DDA and point comparison for any number of axes, Bresenham's in a plane.

#include <leadscrew/pulse/integrator.hpp>

namespace leadscrew::pulse {

/// An integrator an axis, whose integrand is the axis' displacement, and a counter of the steps that are left.
template <std::size_t axis_count, typename Register = std::int64_t>
class LinearDda {
 public:
  static constexpr std::size_t axes = axis_count;

  /// Displacement of each axis, signed, |delta| ≤ greatest_coordinate_of<Register>. capacity q ≥ the largest of them: 2ⁿ for n-bit
  /// registers, where a line takes 2ⁿ clocks; or its length rounded up, where feed is the rate of the clock. The line
  /// ends at its end whatever the preload.
  constexpr LinearDda(const std::array<Register, axes>& delta, Register capacity, Preload preload)
      : LinearDda(delta, capacity, Register{0}) {
    Register longest = 0;
    for (const Register integrand : integrand_) longest = integrand > longest ? integrand : longest;
    for (std::size_t i = 0; i < axes; ++i)
      integrator_[i] = {capacity, preloaded(preload, capacity, integrand_[i] < longest)};
  }
  constexpr LinearDda(const std::array<Register, axes>& delta, Register capacity, Register preload) {
    for (std::size_t i = 0; i < axes; ++i) {
      integrand_[i] = left_[i] = absolute(delta[i]);
      sign_[i] = sign(delta[i]);
      integrator_[i] = {capacity, preload};
    }
  }

  constexpr bool done() const {
    Register left = 0;
    for (const Register of_axis : left_) left |= of_axis;
    return left == 0;
  }

  constexpr Pulse<axes> step() {
    Pulse<axes> pulse;
    for (std::size_t i = 0; i < axes; ++i) {
      const bool steps = left_[i] > 0 && integrator_[i].add(integrand_[i]);
      left_[i] = static_cast<Register>(left_[i] - steps);
      pulse.step[i] = steps ? sign_[i] : std::int8_t{0};
    }
    return pulse;
  }

  constexpr Register integrand(std::size_t axis) const { return integrand_[axis]; }
  constexpr Register left(std::size_t axis) const { return left_[axis]; }
  constexpr const BasicIntegrator<Register>& integrator(std::size_t axis) const { return integrator_[axis]; }

 private:
  std::array<Register, axes> integrand_{}, left_{};
  std::array<std::int8_t, axes> sign_{};
  std::array<BasicIntegrator<Register>, axes> integrator_{};
};

/// The smallest q that a line of this squared length may have: its length, rounded up.
constexpr std::int64_t capacity_for(std::int64_t squared_length) {
  const std::int64_t nearest = root(squared_length, 0);
  const std::int64_t capacity = nearest * nearest < squared_length ? nearest + 1 : nearest;
  return capacity > 0 ? capacity : 1;
}

/// One axis a clock, the one that is furthest behind; of those that are equally far the first. Ends after Σ |delta|
/// clocks.
///
/// Each axis keeps what share of its distance it has made, ⌊2⁶² k/a⌋ after k of a steps, by additions. For a ≤ 2³⁰ two
/// such shares are equal or at least 2⁻⁶⁰ apart, so that these order them.
template <std::size_t axis_count, typename Register = std::int64_t>
class LinearPointComparison {
  static_assert(sizeof(Register) == 8, "shares of a distance take 62 bits; in a plane any registers do");

 public:
  static constexpr std::size_t axes = axis_count;

  /// Displacement of each axis, signed, |delta| ≤ greatest_coordinate.
  constexpr explicit LinearPointComparison(const std::array<std::int64_t, axes>& delta) {
    for (std::size_t i = 0; i < axes; ++i) {
      const std::int64_t whole = absolute(delta[i]);
      sign_[i] = sign(delta[i]);
      all_left_ += whole;
      if (whole > 0) made_[i] = {0, all_made / whole, 0, all_made % whole, whole, whole};
    }
  }

  constexpr bool done() const { return all_left_ == 0; }

  /// Of one axis.
  struct OneStep {
    std::size_t axis = 0;
    std::int8_t step = 0;
  };
  /// One clock; not when done.
  constexpr OneStep step_one() {
    const std::size_t last = furthest_behind();
    made_[last].add();
    --all_left_;
    return {last, sign_[last]};
  }

  constexpr Pulse<axes> step() {
    Pulse<axes> pulse;
    if (done()) return pulse;
    const OneStep one = step_one();
    pulse.step[one.axis] = one.step;
    return pulse;
  }

  constexpr std::int64_t left(std::size_t axis) const { return made_[axis].left; }

 private:
  static constexpr std::int64_t all_made = std::int64_t{1} << 62;

  /// Of an axis' distance.
  struct Made {
    std::int64_t share = all_made;       ///< rounded down
    std::int64_t by = 0;                 ///< what a step adds to it, rounded down
    std::int64_t rest = 0, rest_by = 0;  ///< what that leaves of 2⁶² k, and of 2⁶²
    std::int64_t whole = 0, left = 0;    ///< steps

    constexpr void add() {
      rest += rest_by;
      const std::int64_t carries = ~((rest - whole) >> 63);  // a mask
      rest -= whole & carries;
      share += by - carries;
      --left;
    }
  };

  constexpr std::size_t furthest_behind() const {
    std::size_t last = 0;
    std::int64_t least = made_[0].share;
    for (std::size_t i = 1; i < axes; ++i) {
      const std::int64_t share = made_[i].share;
      last = share < least ? i : last;
      least = share < least ? share : least;
    }
    return last;
  }

  std::array<Made, axes> made_{};
  std::array<std::int8_t, axes> sign_{};
  std::int64_t all_left_ = 0;
};

/// In a plane, for the displacement (a, b) and x and y counted along it, that is the sign of F = |a|·y − |b|·x: above
/// the line F > 0, where x steps; below it y does.
template <typename Register>
class LinearPointComparison<2, Register> {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit LinearPointComparison(const std::array<Register, 2>& delta)
      : distance_{absolute(delta[0]), absolute(delta[1])}, left_(distance_), sign_{sign(delta[0]), sign(delta[1])} {}

  constexpr bool done() const { return (left_[0] | left_[1]) == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    // A mask, for a branch would be mispredicted.
    const auto y_steps = static_cast<Register>(-static_cast<Register>(f_ < 0 || distance_[0] == 0));
    left_[0] = static_cast<Register>(left_[0] + ~y_steps);
    left_[1] = static_cast<Register>(left_[1] + y_steps);
    f_ = static_cast<Register>(f_ + (distance_[0] & y_steps) - (distance_[1] & ~y_steps));
    return {{static_cast<std::int8_t>(sign_[0] & ~y_steps), static_cast<std::int8_t>(sign_[1] & y_steps)}};
  }

  constexpr Register deviation() const { return f_; }  ///< F
  constexpr Register left(std::size_t axis) const { return left_[axis]; }

 private:
  std::array<Register, 2> distance_, left_;
  std::array<std::int8_t, 2> sign_;
  Register f_ = 0;
};

/// Bresenham's line: the longer axis steps at every clock, the other where the line is half a BLU away; so do the
/// methods of least error, for on a line the nearest of three points is one of two. Ends after max(|a|, |b|) clocks.
template <typename Register>
class BasicLinearBresenham {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit BasicLinearBresenham(BasicPoint<Register> delta)
      : is_steep_(absolute(delta.y) > absolute(delta.x)),
        long_(is_steep_ ? absolute(delta.y) : absolute(delta.x)),
        short_(is_steep_ ? absolute(delta.x) : absolute(delta.y)),
        left_(long_),
        deviation_(static_cast<Register>(-long_)),
        sign_x_(sign(delta.x)),
        sign_y_(sign(delta.y)) {}

  constexpr bool done() const { return left_ == 0; }

  constexpr Pulse<2> step() {
    if (done()) return {};
    --left_;
    deviation_ = static_cast<Register>(deviation_ + 2 * short_);
    const bool both = deviation_ > 0;
    if (both) deviation_ = static_cast<Register>(deviation_ - 2 * long_);
    return {{both || !is_steep_ ? sign_x_ : std::int8_t{0}, both || is_steep_ ? sign_y_ : std::int8_t{0}}};
  }

  /// Twice the distance from the line along the shorter axis, times the line's length along the longer axis, less that
  /// length.
  constexpr Register deviation() const { return deviation_; }
  constexpr Register left() const { return left_; }  ///< steps of the longer axis

 private:
  bool is_steep_;
  Register long_, short_, left_, deviation_;
  std::int8_t sign_x_, sign_y_;
};
using LinearBresenham = BasicLinearBresenham<std::int64_t>;

}  // namespace leadscrew::pulse
