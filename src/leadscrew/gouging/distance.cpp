#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/distance.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::gouging {

namespace {

using kinematics::cross_product;
using numeric::difference;
using numeric::dot;
using numeric::sum;

constexpr double distance_resolution = 1e-10;  // mm
/// |m_z| of a unit normal below which a facet is taken as upright: g does not rise with z, so that an edge has its least value.
constexpr double least_rise = 1e-9;
/// Height over length below which a facet is taken as a line.
constexpr double least_height = 1e-9;
constexpr int most_edge_steps = 64;

/// g − r and its slope at a place.
struct Slope {
  double value = 0;
  Vector gradient{};
};

Slope slope_at(const Part& part, const Vector& q) {
  const double rho = std::hypot(q[0], q[1]);
  const SignedDistance at = signed_distance(part, rho, q[2]);
  if (!(rho > 0)) return {at.value, {0, 0, at.by_z}};
  return {at.value, {at.by_rho * q[0] / rho, at.by_rho * q[1] / rho, at.by_z}};
}

void take_nearer(Nearest& best, double distance, const Vector& place) {
  if (distance < best.distance) best = {distance, place};
}

/// The least value along an edge: between two places where it falls and rises, the tangents at both bound it from below. The
/// next place is where they meet, which is the answer at a bend of g, or where the slope would vanish if it were linear.
void test_edge(const Part& part, const Vector& from, const Vector& to, Nearest& best) {
  const Vector along = difference(to, from);
  double low = 0, high = 1;
  const Slope at_low = slope_at(part, from), at_high = slope_at(part, to);
  take_nearer(best, at_low.value, from);
  take_nearer(best, at_high.value, to);
  double fall = dot(at_low.gradient, along), rise = dot(at_high.gradient, along);
  if (fall >= 0 || rise <= 0) return;
  double value_low = at_low.value, value_high = at_high.value;
  for (int step = 0; step < most_edge_steps; ++step) {
    const double width = high - low;
    const double meeting = (value_high - value_low - rise * width) / (fall - rise);  // from low
    const double bound = value_low + fall * meeting;
    if (bound >= best.distance - distance_resolution) return;
    double share = step % 2 == 0 ? -fall / (rise - fall) : meeting / width;
    share = std::clamp(share, 0.01, 0.99);
    const double t = low + share * width;
    const Vector place = sum(from, t, along);
    const Slope at = slope_at(part, place);
    take_nearer(best, at.value, place);
    const double slope = dot(at.gradient, along);
    if (slope == 0) return;
    if (slope < 0) {
      low = t, value_low = at.value, fall = slope;
    } else {
      high = t, value_high = at.value, rise = slope;
    }
  }
}

/// Where a plane m·q = c, m_z > 0, comes nearest to the part.
Nearest nearest_of_plane(const Part& part, const Vector& m, double c) {
  const double a = part.radius - part.corner, b = part.bottom + part.corner;
  const double across = std::hypot(m[0], m[1]);
  const Vector uphill = across > 0 ? Vector{-m[0] / across, -m[1] / across, 0} : Vector{1, 0, 0};
  const double outside = m[2] * b - across * a - c;
  if (outside >= 0) {
    // The core's lowest place along m, and from there straight to the plane
    const Vector lowest = {a * uphill[0], a * uphill[1], b};
    return {outside - part.corner, sum(lowest, -outside, m)};
  }
  // The plane cuts the core: at the distance x uphill from the axis it is at the height h + s x above b; as deep as far inside
  // both from the side, a − x, and from below.
  const double h = c / m[2] - b, s = across / m[2];
  const double x = h >= a ? 0 : std::clamp((a - h) / (1 + s), 0.0, a);
  const double z = h >= a ? c / m[2] : b + a - x;
  return {x - a - part.corner, {x * uphill[0], x * uphill[1], z}};
}

Vector normal_of(std::span<const Vector> polygon) {
  Vector normal{};
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vector cross = cross_product(difference(polygon[k - 1], polygon[0]), difference(polygon[k], polygon[0]));
    normal = sum(normal, 1, cross);
  }
  return normal;
}

double longest_edge_squared(std::span<const Vector> polygon) {
  double longest = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector edge = difference(polygon[(k + 1) % polygon.size()], polygon[k]);
    longest = std::max(longest, dot(edge, edge));
  }
  return longest;
}

}  // namespace

SignedDistance signed_distance(const Part& part, double rho, double z) {
  const double side = rho - (part.radius - part.corner), below = part.bottom + part.corner - z;
  if (side > 0 && below > 0) {
    const double distance = std::sqrt(side * side + below * below);
    return {distance - part.corner, side / distance, -below / distance};
  }
  if (side >= below) return {side - part.corner, 1, 0};
  return {below - part.corner, 0, -1};
}

ToolFrame::ToolFrame(const Pose& pose) : tip_(pose.tip), z_(pose.axis) {
  // Across the axis and the coordinate that it is least along
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(z_[k]) < std::abs(z_[least])) least = k;
  }
  Vector other{};
  other[least] = 1;
  x_ = kinematics::unit_vector(cross_product(other, z_));
  y_ = cross_product(z_, x_);
}

Vector ToolFrame::to_tool(const Vector& place) const {
  const Vector from_tip = difference(place, tip_);
  return {dot(x_, from_tip), dot(y_, from_tip), dot(z_, from_tip)};
}

Vector ToolFrame::from_tool(const Vector& place) const {
  return sum(sum(sum(tip_, place[0], x_), place[1], y_), place[2], z_);
}

Nearest nearest_of_polygon(const Part& part, std::span<const Vector> polygon, double bound) {
  Nearest best{bound, {}};
  // The tangent plane of a convex function lies below it.
  const Slope at_first = slope_at(part, polygon[0]);
  double least = at_first.value;
  for (const Vector& vertex : polygon) {
    least = std::min(least, at_first.value + dot(at_first.gradient, difference(vertex, polygon[0])));
  }
  if (least >= bound) return best;

  Vector normal = normal_of(polygon);
  const double length = numeric::norm(normal), edge = longest_edge_squared(polygon);
  const double sign = normal[2] < 0 ? -1 : 1;
  bool has_facet = false;
  Nearest facet;
  if (length > least_height * edge) {
    for (double& x : normal) x *= sign / length;
    if (normal[2] > least_rise) {
      facet = nearest_of_plane(part, normal, dot(normal, polygon[0]));
      if (facet.distance >= bound) return best;
      has_facet = true;
    }
  }
  bool is_inside = has_facet;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector& from = polygon[k];
    const Vector& to = polygon[(k + 1) % polygon.size()];
    if (has_facet) {
      const Vector inward = cross_product(normal, difference(to, from));
      if (sign * dot(inward, difference(facet.place, from)) >= 0) continue;
      is_inside = false;
    }
    test_edge(part, from, to, best);
  }
  if (is_inside) take_nearer(best, facet.distance, facet.place);
  return best;
}

Nearest nearest_of_triangle(const Part& part, const std::array<Vector, 3>& triangle, double bound) {
  double highest = triangle[0][2], lowest = highest;
  for (const Vector& vertex : triangle) {
    highest = std::max(highest, vertex[2]);
    lowest = std::min(lowest, vertex[2]);
  }
  if (highest <= part.top) return nearest_of_polygon(part, triangle, bound);
  const Nearest of_all = nearest_of_polygon(part, triangle, bound);
  const double above = std::max({of_all.distance, lowest - part.top, 0.0});
  if (of_all.distance >= bound || lowest >= part.top) return {std::min(above, bound), of_all.place};
  // What is left of the triangle below the top
  std::array<Vector, 4> below{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector& from = triangle[k];
    const Vector& to = triangle[(k + 1) % 3];
    if (from[2] <= part.top) below[count++] = from;
    if ((from[2] <= part.top) != (to[2] <= part.top)) {
      below[count++] = sum(from, (part.top - from[2]) / (to[2] - from[2]), difference(to, from));
    }
  }
  const Nearest cut = nearest_of_polygon(part, {below.data(), count}, bound);
  return cut.distance <= above ? cut : Nearest{std::min(above, bound), of_all.place};
}

}  // namespace leadscrew::gouging
