// Back along the path, word by word within every limit.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/return_path.hpp>
#include <string>

namespace test_return_path {

using namespace leadscrew;

/// The part of a program's path between two lengths.
pipeline::PathStretch stretch_of(const std::string& text, const machine::Machine& machine, double from, double to) {
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
  pipeline::PathStretch stretch(from, to);
  source.on_element = [&](const toolpath::Element& element) { stretch.push(element); };
  while (source.next()) {
  }
  return stretch;
}

double worst_ratio(const std::vector<base::PathPlace>& places, const base::AxisVector& begin,
                   const machine::Machine& machine) {
  std::vector<base::AxisVector> q(3, begin);
  for (const base::PathPlace& place : places) q.push_back(place.position);
  q.insert(q.end(), 3, q.back());
  const double T = machine.period.seconds();
  double worst = 0;
  for (std::size_t k = 3; k < q.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const machine::AxisLimits& limits = *machine.axes[i];
      const double step = q[k][i] - q[k - 1][i], before = q[k - 1][i] - q[k - 2][i], first = q[k - 2][i] - q[k - 3][i];
      worst =
          std::max({worst, std::abs(step) / T / limits.velocity, std::abs(step - before) / T / T / limits.acceleration,
                    std::abs(step - 2 * before + first) / T / T / T / limits.jerk});
    }
  }
  return worst;
}

TEST(ReturnPath, StaysOnAnArcWithinLimitsAndFeed) {
  const machine::Machine machine = machine::mill3();
  for (const double feed : {60.0, 1200.0, 12000.0}) {
    const std::string text = "G21 G90 G94 G17\nG2 X0 Y0 I10 F" + std::to_string(feed) + "\nM2\n";
    const pipeline::PathStretch stretch = stretch_of(text, machine, 3, 11);
    ASSERT_TRUE(stretch.is_whole());
    const auto places = pipeline::plan_return(stretch, machine);
    ASSERT_TRUE(places.has_value());
    double last = 11, fastest = 0;
    for (const base::PathPlace& place : *places) {
      ASSERT_NEAR(std::hypot(place.position[0] - 10, place.position[1]), 10, 1e-12);
      ASSERT_NEAR(std::atan2(place.position[1], 10 - place.position[0]) * 10, place.path_length, 1e-9);
      fastest = std::max(fastest, (last - place.path_length) / machine.period.seconds());
      last = place.path_length;
    }
    EXPECT_EQ(last, 3);
    EXPECT_LE(fastest, feed / 60 * (1 + 1e-9));
    EXPECT_LE(worst_ratio(*places, stretch.at(11).position, machine), 1 + 1e-9);
    if (feed <= 1200) {
      EXPECT_GE(fastest, 0.9 * feed / 60);  // no slower than it must be
    } else {
      EXPECT_GE(worst_ratio(*places, stretch.at(11).position, machine), 0.8);
    }
  }
}

TEST(ReturnPath, GoesOverJoinsOfABlendedPath) {
  const machine::Machine machine = machine::mill3();
  const std::string text = "G21 G90 G94 G17 F3000\nG64 P0.1\nG1 X10\nY10\nX20\nM2\n";
  const pipeline::PathStretch stretch = stretch_of(text, machine, 8, 12);
  const auto places = pipeline::plan_return(stretch, machine);
  ASSERT_TRUE(places.has_value());
  EXPECT_LE(worst_ratio(*places, stretch.at(12).position, machine), 1 + 1e-9);
  EXPECT_NEAR(places->back().position[0], stretch.at(8).position[0], 1e-9);
  for (const base::PathPlace& place : *places) {
    const double x = place.position[0], y = place.position[1];
    EXPECT_LE(std::min(std::hypot(y, std::max(0.0, x - 10)), std::hypot(x - 10, std::min(0.0, y))), 0.1 + 1e-9);
  }
}

TEST(ReturnPath, IsNothingWhereThereIsNoWay) {
  const machine::Machine machine = machine::mill3();
  const auto places = pipeline::plan_return(stretch_of("G21 G90 G94\nG1 X5 F600\nM2\n", machine, 2, 2), machine);
  ASSERT_TRUE(places.has_value());
  EXPECT_TRUE(places->empty());
}

/// Where motion passed one bend of next to nothing, the rest of the way is as fast as ever.
TEST(ReturnPath, IsNotSlowedByOneSlowPlace) {
  machine::Machine machine = machine::mill3();
  for (const std::int64_t period : {50'000, 1'000'000}) {
    machine.period = {period};
    const std::string text = "G21 G90 G94 G17 F4600\nG64 P0.0002\nG1 X10\nX10.002 Y0.002\nX20\nM2\n";
    const pipeline::PathStretch stretch = stretch_of(text, machine, 2, 18);
    const auto places = pipeline::plan_return(stretch, machine);
    ASSERT_TRUE(places.has_value());
    EXPECT_LE(worst_ratio(*places, stretch.at(18).position, machine), 1 + 1e-9);
    EXPECT_LE(static_cast<double>(places->size()) * machine.period.seconds(), 4);
  }
}

/// It rests at least once a second, so that it can be called off.
TEST(ReturnPath, RestsOnALongWay) {
  const machine::Machine machine = machine::mill3();
  const pipeline::PathStretch stretch = stretch_of("G21 G90 G94\nG1 X20 F60\nM2\n", machine, 1, 19);
  const auto places = pipeline::plan_return(stretch, machine);
  ASSERT_TRUE(places.has_value());
  EXPECT_LE(worst_ratio(*places, stretch.at(19).position, machine), 1 + 1e-9);
  std::size_t moving = 0, longest = 0;
  for (std::size_t k = 2; k < places->size(); ++k) {
    const auto at = [&](std::size_t n) { return (*places)[n].path_length; };
    moving = at(k) == at(k - 1) && at(k - 1) == at(k - 2) ? 0 : moving + 1;
    longest = std::max(longest, moving);
  }
  EXPECT_LE(longest, 1010U);
  EXPECT_GE(longest, 500U);
}

/// A corner is passed next to at rest, whether motion rested there or not.
TEST(ReturnPath, KeepsLimitsAtACorner) {
  const machine::Machine machine = machine::mill3();
  const pipeline::PathStretch stretch = stretch_of("G21 G90 G94 G61 F3000\nG1 X10\nY10\nM2\n", machine, 8, 12);
  ASSERT_TRUE(stretch.is_whole());
  const auto places = pipeline::plan_return(stretch, machine);
  ASSERT_TRUE(places.has_value());
  EXPECT_LE(worst_ratio(*places, stretch.at(12).position, machine), 1 + 1e-9);
  EXPECT_NEAR(places->back().position[0], 8, 1e-9);
}

TEST(ReturnPath, IsNotWholeBeyondThePath) {
  const machine::Machine machine = machine::mill3();
  EXPECT_FALSE(stretch_of("G21 G90 G94\nG1 X5 F600\nM2\n", machine, 2, 6).is_whole());
}

}  // namespace test_return_path
