#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>
#include <numbers>
#include <optional>
#include <random_numbers.hpp>

namespace test_piece_limits {

using leadscrew::base::Axis;
using leadscrew::base::index;
using leadscrew::constraints::LimitRatios;
using leadscrew::geometry::Arc;
using leadscrew::geometry::Line;
using leadscrew::geometry::Point;
using leadscrew::machine::AxisLimits;
using leadscrew::machine::Machine;
using leadscrew::planner::Chunk;
using leadscrew::planner::Planner;
using leadscrew::testing_support::any;
using leadscrew::testing_support::logarithmic;
using leadscrew::toolpath::Piece;

Machine random_machine() {
  Machine machine = leadscrew::machine::mill3();
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    machine.axes[index(axis)] =
        AxisLimits{-1e6, 1e6, logarithmic(5, 500), logarithmic(30, 3e4), logarithmic(500, 3e6), 0.001};
  }
  return machine;
}

Piece random_helix() {
  Point start{}, end{};
  const double radius = logarithmic(0.001, 300),
               angle = logarithmic(0.001, 40) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
  const double phase = any(0, 6283) / 1000.0, rise = any(-100, 101) / 50.0 * radius;
  const std::size_t first = any<std::size_t>(0, 3), second = (first + 1) % 3, normal = (first + 2) % 3;
  start[first] = radius * std::cos(phase);
  start[second] = radius * std::sin(phase);
  end[first] = radius * std::cos(phase + angle);
  end[second] = radius * std::sin(phase + angle);
  end[normal] = rise;
  end[index(Axis::A)] = any(-90, 91);
  const double feed = any(0, 5) == 0 ? INFINITY : logarithmic(0.5, 500);
  return {Arc(start, end, first, second, 0, 0, angle, Arc::helix_length(radius, angle, rise)), feed, {}};
}

/// The largest value over limit of any axis, looked for much more finely than the planner looks, with formulas written
/// out here.
double brute_force_ratio(const Chunk& chunk, const Machine& machine) {
  constexpr double angle_between_looks = 1e-3;  // rad
  const auto* arc = std::get_if<Arc>(&chunk.pieces[0].curve);
  double worst = 0;
  for (const auto& segment : chunk.segments) {
    const double duration = segment.duration.value();
    const double distance = leadscrew::planner::evaluate(segment, duration).s - segment.s0.value();
    const double angle = arc != nullptr ? std::abs(arc->angle_rate() * distance) : 0;
    const int looks = std::max(chunk.segments.size() <= 7 ? 2000 : 100, static_cast<int>(angle / angle_between_looks));
    for (int k = 0; k <= looks; ++k) {
      const double t = duration * k / looks;
      const double c2 = segment.c2, c3 = segment.c3, c4 = segment.c4, c5 = segment.c5;
      const double s = segment.s0.value() + t * (segment.v0.value() + t * (c2 + t * (c3 + t * (c4 + t * c5))));
      const double v = segment.v0.value() + t * (2 * c2 + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)));
      const double a = 2 * c2 + t * (6 * c3 + t * (12 * c4 + t * 20 * c5)), j = 6 * c3 + t * (24 * c4 + t * 60 * c5);
      const auto jets = leadscrew::geometry::jets(chunk.pieces[0].curve, s);
      for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
        const auto& q = jets[index(axis)];
        const AxisLimits& limits = machine.limits(axis);
        worst = std::max({worst, std::abs(q.first * v) / limits.velocity,
                          std::abs(q.second * v * v + q.first * a) / limits.acceleration,
                          std::abs(q.third * v * v * v + 3 * q.second * v * a + q.first * j) / limits.jerk});
      }
      worst = std::max(worst, v / chunk.pieces[0].feed);
    }
  }
  return worst;
}

Chunk planned(const Piece& piece, const Machine& machine) {
  Planner planner(machine, leadscrew::geometry::start(piece.curve));
  planner.push(piece);
  planner.finish();
  return *planner.pop();
}

RC_GTEST_PROP(PieceLimits, NoHelixExceedsAnyLimitAnywhere, ()) {
  const Machine machine = random_machine();
  const double excess = brute_force_ratio(planned(random_helix(), machine), machine) - 1;
  RC_LOG() << "excess " << excess << '\n';
  RC_ASSERT(excess <= 1e-9);
}

RC_GTEST_PROP(PieceLimits, LinesMeetOneLimitExactly, ()) {
  const Machine machine = random_machine();
  Point start{}, end{};
  for (const std::size_t i : {0, 1, 2, 3}) end[i] = any(-100000, 100001) / 1000.0;
  const double length = std::hypot(end[0], end[1], end[2]);
  RC_PRE(length > 0);
  const Piece piece{Line(start, end, length), logarithmic(0.5, 500), {}};
  const double worst = brute_force_ratio(planned(piece, machine), machine);
  RC_ASSERT(worst <= 1 + 1e-9);
  RC_ASSERT(worst >= 1 - 1e-9);  // the jerk limit of one axis is in force, or it would not be the fastest
}

RC_GTEST_PROP(PieceLimits, PlanRatiosAgreeWithBruteForce, ()) {
  const Machine machine = random_machine();
  const Piece piece = random_helix();
  const Chunk chunk = planned(piece, machine);
  LimitRatios ratios;
  leadscrew::planner::raise_limit_ratios(chunk, machine, ratios);
  const double worst = ratios.greatest();
  double fine = 0;
  Chunk without_feed = chunk;
  without_feed.pieces[0].feed = INFINITY;
  fine = brute_force_ratio(without_feed, machine);
  // Between its looks the brute force misses up to some (angle/2)²/2 of a peak that the other happens to look at.
  RC_ASSERT(worst <= fine * (1 + 1e-6) + 1e-12);
  RC_ASSERT(worst >= fine * (1 - 2e-3));
}

/// What plan_piece() promises of an arc of any angle, not of the short ones alone that are planned by it: in its plane
/// the whole amplitude of acceleration and jerk, radial and tangential, 3ωva with it.
RC_GTEST_PROP(PieceLimits, NoMotionAlongAnArcExceedsTheAmplitudeOfItsPlane, ()) {
  const Machine machine = random_machine();
  const Piece piece = random_helix();
  const Arc& arc = *std::get_if<Arc>(&piece.curve);
  const leadscrew::planner::RestToRest motion = leadscrew::planner::plan_piece(piece, machine);
  const AxisLimits& one = machine.limits(leadscrew::base::all_axes[arc.first()]);
  const AxisLimits& other = machine.limits(leadscrew::base::all_axes[arc.second()]);
  const double w = std::abs(arc.angle_rate()), amplitude = arc.radius() * w;
  double v = 0, a = 0, worst = 0;
  const std::array<std::array<double, 2>, 3> phases = {
      {{motion.jerk, motion.jerk_time}, {0, motion.acceleration_time}, {-motion.jerk, motion.jerk_time}}};
  for (const auto& [jerk, duration] : phases) {
    constexpr int samples = 1000;
    for (int k = 0; k <= samples; ++k) {
      const double t = duration * k / samples, at = a + jerk * t, vt = v + t * (a + jerk * t / 2);
      const double acceleration = amplitude * std::hypot(w * vt * vt, at);
      const double third = amplitude * std::hypot(jerk - w * w * vt * vt * vt, 3 * w * vt * at);
      worst = std::max({worst, acceleration / std::min(one.acceleration, other.acceleration),
                        third / std::min(one.jerk, other.jerk)});
    }
    v += duration * (a + jerk * duration / 2);
    a += jerk * duration;
  }
  RC_ASSERT(worst <= 1 + 1e-9);
}

TEST(PieceLimits, FullCircleIsNotFarFromTheOptimum) {
  // R = 10 mm; the jerk-limited optimum along the circle is 0.783 s at 100 mm/s and 6.328 s at 10 mm/s.
  const Machine machine = leadscrew::machine::mill3();
  Point start{};
  start[0] = 10;
  const auto sweep = leadscrew::geometry::sweep_angle(10, 0, 10, 0, 1);
  const Arc circle(start, start, 0, 1, 0, 0, sweep, Arc::helix_length(10, sweep, 0));
  const double fast = leadscrew::planner::plan_piece({circle, 100, {}}, machine).duration();
  const double slow = leadscrew::planner::plan_piece({circle, 10, {}}, machine).duration();
  EXPECT_GE(fast, 0.783 * 0.998);
  EXPECT_LE(fast, 0.783 * 1.10);
  EXPECT_GE(slow, 6.328 * 0.998);
  EXPECT_LE(slow, 6.328 * 1.002);
  std::printf("full circle R10: F100 %.4f s, F10 %.4f s\n", fast, slow);
}

}  // namespace test_piece_limits
