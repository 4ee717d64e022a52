#pragma once
// All arcs between lattice points of the same circle.

#include <leadscrew/pulse/arc.hpp>
#include <map>
#include <vector>

namespace leadscrew::testing_support {

/// The lattice points of each circle about the origin with 0 < R² ≤ reach², BLU, by R².
inline std::map<std::int64_t, std::vector<pulse::Point>> lattice_circles(std::int64_t reach) {
  std::map<std::int64_t, std::vector<pulse::Point>> circles;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) {
      const std::int64_t n = x * x + y * y;
      if (n > 0 && n <= reach * reach) circles[n].push_back({x, y});
    }
  }
  return circles;
}

/// take(arc) of all arcs between them, both ways; the full circle from each point among them.
template <typename Take>
void each_lattice_arc(std::int64_t reach, const Take& take) {
  for (const auto& [n, points] : lattice_circles(reach)) {
    for (const pulse::Point& start : points) {
      for (const pulse::Point& end : points) {
        take(pulse::Arc{start, end, pulse::Direction::clockwise});
        take(pulse::Arc{start, end, pulse::Direction::counterclockwise});
      }
    }
  }
}

}  // namespace leadscrew::testing_support
