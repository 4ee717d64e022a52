#pragma once
// The space in which a tolerance is told: all coordinates in millimetres, a degree of a rotary axis counting as the arc
// it sweeps at a radius of 50 mm. The distance is Euclid's.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/geometry/point.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <numbers>

namespace leadscrew::toolpath {

inline constexpr double reference_radius = 50;  // mm

inline double millimetres_per_unit(base::Axis axis) {
  return base::is_rotary(axis) ? reference_radius * std::numbers::pi / 180 : 1;
}

inline geometry::Point to_millimetres(geometry::Point p) {
  for (const base::Axis axis : base::all_axes) p[base::index(axis)] *= millimetres_per_unit(axis);
  return p;
}
inline geometry::Point from_millimetres(geometry::Point p) {
  for (const base::Axis axis : base::all_axes) p[base::index(axis)] /= millimetres_per_unit(axis);
  return p;
}

/// Of the coordinates, in a length.
inline geometry::Point weights_of_length() {
  geometry::Point weights;
  weights.fill(1);
  return to_millimetres(weights);
}

using numeric::difference;
using numeric::distance;
using numeric::distance_to_segment;
using numeric::dot;
using numeric::norm;
using numeric::sum;

/// |t⁺ − t⁻| = 2 sin(θ/2) of two directions; 2 if one is none.
inline double turn_between(const geometry::Point& in, const geometry::Point& out) {
  const double in_length = norm(in), out_length = norm(out);
  if (!(in_length > 0) || !(out_length > 0)) return 2;
  geometry::Point apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = out[i] / out_length - in[i] / in_length;
  return norm(apart);
}

/// One of the jet's derivatives, in millimetres.
inline geometry::Point derivative(const geometry::PointJet& jet, double numeric::Jet<>::* which) {
  geometry::Point d;
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = jet[i].*which;
  return to_millimetres(d);
}

}  // namespace leadscrew::toolpath
