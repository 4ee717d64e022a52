#include <algorithm>
#include <leadscrew/planner/cubic_basis.hpp>

namespace leadscrew::planner {

namespace {

/// p += (c + d·u)·q
void add_product(Four& p, double c, double d, const Four& q) {
  for (std::size_t k = 0; k < 4; ++k) p[k] += c * q[k] + (k > 0 ? d * q[k - 1] : 0);
}

}  // namespace

CubicBasis::CubicBasis(const std::array<double, 6>& t) : h(t[3] - t[2]) {
  const double at = t[2];
  // Cox and de Boor: B(i, p) = rise(i, p) B(i, p−1) + fall(i+1, p) B(i+1, p−1), every factor a straight line in u.
  std::array<Four, 4> lower{};
  lower[3] = {1, 0, 0, 0};
  for (std::size_t p = 1; p <= 3; ++p) {
    std::array<Four, 4> next{};
    for (std::size_t j = 3 - p; j <= 3; ++j) {
      // B(j, p) has the knots t[j−1] … t[j+p]; t[−1] would belong to a function that is 0 here.
      if (j > 3 - p) {
        const double width = t[j + p - 1] - t[j - 1];
        add_product(next[j], (at - t[j - 1]) / width, h / width, lower[j]);
      }
      if (j < 3) {
        const double width = t[j + p] - t[j];
        add_product(next[j], (t[j + p] - at) / width, -h / width, lower[j + 1]);
      }
    }
    lower = next;
  }
  m = lower;
}

Four CubicBasis::value(double u) const {
  Four b;
  for (std::size_t j = 0; j < 4; ++j) b[j] = m[j][0] + u * (m[j][1] + u * (m[j][2] + u * m[j][3]));
  return b;
}

Four CubicBasis::slope(double u) const {
  Four b;
  for (std::size_t j = 0; j < 4; ++j) b[j] = (m[j][1] + u * (2 * m[j][2] + u * 3 * m[j][3])) / h;
  return b;
}

Four CubicBasis::bend(double u) const {
  Four b;
  for (std::size_t j = 0; j < 4; ++j) b[j] = (2 * m[j][2] + u * 6 * m[j][3]) / (h * h);
  return b;
}

void insert_knot(std::vector<double>& knots, std::vector<double>& c, double s) {
  const auto k = static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), s) - knots.begin()) - 1;
  const auto knot = [&](std::size_t i) { return knots[std::min(i, knots.size() - 1)]; };
  const auto before = [&](std::size_t i) { return knots[k >= i ? k - i : 0]; };
  // c_i is the blossom at the knots i − 2, i − 1, i: three of them change.
  const auto between = [&](std::size_t i, double from, double to) {
    const double share = (s - from) / (to - from);
    return (1 - share) * c[i] + share * c[i + 1];
  };
  const double first = between(k, before(2), knot(k + 1)), second = between(k + 1, before(1), knot(k + 2)),
               third = between(k + 2, knots[k], knot(k + 3));
  const auto at = static_cast<std::ptrdiff_t>(k);
  c.insert(c.begin() + at + 1, first);
  c[k + 2] = second;
  c[k + 3] = third;
  knots.insert(knots.begin() + at + 1, s);
}

}  // namespace leadscrew::planner
