// The study of five axes: its pass by formulas written apart, its figures, and what its picture shows.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/study/five_axes_motion.hpp>
#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/surface_pass.hpp>
#include <string>

#include "found.hpp"

namespace test_five_axes_study {

using namespace leadscrew;
using namespace leadscrew::study;
using leadscrew::study::testing::found;
using leadscrew::study::testing::ours;

constexpr std::size_t A = base::index(base::Axis::A), C = base::index(base::Axis::C);
const std::string head = "pass over a patch, tool along the normal, A and C of a trunnion: ";
const std::string off_line = head + "axes straight between the ends of lines, off-line";
const std::string on_curve = head + "one curve of tip and rotary axes";

const Rows& rows() {
  static const Rows all = five_axes_rows({});
  return all;
}

TEST(FiveAxesStudy, ComesOut) {
  for (const Row& row : rows()) {
    if (row.what == "a word of five axes, median") continue;  // without a clock
    const bool good = row.verdict == Verdict::exact || row.verdict == Verdict::kept || row.verdict == Verdict::measured;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN) << ' ' << row.why;
  }
}

/// Another program's figures for the same lines, which looked at twenty places of each.
TEST(FiveAxesStudy, LinesOfAxesLeaveTheTipAsFarBehind) {
  EXPECT_NEAR(ours(rows(), off_line, "tip off its line, at twentieths of each"), 4.642, 5e-4);
  EXPECT_NEAR(ours(rows(), off_line, "tool off the great circle"), 0.888, 5e-4);
  EXPECT_EQ(ours(rows(), head + "cut into lines by a chord tolerance of 0.01 mm", "lines"), 18);
  EXPECT_NEAR(ours(rows(), head + "cut into lines by a chord tolerance of 0.01 mm", "C turns by"), 252.6, 0.05);
}

/// What the tip needs, lines of axes need ten times as many blocks for; the curve is as exact as its numbers.
TEST(FiveAxesStudy, TheCurveKeepsTheTipAndTheTool) {
  EXPECT_GE(ours(rows(), off_line, "lines with which the tip is within 0.01 mm"), 150);
  EXPECT_LE(ours(rows(), on_curve, "tip off the pass"), 1e-9);
  EXPECT_LE(ours(rows(), on_curve, "tool off the normal"), 0.01);
  const std::string words = head + "words every millisecond", times = head + "times, 50 mm/s at the tip";
  EXPECT_GE(ours(rows(), words, "18 lines of axes, blended: tip off the pass"), 4);
  EXPECT_LE(ours(rows(), words, "one curve: tip off the pass"), 1e-9);
  EXPECT_LE(ours(rows(), times, "one curve"), 0.5 * ours(rows(), times, "18 lines of axes, a stop at each"));
}

/// S and n of the patch at (0.25, 0.75), and the machine's coordinates of a pose, to the digits that were computed apart.
TEST(SurfacePass, HasTheCheckValues) {
  const machine::Machine machine = trunnion();
  const kinematics::Chain chain = kinematics::chain_of(machine);
  const SurfacePass pass(chain);
  const auto near = [](const Vector& found, const Vector& expected, double within) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], within);
  };
  near(pass.point(0.25), {15, 45, 3.260742}, 5e-7);
  near(pass.normal(0.25), {-.0691203, .21155002, .97491998}, 5e-8);
  TipAndRotary pose{30, 20, 10};
  pose[A] = 20;
  pose[C] = 60;
  const auto axes = kinematics::machine_of(chain, pose, {});
  near({axes[0], axes[1], axes[2]}, {-0.088457, 32.870208, 20.400637}, 5e-7);
}

/// Its tool is along the normal, its curvature that of three points, its nearest place where it came from.
TEST(SurfacePass, AgreesWithDifferences) {
  const machine::Machine machine = trunnion();
  const kinematics::Chain chain = kinematics::chain_of(machine);
  const SurfacePass pass(chain);
  for (double u = 0.02; u < 1; u += 0.06) {
    const double h = 1e-3;
    const Vector before = pass.point(u - h), here = pass.point(u), after = pass.point(u + h);
    const double slope = (after[2] - before[2]) / (after[0] - before[0]);
    const double bend = (after[2] - 2 * here[2] + before[2]) / std::pow(60 * h, 2);
    EXPECT_NEAR(pass.curvature(u), std::abs(bend) / std::pow(1 + slope * slope, 1.5), 1e-6);
    EXPECT_NEAR(pass.speed(u), 60 * std::hypot(1, slope), 1e-3);
    const Vector normal = pass.normal(u);
    EXPECT_NEAR(normal[0] * (after[0] - before[0]) + normal[2] * (after[2] - before[2]), 0, 1e-6);
    const Vector above = {here[0] + 2 * normal[0], here[1] + 2 * normal[1], here[2] + 2 * normal[2]};
    EXPECT_NEAR(pass.nearest(above), u, 1e-9);
    const TipAndRotary pose = pass.at(u, 0);
    EXPECT_GE(pose[A], 0);
    const auto tool = kinematics::direction_of<double>(chain, kinematics::angles_of<double>(chain, pose));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(tool[i], normal[i], 1e-14);
  }
}

/// Twice the spans, a sixteenth of the error: third degree.
TEST(SurfacePass, SplinesOfAnglesConvergeByTheFourthOrder) {
  const machine::Machine machine = trunnion();
  const kinematics::Chain chain = kinematics::chain_of(machine);
  const SurfacePass pass(chain);
  const auto error = [&](int spans) {
    return error_of_spline(chain, pass, pass.control_points(spans), 4000).direction;
  };
  const double coarse = error(64), fine = error(128);
  EXPECT_LT(fine, coarse / 12);
  EXPECT_GT(fine, coarse / 20);
}

TEST(FiveAxesStudy, DrawsBothMotions) {
  const report::ChartSheet sheet = five_axes_picture();
  ASSERT_EQ(sheet.charts.size(), 4u);
  for (const report::Chart& chart : sheet.charts) {
    ASSERT_EQ(chart.curves.size(), 2u);
    EXPECT_LT(chart.curves[0].samples.size(), chart.curves[1].samples.size()) << "the curve is the faster";
  }
  const auto most = [&](std::size_t chart, std::size_t curve) {
    double greatest = 0;
    for (const auto& sample : sheet.charts[chart].curves[curve].samples)
      greatest = std::max(greatest, std::abs(sample.value));
    return greatest;
  };
  EXPECT_GT(most(0, 1), 4);
  EXPECT_LT(most(0, 0), 1e-9);
  EXPECT_LT(most(2, 0), 50 * (1 + 1e-6));
}

}  // namespace test_five_axes_study
