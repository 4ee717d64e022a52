#pragma once
// The tube around a programmed path in X and Y: every point within the tolerance of it. A motion inside the tube that
// passes every joint within the tolerance keeps it in both directions: words to path and path to words.

#include <cmath>
#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/study/curves.hpp>
#include <vector>

namespace leadscrew::study {

/// A point or a direction in X and Y.
struct PlaneVector {
  double x = 0, y = 0;

  friend PlaneVector operator+(PlaneVector a, PlaneVector b) { return {a.x + b.x, a.y + b.y}; }
  friend PlaneVector operator-(PlaneVector a, PlaneVector b) { return {a.x - b.x, a.y - b.y}; }
  friend PlaneVector operator*(double factor, PlaneVector a) { return {factor * a.x, factor * a.y}; }
};
inline double dot(PlaneVector a, PlaneVector b) {
  return a.x * b.x + a.y * b.y;
}
inline double norm(PlaneVector a) {
  return std::sqrt(dot(a, a));
}

/// A line, or an arc of at most a whole turn.
struct TubeLeg {
  PlaneVector from, to;    ///< mm
  bool is_arc = false;     ///< else a line
  PlaneVector center;      ///< of an arc, mm
  double radius = 0;       ///< of an arc, mm
  double first_angle = 0;  ///< of an arc, from its centre to its beginning, radians
  double turn = 0;         ///< of an arc, radians, counterclockwise positive

  double length() const { return is_arc ? radius * std::abs(turn) : norm(to - from); }
  /// `part`: 0 at its beginning, 1 at its end.
  PlaneVector at(double part) const;
};

struct Tube {
  std::vector<TubeLeg> legs;  ///< each begins where the one before ends
  double tolerance = 0;       ///< mm
  double feed = 0;            ///< greatest speed along the path, mm/s; no more than the velocity of an axis
  double acceleration = 0;    ///< of X and of Y, mm/s²
  double jerk = 0;            ///< of X and of Y, mm/s³
};

/// The tube of a program of lines and arcs in X and Y at one feed, blended within one tolerance, on a machine whose X
/// and Y have the same limits. Errors: the first problem of the program; a program that is none of this.
base::Result<Tube> tube_of(const PartProgram& program, const machine::Machine& machine);

}  // namespace leadscrew::study
