#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/tilted_plane.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

using PlaneVector = TiltedPlane::Vector;
using PlaneMatrix = TiltedPlane::Matrix;

PlaneVector cross_product(const PlaneVector& a, const PlaneVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot_product(const PlaneVector& a, const PlaneVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length_of(const PlaneVector& a) {
  return numeric::hypot(a[0], a[1], a[2]);
}
PlaneVector over(const PlaneVector& a, double length) {
  return {a[0] / length, a[1] / length, a[2] / length};
}
PlaneVector between(const PlaneVector& from, const PlaneVector& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// The rotation about axis 0, 1 or 2 and, behind it, another.
PlaneMatrix turned_about(std::size_t axis, double degrees, const PlaneMatrix& inner) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double c = cosine_of_degrees(degrees), s = sine_of_degrees(degrees);
  PlaneMatrix result = inner;
  for (std::size_t k = 0; k < 3; ++k) {
    result[i][k] = c * inner[i][k] - s * inner[j][k];
    result[j][k] = s * inner[i][k] + c * inner[j][k];
  }
  return result;
}

// Of unit vectors X and Z that are square.
PlaneMatrix of_columns(const PlaneVector& x, const PlaneVector& z) {
  const PlaneVector y = cross_product(z, x);
  PlaneMatrix result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = {x[i], y[i], z[i]};
  return result;
}

}  // namespace

TiltedPlane TiltedPlane::in(const TiltedPlane& outer) const {
  TiltedPlane result = outer;
  for (std::size_t i = 0; i < 3; ++i) {
    result.origin[i] += dot_product(outer.turn[i], origin);
    for (std::size_t k = 0; k < 3; ++k)
      result.turn[i][k] = dot_product(outer.turn[i], {turn[0][k], turn[1][k], turn[2][k]});
  }
  return result;
}

PlaneMatrix TiltedPlane::by_euler(const Vector& degrees) {
  return turned_about(2, degrees[0], turned_about(0, degrees[1], turned_about(2, degrees[2], TiltedPlane{}.turn)));
}

PlaneMatrix TiltedPlane::by_fixed_axes(const std::array<int, 3>& order, const Vector& degrees) {
  PlaneMatrix result = TiltedPlane{}.turn;
  for (const int each : order) {
    const auto axis = static_cast<std::size_t>(each - 1);
    result = turned_about(axis, degrees[axis], result);
  }
  return result;
}

std::optional<PlaneMatrix> TiltedPlane::by_points(const Vector& first, const Vector& second, const Vector& third) {
  constexpr double least_sine = 1e-6;  // of the angle at the first point
  const Vector x = between(first, second), aside = between(first, third), z = cross_product(x, aside);
  if (!(length_of(z) > least_sine * length_of(x) * length_of(aside))) return std::nullopt;
  return of_columns(over(x, length_of(x)), over(z, length_of(z)));
}

std::optional<PlaneMatrix> TiltedPlane::by_vectors(const Vector& x, const Vector& z) {
  constexpr double most_cosine = 0.08715574274765817;  // of 85 degrees
  const double length = length_of(z);
  if (!(length > 0) || !(length_of(x) > 0)) return std::nullopt;
  const Vector normal = over(z, length);
  const double along = dot_product(x, normal);
  if (!(std::fabs(along) <= most_cosine * length_of(x))) return std::nullopt;
  const Vector square = {x[0] - along * normal[0], x[1] - along * normal[1], x[2] - along * normal[2]};
  return of_columns(over(square, length_of(square)), normal);
}

}  // namespace leadscrew::gcode
