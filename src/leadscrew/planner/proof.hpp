#pragma once
// The proof that a motion keeps every limit: what the cycle will evaluate, looked at at samples, and between them by
// parabolas.

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/speed_bounds.hpp>

namespace leadscrew::planner {

/// Samples of the proof on a segment between knots; the closer ones where knots lie far apart for how speed falls.
inline constexpr int usual_looks = 12, close_looks = 32;
inline constexpr int stop_looks = 64;  ///< on a whole stop, which passes many knots
/// The largest ratios of speed, and of acceleration and jerk, seen where a segment is parted into `looks` or one more,
/// and between them where that may exceed a limit. Speed is judged by `feed_factor` times the programmed one, too. A
/// motion that turns back counts as one that exceeds acceleration by half, so that it is planned again deeper inside the
/// limits.
Ratios greatest_ratios(const Segment& segment, const Section& section, const constraints::Constraints& constraints,
                       double feed_factor, int looks);

}  // namespace leadscrew::planner
