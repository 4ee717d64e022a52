#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/vector_run.hpp>

#include "machines.hpp"

// Lines with tool vectors become lines of the tip and the rotary axes.

namespace leadscrew::kinematics::testing {
namespace test_vector_run {

RotaryLimits wide_limits() {
  return {{-36000, -36000}, {36000, 36000}, {360, 180}};
}

Chain trunnion() {
  return Chain::of(*machine::preset_chain("table-table-ac")).value();
}

TEST(VectorRuns, HoldEveryVectorOfEveryChain) {
  Draw draw(404);
  int refused = 0;
  for (const NamedChain& named : all_chains()) {
    for (int trial = 0; trial < 20; ++trial) {
      Angles<double> at = {draw(-180, 180), draw(-60, 60)};
      const Angles<double> start = at;
      std::vector<Vector3<double>> directions;
      for (int k = 0; k < 8; ++k) {
        at[0] += draw(-20, 20);
        at[1] += draw(-20, 20);
        directions.push_back(direction_of(named.chain, at));
      }
      VectorRun run(named.chain, wide_limits(), {.pole_cone = 0});
      run.begin_at({0, 0, 0}, start);
      double x = 0;
      const bool is_done = std::ranges::all_of(
          directions, [&](const Vector3<double>& direction) { return run.add({++x, 0, 0}, direction); });
      ASSERT_EQ(run.finish(), is_done);
      if (!is_done) {  // the great circle leads where the tool cannot
        EXPECT_EQ(run.failure()->kind, VectorRunFailure::Kind::out_of_reach) << named.name;
        ++refused;
        continue;
      }
      const auto vertices = run.take();
      Angles<double> before = start;
      std::size_t reached = 0;
      for (const RunVertex& vertex : vertices) {
        // Where reach ends both solutions meet, and a part may lead from one to the other.
        const double most = named.chain.cones().difference_sine == 0 ? 1 + 1e-9 : 4;
        EXPECT_LE(std::abs(vertex.angles[0] - before[0]), most) << named.name;
        EXPECT_LE(std::abs(vertex.angles[1] - before[1]), most) << named.name;
        before = vertex.angles;
        EXPECT_NEAR(vertex.tip[0], std::clamp<double>(vertex.tip[0], vertex.segment, vertex.segment + 1), 1e-12);
        if (vertex.tip[0] != static_cast<double>(vertex.segment + 1)) continue;
        EXPECT_LE(angle_between(direction_of(named.chain, vertex.angles), directions[vertex.segment]), 1e-12);
        ++reached;
      }
      EXPECT_EQ(reached, directions.size());
    }
  }
  EXPECT_LT(refused, 20);
}

TEST(VectorRuns, DecideLongRunsInParts) {
  const Chain chain = trunnion();
  VectorRun run(chain, wide_limits(), {});
  run.begin_at({0, 0, 0}, {0, 30});
  std::vector<RunVertex> vertices;
  for (int k = 1; k <= 200'000; ++k) {
    ASSERT_TRUE(run.add({k * 0.1, 0, 0}, direction_of(chain, Angles<double>{k * 0.05, 30})));
    for (const RunVertex& vertex : run.take()) vertices.push_back(vertex);
  }
  EXPECT_GT(vertices.size(), 100'000u);
  ASSERT_TRUE(run.finish());
  for (const RunVertex& vertex : run.take()) vertices.push_back(vertex);
  ASSERT_EQ(vertices.size(), 200'000u);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    ASSERT_EQ(vertices[k].segment, k);
    ASSERT_NEAR(vertices[k].angles[0], static_cast<double>(k + 1) * 0.05, 1e-9);
  }
}

TEST(VectorRuns, RefuseHalfATurn) {
  VectorRun run(trunnion(), wide_limits(), {});
  run.begin_at({0, 0, 0}, {0, 90});
  const Vector3<double> direction = direction_of(trunnion(), Angles<double>{0, -90});
  EXPECT_TRUE(run.add({1, 0, 0}, direction_of(trunnion(), Angles<double>{0, 89})));
  EXPECT_TRUE(run.add({1, 0, 0}, direction_of(trunnion(), Angles<double>{0, 90})));
  EXPECT_FALSE(run.add({1, 0, 0}, direction));
  ASSERT_TRUE(run.failure());
  EXPECT_EQ(run.failure()->kind, VectorRunFailure::Kind::opposite);
  EXPECT_EQ(run.failure()->segment, 2u);
}

}  // namespace test_vector_run
}  // namespace leadscrew::kinematics::testing
