#pragma once
// The referee's own geometry: what a block asks for, as lines, as arcs of at most a quarter turn and as segments of
// curves that turn little (bezier.hpp).
//
// A place on a piece is a distance along a line (mm), an angle from an arc's start (radians, never negative) or the
// parameter of a segment (0 … 1). Arcs are cut at quarter turns so that each piece has one nearest point to anything
// near it, and so that a circle milled three times is twelve pieces one after the other and no angle is ever ambiguous:
//
//     p(φ) = c + a cos φ ± a⊥ sin φ   in the plane,   a = start − c,   0 ≤ φ ≤ Δ ≤ π/2
//     p(φ) = l + m φ                  in every other axis

#include <cstdint>
#include <leadscrew/base/line.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/referee/bezier.hpp>
#include <leadscrew/referee/metric.hpp>

namespace leadscrew::referee {

/// The axes whose travel a block's feed counts: the first group that moves (RS274/NGC 2.1.2.5).
enum class FeedAxes : std::uint8_t { xyz, uvw, abc };

constexpr std::array<base::Axis, 3> axes_of(FeedAxes axes) {
  using enum base::Axis;
  return axes == FeedAxes::xyz   ? std::array{X, Y, Z}
         : axes == FeedAxes::uvw ? std::array{U, V, W}
                                 : std::array{A, B, C};
}
Coordinates coordinates_of(const Metric& metric, FeedAxes axes);

/// Programmed feed along a block.
struct ProgrammedFeed {
  FeedAxes axes = FeedAxes::xyz;
  double value = 0;  ///< mm/s or degrees/s; infinite for a rapid
  /// Programmed where the tool touches a surface: the value is what the tip's may be, at most, on a piece.
  bool is_of_contact = false;
};

struct Piece {
  enum class Kind : std::uint8_t { line, arc, curve };

  Kind kind = Kind::line;
  bool helix = false;                ///< an arc on which other axes than the plane's move
  base::Line line{};                 ///< source line
  std::int64_t block = 0;            ///< counts the program's lines, arcs and curves
  double tolerance = 0;              ///< mm
  double orientation_tolerance = 0;  ///< of the tip: of the tool's direction, degrees
  ProgrammedFeed feed;
  std::array<double, 3> tool{};  ///< its offset, mm, of a machine with a chain of rotary axes
  Point from{};                  ///< mm
  Point to{};                    ///< mm
  Point slope{};                 ///< line: unit direction; arc: m, mm per radian, 0 in the plane
  double span = 0;               ///< line: length, mm; arc: Δ, radians; curve: 1

  std::uint8_t first = 0, second = 0;          ///< arc: coordinates of the plane
  double center_first = 0, center_second = 0;  ///< arc: mm
  double radial_first = 0, radial_second = 0;  ///< arc: a, mm
  double side = 1;                             ///< arc: 1 counterclockwise, −1 clockwise
  double radius = 0, radius_slope = 0;         ///< arc: |a|, and its change per radian, which is rounding
  double squared_slope = 0;                    ///< arc: |m|²
  double angle_before = 0;                     ///< arc: from the block's start to the piece's, radians

  Bezier segment;           ///< curve
  std::int64_t number = 0;  ///< curve: counts the block's pieces

  std::int64_t serial = 0;       ///< counts the program's pieces; parts of a piece have its number
  double begins = 0, scale = 1;  ///< of a part: its place p is the place begins + scale·p of the whole piece
};

/// The nearest place of a piece to a point, and how far it is.
struct Nearest {
  double place = 0;
  double distance = 0;  ///< mm
};

Nearest nearest_on_arc(const Metric& metric, const Piece& piece, const Point& point);
Nearest nearest_on_curve(const Metric& metric, const Piece& piece, const Point& point);

inline Nearest nearest_on(const Metric& metric, const Piece& piece, const Point& point) {
  if (piece.kind == Piece::Kind::arc) return nearest_on_arc(metric, piece, point);
  if (piece.kind == Piece::Kind::curve) return nearest_on_curve(metric, piece, point);
  double place = 0;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) place += (point[i] - piece.from[i]) * piece.slope[i];
  if (place <= 0) return {0, metric.distance(point, piece.from)};
  if (place >= piece.span) return {piece.span, metric.distance(point, piece.to)};
  double sum = 0;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    const double offset = point[i] - piece.from[i] - place * piece.slope[i];
    sum += offset * offset;
  }
  return {place, std::sqrt(sum)};
}

Point point_at(const Metric& metric, const Piece& piece, double place);

/// Length, mm; of a curve at most 8.3 % more than there is (turns_little).
double length_of(const Metric& metric, const Piece& piece);

/// The part between two places of a whole piece.
Piece part(const Metric& metric, const Piece& piece, double from, double to);

/// The largest distance to the chord of the points between two places of an arc or a curve, mm; both ends of that part
/// are at most `at_ends`, mm, from the chord. Where it is no larger than `negligible`, mm, any value up to that may be
/// returned.
double farthest_from_chord(const Metric& metric, const Piece& piece, double from, double to, const Chord& chord,
                           double at_ends, double negligible);

}  // namespace leadscrew::referee
