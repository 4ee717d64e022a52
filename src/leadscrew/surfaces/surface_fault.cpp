// Which forms are surfaces that can be machined.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/surface.hpp>

namespace leadscrew::surfaces {

namespace {

using Kind = SurfaceFault::Kind;

/// A normal whose length is less than this part of |Su|·|Sv| is none.
constexpr double least_normal = 1e-9;
/// Nor is one that is less than this part of the net's extent squared by the ranges: where a side comes to a point, rounding
/// leaves some.
constexpr double rounding = 1e-13;
/// Rows nearer to each other than this part of the net's extent coincide.
constexpr double least_distance = 1e-12;

std::optional<SurfaceFault> fault_of_counts(const SurfaceForm& form) {
  for (std::size_t d = 0; d < 2; ++d) {
    const auto direction = static_cast<Direction>(d);
    const int p = form.degree[d];
    const bool ok = p >= 1 && p <= highest_degree && form.count[d] > static_cast<std::size_t>(p) &&
                    form.count[d] <= most_control_points &&
                    form.knots[d].size() == form.count[d] + static_cast<std::size_t>(p) + 1;
    if (!ok) return SurfaceFault{Kind::counts, direction};
  }
  const bool fits = form.count[0] * form.count[1] <= most_control_points;
  if (!fits || form.net.size() != form.count[0] * form.count[1]) return SurfaceFault{Kind::counts};
  return std::nullopt;
}

std::optional<SurfaceFault> fault_of_points(const SurfaceForm& form) {
  for (std::size_t i = 0; i < form.net.size(); ++i) {
    const NetPoint& point = form.net[i];
    bool is_finite = std::isfinite(point.weight);
    for (const double x : point.position) is_finite = is_finite && std::isfinite(x);
    if (!is_finite) return SurfaceFault{Kind::not_finite, Direction::u, i};
    if (!(point.weight > 0)) return SurfaceFault{Kind::weight, Direction::u, i};
  }
  return std::nullopt;
}

std::optional<SurfaceFault> fault_of_knots(const SurfaceForm& form) {
  for (std::size_t d = 0; d < 2; ++d) {
    const auto direction = static_cast<Direction>(d);
    const std::vector<double>& knots = form.knots[d];
    const auto p = static_cast<std::size_t>(form.degree[d]);
    const std::size_t last = knots.size() - 1;
    for (std::size_t k = 0; k <= last; ++k) {
      if (!std::isfinite(knots[k])) return SurfaceFault{Kind::not_finite, direction, k};
      const bool falls = k > 0 && knots[k] < knots[k - 1];
      const bool is_end = k <= p || k >= last - p;
      const bool is_loose = is_end && knots[k] != (k <= p ? knots.front() : knots.back());
      const bool is_repeated = !is_end && k >= p && knots[k] == knots[k - p];
      if (falls || is_loose || is_repeated) return SurfaceFault{Kind::knots, direction, k};
    }
    if (!(knots.back() > knots.front())) return SurfaceFault{Kind::knots, direction, last};
  }
  return std::nullopt;
}

double extent_of(const SurfaceForm& form) {
  Vector low = form.net.front().position, high = low;
  for (const NetPoint& point : form.net) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point.position[k]);
      high[k] = std::max(high[k], point.position[k]);
    }
  }
  return numeric::distance(low, high);
}

std::optional<SurfaceFault> fault_of_rows(const SurfaceForm& form, double extent) {
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t across = form.count[d], along = form.count[1 - d];
    for (std::size_t row = 1; row < across; ++row) {
      double farthest = 0;
      for (std::size_t k = 0; k < along; ++k) {
        const NetPoint& here = d == 0 ? form.point(row, k) : form.point(k, row);
        const NetPoint& before = d == 0 ? form.point(row - 1, k) : form.point(k, row - 1);
        farthest = std::max(farthest, numeric::distance(here.position, before.position));
      }
      if (farthest <= least_distance * extent) return SurfaceFault{Kind::rows, static_cast<Direction>(d), row};
    }
  }
  return std::nullopt;
}

std::optional<SurfaceFault> fault_of_normals(const SurfaceForm& form, double extent) {
  const Surface surface(form);
  const auto& us = surface.breaks(Direction::u);
  const auto& vs = surface.breaks(Direction::v);
  const double scale = extent * extent / ((us.back() - us.front()) * (vs.back() - vs.front()));
  for (std::size_t j = 0; j <= 4 * (vs.size() - 1); ++j) {
    const double v = j % 4 == 0 ? vs[j / 4] : vs[j / 4] + static_cast<double>(j % 4) / 4 * (vs[j / 4 + 1] - vs[j / 4]);
    for (std::size_t i = 0; i <= 4 * (us.size() - 1); ++i) {
      const double u =
          i % 4 == 0 ? us[i / 4] : us[i / 4] + static_cast<double>(i % 4) / 4 * (us[i / 4 + 1] - us[i / 4]);
      const SurfaceJet jet = surface.jet(u, v);
      const double area = numeric::norm(kinematics::cross_product(jet.u, jet.v));
      const bool vanishes =
          area <= least_normal * numeric::norm(jet.u) * numeric::norm(jet.v) || area <= rounding * scale;
      if (vanishes) return SurfaceFault{Kind::normal, Direction::u, 0, u, v};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SurfaceFault> fault_of(const SurfaceForm& form) {
  if (auto fault = fault_of_counts(form)) return fault;
  if (auto fault = fault_of_points(form)) return fault;
  if (auto fault = fault_of_knots(form)) return fault;
  const double extent = extent_of(form);
  if (auto fault = fault_of_rows(form, extent)) return fault;
  return fault_of_normals(form, extent);
}

}  // namespace leadscrew::surfaces
