// Feed per revolution (G95) beside a simulated spindle, on random machines: F times the speed that the spindle has.
//
// The spindle is asked where a slice begins, and what it says holds to the end of that slice, no more than L = 1.5 slices and a
// period later. Its speed is S (1 + ε w), |w'| ≤ Σ c_k 2πk/P ≤ 6π/P in its own time, which goes by 1 + ε at most: in t it changes
// by no more than
//
//     S ε (1 + ε) · 6π/P · t.
//
// What a slice changes is Δv = F S times the change over L and what has been passed over, in three phases of constant jerk that
// take 2 √(Δv/j), or more by the acceleration: until then the feed is between what it was and what it is to be. So |feed − F n|
// is no more than F times that change with t = 2 L + 2 √(Δv/j) + Δv/a, and what is passed over.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "judged_run.hpp"
#include "spindle_machines.hpp"

namespace test_feed_per_revolution {

using namespace leadscrew;
using planner::Planner;
using testing_support::between;
using testing_support::SpindleOfEvents;

RC_GTEST_PROP(FeedPerRevolution, FollowsTheSpindleWithinASlice, ()) {
  machine::Machine machine = testing_support::machine_with_spindle();
  const machine::Derivatives least = testing_support::least_limits(machine);
  const double turns = 100 * between(0.01, 1), v = least.velocity * between(0.05, 0.85), f = v / turns;  // mm/s, mm
  machine.spindle->acceleration = std::max(machine.spindle->acceleration, 60 * turns / 0.5);
  const double rise = 2 * std::sqrt(v / least.jerk) + v / least.acceleration, way = 2 * v * rise;
  const double length = 2 * way + v * between(1, 4);
  char block[200];
  std::snprintf(block, sizeof block, "G21 G90 G94 G17\nS%.6f M%d\nG95 F%.9f\nG1 X%.4f Y%.4f\nG94\nG1 X0 F600\nM2\n",
                60 * turns, *rc::gen::inRange(3, 5), f, length * 0.8, length * 0.6);
  RC_LOG() << block << testing_support::limits_with_spindle(machine);
  SpindleOfEvents spindle(machine);
  const double wander = machine.spindle->wander, period = machine.period.seconds();
  const double slice = 1.5 * Planner::feed_slice + period;
  const double rate = wander * (1 + wander) * 6 * std::numbers::pi / machine.spindle->wander_period;
  const double passed_over = v * Planner::least_spindle_change * (1 + wander), change = v * rate * slice + passed_over;
  const double settles = 2 * slice + 2 * std::sqrt(change / least.jerk) + change / least.acceleration;
  const double bound = v * rate * settles + passed_over;
  double worst = 0, at_speed_since = 0;
  std::int64_t cruising = 0;
  const auto see = [&](const base::Word& word) {
    const std::int64_t tick = base::count(word.tick);
    const double t = static_cast<double>(tick) * period;
    if (!spindle.is_at_speed(tick)) at_speed_since = t;
    const bool has_settled = t > at_speed_since + settles + 2 * rise && word.path_length > way;
    if (!has_settled || word.path_length > length - way) return;
    ++cruising;
    worst = std::max(worst, std::abs(word.feed - f * std::abs(spindle.speed(tick))));
  };
  testing_support::judged_run(block, machine, [&](const base::PassedEvent& event) { spindle.obey(event); }, see);
  RC_LOG() << "off by " << worst / v << " of F S, bound " << bound / v << ", in " << cruising << " words\n";
  RC_ASSERT(worst <= bound);
  RC_CLASSIFY(cruising > 10, "long enough");
}

/// Along lines and curves, over changes of S on the way, all limits are kept.
RC_GTEST_PROP(FeedPerRevolution, KeepsLimitsAlongCurves, ()) {
  const machine::Machine machine = testing_support::machine_with_spindle();
  const machine::Derivatives least = testing_support::least_limits(machine);
  const double turns = 100 * between(0.02, 1), v = least.velocity * between(0.2, 1), f = v / turns;
  char block[100];
  std::snprintf(block, sizeof block, "G21 G90 G94 G17 G64 P0.05\nS%.4f M3\nG95 F%.6f\n", 60 * turns, f);
  std::string text = block;
  double x = 0;
  for (int k = 0; k < 4; ++k) {
    x += v * between(0.02, 0.2);
    std::snprintf(block, sizeof block, "G1 X%.3f Y%.3f S%.4f\n", x, v * between(-0.2, 0.2),
                  60 * turns * between(0.5, 1));
    text += block;
  }
  std::snprintf(block, sizeof block, "G1 Y0\nG2 X%.3f I%.3f J0\nG0 Y0\nG94 G1 X0 F6000\nM2\n", x + v * 0.1, v * 0.05);
  text += block;
  RC_LOG() << text << testing_support::limits_with_spindle(machine);
  const pipeline::Summary summary =
      testing_support::judged_run(text, machine, [](const base::PassedEvent&) {}, [](const base::Word&) {});
  RC_ASSERT(summary.bound_s <= summary.time_s * (1 + 1e-6));
}

/// A spindle that takes long to turn: motion creeps, in windows of many knots, which end in motion though all knots to rest
/// have been placed. Rapids between.
RC_GTEST_PROP(FeedPerRevolution, CreepsWhileTheSpindleTakesUpSpeed, ()) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = between(200, 2000), .wander = 0.05, .seed = 3};
  char block[100];
  std::snprintf(block, sizeof block, "G18 G21 G90 S%d M3\nG95 F0.2\n", 100 * *rc::gen::inRange(2, 9));
  std::string text = block;
  for (int k = *rc::gen::inRange(2, 7); k > 0; --k) {
    std::snprintf(block, sizeof block, "G%d X%d Z%d\n", *rc::gen::inRange(0, 2), *rc::gen::inRange(0, 30),
                  *rc::gen::inRange(0, 30));
    text += block;
  }
  text += "M2\n";
  RC_LOG() << text << testing_support::limits_with_spindle(machine);
  testing_support::judged_run(text, machine, [](const base::PassedEvent&) {}, [](const base::Word&) {});
}

std::vector<base::Word> words_of(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {},
                            [](const base::Diagnostic& problem) { ADD_FAILURE() << problem.message; });
  program.on_event([](const base::PassedEvent& event) { EXPECT_NE(base::code_of(event), "G95"); });
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  return words;
}

/// Of a spindle that does not wander: F times S, to the last bits, once it has taken up its speed.
TEST(FeedPerRevolution, IsThatOfSWhereTheSpindleDoesNotWander) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 1000};
  int cruising = 0;
  double slow = 0;
  for (const base::Word& word : words_of("G21 G90\nS1200 M3\nG95 F0.5\nG1 X100\nM2\n", machine)) {
    const double t = static_cast<double>(base::count(word.tick)) * machine.period.seconds();
    if (t < 1.1) slow = std::max(slow, word.feed - 10 * t / 1.2);  // 1200 revolutions per minute by 1000 in a second
    if (t < 1.4 || word.path_length > 95) continue;
    ++cruising;
    EXPECT_NEAR(word.feed, 10, 1e-9);
  }
  EXPECT_GT(cruising, 1000);
  EXPECT_LT(slow, 0.25);  // of what is least, and no faster than the spindle
}

/// The end of a window in motion was where the section comes to rest: no knot was new.
TEST(FeedPerRevolution, GoesOnWhereAllKnotsToRestAreThere) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 500, .wander = 0.05, .seed = 3};
  const std::vector<base::Word> words =
      words_of("G18 G21 G90 S600 M3\nG95 F0.2\nG0 X1\nX11\nG1 Z20\nG0 X1 Z0\nG1 Z20\nZ60\nM2\n", machine);
  EXPECT_NEAR(words.back().position[2], 60, 1e-12);
}

/// Without a simulated spindle, and in minutes, nothing changes.
TEST(FeedPerRevolution, IsThatOfSWithoutASpindle) {
  machine::Machine machine = machine::mill3();
  const auto positions = [&](const std::string& feed) {
    std::vector<base::AxisVector> all;
    for (const base::Word& word : words_of("G21 G90\nS1200 M3\n" + feed + "\nG1 X30\nG2 X40 I5 J0\nM2\n", machine))
      all.push_back(word.position);
    return all;
  };
  const auto by_minute = positions("G94 F600");
  EXPECT_EQ(positions("G95 F0.5"), by_minute);
  machine.spindle = machine::Spindle{.acceleration = 1e9, .wander = 0.05};
  EXPECT_EQ(positions("G94 F600"), by_minute);
  EXPECT_NE(positions("G95 F0.5"), by_minute);
}

}  // namespace test_feed_per_revolution
