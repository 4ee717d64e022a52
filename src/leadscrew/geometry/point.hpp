#pragma once
// Points of the space in which curves live: one coordinate for each axis, mm or degrees.

#include <array>
#include <cmath>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/numeric/compensated.hpp>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/jet.hpp>
#include <leadscrew/numeric/pair.hpp>
#include <span>
#include <vector>

namespace leadscrew::geometry {

using Point = base::AxisVector;
/// Of one place, or of two side by side: T is double or numeric::Pair.
template <typename T>
using PointJetOf = std::array<numeric::Jet<3, T>, base::axis_count>;
using PointJet = PointJetOf<double>;
/// First derivatives of X Y Z, U V W or A B C.
using Rates = std::array<double, 3>;
/// X, Y and Z turned and shifted, all other coordinates as they are.
struct RigidMotion {
  std::array<std::array<double, 3>, 3> rotation{};  ///< rows; orthonormal, its determinant is 1
  std::function<Point(const Point&)> place{};       ///< of a point: turned and shifted, rounded once
};
/// Before it is rounded.
using UnroundedPoint = std::array<numeric::Compensated, base::axis_count>;

inline UnroundedPoint unrounded(const Point& point) {
  UnroundedPoint result;
  for (std::size_t i = 0; i < point.size(); ++i) result[i] = point[i];
  return result;
}
inline Point rounded(const UnroundedPoint& point) {
  Point result;
  for (std::size_t i = 0; i < point.size(); ++i) result[i] = point[i].value();
  return result;
}

/// A coordinate of a Point is the sum, one of an UnroundedPoint keeps both.
constexpr void set(double& coordinate, double sum, double error) {
  coordinate = sum + error;
}
constexpr void set(numeric::Compensated& coordinate, double sum, double error) {
  coordinate = {sum, error};
}

/// |q″| of X, Y and Z: where the jet is by the tool tip's path length, the curvature 1/ρ of its path, 1/mm.
template <typename T>
T tip_curvature(const PointJetOf<T>& jet) {
  const T x = jet[0].second, y = jet[1].second, z = jet[2].second;
  return numeric::root(x * x + y * y + z * z);
}

/// A path length in double-double, its greater part split into halves for exact products (Dekker).
struct SplitLength {
  numeric::Split hi;
  double lo = 0;

  explicit SplitLength(numeric::DoubleDouble s) : hi(s.hi), lo(s.lo) {}
};

/// rate · s, the rate in double-double too.
struct Rate {
  numeric::Split hi;
  double lo = 0;

  Rate() = default;
  explicit Rate(numeric::DoubleDouble rate) : hi(rate.hi), lo(rate.lo) {}

  numeric::DoubleDouble times(const SplitLength& s) const {
    const numeric::DoubleDouble product = numeric::two_product(hi, s.hi);
    return {product.hi, product.lo + (hi.value * s.lo + lo * s.hi.value)};
  }
};

/// Straight motion of the coordinates that change: q_i = start_i + rate_i·s, rates in double-double so that the end is
/// met.
class Slopes {
 public:
  struct Coordinate {
    std::size_t coordinate = 0;
    Rate rate;
  };

  Slopes() = default;
  /// length > 0.
  Slopes(const Point& start, const Point& end, double length) {
    for (std::size_t i = 0; i < start.size(); ++i) {
      if (start[i] == end[i]) continue;
      rates_[count_++] = {i, Rate(numeric::two_sum(end[i], -start[i]) / numeric::DoubleDouble(length))};
    }
  }

  /// To start, which `position` holds.
  template <typename T>
  void add(const Point& start, std::array<T, base::axis_count>& position, const SplitLength& s) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t i = rates_[k].coordinate;
      const numeric::DoubleDouble moved = rates_[k].rate.times(s);
      const numeric::DoubleDouble sum = numeric::two_sum(start[i], moved.hi);
      set(position[i], sum.hi, sum.lo + moved.lo);
    }
  }
  void add(PointJet& jet, double s) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t i = rates_[k].coordinate;
      jet[i].value += rates_[k].rate.hi.value * s;
      jet[i].first += rates_[k].rate.hi.value;
    }
  }
  /// As geometry::append_shape() has it.
  void append_shape(std::vector<double>& numbers) const {
    numbers.push_back(static_cast<double>(count_));
    for (const Coordinate& each : coordinates()) {
      numbers.push_back(static_cast<double>(each.coordinate));
      numbers.push_back(each.rate.hi.value);
    }
  }
  /// Rate of one coordinate, per unit of length.
  double rate(std::size_t coordinate) const {
    for (std::size_t k = 0; k < count_; ++k) {
      if (rates_[k].coordinate == coordinate) return rates_[k].rate.hi.value;
    }
    return 0;
  }
  /// Those of three coordinates, from `first` on.
  Rates rates(std::size_t first) const {
    Rates rates{};
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t i = rates_[k].coordinate - first;
      if (i < rates.size()) rates[i] = rates_[k].rate.hi.value;
    }
    return rates;
  }
  /// Those that change, each with its rate ≠ 0.
  std::span<const Coordinate> coordinates() const { return std::span(rates_).first(count_); }

 private:
  std::array<Coordinate, base::axis_count> rates_{};
  std::size_t count_ = 0;
};

}  // namespace leadscrew::geometry
