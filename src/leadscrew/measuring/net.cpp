#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/net.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

/// Index of the span knots[i] ≤ parameter < knots[i + 1]; at the end of the range the last that is not empty.
std::size_t span_at(std::size_t degree, const std::vector<double>& knots, double parameter) {
  const std::size_t points = knots.size() - degree - 1;
  if (parameter >= knots[points]) parameter = std::nextafter(knots[points], knots[degree]);
  const auto above = std::upper_bound(knots.begin() + static_cast<std::ptrdiff_t>(degree),
                                      knots.begin() + static_cast<std::ptrdiff_t>(points), parameter);
  return static_cast<std::size_t>(above - knots.begin()) - 1;
}

double share(double of, double width) {
  return width > 0 ? of / width : 0;
}

}  // namespace

Basis basis_of(int degree, const std::vector<double>& knots, double parameter) {
  const auto p = static_cast<std::size_t>(degree);
  const double x = std::clamp(parameter, knots[p], knots[knots.size() - p - 1]);
  const std::size_t i = span_at(p, knots, x);
  Basis basis{i - p};
  basis.value[0] = 1;
  for (std::size_t d = 1; d <= p; ++d) {
    const auto lower = basis.value;  // N_{i−d+1…i} of degree d − 1
    for (std::size_t k = 0; k <= d; ++k) {
      const std::size_t a = i - d + k;  // index of the function
      const double left = k > 0 ? share(lower[k - 1], knots[a + d] - knots[a]) : 0;
      const double right = k < d ? share(lower[k], knots[a + d + 1] - knots[a + 1]) : 0;
      basis.value[k] = (x - knots[a]) * left + (knots[a + d + 1] - x) * right;
      basis.derivative[k] = static_cast<double>(d) * (left - right);
    }
  }
  return basis;
}

Basis Net::basis(surfaces::Direction direction, double parameter) const {
  const std::size_t k = direction == surfaces::Direction::v ? 1 : 0;
  return basis_of(form_->degree[k], form_->knots[k], parameter);
}

SurfacePlace Net::at(const Basis& u, const Basis& v) const {
  std::array<double, 4> value{}, by_u{}, by_v{};  // w x, w y, w z, w
  for (std::size_t j = 0; j <= static_cast<std::size_t>(form_->degree[1]); ++j) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(form_->degree[0]); ++i) {
      const surfaces::NetPoint& point = form_->point(u.first + i, v.first + j);
      const double w = point.weight;
      const std::array<double, 4> term = {w * point.position[0], w * point.position[1], w * point.position[2], w};
      value = numeric::sum(value, u.value[i] * v.value[j], term);
      by_u = numeric::sum(by_u, u.derivative[i] * v.value[j], term);
      by_v = numeric::sum(by_v, u.value[i] * v.derivative[j], term);
    }
  }
  SurfacePlace place;
  Vector su, sv;
  for (std::size_t k = 0; k < 3; ++k) {
    place.s[k] = value[k] / value[3];
    su[k] = (by_u[k] - by_u[3] * place.s[k]) / value[3];
    sv[k] = (by_v[k] - by_v[3] * place.s[k]) / value[3];
  }
  const Vector across = {su[1] * sv[2] - su[2] * sv[1], su[2] * sv[0] - su[0] * sv[2], su[0] * sv[1] - su[1] * sv[0]};
  place.area = numeric::norm(across);
  place.along_u = numeric::norm(su);
  place.along_v = numeric::norm(sv);
  for (std::size_t k = 0; place.area > 0 && k < 3; ++k) place.n[k] = side_ * across[k] / place.area;
  return place;
}

}  // namespace leadscrew::measuring
