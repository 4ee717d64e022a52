#pragma once
// Polylines to test with, and a judge of how far two are apart that shares nothing with the house: Fréchet's distance
// of their points alone (Eiter and Mannila, "Computing discrete Fréchet distance", 1994).

#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tube_spline.hpp>
#include <random_numbers.hpp>
#include <vector>

namespace leadscrew::toolpath::testing {

using geometry::Point;
using testing_support::any;
using testing_support::logarithmic;
using Polyline = std::vector<Point>;

inline double uniform(double low, double high) {
  return low + (high - low) * any(0, 1000001) / 1e6;
}

inline Point scaled(double factor, const Point& p) {
  return sum(Point{}, factor, p);
}

/// Of length 1, in these coordinates.
inline Point random_direction(const std::vector<std::size_t>& coordinates) {
  for (;;) {
    Point p{};
    for (const std::size_t i : coordinates) p[i] = uniform(-1, 1);
    if (norm(p) > 0.1) return scaled(1 / norm(p), p);
  }
}

/// The direction after a turn by an angle, towards anywhere.
inline Point turned(const Point& direction, double angle, const std::vector<std::size_t>& coordinates) {
  for (;;) {
    const Point other = random_direction(coordinates), aside = sum(other, -dot(other, direction), direction);
    if (norm(aside) < 0.1) continue;
    return sum(scaled(std::cos(angle), direction), std::sin(angle) / norm(aside), aside);
  }
}

/// Numbered by the length from the first, all with this margin, which is all of the tolerance.
inline std::vector<Vertex> vertices_of(const Polyline& polyline, double margin) {
  std::vector<Vertex> vertices{{polyline.front(), 0, margin, 0, margin}};
  for (std::size_t i = 1; i < polyline.size(); ++i)
    vertices.push_back({polyline[i], vertices.back().u + distance(polyline[i - 1], polyline[i]), margin, 0, margin});
  return vertices;
}

/// With further points, so that none is farther from the next than `step`.
inline Polyline subdivided(const Polyline& polyline, double step) {
  Polyline points{polyline.front()};
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Point along = difference(polyline[i], polyline[i - 1]);
    const int count = std::max(1, static_cast<int>(std::ceil(norm(along) / step)));
    for (int k = 1; k < count; ++k) points.push_back(sum(polyline[i - 1], static_cast<double>(k) / count, along));
    points.push_back(polyline[i]);
  }
  return points;
}

/// No less than the distance of the polylines, and more by at most the longest chord of either.
inline double discrete_frechet(const Polyline& a, const Polyline& b) {
  std::vector<double> before(b.size()), row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      double reached = i + j > 0 ? INFINITY : 0;
      if (i > 0) reached = std::min(reached, before[j]);
      if (j > 0) reached = std::min(reached, row[j - 1]);
      if (i > 0 && j > 0) reached = std::min(reached, before[j - 1]);
      row[j] = std::max(reached, distance(a[i], b[j]));
    }
    before.swap(row);
  }
  return before.back();
}

}  // namespace leadscrew::toolpath::testing
