#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/cutter.hpp>
#include <limits>

namespace leadscrew::surfaces {

Tensor curvature_of(const Cutter& cutter, const Vector& n, const Vector& axis, const TangentPair& tangents) {
  const double R = cutter.radius, r = cutter.corner_radius;
  if (cutter.is_ball()) return {1 / R, 0, 1 / R};
  const Vector cross = kinematics::cross_product(axis, n);
  const double sine = numeric::norm(cross);
  if (sine * sine <= least_lean) return {0, 0, 0};
  const double in_plane = r > 0 ? std::min(1 / r, greatest_curvature) : greatest_curvature;
  const double across = sine / ((R - r) + r * sine);
  const double cf = numeric::dot(cross, tangents.f) / sine, cb = numeric::dot(cross, tangents.b) / sine;
  // c = cf f + cb b, and m is perpendicular to it
  return {across * cf * cf + in_plane * cb * cb, (across - in_plane) * cf * cb, across * cb * cb + in_plane * cf * cf};
}

double local_clearance(const Tensor& tool, const Tensor& surface) {
  return (tool - surface).principal()[1];
}

/// A flat tool's edge has no thickness: written with K_ff K_bb − K_fb², in which what is infinite cancels.
double effective_radius(const Tensor& tool) {
  const double determinant = tool.ff * tool.bb - tool.fb * tool.fb;
  if (!(determinant > 0)) return std::numeric_limits<double>::infinity();
  return tool.ff / determinant;
}

}  // namespace leadscrew::surfaces
