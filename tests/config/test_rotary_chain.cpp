// Machine files of five axes: what a preset gives, what a file gives in its place, and what is wrong where it stands.

#include <gtest/gtest.h>

#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/machine/rotary_chain.hpp>

#include "files.hpp"

namespace leadscrew::config::testing {
namespace test_rotary_chain {

using Texts = std::vector<std::string>;
using machine::Carries;
using machine::RotaryAxis;
using machine::RotaryChain;
using machine::Vector;

std::string linear_axis(const std::string& letter) {
  return replaced(one_axis, "axis.X", "axis." + letter);
}
std::string rotary_axis(const std::string& letter) {
  return "[axis." + letter +
         "]\ntravel_deg = [-400, 400]\nmax_velocity_deg_s = 90\nmax_acceleration_deg_s2 = 500\n"
         "max_jerk_deg_s3 = 5000\nblu_deg = 0.001\n";
}

/// Line 1: kinematics; X from line 2, Y from 8, Z from 14; `first` from 20, its own keys from 26.
std::string machine_with(const std::string& kinematics, const std::string& first, const std::string& second) {
  return "kinematics = \"" + kinematics + "\"\n" + linear_axis("X") + linear_axis("Y") + linear_axis("Z") + first +
         second;
}
std::string trunnion(const std::string& keys_of_a = "", const std::string& keys_of_c = "") {
  return machine_with("table-table-ac", rotary_axis("A") + keys_of_a, rotary_axis("C") + keys_of_c);
}

TEST(RotaryChain, IsThatOfThePreset) {
  const std::array<std::string, 6> letters = {"AB", "AC", "BC", "CB", "CA", "CB"};
  for (std::size_t k = 0; k < machine::kinematics_presets.size(); ++k) {
    const machine::KinematicsPreset& preset = machine::kinematics_presets[k];
    const std::string text =
        machine_with(std::string(preset.name), rotary_axis(letters[k].substr(0, 1)), rotary_axis(letters[k].substr(1)));
    const auto read = read_machine(text, "m");
    ASSERT_TRUE(read) << text << read.error()[0].message;
    EXPECT_EQ(read->kinematics, preset.name);
    ASSERT_TRUE(read->rotary_chain);
    EXPECT_EQ(*read->rotary_chain, *machine::preset_chain(preset.name));
  }
  EXPECT_FALSE(read_machine(one_axis, "m")->rotary_chain);
  EXPECT_FALSE(read_machine("kinematics = \"cartesian\"\n" + one_axis, "m")->rotary_chain);
}

TEST(RotaryChain, IsWhatTheFileSaysInPlaceOfThePreset) {
  const std::string head = "orientation_tolerance_deg = 0.2\npole_cone_deg = 1\n";
  const auto read = read_machine(
      head +
          trunnion("carries = \"tool\"\npoint_mm = [1, 2.5, -3]\ndirection = [0, 0.6, 0.8]\norder = 2\nsign = -1\n",
                   "order = 1\n") +
          "[kinematics_geometry]\ntool_zero_mm = [0, 0, -7]\n",
      "m");
  ASSERT_TRUE(read) << read.error()[0].message;
  RotaryChain expected;
  expected.axes[0] = {base::Axis::A, Carries::tool, {0, 0.6, 0.8}, {1, 2.5, -3}, 2, -1};
  expected.axes[1] = {base::Axis::C, Carries::workpiece, {0, 0, 1}, {0, 0, 0}, 1, 1};
  expected.tool_zero = {0, 0, -7};
  expected.orientation_tolerance = 0.2;
  expected.pole_cone = 1;
  EXPECT_EQ(*read->rotary_chain, expected);
}

TEST(RotaryChain, IsRefusedWhereAValueIsWrong) {
  EXPECT_EQ(problems_of(trunnion("carries = \"table\"\n")), Texts{"26:11 machine-carries"});
  EXPECT_EQ(problems_of(trunnion("carries = 1\n")), Texts{"26:11 machine-carries"});
  EXPECT_EQ(problems_of(trunnion("point_mm = [0, 0]\n")), Texts{"26:12 machine-type"});
  EXPECT_EQ(problems_of(trunnion("point_mm = 5\n")), Texts{"26:12 machine-type"});
  EXPECT_EQ(problems_of(trunnion("point_mm = [0, \"0\", 0]\n")), Texts{"26:12 machine-type"});
  EXPECT_EQ(problems_of(trunnion("point_mm = [0, 0, inf]\n")), Texts{"26:12 rotary-point"});
  EXPECT_EQ(problems_of(trunnion("direction = [1, 0, 0.01]\n")), Texts{"26:13 rotary-direction"});
  EXPECT_EQ(problems_of(trunnion("direction = [0, 0, 0]\n")), Texts{"26:13 rotary-direction"});
  EXPECT_EQ(problems_of(trunnion("direction = [nan, 0, 1]\n")), Texts{"26:13 rotary-direction"});
  EXPECT_EQ(problems_of(trunnion("order = 3\n")), Texts{"26:9 rotary-order"});
  EXPECT_EQ(problems_of(trunnion("order = 1.0\n")), Texts{"26:9 machine-type"});
  EXPECT_EQ(problems_of(trunnion("sign = 0\n")), Texts{"26:8 rotary-sign"});
  EXPECT_EQ(problems_of(trunnion("colour = 1\n")), Texts{"26:1 machine-key"});
}

TEST(RotaryChain, IsRefusedWhereItsAxesDoNotGoTogether) {
  EXPECT_EQ(problems_of(trunnion("order = 2\n", "order = 2\n")), Texts{"33:9 rotary-order"});
  EXPECT_EQ(problems_of(trunnion("", "order = 1\n")), Texts{"32:9 rotary-order"});
  EXPECT_EQ(problems_of(trunnion("", "direction = [-1, 0, 0]\n")), Texts{"32:13 rotary-parallel"});
  // Turned round, C would tilt the tool, which it cannot; it is told at the axis, where the file gives no direction.
  EXPECT_EQ(problems_of(trunnion("order = 2\n", "order = 1\n")), Texts{"27:1 rotary-parallel"});
  EXPECT_EQ(problems_of(trunnion("carries = \"tool\"\n", "carries = \"tool\"\n")), Texts{"27:1 rotary-parallel"});
}

TEST(RotaryChain, IsRefusedWhereItsNumbersAreWrong) {
  EXPECT_EQ(problems_of("orientation_tolerance_deg = 0\n" + trunnion()), Texts{"1:29 orientation-tolerance"});
  EXPECT_EQ(problems_of("orientation_tolerance_deg = nan\n" + trunnion()), Texts{"1:29 orientation-tolerance"});
  EXPECT_EQ(problems_of("orientation_tolerance_deg = \"1\"\n" + trunnion()), Texts{"1:29 machine-type"});
  EXPECT_EQ(problems_of("pole_cone_deg = 10.5\n" + trunnion()), Texts{"1:17 pole-cone"});
  EXPECT_EQ(problems_of("pole_cone_deg = -1\n" + trunnion()), Texts{"1:17 pole-cone"});
  EXPECT_EQ(problems_of(trunnion() + "[kinematics_geometry]\ntool_zero_mm = [0, 0, nan]\n"), Texts{"33:16 tool-zero"});
  EXPECT_EQ(problems_of(trunnion() + "[kinematics_geometry]\ntool_zero = [0, 0, 0]\n"), Texts{"33:1 machine-key"});
  EXPECT_EQ(problems_of("kinematics_geometry = 5\n" + trunnion()), Texts{"1:23 machine-type"});
}

/// A chain needs its axes, and its keys need a chain.
TEST(RotaryChain, NeedsWhatItTurns) {
  const std::string without = machine_with("table-table-ac", rotary_axis("A"), rotary_axis("B"));
  EXPECT_EQ(problems_of(without), Texts{"1:14 machine-kinematics"});
  EXPECT_EQ(problems_of("kinematics = \"head-head-ac\"\n" + one_axis),
            (Texts{"1:14 machine-kinematics", "1:14 machine-kinematics", "1:14 machine-kinematics",
                   "1:14 machine-kinematics"}));
  EXPECT_EQ(problems_of(one_axis + rotary_axis("A") + "sign = 1\n"), Texts{"13:8 machine-kinematics"});
  EXPECT_EQ(problems_of("pole_cone_deg = 1\n" + one_axis), Texts{"1:17 machine-kinematics"});
  EXPECT_EQ(problems_of(trunnion() + rotary_axis("B") + "order = 1\n"), Texts{"38:9 machine-kinematics"});
  EXPECT_EQ(problems_of(one_axis + "sign = 1\n"), Texts{"7:1 machine-key"});
  EXPECT_EQ(problems_of("kinematics = \"tripod\"\n" + one_axis), Texts{"1:14 machine-kinematics"});
}

TEST(RotaryChain, OfAMisspeltNameIsTold) {
  const auto read = read_machine("kinematics = \"table-table-ca\"\n" + one_axis, "m");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error()[0].hint, "did you mean table-table-ac?");
}

}  // namespace test_rotary_chain
}  // namespace leadscrew::config::testing
