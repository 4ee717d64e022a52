#pragma once
// Programs of lines and arcs, random ones and waves, and the smoothed paths that are built of them.

#include <rapidcheck.h>

#include <leadscrew/toolpath/builder.hpp>
#include <numbers>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {

using gcode::Move;

inline std::int64_t line_number(const Move& move) {
  return base::number(move.line);
}

/// A program that is made move by move; each on a line of its own, counted from 1.
struct Program {
  std::vector<Move> moves;
  Point at{};
  double tolerance = 0.01, cam_tolerance = 0.01, feed = 50;

  Move& add(Move::Kind kind, const Point& end) {
    Move move;
    move.kind = kind;
    move.line = base::Line{static_cast<std::int64_t>(moves.size()) + 1};
    move.start = at;
    move.end = at = end;
    move.feed = {gcode::Feed::Mode::units_per_second, feed};
    move.tolerance = tolerance;
    move.naive_cam_tolerance = cam_tolerance;
    moves.push_back(move);
    return moves.back();
  }
  void line_to(const Point& end) { add(Move::Kind::line, end); }
  /// In the plane of X and Y, about a centre, through an angle.
  void arc(double center_x, double center_y, double angle) {
    const double x = at[0] - center_x, y = at[1] - center_y;
    Point end = at;
    end[0] = center_x + x * std::cos(angle) - y * std::sin(angle);
    end[1] = center_y + x * std::sin(angle) + y * std::cos(angle);
    Move& move = add(Move::Kind::arc, end);
    move.center_first = center_x;
    move.center_second = center_y;
    move.turns = angle > 0 ? 1 : -1;
  }
  void dwell() { add(Move::Kind::dwell, at).dwell_seconds = 0.1; }
  void event() { add(Move::Kind::event, at).event = {base::Event::Kind::coolant_off, 0, moves.back().line}; }
};

enum class Popping { after_each, at_the_end };

inline std::vector<Element> path_of(const std::vector<Move>& moves, Popping popping = Popping::at_the_end) {
  Builder builder;
  std::vector<Element> path;
  const auto pop = [&] {
    while (std::optional<Element> element = builder.pop()) path.push_back(std::move(*element));
  };
  for (const Move& move : moves) {
    builder.push(move);
    if (popping == Popping::after_each) pop();
  }
  builder.finish();
  pop();
  return path;
}

inline std::vector<Piece> pieces_of(const std::vector<Move>& moves) {
  std::vector<Piece> pieces;
  for (const Element& element : path_of(moves)) {
    if (const auto* piece = std::get_if<Piece>(&element)) pieces.push_back(*piece);
  }
  return pieces;
}

/// Chords that turn now and then, by little and by much; sometimes arcs; in up to five axes; sometimes within
/// tolerances that change, at most that of the program.
inline Program random_program(int longest = 80) {
  Program program;
  program.tolerance = program.cam_tolerance = logarithmic(1e-3, 0.1);
  if (any(0, 3) == 0) program.cam_tolerance *= any(0, 3) / 2.0;
  program.feed = logarithmic(1, 300);
  std::vector<std::size_t> axes{0, 1};
  for (const std::size_t i : {2u, 3u, 4u}) {
    if (any(0, 3) == 0) axes.push_back(i);
  }
  const double most_turn = logarithmic(0.01, 3), chord = logarithmic(0.1, 10);
  const double greatest = program.tolerance;
  const bool varies = any(0, 3) == 0;
  Point direction = random_direction({0, 1});
  program.at = {uniform(-50, 50), uniform(-50, 50)};
  for (int count = any(1, longest); count > 0; --count) {
    if (varies && any(0, 3) == 0) program.tolerance = greatest * logarithmic(1e-2, 1);
    if (any(0, 10) == 0) {
      const double radius = logarithmic(0.5, 10), side = any(0, 2) == 0 ? 1 : -1;
      const double angle = uniform(0, 2 * std::numbers::pi);
      program.arc(program.at[0] + radius * std::cos(angle), program.at[1] + radius * std::sin(angle),
                  side * uniform(0.1, 3));
    } else {
      program.line_to(sum(program.at, chord * logarithmic(0.1, 10), direction));
    }
    direction = turned(direction, any(0, 5) == 0 ? uniform(0, most_turn) : uniform(0, most_turn / 10), axes);
    if (std::hypot(direction[0], direction[1]) < 0.1) direction = random_direction({0, 1});
  }
  program.tolerance = greatest;
  return program;
}

/// The lines named along the path, one after another.
inline std::vector<std::int64_t> lines_of(const std::vector<Piece>& pieces) {
  std::vector<std::int64_t> lines;
  for (const Piece& piece : pieces) {
    lines.push_back(base::number(piece.line));
    if (!piece.lines) continue;
    double last = 0;
    for (const LineMark& mark : *piece.lines) {
      RC_ASSERT(mark.s >= last);
      RC_ASSERT(mark.s <= geometry::length(piece.curve));
      last = mark.s;
      lines.push_back(base::number(mark.line));
    }
  }
  return lines;
}

/// A wave of lines of this length.
inline Program wave(double chord, double tolerance, double cam_tolerance) {
  Program program;
  program.tolerance = tolerance;
  program.cam_tolerance = cam_tolerance;
  double x = 0;
  for (int k = 0; k < 200; ++k) {
    x += chord / std::hypot(1, std::cos(x));
    program.line_to({x, std::sin(x)});
  }
  return program;
}

}  // namespace leadscrew::toolpath::testing
