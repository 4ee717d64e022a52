#pragma once
// Points of the space in which curves live: one coordinate for each axis, mm or degrees.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/jet.hpp>

namespace leadscrew::geometry {

using Point = base::AxisVector;
using PointJet = std::array<numeric::Jet, base::axis_count>;

/// Straight motion of the coordinates that change: q_i = start_i + rate_i·s, rates in double-double so that the end is
/// met.
class Slopes {
 public:
  Slopes() = default;
  /// length > 0.
  Slopes(const Point& start, const Point& end, double length) {
    for (std::size_t i = 0; i < start.size(); ++i) {
      if (start[i] == end[i]) continue;
      rates_[count_++] = {i, numeric::two_sum(end[i], -start[i]) / numeric::DoubleDouble(length)};
    }
  }

  void add(Point& position, numeric::DoubleDouble s) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const auto& [i, rate] = rates_[k];
      position[i] = (rate * s + position[i]).value();
    }
  }
  void add(PointJet& jet, double s) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const auto& [i, rate] = rates_[k];
      jet[i].value += rate.hi * s;
      jet[i].first += rate.hi;
    }
  }
  /// Rate of one coordinate, per unit of length.
  double rate(std::size_t coordinate) const {
    for (std::size_t k = 0; k < count_; ++k) {
      if (rates_[k].coordinate == coordinate) return rates_[k].rate.hi;
    }
    return 0;
  }

 private:
  struct Rate {
    std::size_t coordinate = 0;
    numeric::DoubleDouble rate;
  };
  std::array<Rate, base::axis_count> rates_{};
  std::size_t count_ = 0;
};

}  // namespace leadscrew::geometry
