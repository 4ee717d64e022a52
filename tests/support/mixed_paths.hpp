#pragma once
// Paths for the tests of the controller and of motion in windows.

#include <cut_motion.hpp>
#include <planned.hpp>

namespace leadscrew::testing_support {

constexpr double path_jerk = 20000, path_speed = 80;
constexpr base::Period path_period{1'000'000};

/// A line, a NURBS curve that goes on from it, an arc.
inline Path mixed_path() {
  geometry::Point at{};
  at[0] = 12;
  Path path{{line_piece({}, at, 80, 1)}};
  geometry::NurbsForm form{3, {0, 0, 0, 0, 1, 1, 1, 1}, {at, at, at, at}, {1, 2, 0.5, 1}};
  const std::array<std::array<double, 2>, 3> offsets = {{{8, 0}, {14, 5}, {14, 13}}};
  for (std::size_t i = 0; i < 3; ++i) {
    form.points[i + 1][0] += offsets[i][0];
    form.points[i + 1][1] += offsets[i][1];
  }
  for (const geometry::Nurbs& piece : geometry::smooth_pieces(form)) path.pieces.push_back({piece, 80, base::Line{2}});
  const geometry::Point end = geometry::end(path.pieces.back().curve);
  path.pieces.push_back(arc_piece(end, end[0] - 9, end[1], 2.5, 80, 3));
  return path;
}

/// Two lines and two half circles that lead back to the start.
inline Path stadium() {
  const auto point = [](double x, double y) {
    geometry::Point at{};
    at[0] = x;
    at[1] = y;
    return at;
  };
  const double half_turn = std::acos(-1.0);
  Path path;
  path.pieces = {line_piece(point(0, 0), point(15, 0), 80, 1), arc_piece(point(15, 0), 15, 6, half_turn, 80, 2)};
  const geometry::Point across = geometry::end(path.pieces.back().curve);
  path.pieces.push_back(line_piece(across, point(0, 12), 80, 3));
  path.pieces.push_back(arc_piece(point(0, 12), 0, 6, half_turn, 80, 4));
  return path;
}

}  // namespace leadscrew::testing_support
