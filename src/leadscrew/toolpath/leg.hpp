#pragma once
// What one move asks for, what G64 allows it, and how long a span of a spline along it is.

#include <algorithm>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <variant>
#include <vector>

namespace leadscrew::toolpath {

/// Below it, the path is kept as programmed.
inline constexpr double least_tolerance = gcode::least_rounded;  // mm

/// The tolerances of G64.
struct Allowance {
  double tolerance = 0;      ///< P > 0, mm
  double cam_tolerance = 0;  ///< Q ≥ 0, mm

  /// Of what is fitted as a whole, mm.
  double fitted() const { return std::min(tolerance, cam_tolerance); }
  bool operator==(const Allowance&) const = default;
};

/// What both allow.
inline Allowance lesser(const Allowance& a, const Allowance& b) {
  return {std::min(a.tolerance, b.tolerance), std::min(a.cam_tolerance, b.cam_tolerance)};
}

/// What one move asks for, or several that were made one.
struct Leg {
  geometry::Curve curve;
  double feed = 0;  ///< as a Piece's
  base::Line line{};
  std::vector<LineMark> lines{};        ///< of the moves behind the first, by path length
  double spent = 0;                     ///< how far the moves may be from the curve, mm; at most most_spent of P
  FeedAxes feed_axes = FeedAxes::none;  ///< as a Piece's
  Allowance allowance{};
  std::vector<EventMark> events{};  ///< that are passed on it, by path length, its end included
  ToleranceSpace space{};           ///< in which the allowance is told, and the curve's length where rotary axes count
  double kept = 0;                  ///< of P, for chords between words where a spline is fitted (sampling.hpp), mm
};

inline constexpr double most_spent = 0.25;  // of P, by what stands for what was programmed

inline bool is_line(const geometry::Curve& curve) {
  return std::holds_alternative<geometry::Line>(curve);
}

/// By which its feed is counted.
inline FeedAxes axes_of(const Leg& leg) {
  return feed_axes(geometry::moving(leg.curve));
}

/// Millimetres of the space of tolerances (tolerance_space.hpp) per unit of the curve's length, at its start.
double millimetres_per_length(const geometry::Curve& curve, const ToleranceSpace& space);

/// As far as feed goes, mm/s.
double greatest_speed(const Leg& leg);

/// By the space of tolerances, mm.
double length_of(const Leg& leg);

/// Of a spline along the leg, mm.
double span_length(const Leg& leg);

/// Is the leg so long that it stays exact but for its ends, whatever is next to it?
bool is_long(const Leg& leg);

/// Does the second go on where the first ends with the same direction and curvature?
bool goes_on(const geometry::Curve& first, const geometry::Curve& second, const ToleranceSpace& space);

/// May any of it be fitted: is it long, or allowed a Q that machines can show?
bool may_be_fitted(const Leg& leg);

/// Where a chord from s ends that stays within `sagitta` of the curve, or nearly: at `to` at last.
double chord_end(const geometry::Curve& curve, double s, double to, double sagitta, const ToleranceSpace& space);

/// Between a curve and the chords that stand for it, mm.
double sagitta(const Leg& leg);

/// How far the polyline that stands for the leg may be from what was programmed, mm.
double spent_by(const Leg& leg);

/// How far a spline may be from the polyline of the leg, mm. P; for legs that are fitted as a whole no more than Q.
double margin_about(const Leg& leg);
/// The same with another share of the tolerance kept than splines keep.
double margin_about(const Leg& leg, double share);

/// How far chords between words may be from that polyline, mm.
double margin_of_words(const Leg& leg);

/// How far chords between words may be off at a blend within the tolerance P, mm, where no leg has spent more than
/// `spent` and none more than most_spent of its own P.
double margin_beside(double tolerance, double spent);

/// Would a curve through both lose time? Where much of a move is rotary, what the curve takes of its neighbour's travel
/// into it, no more than the tolerance, is fed as slowly as its own.
bool costs_time(const Leg& before, const Leg& behind, double tolerance);

}  // namespace leadscrew::toolpath
