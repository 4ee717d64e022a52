#pragma once
// The space in which a tolerance is told: all coordinates in millimetres, a degree of a rotary axis counting as the arc
// it sweeps at a radius of 50 mm. The distance is Euclid's.
//
// Under tool centre point control a degree counts as P/E mm, P the tolerance of the tip and E that of the tool's direction:
// what is within P in that space is within both, and each may be used up. The direction turns by no more than the rotary
// axes do together, where one is across the other; else a degree counts as so much more (kinematics::most_turned).

#include <leadscrew/base/axes.hpp>
#include <leadscrew/geometry/point.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <numbers>

namespace leadscrew::toolpath {

inline constexpr double reference_radius = 50;  // mm

struct ToleranceSpace {
  double millimetres_per_degree = reference_radius * std::numbers::pi / 180;

  double millimetres_per_unit(base::Axis axis) const { return base::is_rotary(axis) ? millimetres_per_degree : 1; }
  geometry::Point to_millimetres(geometry::Point p) const {
    for (const base::Axis axis : base::all_axes) p[base::index(axis)] *= millimetres_per_unit(axis);
    return p;
  }
  geometry::Point from_millimetres(geometry::Point p) const {
    for (const base::Axis axis : base::all_axes) p[base::index(axis)] /= millimetres_per_unit(axis);
    return p;
  }
  /// Of the coordinates, in a length.
  geometry::Point weights_of_length() const {
    geometry::Point weights;
    weights.fill(1);
    return to_millimetres(weights);
  }
  /// One of the jet's derivatives, in millimetres.
  geometry::Point derivative(const geometry::PointJet& jet, double numeric::Jet<>::* which) const {
    geometry::Point d;
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = jet[i].*which;
    return to_millimetres(d);
  }
};

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

}  // namespace leadscrew::toolpath
