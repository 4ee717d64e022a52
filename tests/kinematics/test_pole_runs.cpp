#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/vector_run.hpp>
#include <numeric>

#include "machines.hpp"

// Runs of vectors about poles: straight through, about, from, to and at them, and the tool within what is told of E.

namespace leadscrew::kinematics::testing {
namespace test_pole_runs {

using Directions = std::vector<Vector3<double>>;

/// Tips one millimetre times `spacing` apart, along X.
struct Programmed {
  Directions directions;
  double spacing = 1;

  Vector3<double> tip(std::size_t k) const { return {spacing * static_cast<double>(k), 0, 0}; }
  /// The direction where the tip is at x.
  Vector3<double> at(double x) const {
    const double place = std::clamp(x / spacing, 0.0, static_cast<double>(directions.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(place), directions.size() - 2);
    const double share = place - static_cast<double>(k), angle = angle_between(directions[k], directions[k + 1]);
    if (angle < 1e-12) return directions[k];
    const double a = std::sin((1 - share) * angle) / std::sin(angle), b = std::sin(share * angle) / std::sin(angle);
    Vector3<double> sum;
    for (std::size_t i = 0; i < 3; ++i) sum[i] = a * directions[k][i] + b * directions[k + 1][i];
    return sum;
  }
};

/// Beside the pole by x and y, degrees as on a map.
Vector3<double> beside(const Vector3<double>& pole, double x, double y) {
  const Vector3<double> other = std::abs(pole[0]) < 0.9 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0};
  const Vector3<double> u = unit_vector(cross_product(pole, other)), v = cross_product(pole, u);
  Vector3<double> direction;
  const double radius = std::hypot(x, y) * degree, scale = radius > 0 ? std::sin(radius) / radius * degree : 0;
  for (std::size_t i = 0; i < 3; ++i) direction[i] = std::cos(radius) * pole[i] + scale * (x * u[i] + y * v[i]);
  return direction;
}

RotaryLimits wide_limits() {
  return {{-36000, -36000}, {36000, 36000}, {360, 180}};
}

struct Travelled {
  bool is_done = false;
  Angles<double> start{};
  std::vector<RunVertex> vertices;
};

Travelled travel(const Chain& chain, const Programmed& programmed, const VectorRunSettings& settings,
                 const Angles<double>& before = {}) {
  VectorRun run(chain, wide_limits(), settings);
  Travelled travelled;
  travelled.is_done = run.begin_free(programmed.tip(0), programmed.directions[0], before);
  for (std::size_t k = 1; k < programmed.directions.size() && travelled.is_done; ++k)
    travelled.is_done = run.add(programmed.tip(k), programmed.directions[k]);
  travelled.is_done = run.finish() && travelled.is_done;
  travelled.start = run.start_angles();
  travelled.vertices = run.take();
  return travelled;
}

/// Along every line the tool is off by no more than what is not left of E, and what is left is enough to smooth by.
void expect_within(const Chain& chain, const Programmed& programmed, const VectorRunSettings& settings,
                   const Travelled& travelled) {
  ASSERT_TRUE(travelled.is_done);
  const double e = settings.orientation_tolerance;
  Angles<double> from = travelled.start;
  Vector3<double> from_tip = programmed.tip(0);
  std::size_t segment = 0;
  for (const RunVertex& vertex : travelled.vertices) {
    EXPECT_GE(vertex.tolerance, 0.09 * e);
    EXPECT_GE(vertex.segment, segment);
    segment = vertex.segment;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Angles<double> at = {from[0] + share * (vertex.angles[0] - from[0]),
                                 from[1] + share * (vertex.angles[1] - from[1])};
      const double x = from_tip[0] + share * (vertex.tip[0] - from_tip[0]);
      const double off = angle_between(direction_of(chain, at), programmed.at(x)) / degree;
      ASSERT_LE(off, e - vertex.tolerance + 6e-5) << "at x = " << x << " C " << from[0] << " to " << vertex.angles[0];
    }
    if (vertex.is_pole_turn) {
      EXPECT_EQ(vertex.tip, from_tip);
      EXPECT_EQ(vertex.angles[1], from[1]);
    }
    from = vertex.angles;
    from_tip = vertex.tip;
  }
  EXPECT_EQ(from_tip, programmed.tip(programmed.directions.size() - 1));
  EXPECT_EQ(segment + 2, programmed.directions.size());
}

double turned_in_all(const Travelled& travelled) {
  double all = 0, last = travelled.start[0];
  for (const RunVertex& vertex : travelled.vertices)
    all += std::abs(std::exchange(last, vertex.angles[0]) - vertex.angles[0]);
  return all;
}

Chain trunnion() {
  return Chain::of(*machine::preset_chain("table-table-ac")).value();
}

/// On a straight line past the pole, at this distance.
Programmed past(const Vector3<double>& pole, double miss, double from, double to, int steps) {
  Programmed programmed;
  for (int k = 0; k <= steps; ++k) programmed.directions.push_back(beside(pole, from + (to - from) * k / steps, miss));
  return programmed;
}

TEST(PoleRuns, LeadStraightThroughWithoutTurning) {
  const Chain chain = trunnion();
  for (const int steps : {7, 40, 41, 400}) {
    for (const double miss : {0.04, 0.01, 1e-4, 1e-6, 0.0}) {
      const Programmed programmed = past({0, 0, 1}, miss, -20, 20, steps);
      const VectorRunSettings settings;
      const Travelled travelled = travel(chain, programmed, settings);
      expect_within(chain, programmed, settings, travelled);
      EXPECT_LE(turned_in_all(travelled), 10) << miss;
      EXPECT_LT(travelled.start[1] * travelled.vertices.back().angles[1], 0);
    }
  }
}

TEST(PoleRuns, GoRoundOutsideTheCone) {
  const Chain chain = trunnion();
  for (const VectorRunSettings& settings :
       {VectorRunSettings{0.05, 0.1, true}, VectorRunSettings{0.5, 0.05, true}, VectorRunSettings{0.5, 0.5, false}}) {
    const Programmed programmed = past({0, 0, 1}, 0.06, -20, 20, 400);
    const Travelled travelled = travel(chain, programmed, settings);
    expect_within(chain, programmed, settings, travelled);
    EXPECT_GT(turned_in_all(travelled), 170);
    EXPECT_TRUE(std::ranges::all_of(
        travelled.vertices, [&](const RunVertex& v) { return v.tolerance == travelled.vertices[0].tolerance; }));
  }
}

TEST(PoleRuns, TurnAtRestWhereThePathTurnsAtThePole) {
  const Chain chain = trunnion();
  for (const bool blends : {true, false}) {
    Programmed programmed;
    for (int k = 10; k >= 0; --k) programmed.directions.push_back(beside({0, 0, 1}, k, 0));
    for (int k = 1; k <= 10; ++k) programmed.directions.push_back(beside({0, 0, 1}, 0, k));
    const VectorRunSettings settings{0.05, 0.1, blends};
    const Travelled travelled = travel(chain, programmed, settings);
    expect_within(chain, programmed, settings, travelled);
    EXPECT_EQ(std::ranges::count_if(travelled.vertices, &RunVertex::is_pole_turn), 1);
    EXPECT_NEAR(turned_in_all(travelled), 90, 1e-6);
  }
}

TEST(PoleRuns, LeaveAPoleByATurnAndByNoneWhereTheyBeginFree) {
  const Chain chain = trunnion();
  const Programmed programmed = past({0, 0, 1}, 0, 0, 20, 20);
  const Travelled free = travel(chain, programmed, {}, {40, 0});
  expect_within(chain, programmed, {}, free);
  EXPECT_NEAR(turned_in_all(free), 0, 1e-9);
  VectorRun run(chain, wide_limits(), {});
  run.begin_at({0, 0, 0}, {40, 0});
  for (std::size_t k = 1; k < programmed.directions.size(); ++k)
    ASSERT_TRUE(run.add(programmed.tip(k), programmed.directions[k]));
  ASSERT_TRUE(run.finish());
  const Travelled fixed{true, run.start_angles(), run.take()};
  EXPECT_EQ(fixed.start, (Angles<double>{40, 0}));
  EXPECT_TRUE(fixed.vertices.front().is_pole_turn);
  EXPECT_EQ(std::ranges::count_if(fixed.vertices, &RunVertex::is_pole_turn), 1);
  expect_within(chain, programmed, {}, fixed);
}

TEST(PoleRuns, StandAtThePoleWhereTheyWanderAboutIt) {
  const Chain chain = trunnion();
  Draw draw(77);
  for (int trial = 0; trial < 5; ++trial) {
    Programmed programmed{past({0, 0, 1}, 0.02, -10, -0.1, 100).directions, 0.1};
    for (int k = 0; k < 50; ++k)
      programmed.directions.push_back(beside({0, 0, 1}, draw(-0.02, 0.02), draw(-0.02, 0.02)));
    for (const auto& direction : past({0, 0, 1}, 0.02, 0.1, 10, 100).directions)
      programmed.directions.push_back(direction);
    const Travelled travelled = travel(chain, programmed, {});
    expect_within(chain, programmed, {}, travelled);
    EXPECT_LE(4 * turned_in_all(travelled), turned_in_all(travel(chain, programmed, {.pole_cone = 0})));
  }
}

TEST(PoleRuns, StayWhereTheyAreAtThePole) {
  const Chain chain = trunnion();
  Programmed programmed;
  for (int k = 0; k < 50; ++k) programmed.directions.push_back({0, 0, 1});
  const Travelled travelled = travel(chain, programmed, {}, {70, 0});
  expect_within(chain, programmed, {}, travelled);
  for (const RunVertex& vertex : travelled.vertices) EXPECT_EQ(vertex.angles, (Angles<double>{70, 0}));
}

/// Anything about a pole of any machine.
void expect_sound(Draw& draw, const NamedChain& named) {
  const Cones& cones = named.chain.cones();
  const bool has_first = cones.difference_sine == 0, has_second = cones.sum_cosine == 0;
  if (!has_first && !has_second) return;
  Vector3<double> pole = named.chain.turns()[0].direction;
  if (!has_first || (has_second && draw(0, 1) < 0.5)) pole = {-pole[0], -pole[1], -pole[2]};
  Programmed programmed;
  programmed.spacing = std::exp(draw(-4, 1));
  const double cone = std::exp(draw(-4, 0)), e = cone * std::exp(draw(-1, 1));
  double x = draw(-20, 20) * cone, y = draw(-20, 20) * cone;
  const auto count = static_cast<int>(draw(2, 60));
  double size = 1;
  for (int k = 0; k < count; ++k) {
    if (draw(0, 1) < 0.2) size = std::exp(draw(-3, 3));
    const double kind = draw(0, 1);
    if (kind < 0.1) x = y = 0;
    if (kind >= 0.1 && kind < 0.2) x = -x, y = -y + draw(-1, 1) * cone;
    if (kind >= 0.2) x = 0.9 * x + draw(-1, 1) * size * cone, y = 0.9 * y + draw(-1, 1) * size * cone;
    programmed.directions.push_back(beside(pole, x, y));
  }
  const VectorRunSettings settings{e, cone, draw(0, 1) < 0.8};
  expect_within(named.chain, programmed, settings,
                travel(named.chain, programmed, settings, {draw(-300, 300), draw(-50, 50)}));
}

TEST(PoleRuns, KeepTheToolWithinItsTolerance) {
  Draw draw(2026);
  for (int k = 0; k < 8 && !::testing::Test::HasFatalFailure(); ++k)
    for (const NamedChain& named : all_chains()) expect_sound(draw, named);
}

RC_GTEST_PROP(LongRandomRuns, KeepTheToolWithinItsToleranceAboutPoles, ()) {
  Draw draw(*rc::gen::arbitrary<std::uint64_t>());
  for (const NamedChain& named : all_chains()) expect_sound(draw, named);
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace test_pole_runs
}  // namespace leadscrew::kinematics::testing
