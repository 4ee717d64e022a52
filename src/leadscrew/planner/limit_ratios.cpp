#include <algorithm>
#include <cmath>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/section.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

constexpr double no_feed = std::numeric_limits<double>::infinity();

/// Along a line every derivative is largest where a segment begins or ends: its polynomial is a cubic whose
/// acceleration is monotonic and whose speed turns only where acceleration is 0, at a knot. On a curve the axes' shares
/// change with the angle: look at least every 0.05 rad, 3 times a polynomial and 4 times a segment.
int looks(const toolpath::AxisPath& axes, const Segment& segment) {
  constexpr int fewest = 4;
  if (axes.line()) return segment.c4 == 0 && segment.c5 == 0 ? 1 : fewest;
  const double begin = segment.s0.value(), end = evaluate(segment, segment.duration.value()).s;
  const geometry::Arc* arc = axes.arc();
  if (!arc) return std::clamp(3 * static_cast<int>(axes.borders(begin, end) + 1), fewest, 256);
  const double angle = arc->angle_rate() * (end - begin);
  return std::clamp(static_cast<int>(std::abs(angle) / 0.05), fewest, 256);
}

}  // namespace

void raise_limit_ratios(const Chunk& chunk, const constraints::Constraints& constraints,
                        constraints::LimitRatios& ratios) {
  for (const Segment& segment : chunk.segments) {
    if (segment.state == base::MotionState::rest) continue;
    const toolpath::AxisPath axes = chunk.pieces[segment.piece].axes();
    const int count = looks(axes, segment);
    const auto look = [&](double time, Side side) {
      const PathState at = evaluate(segment, time);
      const geometry::PointJet jet = one_sided_jets(axes, at.s, side);
      constraints.raise({jet, no_feed}, rates(at), ratios);
    };
    const double duration = segment.duration.value();
    for (int k = 0; k <= count; ++k) look(duration * k / count, k == 0 ? Side::right : Side::left);
    for (const double s : axes.breaks(segment.s0.value(), evaluate(segment, duration).s)) {
      for (const Side side : {Side::left, Side::right}) look(time_at(segment, s), side);
    }
  }
}

}  // namespace leadscrew::planner
