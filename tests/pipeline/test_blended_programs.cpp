#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random_numbers.hpp>
#include <string>
#include <string_view>

#include "blended.hpp"

// Programs of short lines and corners under G64, judged by the referee: inside the tolerance, inside every limit, and
// no slower than with a stop at every joint.

namespace test_blended_programs {

using namespace leadscrew;
using namespace leadscrew::testing_support;

/// Lines of 1 µm to 100 mm that turn anyhow: little, sharply, back.
std::string random_polyline() {
  const int decimals = any(0, 2) == 0 ? 3 : 9;
  const bool in_space = any(0, 3) == 0, alike = any(0, 3) == 0;
  const int seldom = any(0, 4) == 0 ? 2 : 20;  // how often feed changes
  const double usual = logarithmic(1e-3, 100);
  std::string text = "G21 G90 G17 G94 F6000\nG64" + word('P', logarithmic(1e-3, 1), 6) + '\n';
  double x = 0, y = 0, z = 0, angle = any(0, 6283) / 1000.0;
  for (int k = any(2, 30); k > 0; --k) {
    const double length = alike ? std::clamp(usual * logarithmic(0.3, 3), 1e-3, 100.0) : logarithmic(1e-3, 100);
    switch (any(0, 10)) {
      case 0:
        angle += std::numbers::pi;
        break;
      case 1:
      case 2:
      case 3:
      case 4:
        angle += any(-3142, 3142) / 1000.0;
        break;
      default:
        angle += any(-400, 400) / 1000.0;
    }
    x += length * std::cos(angle);
    y += length * std::sin(angle);
    if (in_space) z += length * any(-1000, 1001) / 1000.0;
    text += (any(0, 3 * seldom) == 0 ? "G0" : "G1") + word('X', x, decimals) + word('Y', y, decimals) +
            word('Z', z, decimals);
    if (any(0, seldom) == 0) text += word('F', any(200, 12000), 0);
    text += '\n';
  }
  return text + "M2\n";
}

/// By up to twice the usual distance, each of these axes.
void move(std::string& text, std::array<double, 5>& at, std::string_view axes, double usual) {
  constexpr std::string_view letters = "XYABU";
  for (const char letter : axes) {
    double& place = at[letters.find(letter)];
    place += usual * any(-2000, 2001) / 1000.0;
    text += word(letter, place, 3);
  }
}

void keep_promises_and_lose_no_time(const std::string& text) {
  RC_LOG() << text;
  const Outcome outcome = run(text), stopping = run_with_stops(text);
  RC_ASSERT(keeps_promises(outcome));
  RC_ASSERT(outcome.summary.time_s <= stopping.summary.time_s + 0.001);  // words come every 1 ms
}

/// Lines along some of the axes each, at feeds of their own.
std::string random_turns() {
  std::string text = "G21 G90 G17 G94 F6000\nG64" + word('P', logarithmic(1e-3, 1), 6) + '\n';
  const double usual = logarithmic(0.01, 30);
  const int sorts = any(2, 5);  // how many kinds of lines there are: the fewer, the more often the axes change
  std::array<double, 5> at{};
  for (int k = any(2, 30); k > 0; --k) {
    text += any(0, 12) == 0 ? "G0" : "G1";
    switch (any(0, sorts)) {
      case 0:
        move(text, at, "X", usual);
        break;
      case 1:
        move(text, at, "A", usual);
        break;
      case 2:
        move(text, at, "XYA", usual);
        break;
      default:
        move(text, at, any(0, 2) == 0 ? "UB" : "AB", usual);
    }
    if (any(0, 8) == 0) text += word('F', logarithmic(100, 12000), 0);
    text += '\n';
  }
  return text + "M2\n";
}

RC_GTEST_PROP(RandomTurns, KeepEveryPromiseAndAreNoSlowerThanWithStops, ()) {
  keep_promises_and_lose_no_time(random_turns());
}
RC_GTEST_PROP(RandomPolylines, KeepEveryPromiseAndAreNoSlowerThanWithStops, ()) {
  keep_promises_and_lose_no_time(random_polyline());
}
RC_GTEST_PROP(LongRandomPolylines, KeepEveryPromiseAndAreNoSlowerThanWithStops, ()) {
  constexpr int programs = 2;  // a case
  for (int k = 0; k < programs; ++k) keep_promises_and_lose_no_time(random_polyline());
}

/// Short lines along waves of X and A, rounded: one axis after another is the one at its limit.
std::string random_waves() {
  const double step = logarithmic(0.05, 0.6), height = logarithmic(0.1, 2), turn = logarithmic(0.5, 8);
  const double tolerance = logarithmic(1e-3, 0.1), cam_share = any(0, 2) == 0 ? 0.3 : 1;
  const double rate = logarithmic(0.2, 1.2), other_rate = logarithmic(0.2, 1.2), ahead = any(0, 6283) / 1000.0;
  std::string text = "G21 G90 G17 G94" + word('F', logarithmic(500, 8000), 1) + "\nG64" + word('P', tolerance, 5) +
                     word('Q', cam_share * tolerance, 5) + '\n';
  for (int k = 0, lines = any(20, 80); k < lines; ++k) {
    text += "G1" + word('X', height * std::sin(rate * k), 3) + word('Y', step * k, 3) +
            word('A', turn * std::sin(other_rate * k + ahead), 3) + '\n';
  }
  return text + "M2\n";
}

RC_GTEST_PROP(RandomWaves, KeepEveryPromise, ()) {
  machine::Machine machine = wide_mill();
  machine.axes[base::index(base::Axis::X)] = machine::AxisLimits{-1e5, 1e5, 500, 3000, 50000, 0.001};
  machine.axes[base::index(base::Axis::A)] = machine::AxisLimits{-1e5, 1e5, 90, 500, 5000, 0.001};
  const std::string text = random_waves();
  RC_LOG() << text;
  RC_ASSERT(keeps_promises(run_on(machine, text)));
}

// ---------------------------------------------------------------------------------------------------------------------

TEST(BlendedPrograms, PassOverPointsThatAreGivenAgain) {
  const std::string again = "G1 X5\nX5\nX5\nX5\nX5\nY5\nY5\nY5\nY5\nY5\nX0\nY0\n", once = "G1 X5\nY5\nX0\nY0\n";
  expect_better_than_stops(head + again);
  EXPECT_EQ(run(head + again).summary.time_s, run(head + once).summary.time_s);
}

TEST(BlendedPrograms, PassOverASpikeWithinTheTolerance) {
  expect_better_than_stops(head + "G1 X10\nY0.003\nY0\nX20\n");
  EXPECT_LE(run(head + "G1 X10\nY0.003\nY0\nX20\n").summary.time_s, run(head + "G1 X10\nX20\n").summary.time_s + 0.002);
}

TEST(BlendedPrograms, GoToTheTipOfASpikeBeyondIt) {
  expect_better_than_stops(head + "G1 X10\nY0.5\nY0\nX20\n");
}

TEST(BlendedPrograms, StopWhereThePathTurnsBack) {
  const std::string text = head + "G1 X10\nX0\nX10\n";
  expect_better_than_stops(text);
  EXPECT_EQ(run(text).summary.time_s, run_with_stops(text).summary.time_s);
}

TEST(BlendedPrograms, TakeTenThousandPointsInOneMicrometreForOne) {
  std::string points;
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525 + 1013904223) / 4294967296e3; };
  for (int k = 0; k < 10000; ++k) points += "X" + word(' ', 10 + next(), 6).substr(2) + word('Y', next(), 6) + '\n';
  const Outcome outcome = run(head + "G1 X10\n" + points + "X20 Y0\n");
  EXPECT_TRUE(keeps_promises(outcome));
  EXPECT_LE(outcome.summary.time_s, run(head + "G1 X20\n").summary.time_s + 0.002);
}

TEST(BlendedPrograms, OfNoToleranceStop) {
  const std::string text = "G21 G90 G17 G94 F6000 G64 P0\nG1 X10\nY10\nX10.05 Y10.1\nX0\n";
  expect_better_than_stops(text);
  EXPECT_EQ(run(text).summary.time_s, run_with_stops(text).summary.time_s);
  EXPECT_LE(run(text).verdict.deviation_mm, 1e-6);
}

TEST(BlendedPrograms, BlendArcsHelicesAndPlanes) {
  expect_better_than_stops(head + "G3 X10 Y0 I5\nG2 X20 Y0 I5\nG3 X20 Y0 I-3 J0\nG1 X30\n");
  expect_better_than_stops(head + "G1 X10\nG3 X10 Y0 Z-5 J5 I0 P3\nG1 X20 Y0 Z-5\n");
  expect_better_than_stops(head + "G18 G1 X10\nG3 X20 Z0 I5 K0\nG1 X20 Z5\nG19\nG2 Y5 Z5 J2.5 K0\nG1 Y10\n");
  expect_better_than_stops(head +
                           "G1 X10\nG3 X10 Y4 I0 J2\nG1 X0\nY0\nG2 X3 Y3 I3 J0\nG2 X6 Y0 I0 J-3\nG3 X8 Y2 J2 I0\n");
}

TEST(BlendedPrograms, BlendSplinesWithAnything) {
  const std::string text = head + "G1 X10\nG5 I5 J0 P-5 Q5 X30 Y20\nG1 X20\nG5 I0 J-9 P9 Q0 X0 Y0\n";
  expect_better_than_stops(text);
  EXPECT_LT(run(text).summary.time_s, run_with_stops(text).summary.time_s - 0.02);
}

TEST(BlendedPrograms, BlendRotaryAndSecondaryAxes) {
  expect_better_than_stops(head + "G1 A10\nA20\nB10\nA10 B5\nB0\n");
  expect_better_than_stops(head + "G1 X10 A5\nX10 Y10 A9\nX0 B4\nY0 A0 B0\n");
  expect_better_than_stops(head + "G1 U5\nX10 U5\nU0 X10 Y5\n");
}

TEST(BlendedPrograms, SmoothRotaryAxesWhereTheLinearOnesStandSomewhere) {
  std::string lines;
  for (int k = 1; k < 60; ++k) lines += "G1" + word('A', 0.5 * k, 3) + word('B', 5 * std::sin(0.05 * k), 3) + '\n';
  const std::string text = head + "G0 X10.1 Y3.3 Z7.7\n" + lines;
  expect_better_than_stops(text);
  EXPECT_LT(run(text).summary.time_s, run_with_stops(text).summary.time_s / 2);
}

/// By the length of X alone, such a curve has no derivatives: motion would creep past its crest.
TEST(BlendedPrograms, DoNotSlowDownWhereTheLinearAxesTurnBackWhileARotaryOneGoesOn) {
  std::string wave;
  for (int k = 1; k <= 120; ++k) wave += "G1" + word('X', 2 * std::sin(0.1 * k), 3) + word('A', k, 3) + '\n';
  expect_better_than_stops(head + wave);
  EXPECT_LT(run(head + wave).summary.time_s, run_with_stops(head + wave).summary.time_s / 3);
  const std::string crest = head + "G1 X-0.369\nX-0.368 Z-0.001 A-15.84\nX-0.269 A-185.24\n";
  expect_better_than_stops(crest);
  EXPECT_LT(run(crest).summary.time_s, run_with_stops(crest).summary.time_s - 0.05);
  const std::string into_rotation = "G21 G90 G17 G94 F6000 G64 P0.75\nG1 X4 Y1.1 Z4\nZ4.002 A34.4\n";
  expect_better_than_stops(into_rotation);
  EXPECT_LT(run(into_rotation).summary.time_s, run_with_stops(into_rotation).summary.time_s - 0.05);
}

TEST(BlendedPrograms, KeepTheFeedOfTheLinearAxesWhereRotaryOnesMoveBesides) {
  const machine::Machine machine = wide_mill();
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source("G21 G90 G17 G94 F600 G64 P0.1\nG1 X20 A40\nX40 Y1 A90\nY40 A120\n"),
                            machine, tools, {}, [](const base::Diagnostic&) {});
  double fastest = 0;
  int at_feed = 0;
  while (program.prepare()) {
    const double feed = program.cycle().feed;
    fastest = std::max(fastest, feed);
    at_feed += std::abs(feed - 10) < 0.01;
  }
  EXPECT_LE(fastest, 10 * (1 + 1e-6));
  EXPECT_GT(at_feed, 5500);  // of 80 mm at 10 mm/s
}

/// All of the small circle lies within the wider tolerance of the line before.
TEST(BlendedPrograms, AreFollowedFromAWideToleranceIntoANarrowOne) {
  const Outcome outcome =
      run("G21 G90 G17 G94 F600 G64 P0.178946\nG1 X10\nG64 P0.01\nG3 X10.1 Y-0.1 I0.1 J0\n"
          "X10.2 Y0 I0 J0.1\nX10.1 Y0.1 I-0.1 J0\nX10 Y0 I0 J-0.1\nX10.1 Y-0.1 I0.1 J0\n");
  EXPECT_TRUE(keeps_promises(outcome)) << outcome.verdict.deviation_mm;
}

/// Where a blend leaves an arc, it bends less: a chord there is not as much shorter than its arc.
TEST(BlendedPrograms, KeepTheFeedWhereABlendLeavesASmallArc) {
  const std::string text = "G21 G90 G17 G94 F161 G64 P0.051694\nG2 Z-0.002 I0.091 J0.041\nG18\nG2 K-4.736 I-6.974\n";
  for (const std::int64_t nanoseconds : {9'000'000, 9'227'532, 9'500'000, 12'000'000, 20'000'000}) {
    EXPECT_LE(run(text, {}, {nanoseconds}).verdict.feed_max_ratio, 1.001) << nanoseconds;
  }
}

/// Control points on a line but for one: a chord between places where the curve is straight passes over its bulge.
TEST(BlendedPrograms, SeeABulgeBetweenStraightPartsOfASpline) {
  std::string points;
  for (int k = 1; k <= 40; ++k)
    points += "X" + word(' ', 1 + 0.1 * k, 4).substr(2) + (k == 13 ? " Y0.25 P1\n" : " Y0.2 P1\n");
  expect_better_than_stops(head + "G1 X1 Y0.2\nG5.2 P1 L4\n" + points + "G5.3\nG1 X10\n");
}

/// Near its middle the rows must be tightened; the window that begins shortly before has no room to find that out
/// again.
TEST(BlendedPrograms, AreNoSlowerWhereAWindowBeginsBeforeAPlaceOfTightenedLimits) {
  expect_better_than_stops(
      "F2494\nG64 P0.00202\nG2 X3 Y-3.72 I2.9 J-0.73\nX3.4 Y-22.14 J-9.21\nX7.4 Y-21.16 I3.5 J-5.6 F5874\n"
      "G3 X6.008 Y-19.03162 I1.1 J2.27\nG2 X6.26785 Y-18.812 I0.028 J0.23049\nG3 X7.42713 Y-19.282 I0.429 J-0.606\n"
      "I-4 J-7.7\n");
}

/// A line that is one whatever the mode.
TEST(BlendedPrograms, DoNotStopWhereThePathModeChangesOnAStraightLine) {
  const std::string before = "G21 G90 G17 G94 F6000 G64 P0.01\nG1 X10 A20\n", behind = "X20 A40\n";
  const double whole = run(before + behind).summary.time_s;
  EXPECT_NEAR(run(before + "G61\n" + behind).summary.time_s, whole, 0.0021);
  EXPECT_NEAR(run(before + "G64 P0.0001\n" + behind).summary.time_s, whole, 0.0021);
}

/// Feed passes from X to A, at the border of two spans, and back: motion goes on.
TEST(BlendedPrograms, RunThroughSplinesWhoseLinearAxesStandOnSomeSpans) {
  const std::string spline =
      "G6.2 P4 K0 X0 A0\nK0 X1 A1\nK0 X2 A5\nK0 X3 A6\nK1 X3 A7\nK2 X3 A9\nK3 X3 A12\nK4 X3 A13\nK5 X4 A14\n"
      "K6 X6 A15\nK7\nK7\nK7\nK7\n";
  for (const std::string mode : {"G61\n", "G64 P0.01\n"}) {
    for (const std::string feed : {"F6000 ", "F60 "}) {
      const Outcome outcome = run("G21 G90 G17 G94 " + feed + mode + spline);
      EXPECT_TRUE(keeps_promises(outcome)) << mode << feed << outcome.verdict.feed_max_ratio;
      EXPECT_LT(outcome.summary.time_s, 2 * outcome.summary.bound_s);
    }
  }
}

TEST(BlendedPrograms, RunFromLinearAxesIntoRotaryOnes) {
  for (const std::string& text : {head + "G1 X10\nA10\nX0\nA0\n", head + "G1 X10 A5\nA20\nX0 A25\nF600 A40\nU5\n",
                                  head + "G1 X10\nF60 A10\nG0 X0\nG1 F600 X5\nU3 B3\nG0 A0 B9\nX0\n"}) {
    expect_better_than_stops(text);
    EXPECT_LT(run(text).summary.time_s, run_with_stops(text).summary.time_s - 0.05);
  }
}

/// X turns back by so little that motion runs through.
TEST(BlendedPrograms, KeepTheFeedOfLinearAxesThatTurnBackUnseen) {
  machine::Machine machine = wide_mill();
  machine.period = {4'000'000};
  for (auto& axis : machine.axes) {
    if (axis) axis->acceleration = 20'000, axis->jerk = 1e6;
  }
  const std::string text = "G21 G90 G94 F0.03\nG64 P0.1\nG1 X0.00005 A0.5\nG64 P0.05\nX0 A1\nM2\n";
  EXPECT_LE(run_on(machine, text).verdict.feed_max_ratio, 1.001);
}

/// A line into a tangent arc: nothing turns there, but curvature steps.
TEST(BlendedPrograms, RunThroughStepsOfCurvatureWhereNoLinesAreFitted) {
  const std::string text = "G21 G90 G17 G94 F4800 G64 P0.01 Q0\nG1 X2\nG3 X3 Y1 J1\nG1 Y3\nG3 X2 Y4 I-1\nG1 X0\n";
  expect_better_than_stops(text);
  EXPECT_LT(run(text).summary.time_s, run_with_stops(text).summary.time_s * 0.7);
}

TEST(BlendedPrograms, RestAtEventsAndDwellsAtTheirPoint) {
  const std::string before = "G1 X10\nY5\n", behind = "Y10\nX0\nY0\n";
  for (const std::string event : {"M0\n", "M5\n", "G4 P0.1\n"}) {
    const std::string text = head + before + event + behind;
    expect_better_than_stops(text);
    EXPECT_GT(run(text).summary.time_s, run(head + before + behind).summary.time_s);
  }
}

TEST(BlendedPrograms, FitNoLinesWhereQIsZero) {
  std::string lines;
  for (int k = 1; k < 60; ++k) {
    lines += "G1" + word('X', 10 * std::sin(0.03 * k), 6) + word('Y', 10 - 10 * std::cos(0.03 * k), 6) + '\n';
  }
  const std::string mode = "G21 G90 G17 G94 F6000 G64 P0.01";
  expect_better_than_stops(mode + " Q0\n" + lines);
  expect_better_than_stops(mode + " Q0.001\n" + lines);
  expect_better_than_stops(mode + '\n' + lines);
  EXPECT_LE(run(mode + " Q0.001\n" + lines).verdict.deviation_mm, 0.001);
  EXPECT_LT(run(mode + '\n' + lines).summary.time_s, run(mode + " Q0\n" + lines).summary.time_s);
}

}  // namespace test_blended_programs
