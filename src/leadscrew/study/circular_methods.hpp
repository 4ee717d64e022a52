#pragma once
// The circular interpolators of pulse/ in each of their conventions, with what is known of each.

#include <leadscrew/study/lattice_path.hpp>
#include <string>
#include <vector>

namespace leadscrew::study {

struct FollowedArc {
  LatticePath path;
  int drained = 0;  ///< pulses that came of an axis left over with an integrand of 0
};

/// A bound that was found by trying all circles up to this radius.
struct CircleBound {
  double error = 0;  ///< BLU
  int decimals = 0;
  std::int64_t radius = 0;
};

inline constexpr double no_bound = 0;  ///< was told
inline constexpr const char* untold_bound = "the table of bounds has none";

struct CircularMethod {
  std::string name;
  FollowedArc (*follow)(const pulse::Arc&);
  double clocks_by_radius;  ///< on a full circle
  std::vector<CircleBound> circles;
  double one_quadrant = no_bound, more = no_bound;  ///< bounds of arcs, BLU
  std::int64_t exception = 0;                       ///< R² of arcs that keep another bound
  int endless = -1;  ///< arcs that would not end without the drain rule, all of irrational R
};

const std::vector<CircularMethod>& circular_methods();

}  // namespace leadscrew::study
