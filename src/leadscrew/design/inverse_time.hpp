#pragma once
// Feed words of Koren's interpolators. Distances in one unit, feeds in that unit a minute.
//
// Hardware: the block carries the inverse of its time, whatever its length.
//
//   f = 10 V₀/l = 600 V/L (lines, 14, 16),  f = 10 V₀/r = 600 V/R (arcs, 15, 17),  w₀ = q q₀/600 (18)
//
//   V₀ feed, l or r distance; V steps/s, L or R steps; q capacity of the axis integrators: the greatest distance in
//   steps; q₀ that of the feed's: f < q₀, a power of ten; w₀ clock, pulses/s
//
// Software: q = L or R, so that f is the feed itself, in units of its resolution.
//
//   V = w₀ f/q₀ (20),  f = V₀/resolution (21),  q₀ = f of the greatest feed,  w₀ = the greatest feed in steps/s
//
// ("Interpolator for a computer numerical control system")

#include <cstdint>

namespace leadscrew::design {

/// All > 0.
struct InverseTimeRange {
  double max_distance = 0;  ///< greatest length of a line, greatest radius of an arc
  double blu = 0;           ///< of a step
  double max_feed = 0;
  double resolution = 0;  ///< of the feed, in software
  int digits = 4;         ///< of the f-number; EIA has 4
};

/// Clocks and capacities.
struct InverseTimeDesign {
  std::int64_t capacity = 0;       ///< q
  std::int64_t feed_capacity = 0;  ///< q₀
  double clock_pps = 0;            ///< w₀ (18)

  std::int64_t software_feed_capacity = 0;  ///< q₀ where q = L or R
  double software_clock_pps = 0;            ///< w₀ there: interrupts/s
};

InverseTimeDesign design_inverse_time(const InverseTimeRange& range);

/// One block's word, and what becomes of it.
struct FeedWord {
  double word = 0;      ///< f
  double feed = 0;      ///< along the path
  double feed_pps = 0;  ///< V
};

/// By (14) or (15): a line of this length or an arc of this radius. `rounded`: as its digits hold it, or as it ought to
/// be.
FeedWord inverse_time_word(const InverseTimeRange& range, double distance, double feed, bool rounded);

/// By (20) and (21).
FeedWord software_word(const InverseTimeRange& range, double feed, bool rounded);

}  // namespace leadscrew::design
