#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/referee/pose.hpp>
#include <numbers>
#include <trunnion.hpp>
#include <vector>

#include "five_axes.hpp"
#include "worst_ratios.hpp"

// Tool vectors within tolerances so narrow that nothing is rounded: motion is that of the exact path, one curve a line, and
// not a stop at every degree.

namespace test_narrow_vectors {

using namespace leadscrew;
using kinematics::Vector;
using testing_support::judge;
using testing_support::Judged;

constexpr double degree = std::numbers::pi / 180;

struct Pose {
  Vector tip{}, direction{};
};

/// A tool that turns about the workpiece's Z, and leans farther and farther from it. `least`: from there.
std::vector<Pose> leaning(double least) {
  std::vector<Pose> poses;
  for (int k = 0; k <= 4; ++k) {
    const double lean = (least + 6 * k) * degree, turn = 25 * k * degree;
    poses.push_back({{5.0 * k, 3 * std::sin(k), -1.0 * k},
                     {std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)}});
  }
  return poses;
}

/// The first is led to by a rapid; pose k lies at the end of line k + 3.
std::string program_along(const std::vector<Pose>& poses, const std::string& mode) {
  std::string text = "G21 G90 G94 G17 F1200 " + mode + "\nG43.5\n";
  for (const Pose& pose : poses) {
    char line[200];
    std::snprintf(line, sizeof line, "%s X%.12f Y%.12f Z%.12f I%.15f J%.15f K%.15f\n",
                  &pose == &poses.front() ? "G0" : "G1", pose.tip[0], pose.tip[1], pose.tip[2], pose.direction[0],
                  pose.direction[1], pose.direction[2]);
    text += line;
  }
  return text + "M2\n";
}

/// Of all words, the greatest distance to the line that it belongs to, mm, and to the great circle there, degrees.
Pose worst_of(const std::vector<Pose>& poses, const std::string& text, const machine::Machine& machine) {
  const referee::Pose kinematics(machine);
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  double off = 0, turned = 0;
  while (program.prepare()) {
    const base::Word word = program.cycle();
    const std::int64_t number = base::number(word.line) - 3;
    if (number < 1 || number >= static_cast<std::int64_t>(poses.size())) continue;
    const Pose &from = poses[static_cast<std::size_t>(number) - 1], &to = poses[static_cast<std::size_t>(number)];
    const auto tip_with = [&](double length) {
      const base::AxisVector tip = kinematics.tip_of(word.position, {0, 0, length});
      return Vector{tip[0], tip[1], tip[2]};
    };
    const Vector tip = tip_with(0), along = numeric::difference(to.tip, from.tip);
    const double share = numeric::dot(numeric::difference(tip, from.tip), along) / numeric::dot(along, along);
    off = std::max(off, numeric::distance(tip, numeric::sum(from.tip, share, along)));
    const kinematics::GreatCircle circle(from.direction, to.direction);
    turned = std::max(turned, kinematics::angle_between(numeric::difference(tip, tip_with(1)), circle.at(share)));
  }
  return {{off}, {turned / degree}};
}

TEST(NarrowVectors, AreTravelledAsTheExactPathIs) {
  const machine::Machine machine = testing_support::trunnion();
  const auto expect_exact = [&](const std::vector<Pose>& poses, const char* mode, double e) {
    SCOPED_TRACE(mode);
    const double exact = judge(program_along(poses, "G61"), machine).summary.time_s;
    const std::string text = program_along(poses, mode);
    const Judged outcome = judge(text, machine);
    EXPECT_EQ(outcome.errors, 0);
    EXPECT_EQ(outcome.verdict.violation_count, 0);
    EXPECT_LE(testing_support::worst_judged(outcome.verdict), 1.001);
    EXPECT_NEAR(outcome.summary.time_s, exact, 0.02 * exact);
    const Pose worst = worst_of(poses, text, machine);
    EXPECT_LE(worst.tip[0], 1e-9);
    EXPECT_LE(worst.direction[0], e / 4);
  };
  expect_exact(leaning(12), "G64 P0.0001 E0.0001", 1e-4);
  expect_exact(leaning(12), "G64 P0.00019 E0.02", 0.02);
  expect_exact(leaning(12), "G64 P0.01 E0.000001", 1e-5);
  expect_exact(leaning(1e-3), "G64 P0.0001 E0.0001", 1e-4);  // from beside the pole
}

}  // namespace test_narrow_vectors
