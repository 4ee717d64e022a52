#include <array>
#include <leadscrew/gcode/parameters.hpp>
#include <limits>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_parameters {

double last_x(std::string_view text, const Conditions& conditions = {}) {
  return at(read_well(text, conditions).lines().back().end, base::Axis::X);
}

TEST(Parameters, AreSetAfterTheBlockHasBeenRead) {
  EXPECT_EQ(last_x("#3=15\n#3=6 G0 X#3\nM2\n"), 15);
  EXPECT_EQ(last_x("#3=15\n#3=6 G0 X#3\nX#3\nM2\n"), 6);
  EXPECT_EQ(last_x("#1=1\n#1=[#1+1] #2=[#1*10]\nG0 X[#1+#2]\nM2\n"), 12);
}

TEST(Parameters, TakeTheLastOfTwoSettings) {
  EXPECT_EQ(last_x("#1=1 #1=2\nG0 X#1\nM2\n"), 2);
}

TEST(Parameters, HaveLocalAndGlobalNames) {
  EXPECT_EQ(last_x("#<a b>=3 #<_Global>=4\nG0 X[#<AB>+#<_global>]\nM2\n"), 7);
}

TEST(Parameters, TellThePosition) {
  EXPECT_EQ(last_x("G0 X10 Y4\nG92 X3\nG0 X[#5420+#5421]\nM2\n"), 14);  // X3 + 4 of the program is 14 of the machine
  EXPECT_EQ(last_x("G20\nG0 Y2\nG0 X#5421\nM2\n"), 2 * 25.4);
  EXPECT_EQ(last_x("G20 G0 A45\nG21 G0 X#5423\nM2\n"), 45);
}

TEST(Parameters, TellTheCoordinateSystem) {
  EXPECT_EQ(last_x("G59.1\nG0 X#5220\nM2\n"), 7);
  EXPECT_EQ(last_x("G10 L2 P2 Y12\nG0 X#5242\nM2\n"), 12);
  EXPECT_EQ(last_x("G10 L2 P3 R30\nG0 X#5270\nM2\n"), 30);
}

TEST(Parameters, TellTheShiftOfG92) {
  EXPECT_EQ(last_x("G92 X-7\nG0 X[#5211 + 10 * #5210]\nM2\n"), 24);
  EXPECT_EQ(last_x("G92 X-7\nG92.2\nG0 X[#5211 + 10 * #5210]\nM2\n"), 7);
}

TEST(Parameters, SetOriginsWhenTheSystemIsSelected) {
  EXPECT_EQ(last_x("#5241=100\nG55 G0 X1\nM2\n"), 101);
  EXPECT_EQ(last_x("#5221=100\nG0 X1\nM2\n"), 1);
}

TEST(Parameters, SetThePlacesOfG28AndG30) {
  EXPECT_EQ(last_x("#5161=30\nG28\nM2\n"), 30);
  EXPECT_EQ(last_x("#5181=-30\nG30\nM2\n"), -30);
}

TEST(Parameters, HaveABoundedNumberOfNames) {
  std::string text;
  for (int i = 0; i < 10'001; ++i) text += "#<n" + std::to_string(i) + ">=1\n";
  EXPECT_EQ(read(text + "M2\n").problems(), "10001:1 too-many-parameters; ");
}

TEST(ParametersOfCalls, AreTheirOwnUpToThirty) {
  Parameters parameters;
  parameters.set(1, 10);
  parameters.set(30, 300);
  parameters.set(31, 310);
  ASSERT_TRUE(parameters.enter_call(std::array{5.0}));
  EXPECT_EQ(parameters.get(1), 5);
  EXPECT_EQ(parameters.get(2), 0);
  EXPECT_EQ(parameters.get(30), 0);
  parameters.set(1, 6);
  parameters.set(7, 8);
  parameters.set(31, 311);
  parameters.leave_call();
  EXPECT_EQ(parameters.get(1), 10);
  EXPECT_EQ(parameters.get(7), std::nullopt);
  EXPECT_EQ(parameters.get(30), 300);
  EXPECT_EQ(parameters.get(31), 311);
}

TEST(ParametersOfCalls, MayBeVacant) {
  Parameters parameters;
  parameters.set(2, 20);
  ASSERT_TRUE(parameters.enter_call(std::array{1.0, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_EQ(parameters.get(2), std::nullopt);
  parameters.leave_call();
  EXPECT_EQ(parameters.get(2), 20);
}

TEST(ParametersOfCalls, AreThirtyThreeOfMacros) {
  Parameters parameters;
  parameters.set(33, 330);
  parameters.set(34, 340);
  std::array<double, Parameters::macro_locals> arguments;
  arguments.fill(std::numeric_limits<double>::quiet_NaN());
  ASSERT_TRUE(parameters.enter_call(arguments));
  EXPECT_EQ(parameters.get(33), std::nullopt);
  parameters.set(33, 5);
  parameters.set(34, 6);
  parameters.leave_call();
  EXPECT_EQ(parameters.get(33), 330);
  EXPECT_EQ(parameters.get(34), 6);
}

TEST(ParametersOfCalls, HaveLocalNamesOfTheirOwn) {
  Parameters parameters;
  parameters.set("A", 1);
  parameters.set("_G", 2);
  ASSERT_TRUE(parameters.enter_call({}));
  EXPECT_EQ(parameters.get("A"), std::nullopt);
  EXPECT_EQ(parameters.get("_G"), 2);
  parameters.set("A", 3);
  parameters.set("A", 4);
  parameters.set("_G", 5);
  parameters.set("_LATE", 6);
  ASSERT_TRUE(parameters.enter_call({}));
  EXPECT_EQ(parameters.get("A"), std::nullopt);
  parameters.set("A", 7);
  parameters.leave_call();
  EXPECT_EQ(parameters.get("A"), 4);
  parameters.leave_call();
  EXPECT_EQ(parameters.get("A"), 1);
  EXPECT_EQ(parameters.get("_G"), 5);
  EXPECT_EQ(parameters.get("_LATE"), 6);
}

TEST(ParametersOfCalls, ForgetTheirNamesBetweenCalls) {
  Parameters parameters;
  ASSERT_TRUE(parameters.enter_call({}));
  parameters.set("A", 3);
  parameters.leave_call();
  EXPECT_EQ(parameters.get("A"), std::nullopt);
  ASSERT_TRUE(parameters.enter_call({}));
  EXPECT_EQ(parameters.get("A"), std::nullopt);
}

TEST(ParametersOfCalls, AreBounded) {
  Parameters parameters;
  for (std::size_t i = 0; i < Parameters::most_calls; ++i) ASSERT_TRUE(parameters.enter_call({}));
  parameters.set(1, 1);
  EXPECT_FALSE(parameters.enter_call(std::array{2.0}));
  EXPECT_EQ(parameters.get(1), 1);
  for (std::size_t i = 0; i < Parameters::most_calls; ++i) parameters.leave_call();
  EXPECT_EQ(parameters.calls(), 0u);
}

TEST(ParametersOfCalls, HideABoundedNumberOfNames) {
  Parameters parameters;
  bool all = true;
  for (int call = 0; call < 11; ++call) {
    ASSERT_TRUE(parameters.enter_call({}));
    for (std::size_t i = 0; i < Parameters::most_names; ++i) all = all && parameters.set("N" + std::to_string(i), call);
  }
  EXPECT_FALSE(all);
  for (int call = 0; call < 11; ++call) parameters.leave_call();
  EXPECT_EQ(parameters.get("N0"), std::nullopt);
}

}  // namespace test_parameters
}  // namespace leadscrew::gcode
