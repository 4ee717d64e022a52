#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/pipeline/motion_source.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "blended.hpp"

// Wherever no more motion comes, the tail of the slice that came last brings the machine to rest. At 100 mm/s on the
// built-in mill (1000 mm/s², 20000 mm/s³) a stop along an axis takes v²/2a + va/2j = 7.5 mm.

namespace test_tails {

using namespace leadscrew;

constexpr double straight_stop = 7.5;  // mm

/// Numbers in [0, 1) that are the same everywhere.
class Draws {
 public:
  explicit Draws(std::uint32_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 33) / 2147483648.0;
  }

 private:
  std::uint64_t state_;
};

/// Lines of 0.2 mm to `longest` that turn by `bend` rad at most, blended within `tolerance` mm.
std::string short_lines(std::uint32_t seed, double bend, double longest, double tolerance, int count) {
  Draws draws(seed);
  std::string text = "G21 G90 G17 G94 F6000 G64" + testing_support::word('P', tolerance, 3) + "\n";
  double x = 0, y = 0, angle = 0;
  for (int k = 0; k < count; ++k) {
    angle += bend * (2 * draws.next() - 1);
    const double length = 0.2 * std::pow(longest / 0.2, draws.next());
    x += length * std::cos(angle), y += length * std::sin(angle);
    text += "G1" + testing_support::word('X', x, 3) + testing_support::word('Y', y, 3) + "\n";
  }
  return text + "M2\n";
}

/// Axis by axis from positions at even steps of the tail: first, second and third differences, which are means of what
/// they stand for, over their limits.
double worst_difference(const planner::Chunk& chunk, const machine::Machine& machine) {
  constexpr double step = 0.5e-3;  // s
  const auto position = [&](double t) {
    std::size_t k = 0;
    while (k + 1 < chunk.stop_tail.size() && chunk.stop_tail[k + 1].begin.value() <= t) ++k;
    const planner::Segment& segment = chunk.stop_tail[k];
    const double s = planner::evaluate(segment, t - segment.begin.value()).s;
    return chunk.pieces[segment.piece].axes().position(s);
  };
  const planner::Segment& last = chunk.stop_tail.back();
  const double begin = chunk.end().value(), duration = (last.begin + last.duration).value() - begin;
  std::vector<geometry::Point> points;
  for (int k = 0; k * step <= duration; ++k) points.push_back(position(begin + k * step));
  double worst = 0;
  for (std::size_t k = 3; k < points.size(); ++k) {
    for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
      const std::size_t i = base::index(axis);
      const double q0 = points[k - 3][i], q1 = points[k - 2][i], q2 = points[k - 1][i], q3 = points[k][i];
      const machine::AxisLimits& limits = *machine.axes[i];
      worst = std::max({worst, std::abs(q3 - q2) / step / limits.velocity,
                        std::abs(q3 - 2 * q2 + q1) / (step * step) / limits.acceleration,
                        std::abs(q3 - 3 * q2 + 3 * q1 - q0) / (step * step * step) / limits.jerk});
    }
  }
  return worst;
}

/// From the speed and acceleration where the tail begins, in the direction there, as if the path went straight on.
double stop_along_tangent(const planner::Chunk& chunk, const machine::Machine& machine) {
  const planner::Segment& first = chunk.stop_tail.front();
  const planner::PathState from = planner::evaluate(first, (chunk.end() - first.begin).value());
  const geometry::PointJet jet = chunk.pieces[first.piece].axes().jets(from.s);
  const double share = std::max(std::abs(jet[0].first), std::abs(jet[1].first));
  const machine::AxisLimits& limits = *machine.axes[0];
  const double a = limits.acceleration / share, j = limits.jerk / share;
  const double rise = std::max(from.acceleration, 0.0) / j, v = from.speed + from.acceleration * rise / 2;
  const double time = v > a * a / j ? v / a + a / j : 2 * std::sqrt(v / j);
  return rise * (from.speed + from.acceleration * rise / 3) + v * time / 2;
}

struct Tails {
  std::vector<double> lengths;   ///< mm
  std::vector<double> shortest;  ///< of each, mm
  double worst = 0;              ///< ratio of any limit
  double longest_slice = 0;      ///< s
};

Tails tails_of(const std::string& text) {
  const machine::Machine machine = testing_support::wide_mill();
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
  source.planner().slice(0.02);
  Tails tails;
  while (const auto chunk = source.next()) {
    tails.longest_slice = std::max(tails.longest_slice, chunk->duration.value());
    if (chunk->stop_tail.empty()) continue;
    tails.lengths.push_back(chunk->tail_length);
    tails.shortest.push_back(stop_along_tangent(*chunk, machine));
    planner::Chunk tail = *chunk;
    tail.segments = tail.stop_tail;
    constraints::LimitRatios ratios{};
    planner::raise_limit_ratios(tail, machine, ratios);
    tails.worst = std::max({tails.worst, ratios.greatest(), worst_difference(*chunk, machine)});
  }
  return tails;
}

/// Nearly all; where motion still rises fast, it takes longer, whatever stops it.
TEST(Tails, AreShortOnBlendedShortLines) {
  std::uint32_t seed = 1;
  std::vector<double> lengths;
  for (const double bend : {0.4, 1.0, std::numbers::pi}) {
    for (const double tolerance : {0.01, 0.05}) {
      for (const double longest : {0.5, 2.0}) {
        const std::string text = short_lines(seed++, bend, longest, tolerance, 60);
        SCOPED_TRACE(text);
        const Tails tails = tails_of(text);
        lengths.insert(lengths.end(), tails.lengths.begin(), tails.lengths.end());
        EXPECT_LE(tails.worst, 1.001);
        EXPECT_LE(tails.longest_slice, 0.05);
      }
    }
  }
  ASSERT_GT(lengths.size(), 1000U);
  std::sort(lengths.begin(), lengths.end());
  EXPECT_LE(lengths[lengths.size() * 199 / 200], straight_stop);
  EXPECT_LE(lengths.back(), 1.25 * straight_stop);
}

/// Where lines hardly turn, motion is as fast as bends allow it to be: of what a stop along the tangent would take of
/// the limits, they leave little.
TEST(Tails, AreAsShortAsTheLimitsAllow) {
  std::vector<double> ratios;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const std::string text = short_lines(seed, 0.1, 2, seed % 2 == 0 ? 0.01 : 0.05, 120);
    SCOPED_TRACE(text);
    const Tails tails = tails_of(text);
    for (std::size_t k = 0; k < tails.lengths.size(); ++k) {
      ratios.push_back(tails.lengths[k] / tails.shortest[k]);
      EXPECT_LE(tails.lengths[k], std::max(straight_stop, 2.5 * tails.shortest[k]));
    }
    EXPECT_LE(tails.worst, 1.001);
  }
  ASSERT_GT(ratios.size(), 100U);
  std::sort(ratios.begin(), ratios.end());
  EXPECT_LE(ratios[ratios.size() / 2], 1.4);
}

}  // namespace test_tails
