#pragma once
// What steps follow between two words: one cubic for each axis and servo period, through both words with a speed at
// each. x is 0 at the first word and 1 at the second; positions are BLU.
//
// The speed at a word is half the displacement from the word before to the word after. That is wrong by jerk·T²/6 only,
// so the cubic strays from a motion whose words it follows by a twentieth of jerk·T³, where straight lines between
// words would stray by acceleration·T²/8: with the limits of mill3 and T = 1 ms, 0.001 BLU instead of 0.125 BLU, and
// steps at 200 mm/s lie right to 1/200 of a microsecond instead of 0.6 µs. Next to a turn between two words the cubic
// strays as lines do: there, staying between the words (below) takes speed away.

#include <algorithm>
#include <cmath>

namespace leadscrew::steps {

/// Speed at a word, BLU a period, from the displacements to it and from it. The cubic never leaves the range of its
/// words where these run in one direction, and it rests where they rest. `sharpest`: the difference of the two
/// displacements, BLU, up to which words that turn back are taken for a smooth turn, whose summit may lie between
/// words; beyond it they turn at the word.
inline double speed_between(double before, double after, double sharpest) {
  if (before * after > 0) {
    const double most = 3 * std::min(std::fabs(before), std::fabs(after));
    return std::clamp((before + after) / 2, -most, most);
  }
  if (before == 0 || after == 0) return 0;
  return std::fabs(after - before) <= sharpest ? (before + after) / 2 : 0;
}

/// The cubic of one axis in one period.
struct Span {
  double begin = 0;         ///< at x = 0, BLU
  double displacement = 0;  ///< to x = 1, BLU
  double speed_begin = 0;   ///< BLU a period
  double speed_end = 0;     ///< BLU a period

  /// From the first word, BLU.
  double displacement_at(double x) const {
    return x == 1 ? displacement : x * (speed_begin + x * (square() + x * cube()));
  }
  double speed_at(double x) const { return speed_begin + x * (2 * square() + x * 3 * cube()); }
  double square() const { return 3 * displacement - 2 * speed_begin - speed_end; }
  double cube() const { return speed_begin + speed_end - 2 * displacement; }
};

/// Where the cubic turns back, in order: roots of its speed inside 0 … 1. Returns how many, at most 2.
inline int turning_points(const Span& span, double (&at)[2]) {
  // speed = a + 2bx + cx²
  const double a = span.speed_begin, b = span.square(), c = 3 * span.cube();
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return 0;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  double roots[2] = {c != 0 ? q / c : 2, q != 0 ? a / q : 2};
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  int count = 0;
  for (const double root : roots) {
    if (0 < root && root < 1) at[count++] = root;
  }
  return count;
}

}  // namespace leadscrew::steps
