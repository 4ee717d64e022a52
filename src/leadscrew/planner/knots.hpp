#pragma once
// Where the knots of the speed profile lie: dense where speed may change soon, sparse along cruises, graded towards
// rest.

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/effort.hpp>
#include <leadscrew/planner/section.hpp>
#include <vector>

namespace leadscrew::planner {

/// Of a window of a section. A window that begins or ends at rest has a ramp there, an interval of its own beyond the
/// knots; one that ends in motion has knots beyond its last interval.
struct Knots {
  std::vector<double> s;      ///< increasing, on the section
  std::vector<bool> breaks;   ///< for each knot: q‴ may jump or bend here, or the greatest speed jump
  std::size_t intervals = 0;  ///< between the first `intervals` + 1 knots
  double start_ramp = 0;      ///< length travelled at constant path jerk from rest before the first knot; 0 in motion
  double end_ramp = 0;        ///< after the last; 0 if the window ends in motion
  bool free_end = false;      ///< in motion, at any speed: the window's motion at its end is never travelled
};

/// Path limits at one place, from the axes that its direction moves: a ≤ min a_i/|q′_i|, j ≤ min j_i/|q′_i|. Feed is
/// not asked.
machine::Derivatives tangent_limits(const geometry::PointJet& jet, const constraints::Constraints& constraints);

/// To come to rest from a constant speed ≥ 0, units/s: v/a + a/j, or 2√(v/j) where a is not reached; s.
double stop_time(double speed, const machine::Derivatives& limits);

/// The part of a section that is to be planned as one window.
struct PlannedRange {
  double begin = 0;  ///< on the section
  double end = 0;    ///< > begin
  bool starts_at_rest = true;
  bool ends_at_rest = true;  ///< otherwise the path goes on beyond `end`, but nothing is known of it
  double feed_factor = 1;    ///< of the programmed feed
  double closeness = 1;      ///< of knots while speed rises or falls, to what is usual; ≥ 1
  /// Knots from `begin` on that are there already, at least 2 unless it starts at rest; what is new begins at the last.
  std::vector<double> kept;
  std::vector<bool> kept_breaks;
  double kept_end_ramp = 0;  ///< if > 0, no other end comes
  /// If > 0, ṡ² at `begin`, in motion, from where speed is to be another: knots come between those kept there.
  double changes_from = 0;
};

/// Distance between two of the knots where speed √x may rise or fall as fast as it can.
double ramp_width(const machine::Derivatives& limits, double x);

/// Knots along the range, at most about `most` intervals: fewer than reach its end if they would be more.
/// Complete only if the effort still goes on afterwards.
Knots place_knots(const Section& section, const constraints::Constraints& constraints, const PlannedRange& range,
                  std::size_t most, Effort& effort);
/// With all the effort of one window.
inline Knots place_knots(const Section& section, const constraints::Constraints& constraints, const PlannedRange& range,
                         std::size_t most) {
  Effort effort;
  return place_knots(section, constraints, range, most, effort);
}

}  // namespace leadscrew::planner
