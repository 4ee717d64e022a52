#pragma once
// Helpers for tests that make path and plan it.

#include <cmath>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <vector>

namespace leadscrew::testing_support {

inline toolpath::Piece line_piece(const geometry::Point& start, const geometry::Point& end, double feed, int line = 1) {
  const double length = std::hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
  return {geometry::Line(start, end, length), feed, base::Line{line}};
}

/// An arc in X and Y about a centre, through an angle in radians, to the end it leads to.
inline toolpath::Piece arc_piece(const geometry::Point& start, double center_x, double center_y, double sweep,
                                 double feed, int line = 1) {
  geometry::Point end = start;
  const double x = start[0] - center_x, y = start[1] - center_y;
  end[0] = center_x + x * std::cos(sweep) - y * std::sin(sweep);
  end[1] = center_y + x * std::sin(sweep) + y * std::cos(sweep);
  const double length = geometry::Arc::helix_length(std::hypot(x, y), sweep, 0);
  return {geometry::Arc(start, end, 0, 1, center_x, center_y, sweep, length), feed, base::Line{line}};
}

inline std::vector<planner::Chunk> plan(const std::vector<toolpath::Element>& elements,
                                        const machine::Machine& machine) {
  planner::Planner planner(machine, {});
  for (toolpath::Element element : elements) {
    if (auto* piece = std::get_if<toolpath::Piece>(&element)) toolpath::check_travel(*piece, machine, {}, 0);
    planner.push(element);
  }
  planner.finish();
  std::vector<planner::Chunk> chunks;
  while (auto chunk = planner.pop()) chunks.push_back(*chunk);
  return chunks;
}

}  // namespace leadscrew::testing_support
