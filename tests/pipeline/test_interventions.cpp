#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "interventions.hpp"
#include "live_program.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Feed override, feed hold, resume and a planner that comes late, at any instant: still no limit exceeded, never off
// the path, and at rest at the end.

namespace test_interventions {

using namespace leadscrew;
using testing_support::any;
using testing_support::expect_kept;
using testing_support::Intervention;
using testing_support::limits_of;
using testing_support::LiveProgram;
using testing_support::random_interventions;
using testing_support::random_machine;
using testing_support::RandomProgram;
using testing_support::worst_judged;
using testing_support::worst_planned;

constexpr std::int64_t most_ticks = 6'000;

/// Of a random program that nobody intervenes in. None if it takes too long.
std::optional<std::size_t> ticks_of(const std::string& text, const machine::Machine& machine) {
  LiveProgram whole(text, machine);
  if (!whole.run({}, most_ticks)) return std::nullopt;
  RC_ASSERT(whole.diagnostics == 0);
  return whole.words.size();
}

void keep_every_promise() {
  machine::Machine machine = random_machine();
  machine.period = {1'000'000};
  std::string text;
  std::optional<std::size_t> ticks;
  for (int blocks = 24; !ticks; blocks = std::max(1, blocks / 2)) {
    text = RandomProgram::make(blocks);
    RC_LOG() << text << limits_of(machine);
    ticks = ticks_of(text, machine);
  }
  const std::vector<Intervention> interventions = random_interventions(*ticks);
  LiveProgram live(text, machine);
  RC_ASSERT(live.run(interventions, 100 * most_ticks));
  expect_kept(live);
  // In one program of a thousand a change from next to nothing waits for the next window.
  RC_CLASSIFY(live.longest_wait > 0.05, "a change of feed waits");
  RC_ASSERT(live.longest_wait <= 1);
}

RC_GTEST_PROP(Interventions, KeepEveryLimitAndEveryPoint, ()) {
  keep_every_promise();
}
RC_GTEST_PROP(LongInterventions, KeepEveryLimitAndEveryPoint, ()) {
  for (int program = 0; program < 7; ++program) keep_every_promise();
}

/// Where a hold follows an override to almost nothing, speed falls by so much within one interval between knots that a
/// polynomial through its ends can pass below 0.
TEST(Interventions, DoNotTurnMotionBack) {
  machine::Machine machine;
  machine.period = {1'000'000};
  machine.axes[0] = machine::AxisLimits{-1e5, 1e5, 36.575645911623276, 134.17211158960586, 830286.74861513998, 0.001};
  machine.axes[1] = machine::AxisLimits{-1e5, 1e5, 14.326496708306824, 873.17291274558386, 822.96000564727387, 0.001};
  machine.axes[2] = machine::AxisLimits{-1e5, 1e5, 30.024238711787916, 806.05236158579237, 6399.8318395319411, 0.001};
  LiveProgram live("G21 G90 G93\nG1 X4 Y31 Z1.002 F15\nM2\n", machine);
  EXPECT_TRUE(live.run({{758, 0.01, 0}, {790, 0.0, 45}, {1098, 1.0, 0}}, 20'000));
  EXPECT_EQ(live.diagnostics, 0);
  EXPECT_EQ(live.words.back().position[1], 31);
  for (std::size_t k = 1; k < live.words.size(); ++k) {
    ASSERT_GE(live.words[k].position[1], live.words[k - 1].position[1] - 1e-12) << k;
  }
}

/// What a window kept of a creep ended where the new speed could not come to rest.
TEST(Interventions, RiseFromACreepAtOnce) {
  machine::Machine machine;
  machine.period = {1'000'000};
  machine.axes[0] = machine::AxisLimits{-1e5, 1e5, 64.971366985387377, 4729.2171378158964, 5629.4670154678133, 0.001};
  machine.axes[1] = machine::AxisLimits{-1e5, 1e5, 29.778444228087135, 811.65086292712715, 248076.98079227033, 0.001};
  LiveProgram live(
      "G21 G90 G94 G17 F600 G61\nG5 I0.499 J0.281 P-0.452 Q-0.389 X1.170 Y0.363\nG5 P-0.120 Q-0.340 X2.533 Y0.814\n"
      "G3 X5.533 Y-2.186 I3\nG3 X8.533 Y0.814 J3\nG3 X5.533 Y3.814 I-3\nG3 X2.533 Y0.814 J-3\nG3 X5.533 Y-2.186 I3\n"
      "G3 X8.533 Y0.814 J3\nM2\n",
      machine);
  EXPECT_TRUE(live.run({{492, 0.01, 15}, {3012, 0.5, 0}, {5877, 1, 0}}, 20'000));
  EXPECT_LE(live.longest_wait, 0.05);
}

struct Refused {
  const char* name;
  std::array<std::array<double, 3>, 4> limits;  ///< of X Y Z A: velocity, acceleration, jerk
  std::string text;
  std::vector<Intervention> interventions;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.name;
}

const std::vector<Refused> refused = {
    // A blend that took so much of a small circle that it turned on the spot.
    {"BlendOfASmallCircle",
     {{{13.657902382103508, 42.413025607206329, 85008.43979625887},
       {9.3680673495698414, 11884.153556045134, 45250.712408053369},
       {50.820625300424418, 17435.413625033107, 35238.296621030153},
       {15.459021612109872, 54.373245276937467, 2950923.0175137473}}},
     "G21 G90 G94 G17 F6290\nG64 P0.812516\nG3 X0.1 Y-0.1 I0.1 J0\nG3 X0.2 Y0 I0 J0.1\nG3 X0.1 Y0.1 I-0.1 J0\n"
     "G2 X-0.073 Y0.196 I-0.095 J0.033 P3\nM2\n",
     {{16, 0.3, 0}, {184, 0.9, 0}, {379, 0.5, 15}, {513, 0.01, 300}, {751, 1.3, 0}, {983, 1, 0}}},
    // Knots that were kept lay so much wider than new ones would that none were placed behind them.
    {"CurvesAtLowSpeed",
     {{{378.23176934224921, 20554.657980115575, 205246.45490792816},
       {181.37941813024145, 35.522314475559497, 3897.4105814707045},
       {381.32563692890477, 707.80276477637472, 5966.1995207567998},
       {338.58678553934459, 2840.8169772097344, 606.0398057634452}}},
     "G21 G90 G94 G17 F600\nG61.1\nG1 X0.045 Y4.83 Z-0.001 A0.084\nG5 I2.705 J2.445 P-3.89 Q-4.065 X14.195 Y6.215\n"
     "G5 P-2.96 Q-1.435 X27.27 Y8.105\nM2\n",
     {{1195, 0.01, 15}, {1824, 0.3, 15}, {2394, 0.3, 0}, {2733, 1, 45}, {3190, 0, 0}, {3541, 0.5, 0}, {3729, 1, 0}}},
    {"LineWithMuchJerk",
     {{{11.210681243761924, 382.64430564302427, 26637.09709924354},
       {372.80180321363912, 39.918779525150413, 138405.02559461631},
       {5.9073677037878944, 50.293198310593475, 2586.7215011904791},
       {268.89207611118957, 141.25676458071382, 140196.11130150454}}},
     "G21 G90 G94 G17 F600\nG61\nG1 X0 Y-0.069 Z-0.001\nG4 P0.101\nG2 X12.196 Y-18.834 A-19.77 I-1842.126 J-1210.612\n"
     "G1 X12.197 Y5.256 Z-0.001\nM2\n",
     {{2063, 0, 0}, {4651, 0.9, 0}, {6372, 0.01, 0}, {8008, 2, 45}, {8119, 1, 0}}}};

class Interrupted : public testing::TestWithParam<Refused> {};

/// Found at random, where the planner once gave up and let the motion come to rest.
TEST_P(Interrupted, GoOn) {
  machine::Machine machine;
  machine.period = {1'000'000};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [velocity, acceleration, jerk] = GetParam().limits[i];
    machine.axes[i] = machine::AxisLimits{-1e5, 1e5, velocity, acceleration, jerk, 0.001};
  }
  LiveProgram live(GetParam().text, machine);
  EXPECT_TRUE(live.run(GetParam().interventions, 100 * most_ticks));
  EXPECT_EQ(live.diagnostics, 0);
  EXPECT_EQ(live.refused_windows(), 0);
}

INSTANTIATE_TEST_SUITE_P(Programs, Interrupted, testing::ValuesIn(refused),
                         [](const auto& each) { return std::string(each.param.name); });

/// Ticks from the request at `tick` until speed is and stays at most `speed`.
std::int64_t ticks_until(const LiveProgram& live, std::int64_t tick, double speed) {
  auto last = static_cast<std::int64_t>(live.words.size());
  while (last > tick && live.words[static_cast<std::size_t>(last - 1)].feed <= speed) --last;
  return last - tick;
}

class OnALongWay : public testing::TestWithParam<const char*> {};

TEST_P(OnALongWay, AHoldActsWithin50MillisecondsAndTheBrakingTheLimitsForce) {
  const machine::Machine machine = machine::mill3();
  LiveProgram live(GetParam(), machine);
  live.run({{1500, 0.0, 0}}, 4000);
  EXPECT_EQ(live.words.back().feed, 0);
  // 100 mm/s to 0 with a = 1000, j = 20000: v/a + a/j.
  EXPECT_LE(ticks_until(live, 1500, 1e-9), 50 + 1.3 * 150) << live.words[1500].feed;
  EXPECT_LE(ticks_until(live, 1500, 5), 50 + 1.1 * 150);
}

TEST_P(OnALongWay, AnOverrideActsWithin50MillisecondsAndTheBrakingTheLimitsForce) {
  const machine::Machine machine = machine::mill3();
  LiveProgram live(GetParam(), machine);
  live.run({{1500, 0.5, 0}}, 2500);
  EXPECT_NEAR(live.words.back().feed, 50, 0.01);
  EXPECT_LE(ticks_until(live, 1500, 50 * 1.01), 50 + 1.2 * 100);  // v/a + a/j for 50 mm/s less
}

TEST_P(OnALongWay, AnOverrideUpwardsIsReached) {
  const machine::Machine machine = machine::mill3();
  LiveProgram live(GetParam(), machine);
  live.run({{1500, 1.5, 0}}, 2500);
  EXPECT_NEAR(live.words[1850].feed, 150, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Paths, OnALongWay,
                         testing::Values("G21 G90 G94\nG1 X400 F6000\nM2\n",
                                         "G21 G90 G94 G17\nG2 X0 Y0 I100 J0 F6000\nM2\n"));

}  // namespace test_interventions
