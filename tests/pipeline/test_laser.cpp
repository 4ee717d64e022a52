#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/machine/laser.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <vector>

// A laser's power, word by word: what the program asks for, times actual over programmed feed.

namespace test_laser {

using namespace leadscrew;
using machine::Laser;

struct Lit {
  base::Word word;
  double power = 0;
};

machine::Machine machine_with(const Laser& laser) {
  machine::Machine machine = machine::mill3();
  machine.laser = laser;
  machine.spindle_waits = false;
  return machine;
}

/// Every word with its power.
std::vector<Lit> run(const std::string& text, const Laser& laser, double factor = 1) {
  const machine::Machine machine = machine_with(laser);
  const machine::ToolTable tools;
  const auto fail = [](const base::Diagnostic& problem) { ADD_FAILURE() << problem.message; };
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, fail);
  machine::LaserPower power(laser);
  program.on_event([&](const base::PassedEvent& event) { power.observe(event); });
  program.override_feed(factor);
  std::vector<Lit> lit;
  while (program.prepare()) {
    const base::Word word = program.cycle();
    lit.push_back({word, power.at(word)});
  }
  return lit;
}

constexpr Laser by_speed{.power = Laser::Power::spindle_speed};
constexpr Laser by_output{.power = Laser::Power::analog_output, .output = 3};

/// A line from 0 to 40 mm at 6000 mm/min, of which the middle is travelled at that feed.
const std::string line = "G21 G90 G94 G61 F6000\nM3 S80\nG1 X40\nM5\nM2\n";

TEST(Laser, GivesWhatIsAskedForWhereFeedIsReached) {
  for (const auto& [text, laser] : {std::pair(line, by_speed),
                                    {"G21 G90 G94 G61 F6000\nM67 E3 Q80\nG1 X40\nM2\n", by_output},
                                    {"G21 G90 G94 G61 F6000\nM68 E3 Q80\nG1 X40\nM2\n", by_output}}) {
    int constant = 0;
    for (const auto& [word, power] : run(text, laser)) {
      if (word.state != base::MotionState::constant) continue;
      EXPECT_NEAR(power, 80, 80e-6);
      ++constant;
    }
    EXPECT_GT(constant, 100);
  }
}

TEST(Laser, FollowsFeedInAccelerations) {
  int changing = 0;
  for (const auto& [word, power] : run(line, by_speed)) {
    EXPECT_NEAR(power, 80 * word.feed / 100, 1e-9) << base::count(word.tick);
    EXPECT_TRUE(power == 0 || word.state != base::MotionState::rest);
    changing += power > 1 && power < 79 ? 1 : 0;
  }
  EXPECT_GT(changing, 50);
}

TEST(Laser, DoesNotFollowFeedUnlessItIsToldTo) {
  Laser laser = by_speed;
  laser.follow_feed = false;
  const std::vector<Lit> lit = run(line, laser);
  for (const auto& [word, power] : lit) {
    const bool is_lit = word.path_length > 0 && word.path_length < 40;
    EXPECT_TRUE(power == 80 || !is_lit) << base::count(word.tick);
  }
  EXPECT_EQ(lit.back().power, 0);
}

TEST(Laser, IsDarkInRapidsAndDwells) {
  int rapid = 0, burning = 0, dwelling = 0;
  for (const auto& [word, power] :
       run("G21 G90 G94 G64 P0.05 F6000\nM67 E3 Q5\nG1 X20\nG0 X40 Y5\nG1 X60\nG4 P0.2\nX80\nM2\n", by_output)) {
    const double x = word.position[0];
    const bool is_in_blend = std::abs(x - 20) < 1 || std::abs(x - 40) < 1;
    if (is_in_blend) continue;
    if (x > 20 && x < 40) {
      EXPECT_EQ(power, 0);
      ++rapid;
    } else if (word.state == base::MotionState::rest) {
      EXPECT_EQ(power, 0);
      ++dwelling;
    } else {
      EXPECT_NEAR(power, 5 * word.feed / 100, 1e-9);
      ++burning;
    }
  }
  EXPECT_GT(rapid, 50);
  EXPECT_GT(burning, 200);
  EXPECT_GE(dwelling, 200);
}

TEST(Laser, IsDarkBehindAChangeOfTool) {
  int lit = 0;
  for (const auto& [word, power] : run("G21 G90 G94 G61 F6000\nM3 S80\nG1 X20\nT1 M6\nX40\nM2\n", by_speed)) {
    EXPECT_TRUE(word.position[0] <= 20 || power == 0) << base::count(word.tick);
    lit += power > 0 ? 1 : 0;
  }
  EXPECT_GT(lit, 50);
}

/// A raster in one direction: what is asked for changes from line to line, at the first word on or behind the joint.
TEST(Laser, ChangesWithTheWordThatPassesTheJoint) {
  std::string text = "G21 G90 G94 G64 P0.01 F6000\nM3 S0\nG1 X10\n";
  for (int k = 1; k <= 60; ++k) text += "S" + std::to_string(k) + "\nX" + std::to_string(10 + k) + "\n";
  int lit = 0;
  for (const auto& [word, power] : run(text + "S0\nX90\nM2\n", by_speed)) {
    const double x = word.position[0];
    if (word.state != base::MotionState::constant || x < 10 || x >= 70) continue;
    const double asked = std::floor(x - 10 + 1e-9) + 1;
    EXPECT_NEAR(power, asked, 1e-4) << x;
    ++lit;
  }
  EXPECT_GT(lit, 400);
}

/// Where feed words differ from line to line, each line's own counts, whatever feed motion is held to.
TEST(Laser, GoesByTheFeedOfEachBlock) {
  std::string text = "G21 G90 G94 G64 P0.01\nM67 E3 Q10\nF6000 G1 X10\n";
  for (int k = 1; k <= 200; ++k)
    text += std::string(k % 2 == 0 ? "F6000" : "F3000") + " X" + std::to_string(10 + 0.1 * k) + '\n';
  int slow = 0, fast = 0;
  for (const auto& [word, power] : run(text + "M2\n", by_output)) {
    const double x = word.position[0], place = (x - 10) / 0.1;
    if (x < 11 || x > 29 || std::abs(place - std::round(place)) < 0.01) continue;
    const bool is_slow = static_cast<int>(place) % 2 == 0;
    EXPECT_NEAR(power, 10 * word.feed / (is_slow ? 50 : 100), 1e-6) << x;
    ++(is_slow ? slow : fast);
  }
  EXPECT_GT(slow, 50);
  EXPECT_GT(fast, 50);
}

TEST(Laser, FollowsWhatIsAskedOfTheFeed) {
  int constant = 0;
  for (const auto& [word, power] : run(line, by_speed, 0.25)) {
    if (word.state != base::MotionState::constant) continue;
    EXPECT_NEAR(power, 20, 1e-3);
    ++constant;
  }
  EXPECT_GT(constant, 500);
}

/// Inverse time and arcs: F is what the block comes to, in mm/s along it.
TEST(Laser, KnowsFeedsThatAreTimes) {
  int constant = 0;
  for (const auto& [word, power] :
       run("G21 G90 G93 G17 G61\nM67 E3 Q7\nG1 X40 F60\nG3 X20 Y20 I-20 F30\nM2\n", by_output)) {
    if (word.state != base::MotionState::constant) continue;
    EXPECT_NEAR(power, 7, 1e-4);
    ++constant;
  }
  EXPECT_GT(constant, 1000);
}

TEST(Laser, ChangesNoWord) {
  const machine::Machine lit = machine_with(by_speed);
  machine::Machine unlit = lit;
  unlit.laser.reset();
  std::string text = "G21 G90 G94 G64 P0.02 G17\nM3 S1\nF3000 G1 X10\n";
  for (int k = 0; k < 50; ++k)
    text += "G1 F" + std::to_string(2000 + 700 * (k % 4)) + " X" + std::to_string(10 + 0.3 * k) + " Y" +
            std::to_string(0.05 * (k % 3)) + " S" + std::to_string(k) + "\n";
  text += "G0 Y10\nG2 X0 I-10 F1500\nM5\nM2\n";
  const machine::ToolTable tools;
  pipeline::Program one(gcode::text_source(text), lit, tools, {}, nullptr);
  pipeline::Program other(gcode::text_source(text), unlit, tools, {}, nullptr);
  while (one.prepare()) {
    ASSERT_TRUE(other.prepare());
    const base::Word word = one.cycle(), same = other.cycle();
    ASSERT_EQ(word.position, same.position);
    ASSERT_EQ(word.path_length, same.path_length);
    ASSERT_EQ(word.speed, same.speed);
  }
  EXPECT_FALSE(other.prepare());
}

}  // namespace test_laser
