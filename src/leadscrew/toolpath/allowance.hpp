#pragma once
// What the tolerances of G64 allow a leg of the path, and how long a span of a spline along it is.

#include <algorithm>
#include <leadscrew/toolpath/reduction.hpp>

namespace leadscrew::toolpath {

/// Below it, the path is kept as programmed: no machine could show the difference.
inline constexpr double least_tolerance = 2e-4;  // mm

struct Allowance {
  double tolerance = 0;      ///< P > 0, mm
  double cam_tolerance = 0;  ///< Q ≥ 0, mm

  /// Of a spline along the leg, mm.
  double span_length(const Leg& leg) const;
  /// Is the leg so long that it stays exact but for its ends, whatever is next to it?
  bool is_long(const Leg& leg) const;
  /// The tolerance of the leg, mm: P; for legs that are fitted as a whole no more than Q.
  double tolerance_of(const Leg& leg) const { return is_long(leg) ? tolerance : std::min(tolerance, cam_tolerance); }
  /// Between a curve and the chords that stand for it, mm.
  double sagitta(const Leg& leg) const { return arc_sagitta * tolerance_of(leg); }
  /// How far the polyline that stands for the leg may be from what was programmed, mm.
  double spent_by(const Leg& leg) const { return leg.spent + (is_line(leg.curve) ? 0 : sagitta(leg)); }
  /// How far a spline may be from the polyline of the leg, mm.
  double margin_about(const Leg& leg) const { return kept_share * tolerance_of(leg) - spent_by(leg); }
  /// How far a blend may be off where `spent` of the tolerance is used already, mm.
  double margin_beside(double spent) const { return kept_share * tolerance - spent; }

 private:
  static constexpr double kept_share = 0.98;   // the rest is for the rounding of words and of samples
  static constexpr double arc_sagitta = 0.02;  // of the leg's tolerance
};

/// As far as feed goes, mm/s.
double greatest_speed(const Leg& leg);

/// By the space of tolerances, mm.
double length_of(const Leg& leg);

}  // namespace leadscrew::toolpath
