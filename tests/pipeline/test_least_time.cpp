#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random_numbers.hpp>
#include <string>
#include <vector>

#include "blended.hpp"

// Programs smoothed along the path of least time, judged by the referee: inside the tolerance, inside every limit, no
// slower than with a stop at every joint; and on programs of corners faster than by splines.

namespace test_least_time {

using namespace leadscrew;
using namespace leadscrew::testing_support;

machine::Machine mill_of_least_time() {
  machine::Machine machine = wide_mill();
  machine.smoothing = machine::Smoothing::least_time;
  return machine;
}

/// Lines, arcs and curves of 0.01 to 50 mm that turn anyhow, some of them in space, some rapids; feeds and tolerances change.
std::string random_program() {
  const bool in_space = any(0, 3) == 0, changes = any(0, 4) == 0;
  const double usual = logarithmic(0.02, 20), tolerance = logarithmic(1e-3, 0.3);
  std::string text = "G21 G90 G17 G94 F6000\nG64" + word('P', tolerance, 6) + '\n';
  double x = 0, y = 0, z = 0, heading = any(0, 6283) / 1000.0;
  for (int k = any(2, 24); k > 0; --k) {
    const double length = usual * logarithmic(0.3, 3);
    if (changes && any(0, 5) == 0) text += "G64" + word('P', tolerance * logarithmic(0.1, 2), 6) + '\n';
    if (any(0, 10) == 0) {
      text += "G5.2";
      for (int point = any(2, 6); point > 0; --point) {
        x += length * any(-1000, 1001) / 1000.0;
        y += length * any(-1000, 1001) / 1000.0;
        text += word('X', x, 6) + word('Y', y, 6) + word('P', logarithmic(0.5, 2), 3) + '\n';
      }
      text += "G5.3\nG1";
    } else if (any(0, 6) == 0) {
      // A quarter of a circle, tangent or not.
      const double side = any(0, 2) == 0 ? 1 : -1;
      const double cx = -side * length * std::sin(heading), cy = side * length * std::cos(heading);
      const double to = heading + side * std::numbers::pi / 2;
      x += cx + side * length * std::sin(to);
      y += cy - side * length * std::cos(to);
      text += (side > 0 ? "G3" : "G2") + word('X', x, 9) + word('Y', y, 9) + word('I', cx, 9) + word('J', cy, 9);
      heading = any(0, 2) == 0 ? to : to + any(-1500, 1501) / 1000.0;
    } else {
      heading += any(0, 8) == 0   ? std::numbers::pi
                 : any(0, 2) == 0 ? any(-3142, 3142) / 1000.0
                                  : any(-500, 500) / 1000.0;
      x += length * std::cos(heading);
      y += length * std::sin(heading);
      if (in_space) z += length * any(-700, 701) / 1000.0;
      text += (any(0, 20) == 0 ? "G0" : "G1") + word('X', x, 6) + word('Y', y, 6) + word('Z', z, 6);
    }
    if (any(0, 12) == 0) text += word('F', logarithmic(200, 12000), 0);
    text += '\n';
  }
  return text + "M2\n";
}

RC_GTEST_PROP(LeastTime, KeepsEveryPromiseAndIsNoSlowerThanWithStops, ()) {
  const std::string text = random_program();
  RC_LOG() << text;
  const Outcome outcome = run_on(mill_of_least_time(), text), stopping = run_with_stops(text);
  RC_ASSERT(keeps_promises(outcome));
  RC_ASSERT(outcome.summary.time_s <= stopping.summary.time_s + 0.001);
}

RC_GTEST_PROP(LeastTime, KeepsEveryPromiseOnOtherMachines, ()) {
  machine::Machine machine = mill_of_least_time();
  const double velocity = logarithmic(50, 300), acceleration = logarithmic(200, 5000), jerk = logarithmic(1e4, 1e6);
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    machine::AxisLimits& limits = *machine.axes[base::index(axis)];
    limits.velocity = velocity * logarithmic(0.1, 10);
    limits.acceleration = acceleration * logarithmic(0.1, 10);
    limits.jerk = jerk * logarithmic(0.1, 10);
  }
  machine.period = {any(1, 11) * 100'000};
  const std::string text = random_program();
  RC_LOG() << text;
  gcode::ReaderOptions with_stops;
  with_stops.path_mode = gcode::PathMode::exact_stop;
  const Outcome outcome = run_on(machine, text), stopping = run_on(machine, text, with_stops);
  RC_ASSERT(keeps_promises(outcome));
  RC_ASSERT(outcome.summary.time_s <= 1.001 * stopping.summary.time_s + 0.001);
}

/// Velocity, acceleration and jerk of X, Y and Z.
machine::Machine of_limits(const std::vector<std::array<double, 3>>& axes, std::int64_t period_ns) {
  machine::Machine machine = mill_of_least_time();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    machine::AxisLimits& limits = *machine.axes[i];
    limits.velocity = axes[i][0], limits.acceleration = axes[i][1], limits.jerk = axes[i][2];
  }
  machine.period = {period_ns};
  return machine;
}
/// All alike.
machine::Machine of_limits(double velocity, double acceleration, double jerk) {
  return of_limits(std::vector<std::array<double, 3>>(3, {velocity, acceleration, jerk}), 1'000'000);
}

/// Where a motion ended at a chord of a curve and the rest of the curve stayed exact, that began elsewhere: by lengths of
/// chords, not of the curve.
TEST(LeastTime, GoesOnWhereItCameToWithinACurve) {
  machine::Machine machine = of_limits(110, 300, 500'000);
  for (const std::int64_t period : {100'000, 1'000'000}) {
    machine.period = {period};
    for (const char* const tolerance : {"G64 P0.001", "G64 P0.01", "G64 P0.05"}) {
      const std::string text = std::string("G21 G90 G17 G94\nG61\nG1 X2.7 Y-5.6 F175.7\n") + tolerance +
                               "\nG5.2 X10.9 Y-27.2 P1.4\nX21.6 Y-20.6 P0.5\nG5.3\nM2\n";
      EXPECT_TRUE(keeps_promises(run_on(machine, text))) << tolerance;
    }
  }
}

/// A line that is short for the speed that it is travelled at, as a spline of thousands of spans, was crept along: of so many
/// a window sees no farther than some hundred.
TEST(LeastTime, IsNoSlowerThanWithStopsWhereATinyCornerFollowsALine) {
  gcode::ReaderOptions with_stops;
  with_stops.path_mode = gcode::PathMode::exact_stop;
  for (const double jerk : {2e4, 2e5, 6.7e5}) {
    const machine::Machine machine = of_limits(87.5, 200, jerk);
    for (const char* const tolerance : {"G64 P0.0002", "G64 P0.0008", "G64 P0.01"}) {
      const std::string text = std::string("G21 G90 G17 G94\n") + tolerance + "\nG0 X75.8\nG1 Y0.03 F3600\nM2\n";
      const Outcome outcome = run_on(machine, text);
      EXPECT_TRUE(keeps_promises(outcome)) << tolerance;
      EXPECT_LE(outcome.summary.time_s, run_on(machine, text, with_stops).summary.time_s) << tolerance << ' ' << jerk;
    }
  }
}

/// Within less than a micrometre it was slower than with stops, and planning took longer than motion; splines are neither.
TEST(LeastTime, IsLeftToSplinesWithinLessThanAMicrometre) {
  const machine::Machine machine =
      of_limits({{18.56, 3036, 79'180}, {32.77, 2042, 40'480}, {359.5, 2988, 10'930}}, 1'000'000);
  machine::Machine by_splines = machine;
  by_splines.smoothing = machine::Smoothing::splines;
  const std::string moves =
      "G1 X0.46812 Y-1.81941 Z-0.977323\nX3.822646 Y-6.328161 Z-2.86291\n"
      "G5.2 X4.735410 Y-7.570376 P1.241\nX6.541917 Y-7.322047 P1.224\nG5.3\nG1 X1.181224 Y-0.116846 Z-4.70565\n"
      "X0.705161 Y3.065198 Z-5.306436\nX0.16858 Y5.166993 Z-4.93593\nX1.202059 Y1.118842 Z-2.42379\nM2\n";
  gcode::ReaderOptions with_stops;
  with_stops.path_mode = gcode::PathMode::exact_stop;
  const auto time_of = [&](const machine::Machine& of, const std::string& tolerance) {
    const Outcome outcome = run_on(of, "G21 G90 G17 G94 F6000\nG64 " + tolerance + '\n' + moves);
    EXPECT_TRUE(keeps_promises(outcome)) << tolerance;
    return outcome.summary.time_s;
  };
  const double stopping = run_on(machine, "G21 G90 G17 G94 F6000\n" + moves, with_stops).summary.time_s;
  EXPECT_LE(time_of(machine, "P0.00099"), stopping);
  EXPECT_EQ(time_of(machine, "P0.00099"), time_of(by_splines, "P0.00099"));
  EXPECT_LE(time_of(machine, "P0.001"), stopping);
  EXPECT_NE(time_of(machine, "P0.001"), time_of(by_splines, "P0.001"));
}

/// Intervals as short as a corner asks were a hundred thousand along a curve at a low feed, and planning took longer than
/// motion.
TEST(LeastTime, PlansALowFeedBehindAHighOne) {
  machine::Machine machine = of_limits(35, 280, 70'000);
  const std::string text =
      "G21 G90 G17 G94\nG1 X0 F6485.61\nG64 P1.027503\nG2 X0.146882495 Y0.674402108 I-0.758137543 J0.518316097 P3 "
      "F75.7832\nG1 X29.930009403 Y-0.718329260\nG5.2 X46.399176818 Y38.959551083 P2.34104 L4\n"
      "X18.421105752 Y10.715766260 P1.90734\nX21.870102786 Y25.945316020 P2.08294\nX44.712249610 Y37.789054363 "
      "P1.18547\nX45.269557175 Y57.780868541 P2.27911\nX22.164046472 Y86.109365906 P0.837794\nG5.3\n"
      "G1 X22.164064640 Y86.109377676 F33965.2\nG0 Y89.226884874\nM2\n";
  machine.period = {2'000'000};
  EXPECT_TRUE(keeps_promises(run_on(machine, text)));
}

/// Found by the property above: where a window began in motion with another interval than that of its given points, it
/// swung about the leg, and what was planned for the path took longer than a stop.
TEST(LeastTime, DoesNotSwingWhereAWindowBeginsOnALongLeg) {
  const std::string text =
      "G21 G90 G17 G94 F6000\nG64 P0.001\nG3 X3.971177054 Y3.971177054 I-0.000000000 J3.971177054\n"
      "G1 X28.078819 Y8.502550 Z-15.821730 F935\nG1 X32.164029 Y7.174985 Z-16.019323\nM2\n";
  const Outcome outcome = run_on(mill_of_least_time(), text), stopping = run_with_stops(text);
  EXPECT_TRUE(keeps_promises(outcome));
  EXPECT_LT(outcome.summary.time_s, stopping.summary.time_s);
}

/// Found by the property above. Of a line that turns back the rest behind its exact beginning was planned as a path of least
/// time, and was slower than the line; and beside a sharp corner 3 % more than a stop takes were allowed.
TEST(LeastTime, IsNoSlowerThanWithStopsWhereLinesTurnBack) {
  for (const char* const lines :
       {"G64 P0.050035\nG1 X-0.498660 Y3.250927 F1109\nG1 X-0.091891 Y0.599069\n",
        "G64 P0.000708\nG1 X12.836641 Y-41.527326 Z-0.956253\nG1 X16.026750 Y-35.821443 Z-4.375165\nG64 P0.002916\n"
        "G1 X2.085696 Y-60.756643 Z10.622911\n",
        "G64 P0.0076\nG1 X2.92 F748\nG1 X-4.405\n"}) {
    SCOPED_TRACE(lines);
    const std::string text = std::string("G21 G90 G17 G94 F6000\n") + lines + "M2\n";
    const Outcome outcome = run_on(mill_of_least_time(), text), stopping = run_with_stops(text);
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LE(outcome.summary.time_s, stopping.summary.time_s + 0.001);
  }
}

/// By random lines of which many turn back. Beside the exact middle of a line a window was allowed to be three times as fast
/// as the feed, so that it ended in too few intervals and swung about the next line; and what was done of a long first line
/// counted as planned ahead, so that a window ended at the corner.
TEST(LeastTime, IsNoSlowerThanSplinesWhereSharpCornersFollowLongLines) {
  for (const char* const lines : {"F691\nG64 P0.0952\nG1 X12.4\nG1 X11.261992 Y0.596783\n",
                                  "F304\nG64 P0.0135\nG1 X9.08\nG1 X-29.587243 Y13.634276\n",
                                  "F691\nG64 P0.0952\nG1 X12.4\nG1 X11.261992 Y0.596783\nG1 X18.311 Y10.798\n"}) {
    SCOPED_TRACE(lines);
    const std::string text = std::string("G21 G90 G17 G94 ") + lines + "M2\n";
    const Outcome outcome = run_on(mill_of_least_time(), text);
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LE(outcome.summary.time_s, run(text).summary.time_s + 0.0005);
  }
}

/// Found by the property above: between knots of the plan as far apart as elsewhere, jerk could not change as often as in the
/// motion of least time, and most of a path that comes nearly to rest in a cloud of lines was crept along.
TEST(LeastTime, IsFollowedWhereItComesNearlyToRest) {
  const std::string text =
      "G21 G90 G17 G94 F6000\n"
      "G64 P0.034199\nG64 P0.010266\nG1 X-0.033037 Y0.058076 F2594\nG1 X0.099689 Y0.024327\n"
      "G3 X0.243099052 Y0.109591063 I0.029073312 J0.114337169\n"
      "G3 X0.207871377 Y0.168842637 I-0.047239624 J0.012011950\nG1 X0.138062 Y0.169122\n"
      "G1 X0.159809 Y0.198937 F205\nG64 P0.014072\nG1 X0.192050 Y0.337128\nG64 P0.007112\n"
      "G1 X0.190308 Y0.353381 F689\nG2 X0.222814806 Y0.393694835 I0.036410435 J0.003903352 F435\n"
      "G1 X0.295291 Y0.404485\nG1 X0.288298 Y0.434901\nG64 P0.053646\nG1 X0.286642 Y0.414141\n"
      "G1 X0.331058 Y0.525934\nG1 X0.306562 Y0.464278 F653\nG0 X0.312906 Y0.479505\n"
      "G2 X0.346241979 Y0.493232415 I0.023531495 J-0.009804426\nG64 P0.015140\n"
      "G2 X0.376108993 Y0.420700948 I-0.021332227 J-0.051199241\nG1 X0.353614 Y0.346076\n"
      "M2\n";
  const Outcome outcome = run_on(mill_of_least_time(), text);
  EXPECT_TRUE(keeps_promises(outcome));
  EXPECT_LE(outcome.summary.time_s, run(text).summary.time_s);
}

/// Found by the property above: at a slow feed and a tenth of a micrometre, hundreds of polynomials lie in an interval.
TEST(LeastTime, KeepsJerkAlongATinyCircleAtASlowFeed) {
  std::string text =
      "G21 G90 G17 G94 F6000\nG64 P0.001\nG1 X1.008425 Y0.048442\nG0 X0.145215 Y0.006976\nG2 X-0.317991388 "
      "Y0.427719604 I-0.021231110 J0.441975047\nG64 P0.00107\nG1 X-1.399101 Y1.049303\nG64 P0.0001 F200\n";
  for (int k = 0; k < 2; ++k) {
    text +=
        "G3 X-1.762393135 Y0.951257367 I-0.132622921 J-0.230668817\nX-1.664347239 Y0.587965629 I0.230668817 "
        "J-0.132622921\nX-1.301055502 Y0.686011525 I0.132622921 J0.230668817\nX-1.399101398 Y1.049303263 "
        "I-0.230668817 J0.132622921\n";
  }
  EXPECT_TRUE(keeps_promises(run_on(mill_of_least_time(), text + "M2\n")));
}

/// As CAM writes a curve: chords that turn by little, rounded to a micrometre.
TEST(LeastTime, KeepsChordsOfACurveWithinTheirTolerance) {
  for (const double pitch : {0.02, 0.1, 0.5}) {
    std::string text = "G21 G90 G17 G94 F6000\nG64 P0.01\n";
    for (double s = 0; s < 12; s += pitch)
      text += "G1" + word('X', s, 3) + word('Y', 2 * std::sin(s) + 0.3 * std::sin(3.1 * s), 3) + '\n';
    text += "M2\n";
    SCOPED_TRACE(pitch);
    const Outcome outcome = run_on(mill_of_least_time(), text);
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LE(outcome.summary.time_s, 1.005 * run(text).summary.time_s);
  }
}

/// 20 lines of 0.2 to 4 mm, each turned by up to 1.8 rad.
std::string walk(unsigned seed) {
  std::string text = "G21 G90 G17 G94 F6000\nG64 P0.01\n";
  double x = 0, y = 0, heading = 0;
  const auto draw = [&] { return (seed = 1664525u * seed + 1013904223u) / 4294967296.0; };
  for (int k = 0; k < 20; ++k) {
    heading += 1.8 * (2 * draw() - 1);
    const double length = 0.2 * std::pow(20, draw());
    x += length * std::cos(heading);
    y += length * std::sin(heading);
    text += "G1" + word('X', x, 3) + word('Y', y, 3) + '\n';
  }
  return text + "M2\n";
}

TEST(LeastTime, IsATenthFasterThanSplinesOnRandomWalks) {
  for (const unsigned seed : {1u, 2u, 3u, 11u}) {
    SCOPED_TRACE(seed);
    const Outcome outcome = run_on(mill_of_least_time(), walk(seed));
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LE(outcome.summary.time_s, 0.93 * run(walk(seed)).summary.time_s);
  }
}

TEST(LeastTime, LeavesOneLineAndOneArcAsTheyAre) {
  for (const char* block : {"G1 X12 Y5 Z-3", "G3 X12 Y0 I6 J0", "G2 X6 Y6 I6 J0"}) {
    const std::string text = std::string("G21 G90 G17 G94 F3000\nG64 P0.05\n") + block + "\nM2\n";
    SCOPED_TRACE(block);
    const Outcome outcome = run_on(mill_of_least_time(), text);
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LE(outcome.verdict.deviation_mm, 1e-9);
  }
}

TEST(LeastTime, KeepsTheMiddleOfLongLinesExact) {
  const std::string text = "G21 G90 G17 G94 F6000\nG64 P0.05\nG1 X300\nG1 Y200\nG1 X0\nM2\n";
  const Outcome outcome = run_on(mill_of_least_time(), text);
  EXPECT_TRUE(keeps_promises(outcome));
  EXPECT_LE(outcome.summary.time_s, run(text).summary.time_s + 0.001);
}

}  // namespace test_least_time
