#pragma once
// Where the knots of the speed profile lie: dense where speed may change soon, sparse along cruises, graded towards
// rest.

#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/section.hpp>
#include <vector>

namespace leadscrew::planner {

struct Knots {
  std::vector<double> s;     ///< increasing; from `start_ramp` to section length − `end_ramp`
  std::vector<bool> breaks;  ///< for each knot: q‴ or the greatest speed may jump here
  double start_ramp = 0;     ///< length of the first interval, travelled at constant path jerk from rest; > 0
  double end_ramp = 0;       ///< of the last; > 0
};

/// Path limits at one place, from the axes that its direction moves: a ≤ min a_i/|q′_i|, j ≤ min j_i/|q′_i|.
struct TangentLimits {
  double acceleration = 0, jerk = 0;
};
TangentLimits tangent_limits(const geometry::PointJet& jet, const machine::Machine& machine);

/// Knots for a section of length > 0.
Knots place_knots(const Section& section, const machine::Machine& machine);

}  // namespace leadscrew::planner
