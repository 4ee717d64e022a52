#pragma once
// Space as the referee measures it: one coordinate for each axis the machine has, all in millimetres. A degree of a
// rotary axis counts as the arc it sweeps at a radius of 50 mm; under tool centre point control with P of the tip and E of
// the tool's direction, as P/E mm, so that both tolerances are as far (space.hpp).

#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/machine/machine.hpp>
#include <numbers>

namespace leadscrew::referee {

inline constexpr double reference_radius = 50;  // mm
inline constexpr double millimetres_per_degree = reference_radius * std::numbers::pi / 180;

/// A deviation below this is not held against a trace, mm.
inline constexpr double nanometre = 1e-6;

/// A point or a direction in the metric, mm; coordinates past the number of axes are 0.
using Point = std::array<double, base::axis_count>;

class Metric {
 public:
  explicit Metric(const machine::Machine& machine, double per_degree = millimetres_per_degree);

  /// What a degree counts, mm; > 0.
  double per_degree() const { return per_degree_; }
  std::size_t dimensions() const { return dimensions_; }
  base::Axis axis(std::size_t coordinate) const { return axes_[coordinate]; }
  /// Which coordinate an axis is; dimensions() if the machine lacks it.
  std::size_t coordinate(base::Axis axis) const { return coordinate_[base::index(axis)]; }

  Point point(const base::AxisVector& position) const {
    Point result{};
    for (std::size_t i = 0; i < dimensions_; ++i) result[i] = position[base::index(axes_[i])] * scale_[i];
    return result;
  }

  /// The way back: axes that the machine lacks are at 0.
  base::AxisVector position(const Point& point) const {
    base::AxisVector result{};
    for (std::size_t i = 0; i < dimensions_; ++i) result[base::index(axes_[i])] = point[i] / scale_[i];
    return result;
  }

  /// Limits along a coordinate, mm/s² and mm/s³.
  double acceleration(std::size_t coordinate) const { return acceleration_[coordinate]; }
  double jerk(std::size_t coordinate) const { return jerk_[coordinate]; }

  double dot(const Point& a, const Point& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < dimensions_; ++i) sum += a[i] * b[i];
    return sum;
  }
  double squared_distance(const Point& a, const Point& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < dimensions_; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
  }
  double distance(const Point& a, const Point& b) const { return std::sqrt(squared_distance(a, b)); }

 private:
  double per_degree_;
  std::size_t dimensions_ = 0;
  std::array<base::Axis, base::axis_count> axes_{};
  std::array<double, base::axis_count> scale_{};
  std::array<std::size_t, base::axis_count> coordinate_{};
  std::array<double, base::axis_count> acceleration_{}, jerk_{};
};

/// What the machine went along between two words, as far as the words tell: the straight line between them.
struct Chord {
  Point from{};
  Point along{};              ///< to − from
  double squared_length = 0;  ///< mm²
};

Chord chord_between(const Metric& metric, const Point& from, const Point& to);

inline double distance_to_chord(const Metric& metric, const Chord& chord, const Point& point) {
  double along = 0;
  if (chord.squared_length > 0) {
    for (std::size_t i = 0; i < metric.dimensions(); ++i) along += (point[i] - chord.from[i]) * chord.along[i];
    along = along <= 0 ? 0 : along >= chord.squared_length ? 1 : along / chord.squared_length;
  }
  double sum = 0;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    const double offset = point[i] - chord.from[i] - along * chord.along[i];
    sum += offset * offset;
  }
  return std::sqrt(sum);
}

}  // namespace leadscrew::referee
