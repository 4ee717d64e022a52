#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <numbers>

// Where words bring the tool, by hand.

namespace leadscrew::kinematics {
namespace test_word_poses {

machine::Machine of_preset(std::string_view name) {
  machine::Machine machine = machine::mill3();
  machine.rotary_chain = machine::preset_chain(name);
  for (const machine::RotaryAxis& axis : machine.rotary_chain->axes)
    machine.axes[base::index(axis.axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  return machine;
}

void expect_near(const Vector& found, const Vector& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

TEST(WordPoses, AreNoneWithoutAChain) {
  EXPECT_FALSE(WordPoses(machine::mill3()).of({1, 2, 3}));
  EXPECT_FALSE(WordPoses(machine::mill3()).direction_at({1, 2, 3}));
}

/// A head whose B turns by 90°: the spindle is along X, and the tip 50 mm before it.
TEST(WordPoses, FollowAHead) {
  WordPoses poses(of_preset("head-head-bc"));
  const auto bare = poses.of({1, 2, 3, 0, 90});
  ASSERT_TRUE(bare);
  expect_near(bare->direction, {1, 0, 0});
  poses.hold({0, 0, 50});
  const auto held = poses.of({1, 2, 3, 0, 90});
  expect_near({held->tip[0], held->tip[1], held->tip[2]}, {1 - 50, 2, 3});
  EXPECT_EQ(held->tip[4], 90);
}

/// A table whose C turns by 90°: what the tip is over has come from −Y of the part.
TEST(WordPoses, SeeThingsFromTheTable) {
  WordPoses poses(of_preset("table-table-ac"));
  poses.hold({0, 0, 50});
  const auto pose = poses.of({30, 0, 60, 0, 0, 90});
  expect_near({pose->tip[0], pose->tip[1], pose->tip[2]}, {0, -30, 10});
  expect_near(pose->direction, {0, 0, 1});
  const double a = 30 * std::numbers::pi / 180;
  const auto tilted = poses.of({0, 0, 0, 30, 0, 0});
  expect_near(tilted->direction, {0, std::sin(a), std::cos(a)});
  expect_near(*poses.direction_at({0, 0, 0, 30, 0, 0}), tilted->direction);
}

}  // namespace test_word_poses
}  // namespace leadscrew::kinematics
