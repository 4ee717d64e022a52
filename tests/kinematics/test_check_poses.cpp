#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "machines.hpp"

// One pose on six machines, computed apart from this code by the closed form of each: atan2 of the direction's components,
// products of rotations about coordinate axes. P = (30, 20, 10), O = (sin 20° cos 30°, sin 20° sin 30°, cos 20°), the table's C
// through (1, 2, 3), its A or B through (−4, 5, 6), tool of 120 mm on heads, whose axes meet in the gauge point: X Y Z are
// those of the pivot.

namespace leadscrew::kinematics::testing {
namespace test_check_poses {

struct Held {
  double tilt, turn;           ///< degrees: of A or B, and of C; of head-b-table-a B and A
  std::array<double, 3> axes;  ///< X Y Z
};
struct CheckPose {
  std::string name;
  base::Axis tilt, turn;
  std::array<Held, 2> held;
};

using base::Axis;
constexpr std::array<double, 3> head_axes = {65.543776, 40.521209, 122.763114};

const std::vector<CheckPose>& check_poses() {
  static const std::vector<CheckPose> poses = {
      {"head-b-table-a",
       Axis::B,
       Axis::A,
       {{{17.229397, 10.314105, {65.543776, 19.041437, 127.236212}},
         {162.770603, -169.685895, {65.543776, -9.041437, -115.236212}}}}},
      {"table-table-ac",
       Axis::A,
       Axis::C,
       {{{20, 60, {-0.088457, 32.870208, 20.400637}}, {-20, -120, {2.088457, -28.508364, 22.452758}}}}},
      {"table-table-bc",
       Axis::B,
       Axis::C,
       {{{-20, -30, {31.387749, 3.088457, 23.136798}}, {20, 150, {-29.990823, 0.911543, 19.716597}}}}},
      {"head-head-bc", Axis::B, Axis::C, {{{20, 30, head_axes}, {-20, -150, head_axes}}}},
      {"head-head-ac", Axis::A, Axis::C, {{{20, 120, head_axes}, {-20, -60, head_axes}}}},
      {"head-b-table-c",
       Axis::B,
       Axis::C,
       {{{20, -30, {76.157154, 3.088457, 122.763114}}, {-20, 150, {-74.157154, 0.911543, 122.763114}}}}}};
  return poses;
}

Chain chain_at_its_places(const std::string& name) {
  machine::RotaryChain data = *machine::preset_chain(name);
  for (machine::RotaryAxis& axis : data.axes) {
    if (axis.carries == machine::Carries::tool) continue;
    axis.point = axis.axis == Axis::C ? Vector{1, 2, 3} : Vector{-4, 5, 6};
  }
  return Chain::of(data).value();
}

constexpr Vector tip = {30, 20, 10};

Vector tool_direction() {
  return {std::sin(20 * degree) * std::cos(30 * degree), std::sin(20 * degree) * std::sin(30 * degree),
          std::cos(20 * degree)};
}

class PoseOn : public ::testing::TestWithParam<CheckPose> {};

/// Within half a unit of the last place that is printed, whichever solution is told first.
TEST_P(PoseOn, IsHeldBothWays) {
  const CheckPose& right = GetParam();
  const Chain chain = chain_at_its_places(right.name);
  const auto found = solutions(chain, tool_direction());
  ASSERT_EQ(found.count, 2u);
  EXPECT_FALSE(found.is_pole);
  const Vector tool = {0, 0, chain.table_count() == 2 ? 0.0 : 120.0};
  for (const Held& held : right.held) {
    int matches = 0;
    for (const Angles<double>& angles : found.angles) {
      const Coordinates<double> pose = coordinates(chain, tip, angles);
      if (std::abs(pose[base::index(right.tilt)] - held.tilt) > 5e-7) continue;
      ++matches;
      EXPECT_NEAR(pose[base::index(right.turn)], held.turn, 5e-7);
      const Coordinates<double> axes = machine_of(chain, pose, tool);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(axes[i], held.axes[i], 5e-7) << i;
      const Coordinates<double> back = pose_of(chain, axes, tool);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], tip[i], 3e-13) << i;
      EXPECT_LT(angle_between(direction_of(chain, angles), tool_direction()), 1e-15);
    }
    EXPECT_EQ(matches, 1) << held.tilt;
  }
}

INSTANTIATE_TEST_SUITE_P(Six, PoseOn, ::testing::ValuesIn(check_poses()), [](const auto& each) {
  std::string name = each.param.name;
  std::erase(name, '-');
  return name;
});

}  // namespace test_check_poses
}  // namespace leadscrew::kinematics::testing
