#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "blended.hpp"

// Blends and fits where feeds differ, where feed is counted by few of the axes, and where curves are sharp.

namespace test_blended_feeds {

using namespace leadscrew;
using namespace leadscrew::testing_support;

TEST(BlendedPrograms, KeepTheProgrammedFeedWhereItChangesOnTheWay) {
  std::string lines;
  for (int k = 1; k < 200; ++k) {
    lines += "G1" + word('X', 10 * std::sin(0.01 * k), 4) + word('Y', 10 - 10 * std::cos(0.01 * k), 4) +
             word('F', k % 50 < 25 ? 600 : 3000, 0) + '\n';
  }
  expect_better_than_stops(head + lines);
}

/// 10 mm of an arc in lines of 5 µm, at feeds in turn.
std::string fine_lines(double one_feed, double other_feed) {
  std::string lines = "G21 G90 G17 G94 G64 P0.01\n";
  for (int k = 1; k <= 2000; ++k) {
    lines += "G1" + word('X', 10 * std::sin(0.0005 * k), 6) + word('Y', 10 - 10 * std::cos(0.0005 * k), 6) +
             word('F', k % 2 == 0 ? one_feed : other_feed, 0) + '\n';
  }
  return lines;
}

TEST(BlendedPrograms, AreAsFastAsTheLowerOfTwoFeedsThatAlternateOnTheShortestLines) {
  for (const double higher : {6000.0, 6001.0, 12000.0}) {
    const Outcome alternating = run(fine_lines(higher, 6000)), lower = run(fine_lines(6000, 6000));
    EXPECT_TRUE(keeps_promises(alternating));
    EXPECT_LE(alternating.summary.time_s, 1.01 * lower.summary.time_s) << higher;
    EXPECT_GE(alternating.summary.time_s, 0.999 * lower.summary.time_s) << higher;
  }
}

/// The slower of two moves lasts as long as it takes; a blend must not make the faster one wait for it.
TEST(BlendedPrograms, AreNoSlowerWhereMovesOfUnlikeFeedsMeet) {
  expect_better_than_stops("G21 G90 G17 G94 F60 G64 P0.5\nG1 X3\nG0 Y20\n");
  expect_better_than_stops("G21 G90 G17 G94 F60 G64 P0.5\nG0 X20\nG1 Y3\nG0 X0\n");
  expect_better_than_stops("G21 G90 G17 G94 F6000 G64 P1 Q0\nG1 X100\nF600 G3 X125 Y25 J25\n");
  expect_better_than_stops("G21 G90 G17 G94 F600 G64 P1 Q0\nG3 X25 Y25 J25\nF6000 G1 Y100\n");
  expect_better_than_stops("G21 G90 G17 G94 F6000 G64 P1\nG1 X30 A40\nF60 X31 Y1 A41\nG0 X0 Y0 A0\n");
}

/// Feed is counted by the linear axes: where the other move hardly has any of them, what the blend takes into it would
/// creep.
TEST(BlendedPrograms, TakeLittleOfAFastMoveIntoASlowOneOfRotaryAxes) {
  for (const std::string tolerance : {"P1", "P0.1", "P0.01", "P0.001"}) {
    const std::string mode = "G21 G90 G17 G94 G64 " + tolerance + "\n";
    expect_better_than_stops(mode + "G1 Z4 F6000\nX0.001 B-5 F10\n");
    expect_better_than_stops(mode + "G1 X0.001 B-5 F10\nZ4 F6000\n");
    expect_better_than_stops(mode + "G1 Z4 F6000\nX0.2 B-5 F51\n");
  }
}

/// Nor may a spline, when the lines are short enough to be fitted.
TEST(BlendedPrograms, FitNoFastMoveIntoASlowOneOfRotaryAxes) {
  expect_better_than_stops(
      "G21 G90 G17 G94 G64 P0.92175\nG1 Y0.5974 F4319\nY-0.3132 Z4.3217\nY-0.3102 F715\n"
      "Z4.4357 X0.1857 A-0.3648 B-5.0579 F51\nZ5.0279 X0.6856 F435\nZ5.1229 F7135\nY-0.2983 X0.6716 F50\n");
}

/// Lines of an arc whose radius is less than the tolerance, each with time of its own: a spline outside it is longer.
TEST(BlendedPrograms, FitNoDetourOfSlowLines) {
  for (const std::string tolerance : {"P1", "P0.5"}) {
    std::string text = "G21 G90 G17 G94 G64 " + tolerance + "\nG1 X5 F2000\nG3 X0 Y5 I-5\n";
    for (int k = 1; k <= 22; ++k) {
      text += "G1" + word('X', -0.25 * std::sin(0.1 * k), 4) + word('Y', 4.75 + 0.25 * std::cos(0.1 * k), 4) +
              word('F', k % 3 == 0 ? 50 : 2, 0) + '\n';
    }
    expect_better_than_stops(text);
  }
}

/// Arcs as small as that are passed in no time: nothing that the smoothing length is shortened to mends it.
TEST(BlendedPrograms, FitNoDetourOfSlowArcsInAnyLength) {
  expect_better_than_stops(
      "G21 G90 G94 G17 F600\nG64 P0.389066\nG6.2 P5 K0 X0 Y0\nK0 X-0.634 Y2.385\nK0 X-2.542 Y3.829 R1.162\n"
      "K0 X-4.614 Y5.441\nK0 X-7.139 Y4.674\nK1\nK1\nK1\nK1\nK1\nG1 X-6.339 Y16.674 Z0.064\n"
      "G3 X-6.239 Y16.574 I0.1\nG3 X-6.139 Y16.674 J0.1\nG3 X-6.239 Y16.774 I-0.1\n");
}

TEST(BlendedPrograms, MakeNoDetourWhereTheToleranceIsAboveARadius) {
  expect_better_than_stops("G21 G90 G17 G94 G64 P2 F97\nG2 J-1\nG1 Y10\n");
  expect_better_than_stops("G21 G90 G17 G94 G64 P0.25 F97\nG2 J-0.076\nG1 Y2.5\n");
  expect_better_than_stops("G21 G90 G17 G94 G64 P0.01 F1000\nG1 X1\nG3 X1 Y0 I-0.005 J0 P5\nG1 X2 Y1\n");
}

/// Too sharp for even looks at the curve to see.
TEST(BlendedPrograms, StayInsideTheToleranceAboutTheTipOfASpline) {
  expect_better_than_stops(
      "G21 G90 G17 G94 F257 G64 P0.004\nG1 Y0.1\nG3 I-0.01\n"
      "G5 X-0.027 Y0.13523 I0 J0 P-0.003 Q0.003\nG3 X-0.025 Y0.14 U0.1 J-0.000235\n");
  expect_better_than_stops(
      "G20 G90 G17 G94 F257\nG64 P0.00364\nG1 Y0.10425 Z0.10015 X0.00519\nG3 I-0.006 J0.000228\n"
      "G5 X-0.02698 Y0.13523 I0.0139 J0.0071 P-0.0033 Q0.0026\n"
      "G3 X-0.0252114 Y0.1374589 U0.13924 I0.002585 J-0.000235\n");
}

/// A curve that begins with a double control point: its table of arc length lies dense there, but it is straight.
TEST(BlendedPrograms, SampleCurvesNoFinerThanTheToleranceAsks) {
  const std::string mode = "G21 G90 G17 G94 ";
  const std::string from_a_double_point =
      "G6.2 P4 K0 Z0 R1\nK0 Z0 R1\nK0 Z0.1071 R1\nK0 Z0.0377 R1\nK1 Z0.1257 R1\nK2 Z0.1257 R1\nK3 Z0.0697 R1.86\n"
      "K4 Z-0.0330 R1\nK5\nK5\nK5\nK5\n";
  expect_better_than_stops(mode + "F588 G64 P0.0384\nG1 X-2\n" + from_a_double_point);
  expect_better_than_stops(mode + "F588 G64 P0.0384\nG1 X-0.2476\n" + from_a_double_point);
  expect_better_than_stops(mode +
                           "F417 G64 P0.01735 Q0.0052\nG1 Y0.509\nG6.2 P3 K0 Z0 Y0.509 R1\nK0 Z0 Y0.3159 R1\n"
                           "K0 Z-0.2222 Y0.5303 R1\nK1 Z0.0024 Y0.3019 R1\nK5\nK5\nK5\n");
  expect_better_than_stops(
      mode +
      "F3498 G64 P0.01\nG3 X12.08963 Y1.91024 A0.0303 B0.5019 I6.11639 J0.50213\n"
      "G2 X11.88669 Y2.03784 Z-0.5322 I0.17335 J0.50089\n"
      "G3 X12.20947 Y1.79225 Z-1.9179 I-0.04448 J-0.39337\nG6.2 P3 K0 Z-1.9179 R1\nK0 Z-9.0590 R1\n"
      "K0 Z-9.0590 R1\nK2 Z-15.1771 R1\nK3 Z-31.9880 R0.59\nK4\nK4\nK4\n");
  expect_better_than_stops(mode +
                           "F419 G64 P0.20399 Q0.0612\nG1 X-0.6344 Y-0.9959\n"
                           "G17 G5 X-10.3589 Y5.9892 I3.1501 J-0.6296 P-3.0229 Q-6.9086\n");
}

/// Along the blend the speed that feed allows changes by many powers of ten.
TEST(BlendedPrograms, PlanBlendsIntoASlowFeedOfOtherAxesInReasonableTime) {
  expect_better_than_stops("G21 G90 G17 G94 G64 P0.05\nG1 Z0.3536 B-1.2162 U0.0030 F1500\nG1 X0.0001 F0.0036\n");
}

TEST(BlendedPrograms, DoNotMakeMovesOneAtALesserFeedThatTakesLonger) {
  expect_better_than_stops("G21 G90 G17 G94 G64 P1\nG1 X0.2 F6000\nG1 X0.21 F1\nG1 Y5 F6000\n");
}

/// A hairpin inside the tolerance: no spline is to turn back nearly on the spot.
TEST(BlendedPrograms, StopRatherThanCreepRoundAHairpin) {
  const std::string mode = "G21 G90 G17 G94 F784 G64 ";
  expect_better_than_stops(
      mode +
      "P0.173442\nG1 X26.134 Y106.063\nX33.536 Y53.543\nX33.493 Y53.849\nX33.415 Y54.331\n"
      "X33.414 Y54.343\nX37.548 Y48.384\nX37.359 Y48.854 F9937\nX36.796 Y50.430\nX36.269 Y51.103\n");
  expect_better_than_stops(mode +
                           "P0.228417\nG1 X-2.135 F6000\nA0.938\nA-1.069\nA-0.061\nA1.31\nA0.413\nA1.787\nA3.154\n"
                           "A3.911 F3156\nA4.722\nA6.289\nA6.155\nX-2.531\nA4.275\nA4.734 F2101\nA4.013\nX-0.856\n");
}

/// Whatever its control points do to the parameter.
TEST(BlendedPrograms, TakeACurveAlongOneAxisForALine) {
  const std::string spline =
      "G6.2 P3 K0 X0.7446 R1\nK0 X2.7466 R1\nK0 X2.7466 R1\nK1 X2.7466 R1\nK2 X3.3602 R1\nK3\nK3\nK3\n";
  expect_better_than_stops("G21 G90 G17 G94 F516 G64 P0.05\nG1 X0.7446 Y0.1203 U2.5985\n" + spline +
                           "G1 X3.4 Y0.5 U1\n");
  EXPECT_EQ(run("G21 G90 G17 G94 F6000 G61\nG1 X0.7446\n" + spline).summary.time_s,
            run("G21 G90 G17 G94 F6000 G61\nG1 X0.7446\nX2.7466\nX3.3602\n").summary.time_s);
}

}  // namespace test_blended_feeds
