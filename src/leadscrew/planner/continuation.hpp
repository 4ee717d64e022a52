#pragma once
// What a window that begins in motion takes over from the one before.

#include <cstddef>
#include <vector>

namespace leadscrew::planner {

struct Continuation {
  std::vector<double> s;          ///< knots from where it begins on, on the section
  std::vector<bool> breaks;       ///< of these
  double end_ramp = 0;            ///< after the last of them; 0 if it ends in motion
  std::vector<double> c;          ///< coefficients of the spline clamped where it begins, as far as they are known
  std::size_t creeping = 0;       ///< the first of them that may yet be lowered; those before must stay
  std::size_t loose = 0;          ///< intervals whose rows need not be tightened for a stop
  std::vector<double> tightened;  ///< of each interval, ≥ 1: how far its rows were
  double share = 1;               ///< of the creep profile, for what follows them

  /// A knot more, between the first and the last; the spline stays as it is. The parts of an interval that it divides
  /// are tightened as that was.
  void insert(double knot);
};

}  // namespace leadscrew::planner
