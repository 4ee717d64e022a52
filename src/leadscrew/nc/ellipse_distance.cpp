#include <algorithm>
#include <cmath>
#include <leadscrew/nc/ellipse_distance.hpp>
#include <utility>

namespace leadscrew::nc {

namespace {

/// Of a ≥ b > 0 in the first quadrant. At the foot (u, v) the place lies along the normal, (x, y) − (u, v) = t (u/a²,
/// v/b²), so that u = a² x/(t + a²), v = b² y/(t + b²), and t is the greatest root of
///
///   F(t) = (a x/(t + a²))² + (b y/(t + b²))² − 1
///
/// F falls and is convex for t > −b²: Newton's steps from its left rise to the root and never pass it.
std::pair<double, double> foot_in_first_quadrant(double a, double b, double x, double y) {
  const double squared_a = a * a, squared_b = b * b;
  if (y == 0 && a * x < squared_a - squared_b) {  // between the centres of curvature: beside the axis
    const double u = squared_a * x / (squared_a - squared_b);
    return {u, b * std::sqrt(std::max(0.0, 1 - u / a * (u / a)))};
  }
  if (y == 0) return {a, 0};
  const double least = b * y - squared_b;  // F ≥ 0 there
  double t = std::max(0.0, least);
  constexpr int most_steps = 200;
  for (int i = 0; i < most_steps; ++i) {
    const double of_x = a * x / (t + squared_a), of_y = b * y / (t + squared_b);
    const double value = of_x * of_x + of_y * of_y - 1;
    const double slope = -2 * (of_x * of_x / (t + squared_a) + of_y * of_y / (t + squared_b));
    const double next = std::max(least, t - value / slope);
    if (i > 1 && next <= t) break;  // the first step may lead back from the right
    t = next;
  }
  return {squared_a * x / (t + squared_a), squared_b * y / (t + squared_b)};
}

}  // namespace

EllipseFoot foot_on_ellipse(double semi_x, double semi_y, double x, double y) {
  const double across = std::abs(x), up = std::abs(y);
  std::pair<double, double> foot = semi_x >= semi_y ? foot_in_first_quadrant(semi_x, semi_y, across, up)
                                                    : foot_in_first_quadrant(semi_y, semi_x, up, across);
  if (semi_x < semi_y) std::swap(foot.first, foot.second);
  const double distance = std::hypot(across - foot.first, up - foot.second);
  const double share_x = x / semi_x, share_y = y / semi_y;
  const bool is_inside = share_x * share_x + share_y * share_y < 1;
  return {std::copysign(foot.first, x), std::copysign(foot.second, y), is_inside ? -distance : distance};
}

}  // namespace leadscrew::nc
