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
