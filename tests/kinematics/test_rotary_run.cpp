#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/rotary_run.hpp>
#include <leadscrew/machine/machine.hpp>
#include <limits>

#include "machines.hpp"

// The choice over a whole run, against every way there is; and what greed would do.

namespace leadscrew::kinematics::testing {
namespace test_rotary_run {

using Directions = std::vector<Vector3<double>>;

double squared(double x) {
  return x * x;
}

/// Every way: each solution of each vertex, each number of whole turns at the beginning, the shorter way round from then on.
class EveryWay {
 public:
  EveryWay(const Chain& chain, const RotaryLimits& limits, const Angles<double>& before, double tolerance,
           const Directions& directions)
      : chain_(chain), limits_(limits), tolerance_(tolerance), directions_(directions) {
    const auto found = solutions(chain, directions[0]);
    for (std::size_t k = 0; k < found.count; ++k) {
      for (int i = -4; i <= 4; ++i) {
        for (int j = -4; j <= 4; ++j) {
          Angles<double> at = {found.angles[k][0] + 360 * i, found.angles[k][1] + 360 * j};
          if (found.is_pole) at[0] = before[0] + 360 * i;
          visit(0, at, found.is_pole ? 2 : k, step_cost(before, at));
        }
      }
    }
  }

  double cost = std::numeric_limits<double>::infinity();
  std::size_t reached = 0;  ///< vertices

 private:
  double step_cost(const Angles<double>& a, const Angles<double>& b) const {
    return squared((b[0] - a[0]) / limits_.velocity[0]) + squared((b[1] - a[1]) / limits_.velocity[1]);
  }

  bool is_inside(const Angles<double>& at) const {
    for (std::size_t i = 0; i < 2; ++i)
      if (at[i] < limits_.travel_min[i] || at[i] > limits_.travel_max[i]) return false;
    return true;
  }

  bool may_change_side(std::size_t vertex, const Angles<double>& a, const Angles<double>& b) const {
    Vector3<double> middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = directions_[vertex][i] + directions_[vertex + 1][i];
    return angle_between(direction_of(chain_, Angles<double>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}), middle) <=
           tolerance_ * degree;
  }

  void visit(std::size_t vertex, const Angles<double>& at, std::size_t side, double so_far) {
    if (!is_inside(at)) return;
    reached = std::max(reached, vertex + 1);
    if (vertex + 1 == directions_.size()) {
      cost = std::min(cost, so_far);
      return;
    }
    const auto found = solutions(chain_, directions_[vertex + 1]);
    for (std::size_t k = 0; k < found.count; ++k) {
      const std::size_t to_side = found.is_pole ? 2 : k;
      for (int i = -9; i <= 9; ++i) {
        Angles<double> to = {found.angles[k][0] + 360 * i, at[1] + std::remainder(found.angles[k][1] - at[1], 360)};
        if (found.is_pole) to[0] = at[0];
        if (std::abs(to[0] - at[0]) > 180 || (found.is_pole && i != 0)) continue;
        if (side != to_side && side != 2 && to_side != 2 && !may_change_side(vertex, at, to)) continue;
        visit(vertex + 1, to, to_side, so_far + step_cost(at, to));
      }
    }
  }

  const Chain& chain_;
  const RotaryLimits& limits_;
  double tolerance_;
  const Directions& directions_;
};

Vector3<double> spherical(double tilt, double azimuth) {
  return {std::sin(tilt * degree) * std::cos(azimuth * degree), std::sin(tilt * degree) * std::sin(azimuth * degree),
          std::cos(tilt * degree)};
}

/// A walk over the sphere, mostly near the pole, where sides change and the first angle runs.
Directions random_walk(const Chain& chain, Draw& draw, std::size_t count) {
  Directions directions;
  Angles<double> at = {draw(-180, 180), draw(-40, 40)};
  for (std::size_t k = 0; k < count; ++k) {
    directions.push_back(direction_of(chain, at));
    at[0] += draw(-100, 100);
    at[1] += draw(-25, 25);
    if (draw(0, 1) < 0.15) at[1] = 0;
  }
  return directions;
}

void expect_sound(const Chain& chain, const RotaryLimits& limits, const Directions& directions, const RotaryRun& run) {
  const auto angles = run.angles();
  ASSERT_EQ(angles.size(), directions.size());
  for (std::size_t k = 0; k < angles.size(); ++k) {
    EXPECT_LE(angle_between(direction_of(chain, angles[k]), directions[k]), 1e-12);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GE(angles[k][i], limits.travel_min[i]);
      EXPECT_LE(angles[k][i], limits.travel_max[i]);
      EXPECT_LE(std::abs(angles[k][i] - angles[k > 0 ? k - 1 : 0][i]), 180 + 1e-9);
    }
  }
}

void expect_best(const NamedChain& named, Draw& draw, int& done, int& failed) {
  const std::size_t count = 2 + static_cast<std::size_t>(draw(0, 6));
  const Directions directions = random_walk(named.chain, draw, count);
  const RotaryLimits limits{
      {draw(-500, -40), draw(-400, -20)}, {draw(40, 500), draw(20, 400)}, {draw(50, 400), draw(50, 400)}};
  const Angles<double> before = {draw(-40, 40), draw(-20, 20)};
  const double tolerance = std::exp(draw(-3, 3));
  RotaryRun run(named.chain, limits, before, tolerance);
  for (const Vector3<double>& direction : directions) {
    if (!run.add(direction)) break;
  }
  const EveryWay every(named.chain, limits, before, tolerance, directions);
  if (every.reached < count) {
    ++failed;
    ASSERT_TRUE(run.failure()) << named.name;
    EXPECT_EQ(run.failure()->kind, RunFailure::Kind::travel);
    EXPECT_EQ(run.failure()->vertex, every.reached);
    return;
  }
  ++done;
  ASSERT_FALSE(run.failure()) << named.name << " at " << run.failure()->vertex;
  EXPECT_TRUE(run.is_exact());
  // At the end of reach both solutions are one, which rounding tells to ±1e-6 degrees: turning by 180 at 50 degrees/s then
  // costs up to 1.4e-7 s² more or less at a vertex.
  EXPECT_NEAR(run.cost(), every.cost, 1e-7 * static_cast<double>(count)) << named.name;
  expect_sound(named.chain, limits, directions, run);
}

TEST(RotaryRuns, CostTheLeastOfAllWays) {
  Draw draw(1980);
  int done = 0, failed = 0;
  for (int k = 0; k < 12; ++k)
    for (const NamedChain& named : all_chains()) expect_best(named, draw, done, failed);
  EXPECT_GT(done, 50);
  EXPECT_GT(failed, 10);
}

RC_GTEST_PROP(LongRandomRuns, CostTheLeastOfAllWays, ()) {
  Draw draw(*rc::gen::arbitrary<std::uint64_t>());
  int done = 0, failed = 0;
  for (const NamedChain& named : all_chains()) expect_best(named, draw, done, failed);
  RC_ASSERT(!::testing::Test::HasFailure());
}

Chain trunnion() {
  return Chain::of(*machine::preset_chain("table-table-ac")).value();
}
/// C and A, in the order of the chain.
RotaryLimits trunnion_limits(double c, double a) {
  return {{-c, -a}, {c, a}, {360, 180}};
}

/// 300° around at a tilt, with C inside ±200°: the nearest beginning, at 0°, runs into the end of travel; one of the others
/// does not.
TEST(RotaryRuns, BeginWhereTheyCanEnd) {
  const Chain chain = trunnion();
  Directions directions;
  for (int k = 0; k <= 300; ++k) directions.push_back(direction_of(chain, Angles<double>{static_cast<double>(k), 30}));
  RotaryRun run(chain, trunnion_limits(200, 110), {0, 30}, 0.05);
  for (const Vector3<double>& direction : directions) ASSERT_TRUE(run.add(direction));
  const auto angles = run.angles();
  EXPECT_NEAR(angles.front()[0], -180, 1e-9);  // the other side, tilted the other way
  EXPECT_NEAR(angles.front()[1], -30, 1e-9);
  EXPECT_NEAR(angles.back()[0], 120, 1e-9);
  // Without the other side there is no way, and it ends where C does, of whichever beginning.
  RotaryRun narrow(chain, {{-200, 0}, {200, 110}, {360, 180}}, {0, 30}, 0.05);
  std::size_t taken = 0;
  while (taken < directions.size() && narrow.add(directions[taken])) ++taken;
  ASSERT_TRUE(narrow.failure());
  EXPECT_EQ(narrow.failure()->kind, RunFailure::Kind::travel);
  EXPECT_EQ(narrow.failure()->axis, base::Axis::C);
  EXPECT_EQ(narrow.failure()->vertex, 201u);
  EXPECT_FALSE(narrow.add(directions[0]));
}

TEST(RotaryRuns, LeadStraightThroughPoles) {
  const Chain chain = trunnion();
  for (const bool has_vertex : {true, false}) {
    RotaryRun run(chain, trunnion_limits(36000, 110), {33, 0}, 0.05);
    std::vector<double> tilts;
    for (double tilt = 20; tilt >= -20; tilt -= 1) tilts.push_back(has_vertex ? tilt : tilt + 0.5);
    for (const double tilt : tilts) ASSERT_TRUE(run.add(direction_of(chain, Angles<double>{33, tilt})));
    const auto angles = run.angles();
    for (std::size_t k = 0; k < angles.size(); ++k) {
      EXPECT_NEAR(angles[k][0], 33, 1e-9);
      EXPECT_NEAR(angles[k][1], tilts[k], 1e-9);
    }
  }
}

/// Past the pole within the tolerance it leads through as well, and C makes but a small turn; outside it goes round.
TEST(RotaryRuns, GoRoundPolesOutsideTheTolerance) {
  const Chain chain = trunnion();
  for (const double miss : {0.01, 0.2}) {
    RotaryRun run(chain, trunnion_limits(36000, 110), {0, 20}, 0.05);
    for (double along = 20; along >= -20.01; along -= 0.25) {
      const Vector3<double> direction = {std::sin(miss * degree), std::sin((along + 0.125) * degree),
                                         std::cos(along * degree)};
      ASSERT_TRUE(run.add(direction));
    }
    const auto angles = run.angles();
    const bool is_through = angles.front()[1] * angles.back()[1] < 0;
    EXPECT_EQ(is_through, miss < 0.05) << miss;
  }
}

/// At every crossing there are two ways on, by one solution and by the other; of all those that meet only the cheapest of each
/// choice of whole turns is worth going on with.
TEST(RotaryRuns, StayExactHoweverOftenTheyCrossAPole) {
  const Chain chain = trunnion();
  for (const double travel : {200.0, 500.0}) {
    Draw draw(1);
    RotaryRun run(chain, trunnion_limits(travel, 110), {0, 20}, 0.05);
    for (int k = 0; k < 60; ++k) {
      ASSERT_TRUE(run.add(spherical(20, draw(-180, 180)))) << travel << " at " << k;
      ASSERT_TRUE(run.add({0, 0, 1}));
    }
    EXPECT_TRUE(run.is_exact()) << travel;
  }
}

TEST(RotaryRuns, AtAPoleLeaveTheFirstAngle) {
  const Chain chain = trunnion();
  RotaryRun run(chain, trunnion_limits(36000, 110), {725, 10}, 0.05);
  for (int k = 0; k < 5; ++k) ASSERT_TRUE(run.add({0, 0, 1}));
  for (const Angles<double>& angles : run.angles()) EXPECT_EQ(angles, (Angles<double>{725, 0}));
  ASSERT_TRUE(run.add(direction_of(chain, Angles<double>{735, 10})));
  EXPECT_NEAR(run.angles().back()[0], 735, 1e-9);
  EXPECT_NEAR(run.angles().back()[1], 10, 1e-9);
  EXPECT_EQ(run.angles().front(), (Angles<double>{725, 0}));
}

/// Travel of two hundred turns: a spiral of fifty begins where it is nearest.
TEST(RotaryRuns, WindAsFarAsTravelGoes) {
  const Chain chain = trunnion();
  RotaryRun run(chain, trunnion_limits(36000, 110), {35000, 25}, 0.05);
  for (int k = 0; k <= 50 * 36; ++k) ASSERT_TRUE(run.add(spherical(25 + k * 0.01, -10.0 * k)));
  const auto angles = run.angles();
  // On the side of the nearest beginning C would pass its end; it begins as much earlier as it takes.
  EXPECT_NEAR(angles.back()[0] - angles.front()[0], 18000, 1e-6);
  EXPECT_LE(angles.back()[0], 36000);
  EXPECT_GT(angles.back()[0], 36000 - 360);
}

TEST(RotaryRuns, TellWhatIsOutOfReach) {
  machine::RotaryChain data = *machine::preset_chain("head-head-bc");
  data.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  const Chain chain = Chain::of(data).value();
  RotaryRun run(chain, {{-400, -400}, {400, 400}, {100, 100}}, {0, 0}, 0.05);
  ASSERT_TRUE(run.add(spherical(80, 0)));
  ASSERT_TRUE(run.add(spherical(89, 0)));
  ASSERT_FALSE(run.add(spherical(92, 0)));
  EXPECT_EQ(run.failure()->kind, RunFailure::Kind::out_of_reach);
  EXPECT_EQ(run.failure()->vertex, 2u);
  EXPECT_NEAR(run.failure()->miss, 2, 1e-9);
}

TEST(RotaryLimits, AreThoseOfTheAxes) {
  machine::Machine machine = machine::mill3();
  machine.kinematics = "head-b-table-a";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  machine.axes[base::index(base::Axis::A)] = machine.axes[base::index(base::Axis::B)] = machine.axes[0];
  machine.axes[base::index(base::Axis::B)]->travel_min = -110;
  machine.axes[base::index(base::Axis::A)]->velocity = 77;
  const Chain chain = chain_of(machine);
  const RotaryLimits limits = limits_of(machine, chain);
  EXPECT_EQ(chain.turns()[0].axis, base::Axis::A);
  EXPECT_EQ(limits.travel_min, (Angles<double>{-500, -110}));
  EXPECT_EQ(limits.velocity, (Angles<double>{77, 200}));
  EXPECT_EQ(limits.travel_max, (Angles<double>{500, 500}));
}

}  // namespace test_rotary_run
}  // namespace leadscrew::kinematics::testing
