#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>

namespace test_machine {

using leadscrew::base::Axis;
using leadscrew::machine::Machine;

leadscrew::machine::AxisLimits& limits_of_x(Machine& machine) {
  return *machine.axes[0];
}

TEST(BuiltInMill, IsSoundAndHasTheDocumentedLimits) {
  const Machine mill = leadscrew::machine::mill3();
  EXPECT_TRUE(leadscrew::machine::validate(mill).empty());
  EXPECT_TRUE(mill.has(Axis::X) && mill.has(Axis::Y) && mill.has(Axis::Z));
  EXPECT_FALSE(mill.has(Axis::A));
  EXPECT_EQ(mill.limits(Axis::Y).velocity, 200);
  EXPECT_EQ(mill.limits(Axis::Y).acceleration, 1000);
  EXPECT_EQ(mill.limits(Axis::Y).jerk, 20000);
  EXPECT_EQ(mill.period.nanoseconds, 1'000'000);
}

/// A mill with a table-table of A and C.
Machine mill_of_five_axes() {
  Machine machine = leadscrew::machine::mill3();
  machine.axes[leadscrew::base::index(Axis::A)] = machine.axes[leadscrew::base::index(Axis::C)] = machine.axes[0];
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = leadscrew::machine::preset_chain(machine.kinematics);
  return machine;
}

TEST(Chain, OfAMachineIsSound) {
  EXPECT_TRUE(leadscrew::machine::validate(mill_of_five_axes()).empty());
  EXPECT_FALSE(leadscrew::machine::preset_chain("cartesian"));
}

struct SpoiledChain {
  std::string_view code;
  std::function<void(Machine&)> spoil;
};

class ChainValidation : public testing::TestWithParam<SpoiledChain> {};

TEST_P(ChainValidation, NamesTheOneThingThatIsWrong) {
  Machine machine = mill_of_five_axes();
  GetParam().spoil(machine);
  const auto problems = leadscrew::machine::validate(machine);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, GetParam().code);
  EXPECT_FALSE(problems[0].hint.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Spoils, ChainValidation,
    testing::Values(
        SpoiledChain{"machine-kinematics", [](Machine& m) { m.axes[0].reset(); }},
        SpoiledChain{"machine-kinematics", [](Machine& m) { m.rotary_chain.reset(); }},
        SpoiledChain{"machine-kinematics", [](Machine& m) { m.kinematics = "cartesian"; }},
        SpoiledChain{"rotary-axis", [](Machine& m) { m.rotary_chain->axes[1].axis = Axis::A; }},
        SpoiledChain{"rotary-axis", [](Machine& m) { m.rotary_chain->axes[1].axis = Axis::X; }},
        SpoiledChain{"rotary-direction", [](Machine& m) { m.rotary_chain->axes[0].direction = {1, 0, 2e-3}; }},
        SpoiledChain{"rotary-point", [](Machine& m) { m.rotary_chain->axes[0].point[2] = INFINITY; }},
        SpoiledChain{"rotary-order", [](Machine& m) { m.rotary_chain->axes[0].order = 0; }},
        SpoiledChain{"rotary-order", [](Machine& m) { m.rotary_chain->axes[0].order = 2; }},
        SpoiledChain{"rotary-sign", [](Machine& m) { m.rotary_chain->axes[1].sign = 2; }},
        SpoiledChain{"rotary-parallel", [](Machine& m) { m.rotary_chain->axes[1].direction = {1, 1e-4, 0}; }},
        SpoiledChain{"rotary-parallel",
                     [](Machine& m) {
                       m.rotary_chain->axes[0].direction = {0, 0, 1};
                       m.rotary_chain->axes[1].direction = {0, 1, 0};
                     }},
        SpoiledChain{"tool-zero", [](Machine& m) { m.rotary_chain->tool_zero[0] = std::nan(""); }},
        SpoiledChain{"orientation-tolerance", [](Machine& m) { m.rotary_chain->orientation_tolerance = 0; }},
        SpoiledChain{"pole-cone", [](Machine& m) { m.rotary_chain->pole_cone = 11; }}));

struct Spoiled {
  std::string_view code;
  std::function<void(Machine&)> spoil;
};

class Validation : public testing::TestWithParam<Spoiled> {};

TEST_P(Validation, NamesTheOneThingThatIsWrong) {
  Machine machine = leadscrew::machine::mill3();
  GetParam().spoil(machine);
  const auto problems = leadscrew::machine::validate(machine);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].code, GetParam().code);
  EXPECT_FALSE(problems[0].hint.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Spoils, Validation,
    testing::Values(Spoiled{"machine-limit", [](Machine& m) { limits_of_x(m).velocity = 0; }},
                    Spoiled{"machine-limit", [](Machine& m) { limits_of_x(m).acceleration = -1; }},
                    Spoiled{"machine-limit", [](Machine& m) { limits_of_x(m).jerk = std::nan(""); }},
                    Spoiled{"machine-limit", [](Machine& m) { limits_of_x(m).blu = INFINITY; }},
                    Spoiled{"machine-travel", [](Machine& m) { limits_of_x(m).travel_max = -500; }},
                    Spoiled{"machine-period", [](Machine& m) { m.period.nanoseconds = 9'999; }},
                    Spoiled{"machine-period", [](Machine& m) { m.period.nanoseconds = 20'000'001; }},
                    Spoiled{"machine-tolerance", [](Machine& m) { m.tolerance = -0.001; }},
                    Spoiled{"machine-chord-error", [](Machine& m) { m.chord_error = 0; }},
                    Spoiled{"machine-kinematics", [](Machine& m) { m.kinematics = "tripod"; }},
                    Spoiled{"machine-axes", [](Machine& m) { m.axes = {}; }}));

TEST(ToolTable, FindsToolsByNumber) {
  const leadscrew::machine::ToolTable table({{3, 1, {}, 0, {}}, {7, 2, {}, 0, {}}});
  ASSERT_NE(table.find(7), nullptr);
  EXPECT_EQ(table.find(7)->pocket, 2);
  EXPECT_EQ(table.find(4), nullptr);
}

}  // namespace test_machine
