#pragma once
// Koren's two codes of feed ("Interpolator for a computer numerical control system", eqs. 14 to 21), each with the
// clock that its DDAs need: of the hardware, whose registers have one capacity for all blocks, and of the program,
// which gives each block its own.
//
//   clock w0 ─▶ feed DDA, capacity q0, word f ──w0 f/q0──▶ DDAs of the axes, capacity q ─▶ V = w0 f/q0 · L/q

#include <cstdint>

namespace leadscrew::stepping {

/// f is the reciprocal of a block's time in tenths of a 1/min: f = 600 V/L along a line, 600 V/R along an arc.
struct InverseTimeCode {
  std::int64_t capacity = 0;       ///< q: the longest way of a block, BLU; > 0
  std::int64_t feed_capacity = 0;  ///< q0: as many words of feed as there are; > 0

  /// Eq. 18: w0, pulses/s.
  constexpr double clock_pps() const {
    return static_cast<double>(capacity) * static_cast<double>(feed_capacity) / 600;
  }
  /// Eqs. 16 and 17: f for V in BLU/s along a line of this length, or an arc of this radius, BLU > 0.
  static constexpr double word(double feed_pps, double length) { return 600 * feed_pps / length; }
};

/// f is the feed itself, by the step that it is told in; q = L along a line, R along an arc.
struct DirectFeedCode {
  double max_feed_mm_min = 0;    ///< > 0
  double resolution_mm_min = 0;  ///< of the feed word, > 0
  double blu_mm = 0;             ///< > 0

  /// w0, pulses/s: a command at each where feed is greatest.
  constexpr double clock_pps() const { return max_feed_mm_min / 60 / blu_mm; }
  /// q0
  constexpr double feed_capacity() const { return max_feed_mm_min / resolution_mm_min; }
  /// Eq. 21.
  constexpr double word(double feed_mm_min) const { return feed_mm_min / resolution_mm_min; }
};

}  // namespace leadscrew::stepping
