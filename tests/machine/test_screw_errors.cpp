#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/machine/machine.hpp>
#include <limits>
#include <string>

namespace leadscrew::machine {
namespace test_screw_errors {

using Texts = std::vector<std::string>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Texts problems_with(const ScrewErrors& errors, base::Axis axis = base::Axis::X) {
  Machine machine = mill3();
  machine.screws[base::index(axis)] = errors;
  Texts texts;
  for (const base::Diagnostic& problem : validate(machine)) {
    EXPECT_FALSE(problem.hint.empty());
    texts.push_back(std::string(problem.code) + ": " + problem.message);
  }
  return texts;
}

TEST(ScrewErrors, MayBeAnyThatScrewsHave) {
  EXPECT_EQ(problems_with({}), Texts{});
  EXPECT_EQ(problems_with({.table = {{0, 0.3}}}), Texts{});
  EXPECT_EQ(problems_with({.table = {{0, 0}, {10, 1}, {20, 0}}}), Texts{});
  EXPECT_EQ(problems_with({.table = {{0, 0}}, .backward_table = {{-1, 0.1}, {7, 0}}, .backlash = 0.1}), Texts{});
  EXPECT_EQ(problems_with({.backlash = 0.1, .takeup_velocity = 5}), Texts{});
}

TEST(ScrewErrors, AreRefusedWithTheirEntry) {
  EXPECT_EQ(problems_with({.table = {{0, 0}, {10, 0.01}, {10, 0.02}}}),
            Texts{"pitch-order: axis X: pitch entry 3 is at 10, the one before at 10"});
  EXPECT_EQ(problems_with({.table = {{0, 0}, {10, -1.5}}}),
            Texts{"pitch-slope: axis X: pitch entry 2: the error changes by -1.5 along 10"});
  EXPECT_EQ(problems_with({.backward_table = {{0, 0}, {5, 0}, {2, 0}}}),
            Texts{"pitch-order: axis X: backward pitch entry 3 is at 2, the one before at 5"});
  EXPECT_EQ(problems_with({.table = {{0, nan}}}), Texts{"pitch-value: axis X: pitch entry 1 is 0, nan"});
  EXPECT_EQ(problems_with({.table = {{INFINITY, 0}}}), Texts{"pitch-value: axis X: pitch entry 1 is inf, 0"});
  EXPECT_EQ(problems_with({.backlash = -0.1}), Texts{"backlash: axis X: a backlash of -0.1"});
  EXPECT_EQ(problems_with({.backlash = nan}), Texts{"backlash: axis X: a backlash of nan"});
  EXPECT_EQ(problems_with({.takeup_velocity = -1}), Texts{"backlash-takeup: axis X: backlash taken up at -1"});
}

TEST(ScrewErrors, AreToldAllAtOnce) {
  const ScrewErrors errors{.table = {{0, 0}, {0, 0}, {1, nan}, {0.5, 0}, {0.4, 0}, {0.6, 1}},
                           .backward_table = {{0, 0}, {1, 1}},
                           .backlash = -1,
                           .takeup_velocity = INFINITY};
  EXPECT_EQ(problems_with(errors, base::Axis::Y),
            (Texts{"pitch-order: axis Y: pitch entry 2 is at 0, the one before at 0",
                   "pitch-value: axis Y: pitch entry 3 is 1, nan",
                   "pitch-order: axis Y: pitch entry 5 is at 0.4, the one before at 0.5",
                   "pitch-slope: axis Y: pitch entry 6: the error changes by 1 along 0.19999999999999996",
                   "pitch-slope: axis Y: backward pitch entry 2: the error changes by 1 along 1",
                   "backlash: axis Y: a backlash of -1", "backlash-takeup: axis Y: backlash taken up at inf"}));
}

TEST(ScrewErrors, AreOfAxesThatAreThere) {
  EXPECT_EQ(problems_with({.backlash = 0.1}, base::Axis::A),
            Texts{"pitch-axis: axis A: its screw has errors, but it is not there"});
  EXPECT_EQ(problems_with({}, base::Axis::A), Texts{});
}

}  // namespace test_screw_errors
}  // namespace leadscrew::machine
