#pragma once
// Velocity, acceleration and jerk of each axis the machine has: a row an axis, its index the axis'.

#include <array>
#include <cstddef>
#include <leadscrew/constraints/row.hpp>
#include <leadscrew/machine/machine.hpp>
#include <limits>
#include <span>

namespace leadscrew::constraints {

/// One limit for each axis the machine has.
class AxisBounds {
 public:
  AxisBounds(const machine::Machine& machine, double machine::AxisLimits::* limit) {
    for (const base::Axis axis : base::all_axes) {
      if (machine.has(axis)) bounds_[count_++] = {base::index(axis), machine.limits(axis).*limit};
    }
  }

  struct Bound {
    std::size_t axis = 0;
    double limit = 0;  ///< > 0
  };
  std::span<const Bound> all() const { return {bounds_.data(), count_}; }
  /// Infinite for an axis the machine lacks.
  double of(std::size_t axis) const {
    for (const Bound& bound : all()) {
      if (bound.axis == axis) return bound.limit;
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  std::array<Bound, base::axis_count> bounds_{};
  std::size_t count_ = 0;
};

/// |q′|·ṡ ≤ v
class AxisVelocity {
 public:
  using Row = SpeedRow;
  static constexpr bool is_of_axes = true, is_proven = true, is_smooth = true;

  explicit AxisVelocity(const machine::Machine& machine) : bounds_(machine, &machine::AxisLimits::velocity) {}

  double limit(std::size_t axis) const { return bounds_.of(axis); }
  template <typename T, typename Take>
  void rows(const PlaceOf<T>& at, const Take& take) const {
    for (const auto& [axis, limit] : bounds_.all())
      take(axis, SpeedRowOf<T>{at.jet[axis].first, numeric::all<T>(limit)});
  }

 private:
  AxisBounds bounds_;
};

/// |q″x + q′b| ≤ a
class AxisAcceleration {
 public:
  using Row = AccelerationRow;
  static constexpr bool is_of_axes = true, is_proven = true, is_smooth = true;

  explicit AxisAcceleration(const machine::Machine& machine) : bounds_(machine, &machine::AxisLimits::acceleration) {}

  double limit(std::size_t axis) const { return bounds_.of(axis); }
  template <typename T, typename Take>
  void rows(const PlaceOf<T>& at, const Take& take) const {
    for (const auto& [axis, limit] : bounds_.all()) {
      const numeric::Jet<3, T>& q = at.jet[axis];
      take(axis, AccelerationRowOf<T>{q.second, q.first, numeric::all<T>(limit)});
    }
  }

 private:
  AxisBounds bounds_;
};

/// |q‴x + 3q″b + q′c|·√x ≤ j
class AxisJerk {
 public:
  using Row = JerkRow;
  static constexpr bool is_of_axes = true, is_proven = true, is_smooth = true;

  explicit AxisJerk(const machine::Machine& machine) : bounds_(machine, &machine::AxisLimits::jerk) {}

  double limit(std::size_t axis) const { return bounds_.of(axis); }
  template <typename T, typename Take>
  void rows(const PlaceOf<T>& at, const Take& take) const {
    for (const auto& [axis, limit] : bounds_.all()) {
      const numeric::Jet<3, T>& q = at.jet[axis];
      take(axis, JerkRowOf<T>{q.third, 3 * q.second, q.first, numeric::all<T>(limit)});
    }
  }

 private:
  AxisBounds bounds_;
};

}  // namespace leadscrew::constraints
