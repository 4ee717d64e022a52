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

/// Beside a pole the first axis turns half a circle within a fraction of a millimetre of the tip's: the exact path is a curve of
/// hundreds of short spans there, and its table of arc length must be as good beside the speed as beside a span.
TEST(NarrowVectors, KeepJerkWhereTheFirstAxisTurnsBesideAPole) {
  machine::Machine machine;
  machine.kinematics = "head-head-bc";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  machine.rotary_chain->tool_zero = {76.2256, -29.76928, -40.5008};
  machine.rotary_chain->axes[0].point = {20.58736, -38.00704, 3.69008};
  machine.rotary_chain->axes[1].point = {-36.80496, -14.04624, 58.35456};
  for (machine::RotaryAxis& axis : machine.rotary_chain->axes) axis.sign = -1;
  const auto give = [&](base::Axis axis, double velocity, double acceleration, double jerk) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e5, 1e5, velocity, acceleration, jerk, 0.001};
  };
  give(base::Axis::X, 38.1248, 1105.134, 1704539);
  give(base::Axis::Y, 120.9411, 17370.49, 111129.7);
  give(base::Axis::Z, 1788.813, 330.1551, 187116.0);
  give(base::Axis::B, 27.30216, 4454.757, 188594.1);
  give(base::Axis::C, 567.7577, 5210.315, 12622.23);
  machine.period = {1'000'000};
  const Judged outcome = judge(
      "G21 G90 G17 G94 F3000 G61\nG43.5 H1\nG1 X0 Y0 Z0\nG1 X-7.749620 Y-7.266040 Z9.684380\n"
      "G1 X4.851220 Y-16.995430 Z10.261160 I0.080653852 J0.003482019 K2.726815511\n"
      "G1 X-4.090400 Y-29.267260 Z-0.385330 I0.037925353 J0.015874864 K3.824202693\n"
      "G1 X-3.535009 Y-29.631009 Z-0.446338 I0.018864981 J0.007537905 K5.859322327\n"
      "G1 X-3.670440 Y-29.866370 Z-0.380331 I0.001556176 J0.000601566 K1.519538605\n"
      "G1 X-3.330806 Y-29.964299 Z-0.619449 I0.041771062 J0.016548746 K4.932600973\n"
      "G1 X-2.941453 Y-29.378828 Z-0.219972 I-0.029996337 J-0.011847181 K3.830510060\n"
      "G1 X-3.434246 Y-29.939982 Z-0.448143 I0.014786145 J0.006033779 K3.558161251\nM2\n",
      machine);
  EXPECT_EQ(outcome.errors, 0);
  EXPECT_LE(testing_support::worst_planned(outcome.summary.plan), 1 + 1e-9);
  EXPECT_LE(testing_support::worst_judged(outcome.verdict), 1.001);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
}

}  // namespace test_narrow_vectors
