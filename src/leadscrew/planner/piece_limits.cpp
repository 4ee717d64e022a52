#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/piece_limits.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using base::Axis;

/// What an arc's motion must keep: bounds of the straight axes and the feed, and of the plane, divided by the amplitude
/// g.
struct ArcBounds {
  machine::Derivatives straight;
  machine::Derivatives plane;
  double curvature = 0;  ///< |ω|, rad per unit of length
};

/// Slowing time by this factor brings every ratio to 1 or below: v, a, j fall with its first, second and third power.
double time_factor(const machine::Derivatives& ratios) {
  return std::max({ratios.velocity, std::sqrt(ratios.acceleration), numeric::cbrt(ratios.jerk)});
}

/// The greatest of g-less in-plane jerk squared, (j − ω²v³)² + (3ωva)², is bounded over a stretch in which v and |a|
/// stay between their values at its ends.
double jerk_bound(double curvature, double v0, double v1, double a0, double a1, double jerk) {
  const double w = curvature, a = std::max(std::abs(a0), std::abs(a1)), v = std::max(v0, v1);
  const double radial = std::max(std::abs(jerk - w * w * v0 * v0 * v0), std::abs(jerk - w * w * v1 * v1 * v1));
  return numeric::hypot(radial, 3 * w * v * a);
}

/// Proven worst case of a motion on an arc, values over bounds. The braking half mirrors the first in time (a changes
/// its sign, j does not), which leaves every magnitude as it is. The first three phases are cut into stretches and
/// bounded on each.
machine::Derivatives worst_case(const ArcBounds& bounds, const RestToRest& motion) {
  constexpr int stretches = 12;
  const double w = bounds.curvature, peak = motion.peak_speed();
  double acceleration = w * peak * peak, jerk = w * w * peak * peak * peak;  // cruising
  double v = 0, a = 0;
  const std::array<std::array<double, 2>, 3> phases = {
      {{motion.jerk, motion.jerk_time}, {0, motion.acceleration_time}, {-motion.jerk, motion.jerk_time}}};
  for (const auto& [j, duration] : phases) {
    if (duration == 0) continue;
    const double v_begin = v, a_begin = a;
    for (int k = 1; k <= stretches; ++k) {
      const double tau = duration * k / stretches;
      const double a_next = a_begin + j * tau, v_next = v_begin + tau * (a_begin + j * tau / 2);
      acceleration = std::max(acceleration, numeric::hypot(w * v_next * v_next, std::max(a, a_next)));
      jerk = std::max(jerk, jerk_bound(w, v, v_next, a, a_next, j));
      v = v_next;
      a = a_next;
    }
  }
  const machine::Derivatives &straight = bounds.straight, &plane = bounds.plane;
  return {std::max(peak / straight.velocity, peak / plane.velocity),
          std::max(motion.peak_acceleration() / straight.acceleration, acceleration / plane.acceleration),
          std::max(motion.jerk / straight.jerk, jerk / plane.jerk)};
}

RestToRest slowed(const RestToRest& motion, double factor) {
  return {motion.jerk / (factor * factor * factor), motion.jerk_time * factor, motion.acceleration_time * factor,
          motion.cruise_time * factor};
}

/// The candidate's motion, its time scaled so that the worst case just meets the bounds.
RestToRest admissible(double length, const ArcBounds& bounds, const machine::Derivatives& candidate) {
  const RestToRest motion = rest_to_rest(length, candidate);
  return slowed(motion, time_factor(worst_case(bounds, motion)));
}

/// Coordinate search over the logarithms of the three bounds, with steps that halve.
RestToRest fastest(double length, const ArcBounds& bounds) {
  const machine::Derivatives &straight = bounds.straight, &plane = bounds.plane;
  const double w = bounds.curvature;
  machine::Derivatives best{std::min({straight.velocity, plane.velocity, 0.9 * std::sqrt(plane.acceleration / w),
                                      0.9 * numeric::cbrt(plane.jerk / (w * w))}),
                            0.9 * std::min(straight.acceleration, plane.acceleration),
                            0.9 * std::min(straight.jerk, plane.jerk)};
  RestToRest motion = admissible(length, bounds, best);
  constexpr std::array<double machine::Derivatives::*, 3> coordinates = {
      &machine::Derivatives::velocity, &machine::Derivatives::acceleration, &machine::Derivatives::jerk};
  double step = 1.4;
  for (int round = 0; round < 8; ++round) {
    bool better = false;
    for (const auto coordinate : coordinates) {
      for (const double factor : {step, 1 / step}) {
        machine::Derivatives candidate = best;
        candidate.*coordinate *= factor;
        const RestToRest tried = admissible(length, bounds, candidate);
        if (tried.duration() >= motion.duration()) continue;
        best = candidate;
        motion = tried;
        better = true;
      }
    }
    if (!better) step = std::sqrt(step);
  }
  return motion;
}

RestToRest plan(const geometry::Arc& arc, double feed, const constraints::Constraints& constraints) {
  const Axis first = base::all_axes[arc.first()], second = base::all_axes[arc.second()];
  base::AxisSet plane;
  plane.insert(first);
  plane.insert(second);
  ArcBounds bounds;
  bounds.straight = constraints.along_tangent({arc.jets(0), feed}, plane);
  bounds.curvature = std::abs(arc.angle_rate());
  const double amplitude = arc.radius() * bounds.curvature;
  const machine::Derivatives one = constraints.of_axis(first), other = constraints.of_axis(second);
  bounds.plane = {std::min(one.velocity, other.velocity) / amplitude,
                  std::min(one.acceleration, other.acceleration) / amplitude,
                  std::min(one.jerk, other.jerk) / amplitude};
  return fastest(arc.length(), bounds);
}

}  // namespace

machine::Derivatives line_limits(const geometry::Line& line, const constraints::Constraints& constraints) {
  return constraints.along_tangent({line.jets(0), std::numeric_limits<double>::infinity()});
}

RestToRest plan_piece(const toolpath::Piece& piece, const constraints::Constraints& constraints) {
  const geometry::PointJet jet = piece.axes().jets(0);
  const double feed = piece.greatest_speed(0, jet);  // everywhere the same
  if (const geometry::Arc* arc = piece.axes().arc()) return plan(*arc, feed, constraints);
  return rest_to_rest(piece.axes().length(), constraints.along_tangent({jet, feed}));
}

}  // namespace leadscrew::planner
