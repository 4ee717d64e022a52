#pragma once
// Paths for the tests of the controller and of motion in windows.

#include <cut_motion.hpp>
#include <planned.hpp>

namespace leadscrew::testing_support {

constexpr double path_jerk = 20000, path_speed = 80;
constexpr base::Period path_period{1'000'000};

/// A curve in X and Y from there on.
inline geometry::NurbsForm bend_from(const geometry::Point& at) {
  geometry::NurbsForm form{3, {0, 0, 0, 0, 1, 1, 1, 1}, {at, at, at, at}, {1, 2, 0.5, 1}};
  const std::array<std::array<double, 2>, 3> offsets = {{{8, 0}, {14, 5}, {14, 13}}};
  for (std::size_t i = 0; i < 3; ++i) {
    form.points[i + 1][0] += offsets[i][0];
    form.points[i + 1][1] += offsets[i][1];
  }
  return form;
}

/// A line, a NURBS curve that goes on from it, an arc.
inline Path mixed_path() {
  geometry::Point at{};
  at[0] = 12;
  Path path{{line_piece({}, at, 80, 1)}};
  for (const geometry::Nurbs& piece : geometry::smooth_pieces(bend_from(at)))
    path.pieces.push_back({piece, 80, base::Line{2}});
  const geometry::Point end = geometry::end(path.pieces.back().curve);
  path.pieces.push_back(arc_piece(end, end[0] - 9, end[1], 2.5, 80, 3));
  return path;
}

/// Such a path of the tool's tip while both rotary axes of a chain turn, and a line of the rotary axes alone behind it.
inline Path posed_path(const machine::RotaryChain& chain) {
  Path path;
  path.machine.rotary_chain = chain;
  for (auto& axis : path.machine.axes) {
    if (axis) axis->travel_min = -1e4, axis->travel_max = 1e4;
  }
  const auto turned = [&](geometry::Point at, double share) {
    at[base::index(chain.axes[0].axis)] = 20 + 60 * share;
    at[base::index(chain.axes[1].axis)] = 10 - 90 * share * share;
    return at;
  };
  geometry::Point at{};
  at[0] = 12;
  path.pieces = {line_piece(turned({}, 0), turned(at, 0.2), 80, 1)};
  geometry::NurbsForm bend = bend_from(at);
  for (std::size_t i = 0; i < bend.points.size(); ++i)
    bend.points[i] = turned(bend.points[i], 0.2 + 0.1 * static_cast<double>(i));
  for (const geometry::Nurbs& piece : geometry::smooth_pieces(bend)) {
    path.pieces.push_back({piece, 80, base::Line{2}});
    path.pieces.back().feed_axes = toolpath::FeedAxes::xyz;
  }
  const geometry::Point end = bend.points.back();
  const toolpath::Piece around = arc_piece(end, end[0] - 9, end[1], 2.5, 80, 3);
  const geometry::Point last = turned(geometry::end(around.curve), 1);
  path.pieces.push_back(around);
  path.pieces.back().curve = geometry::Arc(end, last, 0, 1, end[0] - 9, end[1], 2.5, geometry::length(around.curve));
  path.pieces.push_back({geometry::Line(last, turned(last, 1.1), 8), 20, base::Line{4}});
  path.pieces.back().feed_axes = toolpath::FeedAxes::abc;
  const auto transformation = std::make_shared<const kinematics::Transformation>(kinematics::chain_of(path.machine),
                                                                                 machine::Vector{1, -2, 60});
  for (toolpath::Piece& piece : path.pieces) piece.transformation = transformation;
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
