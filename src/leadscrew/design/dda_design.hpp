#pragma once
// Designing a linear interpolator of DDAs: an m-bit feed DDA with the word S, whose overflows clock an n-bit DDA for
// each axis with the axis' displacement Δ as its word.
//
//   clock f ─▶ feed DDA, m bits, S ──fS/2ᵐ──▶ axis DDA, n bits, Δx ──▶ steps of x
//                                        └──▶ axis DDA, n bits, Δy ──▶ steps of y
//
// With f = 2^(m+n)/10 a minute and S = 10 V/L the axes step at V Δ/L ("Interpolators linear", lecture 12, problem 2).

#include <array>
#include <cstdint>
#include <vector>

namespace leadscrew::design {

/// What the interpolator is to be designed for. All > 0.
struct DdaRange {
  double travel_mm = 0;        ///< greatest travel of an axis
  double blu_mm = 0;           ///< of a step
  double max_feed_mm_min = 0;  ///< that a line of `min_distance_mm` is travelled at
  double min_distance_mm = 0;
};

struct DdaDesign {
  int axis_bits = 0;               ///< n: the fewest that hold the travel in steps
  int feed_bits = 0;               ///< m: the fewest that hold the greatest feed word
  std::int64_t feed_word_max = 0;  ///< S of the greatest feed along the least distance, rounded up
  double clock_pps = 0;            ///< f, pulses/s
};

DdaDesign design_dda(const DdaRange& range);

/// Its rates along one line.
struct DdaLine {
  std::vector<std::int64_t> pulses;  ///< steps of each axis, signed
  double feed_word = 0;              ///< S
  double feed_pps = 0;               ///< out of the feed DDA, pulses/s
  std::vector<double> axis_pps;      ///< steps/s of each axis, ≥ 0
  double feed_mm_min = 0;            ///< along the line
  double seconds = 0;                ///< that the line takes
};

/// A line of these displacements, mm, each a whole number of steps but for rounding; not all 0. `word_rounded`: with S
/// as a register holds it, or as it ought to be.
DdaLine along_line(const DdaDesign& design, const DdaRange& range, const std::vector<double>& delta_mm,
                   double feed_mm_min, bool word_rounded);

/// A DDA as a timer: with the load w it overflows for the first time after 2ⁿ/w clocks.
struct DdaTimer {
  int bits = 0;                     ///< the fewest with which all loads are at least 1
  std::vector<std::int64_t> loads;  ///< of each delay
  std::vector<double> seconds;      ///< that each really takes
};

/// Delays > 0, s; clock > 0, pulses/s.
DdaTimer design_timer(double clock_pps, const std::vector<double>& delays);

}  // namespace leadscrew::design
