#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/frechet.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <vector>

namespace leadscrew::toolpath {

using geometry::Point;

namespace {

/// Shares of a segment, from ≤ to; empty otherwise.
struct Interval {
  double from = 1, to = 0;
  bool empty() const { return !(from <= to); }
};

/// The part of the segment from a to b within `distance` of p.
Interval near(const Point& p, const Point& a, const Point& b, double distance) {
  const Point along = difference(b, a), to = difference(p, a);
  const double length = dot(along, along), off = dot(to, to) - distance * distance;
  if (!(length > 0)) return off <= 0 ? Interval{0, 1} : Interval{};
  const double middle = dot(along, to) / length, root = middle * middle - off / length;
  if (!(root >= 0)) return {};
  const double half = std::sqrt(root);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace

bool is_frechet_within(std::span<const Point> a, std::span<const Point> b, double distance) {
  if (toolpath::distance(a.front(), b.front()) > distance || toolpath::distance(a.back(), b.back()) > distance)
    return false;
  // A point alone is a segment of no length.
  const auto at = [](std::span<const Point> p, std::size_t i) -> const Point& { return p[std::min(i, p.size() - 1)]; };
  const std::size_t n = std::max<std::size_t>(a.size(), 2) - 1, m = std::max<std::size_t>(b.size(), 2) - 1;
  // Cell (i, j): segment i of a against segment j of b. `across[j]`: what can be reached of the side where a is at
  // point i and b on segment j; `up`: of the side where b is at point j and a on segment i.
  std::vector<Interval> across(m);
  bool open = true;
  for (std::size_t j = 0; j < m; ++j) {
    const Interval free = near(a.front(), at(b, j), at(b, j + 1), distance);
    across[j] = open && free.from <= 0 ? free : Interval{};
    open = !across[j].empty() && across[j].to >= 1;
  }
  bool bottom_open = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Interval bottom = near(b.front(), at(a, i), at(a, i + 1), distance);
    Interval up = bottom_open && bottom.from <= 0 ? bottom : Interval{};
    bottom_open = !up.empty() && up.to >= 1;
    for (std::size_t j = 0; j < m; ++j) {
      Interval right = near(at(a, i + 1), at(b, j), at(b, j + 1), distance);
      Interval top = near(at(b, j + 1), at(a, i), at(a, i + 1), distance);
      // Within a cell what is near is convex: from below all of the right side can be reached, from the left what is
      // not behind; and likewise the top.
      if (up.empty()) right = across[j].empty() ? Interval{} : Interval{std::max(right.from, across[j].from), right.to};
      if (across[j].empty()) top = up.empty() ? Interval{} : Interval{std::max(top.from, up.from), top.to};
      across[j] = right;
      up = top;
    }
    if (i + 1 == n) return !up.empty() && up.to >= 1;
  }
  return false;
}

}  // namespace leadscrew::toolpath
