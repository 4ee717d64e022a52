#pragma once
// A curve travelled at constant speed by one of the rules of parameter steps: word after word, how far apart words are,
// and how far the curve leaves the chords between them.

#include <cstdint>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>

namespace leadscrew::study {

struct March {
  std::int64_t steps = 0;       ///< whole ones; the last, which ends at the curve's end, is not judged
  double feed_error_max = 0;    ///< |C(u_k+1) − C(u_k)|/(VT) − 1, the greatest
  double feed_error_min = 0;    ///< the least
  double arc_error = 0;         ///< the greatest size of the same with the arc length in place of the chord
  double chord_error = 0;       ///< mm: greatest distance of the curve from the chord between consecutive words
  double chord_error_rule = 0;  ///< mm: greatest (VT)²/(8ρ) along the curve
};

/// V in mm/s, T in seconds, both > 0. Gives up after 10 million steps.
March march(const geometry::Nurbs& curve, interpolator::StepRule rule, double speed, double period);

}  // namespace leadscrew::study
