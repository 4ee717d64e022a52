#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <leadscrew/gcode/tool_table.hpp>
#include <limits>
#include <sstream>

#include "paths.hpp"
#include "six_axes.hpp"

// A motion that is planned at once: its duration, and its axes at any time.

namespace test_trajectory {

using namespace leadscrew;
using namespace leadscrew::host_tests;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const base::AxisVector& a, const base::AxisVector& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return same_bits(x, y); });
}

bool is_word(const host::TrajectoryState& at, const base::Word& word) {
  return same_bits(at.position, word.position) && same_bits(at.path_length, word.path_length) &&
         same_bits(at.speed, word.speed) && same_bits(at.feed, word.feed) && at.line == word.line &&
         at.state == word.state;
}

/// Every word, by its tick and by its time, and how long the words take.
void expect_the_words(const host::Trajectory& planned, const std::vector<base::Word>& words, base::Period period) {
  for (const base::Word& word : words) {
    ASSERT_TRUE(is_word(planned.at(base::seconds(word.tick, period)), word)) << base::count(word.tick);
    // As a caller computes it.
    ASSERT_TRUE(is_word(planned.at(static_cast<double>(base::count(word.tick)) * period.seconds()), word));
    const base::Word again = planned.word(word.tick);
    ASSERT_EQ(again.tick, word.tick);
    ASSERT_TRUE(same_bits(again.position, word.position) && again.state == word.state && again.line == word.line);
  }
  pipeline::TrajectoryWalk walk(planned);
  for (const base::Word& word : words) {
    for (const double share : {0.0, 0.3, 0.9}) {
      const double time = base::seconds(word.tick, period) + share * period.seconds();
      const pipeline::TrajectoryState along = walk.at(time), there = planned.at(time);
      ASSERT_TRUE(same_bits(along.position, there.position) && same_bits(along.velocity, there.velocity) &&
                  same_bits(along.acceleration, there.acceleration) && same_bits(along.jerk, there.jerk) &&
                  same_bits(along.path_length, there.path_length) && same_bits(along.feed, there.feed) &&
                  along.line == there.line && along.state == there.state)
          << time;
    }
  }
  ASSERT_EQ(planned.last_tick(), words.back().tick);
  const double end = base::seconds(words.back().tick, period), rounding = 1e-15 * end;
  ASSERT_LE(planned.duration(), end + rounding);
  ASSERT_GE(planned.duration(), end - period.seconds() - rounding);
}

std::string example(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(LEADSCREW_SOURCE_DIR "/examples/" + name).rdbuf();
  return text.str();
}

host::Trajectory planned(const host::Motion& motion) {
  auto trajectory = motion.plan();
  EXPECT_TRUE(trajectory);
  return trajectory ? std::move(*trajectory) : host::Trajectory({}, {});
}

RC_GTEST_PROP(HostTrajectory, HasTheWordsOfItsMotion, ()) {
  const std::string text = random_path();
  RC_LOG() << text;
  const auto motion = program(text);
  const host::Trajectory before = planned(*motion);
  const auto words = words_of(*motion);
  expect_the_words(before, words, machine::mill3().period);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(HostTrajectory, HasTheWordsOfCurvesDwellsAndRotaryAxes) {
  for (const std::string name : {"05-finishing", "06-drilling", "07-rotary", "09-butterfly", "11-splines"}) {
    machine::Machine machine = testing_support::mill_of_six_axes();
    machine.period = {3'000'000};
    host::MotionOptions options;
    options.tools = gcode::read_tool_table(example("tools.tbl"), {}).table;
    auto motion = host::Motion::of_program(machine, example(name + ".ngc"), options);
    ASSERT_TRUE(motion) << name << motion.error().message;
    SCOPED_TRACE(name);
    const auto words = words_of(**motion);
    expect_the_words(planned(**motion), words, machine.period);  // of a program, afterwards as well
  }
}

/// Within so much of the time the limits let axes move farther than the difference tells.
RC_GTEST_PROP(HostTrajectory, RatesAreThoseOfTheDifferences, ()) {
  const auto motion = program(random_path());
  const host::Trajectory trajectory = planned(*motion);
  const double duration = trajectory.duration();
  constexpr double h = 1e-5, slack = 1.01;
  const auto between = [&](double t) { return *rc::gen::inRange(0, 1'000'000) * 1e-6 * t; };
  for (int k = 0; k < 50; ++k) {
    const double t = std::min(h + between(duration - 3 * h), duration - 2 * h);
    if (t < h) continue;
    const auto before = trajectory.at(t - h), here = trajectory.at(t), behind = trajectory.at(t + h);
    for (std::size_t i = 0; i < 3; ++i) {
      const double jerk = slack * machine::mill3().limits(base::all_axes[i]).jerk;
      const double velocity = (behind.position[i] - before.position[i]) / (2 * h);
      RC_ASSERT(std::abs(velocity - here.velocity[i]) <= jerk * h * h / 6 + 1e-8);  // 1e-13 mm / h of rounding
      const double acceleration = (behind.velocity[i] - before.velocity[i]) / (2 * h);
      RC_ASSERT(std::abs(acceleration - here.acceleration[i]) <= jerk * h + 1e-6);
      // Between steps of the jerk: of its mean.
      const double most = std::max({before.jerk[i], here.jerk[i], behind.jerk[i]});
      const double least = std::min({before.jerk[i], here.jerk[i], behind.jerk[i]});
      const double mean = (behind.acceleration[i] - before.acceleration[i]) / (2 * h);
      if (most - least < 0.01 * jerk) RC_ASSERT(mean >= least - 0.02 * jerk && mean <= most + 0.02 * jerk);
      RC_ASSERT(std::abs(here.jerk[i]) <= jerk);
    }
  }
}

TEST(HostTrajectory, OfALineHasItsClosedForm) {
  // X: 100 mm at 40 mm/s with 1000 mm/s² and 20 000 mm/s³, which 40 mm/s does not reach: √(v j) = 894 mm/s².
  host::Motion motion(machine::mill3());
  ASSERT_TRUE(motion.push(host::line({100}, 40)));
  const host::Trajectory trajectory = planned(motion);
  const double j = machine::mill3().limits(base::Axis::X).jerk, ramp = std::sqrt(40 / j);
  EXPECT_NEAR(trajectory.duration(), 100.0 / 40 + 2 * ramp, 1e-9);
  const auto third = trajectory.at(ramp / 3), top = trajectory.at(1), end = trajectory.at(trajectory.duration());
  EXPECT_NEAR(third.position[0], j * std::pow(ramp / 3, 3) / 6, 1e-9);
  EXPECT_NEAR(third.velocity[0], j * std::pow(ramp / 3, 2) / 2, 1e-9);
  EXPECT_NEAR(third.acceleration[0], j * ramp / 3, 1e-6);
  EXPECT_NEAR(third.jerk[0], j, 1e-6);
  EXPECT_NEAR(top.velocity[0], 40, 1e-9);
  EXPECT_EQ(top.state, base::MotionState::constant);
  EXPECT_EQ(end.position[0], 100);
  EXPECT_NEAR(end.velocity[0], 0, 1e-9);
  EXPECT_NEAR(trajectory.length(), 100, 1e-12);
}

TEST(HostTrajectory, RestsBeforeAndBehind) {
  host::Motion motion(machine::mill3());
  ASSERT_TRUE(motion.push(host::line({10, 5}, 40)));
  const host::Trajectory trajectory = planned(motion);
  for (const double t : {-1.0, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(trajectory.at(t).position, base::AxisVector{});
    EXPECT_NEAR(trajectory.at(t).velocity[0], 0, 1e-12);
  }
  for (const double t : {trajectory.duration() + 1e-9, 1e6, 1e300, HUGE_VAL}) {
    EXPECT_EQ(trajectory.at(t).position, (base::AxisVector{10, 5}));
    EXPECT_EQ(trajectory.at(t).velocity, base::AxisVector{});
    EXPECT_EQ(trajectory.at(t).jerk, base::AxisVector{});
    EXPECT_EQ(trajectory.at(t).state, base::MotionState::rest);
  }
  const host::Trajectory none = planned(host::Motion(machine::mill3(), {.start = {3}}));
  EXPECT_EQ(none.duration(), 0);
  EXPECT_EQ(none.at(1).position, base::AxisVector{3});
  EXPECT_EQ(base::count(none.last_tick()), 0);
}

TEST(HostTrajectory, OfMovesIsAskedForBeforeTheyGo) {
  host::Motion motion(machine::mill3());
  ASSERT_TRUE(motion.push(host::line({10}, 40)));
  const double there = planned(motion).duration();
  ASSERT_TRUE(motion.push(host::line({0}, 40)));
  host::Trajectory both = planned(motion);
  EXPECT_NEAR(both.duration(), 2 * there, 1e-9);
  motion.finish();
  const auto words = words_of(motion);
  const host::Trajectory moved = std::move(both);  // what it refers to moves along
  expect_the_words(moved, words, machine::mill3().period);
  EXPECT_EQ(motion.plan().error().code, "motion-moves");
  ASSERT_TRUE(motion.reset({5}));
  EXPECT_EQ(planned(motion).at(0).position, base::AxisVector{5});
}

}  // namespace test_trajectory
