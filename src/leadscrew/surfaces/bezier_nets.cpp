#include <leadscrew/surfaces/bezier_nets.hpp>

namespace leadscrew::surfaces {

namespace {

using Point = std::array<double, 4>;  // w x, w y, w z, w

/// One of the Bezier points of a span: the polynomial's blossom at so many times the end of the span, else its beginning
/// (Farin, "Curves and Surfaces for CAGD", section 8.2). `row` gives the span's p + 1 control points.
template <typename Row>
Point bezier_point(const std::vector<double>& knots, std::size_t span, std::size_t p, std::size_t ends, Row&& row) {
  std::array<Point, highest_degree + 1> points{};
  for (std::size_t k = 0; k <= p; ++k) points[k] = row(k);
  for (std::size_t r = 1; r <= p; ++r) {
    const double x = knots[span + (r <= ends ? 1 : 0)];
    for (std::size_t k = p; k >= r; --k) {
      const double low = knots[span - p + k], high = knots[span + k + 1 - r];
      const double share = (x - low) / (high - low);
      for (std::size_t i = 0; i < 4; ++i) points[k][i] = (1 - share) * points[k - 1][i] + share * points[k][i];
    }
  }
  return points[p];
}

Point homogeneous(const NetPoint& point) {
  const double w = point.weight;
  return {w * point.position[0], w * point.position[1], w * point.position[2], w};
}

std::vector<Point> net_of_spans(const SurfaceForm& form, std::size_t u, std::size_t v) {
  const auto p = static_cast<std::size_t>(form.degree[0]), q = static_cast<std::size_t>(form.degree[1]);
  // Rows of the span's control points first, to points of u.
  std::vector<Point> rows;
  for (std::size_t j = 0; j <= q; ++j) {
    for (std::size_t i = 0; i <= p; ++i) {
      rows.push_back(bezier_point(form.knots[0], u, p, i,
                                  [&](std::size_t k) { return homogeneous(form.point(u - p + k, v - q + j)); }));
    }
  }
  std::vector<Point> net;
  for (std::size_t j = 0; j <= q; ++j) {
    for (std::size_t i = 0; i <= p; ++i) {
      Point point = bezier_point(form.knots[1], v, q, j, [&](std::size_t k) { return rows[k * (p + 1) + i]; });
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] /= point[3];
      net.push_back(point);
    }
  }
  return net;
}

}  // namespace

std::vector<std::vector<std::array<double, 4>>> bezier_nets(const SurfaceForm& form) {
  std::vector<std::vector<Point>> nets;
  const auto p = static_cast<std::size_t>(form.degree[0]), q = static_cast<std::size_t>(form.degree[1]);
  for (std::size_t v = q; v < form.count[1]; ++v) {
    for (std::size_t u = p; u < form.count[0]; ++u) {
      const bool is_span = form.knots[0][u] < form.knots[0][u + 1] && form.knots[1][v] < form.knots[1][v + 1];
      if (is_span) nets.push_back(net_of_spans(form, u, v));
    }
  }
  return nets;
}

}  // namespace leadscrew::surfaces
