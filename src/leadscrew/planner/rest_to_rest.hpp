#pragma once
// The fastest motion over a distance from rest to rest within bounds of speed, acceleration and jerk: seven phases of
// constant jerk, symmetric in time.
//
//   jerk  +J |--|        |--|          phase  1 2 3   4   5 6 7
//            |  |--------|  |----      time   j a j   c   j a j
//         -J       |--|   |--|

#include <leadscrew/machine/derivatives.hpp>

namespace leadscrew::planner {

/// Durations in seconds; the whole motion takes 4·jerk_time + 2·acceleration_time + cruise_time.
struct RestToRest {
  double jerk = 0;               ///< the jerk in force, units/s³
  double jerk_time = 0;          ///< phases 1, 3, 5, 7
  double acceleration_time = 0;  ///< phases 2, 6
  double cruise_time = 0;        ///< phase 4

  double duration() const { return 4 * jerk_time + 2 * acceleration_time + cruise_time; }
  double peak_acceleration() const { return jerk * jerk_time; }
  double peak_speed() const { return peak_acceleration() * (jerk_time + acceleration_time); }
};

/// Over a distance > 0, within bounds along the path: units of its length and seconds, all > 0, velocity may be
/// infinite. With V, A, J the bounds, L the distance and V_p the peak speed:
///   V_p = V, reached with or without a phase of constant acceleration (V ≥ or < A²/J), where the two ramps fit into L;
///   else L = V_p (V_p/A + A/J), a quadratic in V_p, where A is reached;
///   else L = 2 J t_j³.
RestToRest rest_to_rest(double distance, const machine::Derivatives& limits);

}  // namespace leadscrew::planner
