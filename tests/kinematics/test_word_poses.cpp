#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <numbers>
#include <tuple>

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

base::PassedEvent told(base::Event::Kind kind, double value, std::int32_t output, std::int64_t tick) {
  return {{kind, value, base::Line{1}, output, false}, base::Tick{tick}, 0};
}

/// The plan tells it with the word at which the tool becomes another.
TEST(WordPoses, ChangeTheToolAtItsWord) {
  WordPoses poses(of_preset("table-table-ac"));
  poses.observe(told(base::Event::Kind::tool_offset, 50, 2, 3));
  poses.observe(told(base::Event::Kind::tool_offset, -4, 0, 3));
  poses.observe(told(base::Event::Kind::spindle_speed, 900, 1, 3));
  base::Word word;
  word.position = {10, 0, 60};
  for (const auto& [tick, x, z] : {std::tuple(0, 10, 60), {2, 10, 60}, {3, 14, 10}, {4, 14, 10}}) {
    word.tick = base::Tick{tick};
    const auto pose = poses.of(word);
    expect_near({pose->tip[0], pose->tip[1], pose->tip[2]}, {double(x), 0, double(z)});
  }
}

/// Under control the speed is the tip's in the workpiece: of axes that follow the table it is 0.
TEST(WordPoses, TellHowFastTheTipGoes) {
  WordPoses poses(of_preset("table-table-ac"));
  const double degree = std::numbers::pi / 180;
  const base::AxisVector axes = {30, 0, 60}, following = {0, 30 * 90 * degree, 0, 0, 0, 90},
                         turning = {0, 0, 0, 0, 0, 90};
  EXPECT_FALSE(poses.tip_speed(axes, turning));
  poses.observe(told(base::Event::Kind::tip_control, 1, 0, 0));
  poses.advance(base::Tick{0});
  EXPECT_NEAR(*poses.tip_speed(axes, following), 0, 1e-12);
  EXPECT_NEAR(*poses.tip_speed(axes, turning), 30 * 90 * degree, 1e-12);
  EXPECT_NEAR(*poses.tip_speed(axes, {3, 4, 12}), 13, 1e-12);
  poses.observe(told(base::Event::Kind::tip_control, 0, 0, 1));
  poses.advance(base::Tick{1});
  EXPECT_FALSE(poses.tip_speed(axes, turning));
}

}  // namespace test_word_poses
}  // namespace leadscrew::kinematics
