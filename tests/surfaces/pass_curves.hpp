#pragma once
// Passes as curves, by formulas of their own.

#include <algorithm>
#include <leadscrew/surfaces/passes.hpp>
#include <leadscrew/surfaces/quintic_spline.hpp>

namespace leadscrew::surfaces::test {

/// By de Casteljau's algorithm between the nodes about t.
inline Vector at(const Pass& pass, VectorOf<PassNode::Jet> PassNode::* member, double t) {
  const std::vector<PassNode>& nodes = pass.nodes;
  const auto after = std::lower_bound(nodes.begin() + 1, nodes.end() - 1, t,
                                      [](const PassNode& node, double place) { return node.t < place; });
  const auto k = static_cast<std::size_t>(after - nodes.begin()) - 1;
  const double width = nodes[k + 1].t - nodes[k].t, x = (t - nodes[k].t) / width;
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const PassNode::Jet &a = (nodes[k].*member)[i], &b = (nodes[k + 1].*member)[i];
    std::array<double, 6> points = {a[0],
                                    a[0] + width * a[1] / 5,
                                    a[0] + 2 * width * a[1] / 5 + width * width * a[2] / 20,
                                    b[0] - 2 * width * b[1] / 5 + width * width * b[2] / 20,
                                    b[0] - width * b[1] / 5,
                                    b[0]};
    for (std::size_t level = 5; level > 0; --level) {
      for (std::size_t j = 0; j < level; ++j) points[j] = (1 - x) * points[j] + x * points[j + 1];
    }
    result[i] = points[0];
  }
  return result;
}

/// De Boor's algorithm on the spline's knots.
template <std::size_t N>
std::array<double, N> de_boor(const QuinticSpline<N>& spline, double t) {
  std::size_t span = 5;
  while (span + 1 < spline.points.size() && spline.knots[span + 1] <= t) ++span;
  std::array<std::array<double, N>, 6> d;
  for (std::size_t j = 0; j <= 5; ++j) d[j] = spline.points[j + span - 5];
  for (std::size_t r = 1; r <= 5; ++r) {
    for (std::size_t j = 5; j >= r; --j) {
      const double low = spline.knots[j + span - 5], high = spline.knots[j + 1 + span - r],
                   x = (t - low) / (high - low);
      for (std::size_t i = 0; i < N; ++i) d[j][i] = (1 - x) * d[j - 1][i] + x * d[j][i];
    }
  }
  return d[5];
}

}  // namespace leadscrew::surfaces::test
