#include <algorithm>
#include <cmath>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/section.hpp>

namespace leadscrew::planner {

namespace {

using base::Axis;

/// q̇ = q′v, q̈ = q″v² + q′a, q⃛ = q‴v³ + 3q″va + q′j.
void raise(AxisRatios& ratios, const numeric::Jet& q, const PathState& at, const machine::AxisLimits& limits) {
  const double v = at.speed, a = at.acceleration;
  const double velocity = q.first * v;
  const double acceleration = q.second * v * v + q.first * a;
  const double jerk = q.third * v * v * v + 3 * q.second * v * a + q.first * at.jerk;
  ratios.velocity = std::max(ratios.velocity, std::abs(velocity) / limits.velocity);
  ratios.acceleration = std::max(ratios.acceleration, std::abs(acceleration) / limits.acceleration);
  ratios.jerk = std::max(ratios.jerk, std::abs(jerk) / limits.jerk);
}

/// Along a line every derivative is largest where a segment begins or ends: its polynomial is a cubic whose
/// acceleration is monotonic and whose speed turns only where acceleration is 0, at a knot. On a curve the axes trade
/// places with the angle: look at least every 0.05 rad, 6 times a polynomial and 8 times a segment.
int looks(const geometry::Curve& curve, const Segment& segment) {
  if (std::holds_alternative<geometry::Line>(curve)) return segment.c4 == 0 && segment.c5 == 0 ? 1 : 8;
  const double begin = segment.s0.value(), end = evaluate(segment, segment.duration.value()).s;
  const auto* arc = std::get_if<geometry::Arc>(&curve);
  if (!arc) return std::clamp(6 * static_cast<int>(geometry::borders(curve, begin, end) + 1), 8, 256);
  const double angle = arc->angle_rate() * (end - begin);
  return std::clamp(static_cast<int>(std::abs(angle) / 0.05), 8, 256);
}

}  // namespace

void raise_limit_ratios(const geometry::PointJet& jet, const PathState& at, const machine::Machine& machine,
                        LimitRatios& ratios) {
  for (const Axis axis : base::all_axes) {
    if (machine.has(axis)) raise(ratios[base::index(axis)], jet[base::index(axis)], at, machine.limits(axis));
  }
}

void raise_limit_ratios(const Chunk& chunk, const machine::Machine& machine, LimitRatios& ratios) {
  for (const Segment& segment : chunk.segments) {
    if (segment.state == base::MotionState::rest) continue;
    const geometry::Curve& curve = chunk.pieces[segment.piece].curve;
    const int count = looks(curve, segment);
    for (int k = 0; k <= count; ++k) {
      const PathState at = evaluate(segment, segment.duration.value() * k / count);
      raise_limit_ratios(one_sided_jets(curve, at.s, k == 0 ? Side::right : Side::left), at, machine, ratios);
    }
  }
}

}  // namespace leadscrew::planner
