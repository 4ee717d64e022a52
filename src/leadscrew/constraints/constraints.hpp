#pragma once
// constraints: the limits that motion along a path keeps. One kind of limit is one class, which gives its rows
// (row.hpp) at a place of the path; whoever plans, proves or bounds motion asks this list and names no kind:
//
//     feed.hpp          ṡ ≤ F, programmed
//     axis_limits.hpp   |q̇| ≤ v, |q̈| ≤ a, |q⃛| ≤ j of every axis
//     chord_error.hpp   ε of the chord between two words
//
// A kind is a class that is made of a machine and has
//
//     Row                the shape of its rows
//     is_of_axes         a row for each axis, its index the axis'; otherwise at most one row, of index 0
//     is_proven          does a motion that passes it between knots have to be planned again? Then it counts in what
//                        bounds time, too
//     is_smooth          does its ratio run smoothly along a piece, so that a parabola through samples finds a peak?
//     rows(place, take)  calls take(index, row); rows of one index are the same limit all along a path, and are given
//                        at every place, be it that they bound nothing there; if it is proven, also of two places side
//                        by side
//     limit(axis)        if it is of axes: that axis', infinite without one
//     name               if it is not: as reports name it
//
// and stands in Kinds below. How the path is travelled is the caller's; nothing here knows of solvers.

#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/constraints/axis_limits.hpp>
#include <leadscrew/constraints/chord_error.hpp>
#include <leadscrew/constraints/feed.hpp>
#include <leadscrew/constraints/row.hpp>
#include <leadscrew/machine/derivatives.hpp>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace leadscrew::constraints {

/// Every kind of limit, in the order in which rows are given.
using Kinds = std::tuple<ProgrammedFeed, AxisVelocity, AxisAcceleration, AxisJerk, ChordError>;

inline constexpr std::size_t kind_count = std::tuple_size_v<Kinds>;
template <std::size_t kind>
using KindAt = std::tuple_element_t<kind, Kinds>;

/// Calls visit(std::integral_constant<std::size_t, kind>) for every kind, in order.
template <typename Visit>
constexpr void for_each_kind(const Visit& visit) {
  [&]<std::size_t... kind>(std::index_sequence<kind...>) {
    (visit(std::integral_constant<std::size_t, kind>{}), ...);
  }(std::make_index_sequence<kind_count>{});
}

/// Do rows of this shape bound speed alone?
template <typename Row>
inline constexpr bool is_speed = std::is_same_v<Row, SpeedRow> || std::is_same_v<Row, SquareRow>;
/// The member of Derivatives that rows of this shape bound.
template <typename Row>
inline constexpr double machine::Derivatives::* derivative_of =
    is_speed<Row>                          ? &machine::Derivatives::velocity
    : std::is_same_v<Row, AccelerationRow> ? &machine::Derivatives::acceleration
                                           : &machine::Derivatives::jerk;
/// How many rows a kind gives at most.
template <std::size_t kind>
inline constexpr std::size_t row_count = KindAt<kind>::is_of_axes ? base::axis_count : 1;

/// The largest value over limit of every proven limit.
class LimitRatios {
 public:
  /// Of an axis, by derivative.
  machine::Derivatives of_axis(base::Axis axis) const;
  /// The largest of all that bounds speed, acceleration and jerk.
  machine::Derivatives by_derivative() const;
  /// Of the limits that are not an axis', as they are named in reports; 0: nothing came near it.
  struct Named {
    std::string_view name;
    double ratio = 0;
  };
  static constexpr std::size_t path_limits = [] {
    std::size_t count = 0;
    for_each_kind([&](auto kind) { count += KindAt<kind>::is_proven && !KindAt<kind>::is_of_axes; });
    return count;
  }();
  std::array<Named, path_limits> of_path() const;
  /// The largest of all.
  double greatest() const;

  friend bool operator==(const LimitRatios&, const LimitRatios&) = default;

  /// One number for each row of the proven kinds.
  static constexpr std::size_t size = [] {
    std::size_t count = 0;
    for_each_kind([&](auto kind) { count += KindAt<kind>::is_proven ? row_count<kind> : 0; });
    return count;
  }();
  /// Where the rows of a kind begin.
  template <std::size_t kind>
  static constexpr std::size_t offset = [] {
    std::size_t count = 0;
    for_each_kind([&](auto before) {
      if (before < kind) count += KindAt<before>::is_proven ? row_count<before> : 0;
    });
    return count;
  }();
  double operator[](std::size_t row) const { return values_[row]; }
  double& operator[](std::size_t row) { return values_[row]; }

 private:
  std::array<double, size> values_{};
};

/// The rows at one place that bound acceleration and jerk, two and two: those of an axis together, where one of the two
/// is missing a row that bounds nothing. A pair of one index is the same two limits all along a path.
struct RowPairs {
  struct Pair {
    AccelerationRow acceleration;
    JerkRow jerk;

    bool bounds() const { return acceleration.bounds() || jerk.bounds(); }
  };
  template <typename Row, std::size_t kind>
  static constexpr std::size_t rows_before = [] {
    std::size_t count = 0;
    for_each_kind([&](auto before) {
      if (before < kind && std::is_same_v<typename KindAt<before>::Row, Row>) count += row_count<before>;
    });
    return count;
  }();
  static constexpr std::size_t size =
      std::max(rows_before<AccelerationRow, kind_count>, rows_before<JerkRow, kind_count>);

  std::array<Pair, size> pairs{};
};

/// Every limit of a machine, by value.
class Constraints {
 public:
  Constraints(const machine::Machine& machine)  // NOLINT: a machine stands for its limits
      : Constraints(machine, std::make_index_sequence<kind_count>{}) {}

  /// Greatest x = ṡ² by what bounds speed; infinite where nothing does.
  double greatest_square(const Place& at) const;
  /// The same without what is not proven, as a speed ṡ; rows whose rate is no more than `least_rate` do not count.
  double greatest_speed(const Place& at, double least_rate = 0) const;
  /// What the tangent alone allows: |q′|·ṡ ≤ v, |q′|·|s̈| ≤ a, |q′|·|s⃛| ≤ j, as if the path went straight on; infinite
  /// where nothing bounds. skip: axes that are left out.
  machine::Derivatives along_tangent(const Place& at, base::AxisSet skip = {}) const;
  /// Greatest x that the curve alone allows where speed does not change: |q″x| ≤ a, |q‴|x√x ≤ j.
  double greatest_square_by_curve(const Place& at) const;
  /// Of one axis; infinite for an axis the machine lacks.
  machine::Derivatives of_axis(base::Axis axis) const;

  RowPairs row_pairs(const Place& at) const {
    RowPairs result;
    each_row(at, [&](auto kind, std::size_t index, const auto& row) {
      using Row = std::remove_cvref_t<decltype(row)>;
      if constexpr (std::is_same_v<Row, AccelerationRow>)
        result.pairs[RowPairs::rows_before<Row, kind> + index].acceleration = row;
      if constexpr (std::is_same_v<Row, JerkRow>) result.pairs[RowPairs::rows_before<Row, kind> + index].jerk = row;
    });
    return result;
  }

  /// Value over limit of every proven limit at one instant.
  LimitRatios ratios(const Place& at, const PathRates& rates) const {
    LimitRatios result;
    each_row(at, [&](auto kind, std::size_t index, const auto& row) {
      if constexpr (KindAt<kind>::is_proven) result[LimitRatios::offset<kind> + index] = row.ratio(rates);
    });
    return result;
  }
  /// Raises `ratios` to these where they are larger.
  void raise(const Place& at, const PathRates& rates, LimitRatios& ratios) const {
    each_row(at, [&](auto kind, std::size_t index, const auto& row) {
      if constexpr (KindAt<kind>::is_proven) {
        double& greatest = ratios[LimitRatios::offset<kind> + index];
        greatest = std::max(greatest, row.ratio(rates));
      }
    });
  }

  /// Calls visit(std::integral_constant<std::size_t, kind>, index, row) for every row of the proven kinds, of two places
  /// side by side.
  template <typename Visit>
  void each_proven_row(const PlaceOf<numeric::Pair>& at, const Visit& visit) const {
    for_each_kind([&](auto kind) {
      if constexpr (KindAt<kind>::is_proven)
        std::get<kind>(kinds_).rows(at, [&](std::size_t index, const auto& row) { visit(kind, index, row); });
    });
  }

  /// Calls visit(std::integral_constant<std::size_t, kind>, index, row) for every row there.
  template <typename Visit>
  void each_row(const Place& at, const Visit& visit) const {
    for_each_kind([&](auto kind) {
      std::get<kind>(kinds_).rows(at, [&](std::size_t index, const auto& row) { visit(kind, index, row); });
    });
  }

 private:
  template <std::size_t... kind>
  Constraints(const machine::Machine& machine, std::index_sequence<kind...>) : kinds_(KindAt<kind>(machine)...) {}

  Kinds kinds_;
};

}  // namespace leadscrew::constraints
