#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/step_over.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::surfaces {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

/// arccos(1 − x) with 1 − cos φ = 2 sin² φ/2: exact for small steps too. 1 − (D² + t² − R²)/(2 D t) = (R² − (D − t)²)/(2 D t),
/// and R² − (D − t)² = (R − s(D − t))(R + s(D − t)) = h (2 R − h), for s(D − t) = R − h. With k = s/ρ: D t/ρ² = (1 + k R)(1 + k h).
double step_over(double radius, double curvature, double height) {
  if (!(height > 0)) return 0;
  const double k = -curvature;
  if (std::isinf(radius)) {
    if (!(k > 0)) return infinite;
    // A flat across a convex surface: D − t and D are infinite, cos φ = 1/(1 + k h).
    return 2 / k * std::asin(std::sqrt(k * height * (2 + k * height)) / (1 + k * height));
  }
  const double h = std::min(height, radius);
  const double square = h * (2 * radius - h);
  const double both = (1 + k * radius) * (1 + k * h);
  if (!(both > 0)) return 0;
  if (k == 0) return 2 * std::sqrt(square);
  const double half_sine = std::sqrt(square / both) * std::abs(k) / 2;
  if (half_sine >= 1) return std::numbers::pi * 2 / std::abs(k);
  return 4 / std::abs(k) * std::asin(half_sine);
}

/// From the same: h² − 2 b h + q c = 0 with q = 4 sin² φ/2/k², c = 1 + k R, b = R − k q c/2; the smaller root, without
/// cancellation.
double scallop_height(double radius, double curvature, double step) {
  const double k = -curvature;
  if (std::isinf(radius)) return k > 0 ? (1 / std::cos(k * step / 2) - 1) / k : 0;
  const double sine = k == 0 ? step / 4 : std::sin(std::abs(k) * step / 4) / std::abs(k);
  const double c = 1 + k * radius, qc = 4 * sine * sine * c, b = radius - k * qc / 2;
  const double square = b * b - qc;
  if (!(square > 0)) return radius;
  return std::min(qc / (b + std::sqrt(square)), radius);
}

}  // namespace leadscrew::surfaces
