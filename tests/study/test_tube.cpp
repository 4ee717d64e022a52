// The least time inside a tube: against closed forms, published optima, other starts, and the referee.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/study/optima.hpp>
#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/tube_barrier.hpp>
#include <leadscrew/study/tube_fragments.hpp>
#include <leadscrew/study/tube_optimum.hpp>
#include <leadscrew/study/tube_words.hpp>
#include <random>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_tube {

constexpr base::Period millisecond{1'000'000};

const TubeFragment& fragment(std::string_view name) {
  for (const TubeFragment& each : tube_fragments()) {
    if (each.program.name == name) return each;
  }
  ADD_FAILURE() << "no " << name;
  return tube_fragments().front();
}

Tube tube(const BlendedProgram& program) {
  return *tube_of(blended(program), machine_of(program, millisecond));
}

Tube line_tube(double length) {
  return {.legs = {{{0, 0}, {length, 0}}}, .tolerance = 0.01, .feed = 100, .acceleration = 1000, .jerk = 20000};
}

Tube corner_tube(double degrees, double tolerance) {
  const double turn = degrees * 3.14159265358979324 / 180;
  const PlaneVector middle = {3, 0}, end = middle + 3.0 * PlaneVector{std::cos(turn), std::sin(turn)};
  Tube tube = line_tube(3);
  tube.tolerance = tolerance;
  tube.legs.push_back({middle, end});
  return tube;
}

double least_time(const Tube& tube, const TubeOptions& options = {}) {
  return least_time_motion(tube, options).motion.seconds();
}

/// Rest to rest along a line: acceleration a is reached, feed is not. v²/a + va/j = L, T = 2(v/a + a/j).
double seven_phases(double length, double a, double j) {
  const double v = (-a / j + std::sqrt(a * a / (j * j) + 4 * length / a)) * a / 2;
  return 2 * (v / a + a / j);
}

/// 0.3 of either side of what the legs' lengths suggest, in time.
TubeOptions random_start(const Tube& tube, unsigned seed) {
  std::mt19937 draw(seed);
  TubeOptions options;
  for (const TubeLeg& leg : tube.legs) {
    const double unit = static_cast<double>(draw()) / 4294967296.0;
    options.shares.push_back(std::cbrt(leg.length()) * std::exp(0.3 * (2 * unit - 1)));
  }
  return options;
}

TEST(TubeMotions, HaveTheVelocityOfTheirPositions) {
  TubeMotion motion;
  for (int k = 0; k < 12; ++k) motion.points.push_back({std::sin(k), std::cos(0.7 * k)});
  constexpr double step = 1e-5;
  for (double t = 0.1; t < 8.95; t += 0.37) {
    const PlaneVector difference = 0.5 / step * (motion.at(t + step) - motion.at(t - step));
    EXPECT_NEAR(motion.velocity(t).x, difference.x, 1e-8);
    EXPECT_NEAR(motion.velocity(t).y, difference.y, 1e-8);
  }
  for (std::size_t k = 0; k <= motion.intervals(); ++k)
    EXPECT_NEAR(norm(motion.knot(k) - motion.at(static_cast<double>(k))), 0, 1e-15);
}

/// −log of the slacks, and its derivatives along a random direction, by differences.
void model_is_that_of(TubeBarrier& barrier, const Tube& tube, const TubeIterate& at, const TubeAssignment& assignment) {
  constexpr double t = 50;
  TubeModel model;
  barrier.assemble(t, at, assignment, TubeBarrier::Passes::fixed, model);
  const TubeModel::Step step = model.newton_step();
  const auto along = [&](double length) {
    TubeIterate moved = at;
    for (std::size_t k = 0; k < at.points.size(); ++k) moved.points[k] = at.points[k] + length * step.points[k];
    moved.w += length * step.w;
    return barrier.value(t, moved, assignment);
  };
  // Along Newton's step d: gᵀd = −δ, dᵀHd = δ.
  const double length = 1e-4 / std::sqrt(step.decrement);
  const double slope = (along(length) - along(-length)) / (2 * length);
  const double curvature = (along(length) - 2 * along(0) + along(-length)) / (length * length);
  EXPECT_NEAR(slope / step.decrement, -1, 1e-5) << tube.legs.size();
  EXPECT_NEAR(curvature / step.decrement, 1, 1e-2);
}

TEST(TubeBarriers, HaveTheDerivativesThatTheyAssemble) {
  for (const char* name : {"square of 10 mm", "4 lines and 2 arcs, corners and tangents", "zigzag, pitch 0.5 mm"}) {
    SCOPED_TRACE(name);
    const Tube around = tube(fragment(name).program);
    const TubeMotion start = stopping_motion(around, 400, std::vector<double>(around.legs.size(), 1));
    TubeBarrier barrier(around, 1.3 * start.interval);
    const TubeIterate at{start.points, 1.1};
    const TubeAssignment assignment = assigned(around, at.points, start.passes);
    ASSERT_TRUE(std::isfinite(barrier.value(50, at, assignment)));
    model_is_that_of(barrier, around, at, assignment);
  }
}

TEST(TubeOptimum, OfOneLineIsTheClosedForm) {
  for (const double length : {6.0, 10.0})
    EXPECT_NEAR(least_time(line_tube(length)) / seven_phases(length, 1000, 20000), 1, 2e-4) << length;
}

/// A circle's optimum on the path itself, T3* (optima.cpp), is met from below as the tube gets narrow.
TEST(TubeOptimum, OfANarrowTubeIsThatOfThePath) {
  const Optimum& published = circle_optima().optima[1];
  const BlendedProgram circle = {
      "circle", [] { return ProgrammedContour{"G3 X-10 Y0 I-10 J0\nG3 X10 Y0 I10 J0\n", {10}}; }, 100, 1e-3};
  ASSERT_EQ(published.feed, 100);
  EXPECT_NEAR(least_time(tube(circle)) / published.optimum, 1, 2 * optimum_accuracy);
}

TEST(TubeOptimum, FallsAsTheTubeWidens) {
  double before = 2 * seven_phases(3, 1000, 20000);
  for (const double tolerance : {0.001, 0.01, 0.1}) {
    const double time = least_time(corner_tube(90, tolerance));
    EXPECT_LT(time, before * 0.99) << tolerance;
    before = time;
  }
}

TEST(TubeOptimum, IsTheSameOfTheMirrorImage) {
  EXPECT_NEAR(least_time(corner_tube(60, 0.01)) / least_time(corner_tube(-60, 0.01)), 1, 1e-4);
}

/// Across the first leg the corner is taken by jerk alone: swinging from the inner wall to the outer one at +j, where it
/// arrives with v = 0 and the greatest acceleration that there can be, ∛(3 P j²), and on at +j to P cos(φ/2), from where
/// the corner is P away. The speed there is that across the leg over sin(φ/2).
double corner_speed(double turn, double tolerance, double jerk) {
  const double a = std::cbrt(3 * tolerance * jerk * jerk);
  double t = 0;
  while (-tolerance + (a / 2 + jerk * t / 6) * t * t < tolerance * std::cos(turn / 2)) t += 1e-7;
  return (a + jerk * t / 2) * t / std::sin(turn / 2);
}

TEST(TubeOptimum, PassesACornerAtTheSpeedOfTheClosedForm) {
  constexpr double right_angle = 1.57079632679489662;
  for (const double tolerance : {0.003, 0.01, 0.03}) {
    const TubeMotion motion = least_time_motion(corner_tube(90, tolerance)).motion;
    const double speed = norm(motion.velocity(motion.passes.front())) / motion.interval;
    EXPECT_NEAR(speed / corner_speed(right_angle, tolerance, 20000), 1, 0.005) << tolerance;
  }
}

TEST(TubeOptimum, OfASquareIsTheSameFromFiveStarts) {
  const TubeFragment& square = fragment("square of 10 mm");
  const Tube around = tube(square.program);
  for (unsigned seed = 1; seed <= 5; ++seed)
    EXPECT_NEAR(least_time(around, random_start(around, seed)) / square.least, 1, least_accuracy) << seed;
}

TEST(TubeOptimum, OfACornerIsFoundAgainAndItsWordsAreKept) {
  const TubeFragment& corner = fragment("corner that turns 90°, 2 × 5 mm");
  const machine::Machine machine = machine_of(corner.program, millisecond);
  const PartProgram program = blended(corner.program);
  const TubeMotion motion = least_time_motion(tube(corner.program)).motion;
  EXPECT_NEAR(motion.seconds() / corner.least, 1, least_accuracy);

  const std::vector<PlaneVector> words = motion.words(millisecond.seconds());
  const referee::Verdict verdict = judge(program, machine, words);
  EXPECT_FALSE(verdict.objects()) << verdict.violations.front().what;
  EXPECT_LE(static_cast<double>(words.size() - 1) * 1e-3, motion.seconds() + 2e-3);
  EXPECT_LT(motion.seconds(), plan(program, machine, {})->seconds);
  // Nothing is left unused: the tolerance, and all of the jerk but what a whole number of periods costs.
  EXPECT_GT(verdict.deviation_mm, 0.0099);
  EXPECT_GT(largest(verdict.axes).jerk, 0.98);
}

/// The referee of the row above can say no.
TEST(TubeWords, ThatLeaveTheTubeAreObjectedTo) {
  const TubeFragment& corner = fragment("corner that turns 90°, 2 × 5 mm");
  Tube wide = tube(corner.program);
  wide.tolerance *= 1.1;
  const std::vector<PlaneVector> words = least_time_motion(wide).motion.words(millisecond.seconds());
  EXPECT_TRUE(judge(blended(corner.program), machine_of(corner.program, millisecond), words).objects());
}

TEST(TubeWords, AreWrittenAsATraceThatReadsBackBitForBit) {
  EXPECT_EQ(trace_of({{0, -0.5}, {0.1, 1e-7}, {1.0 / 3, 2}}, millisecond),
            "t,X,Y,Z\n0,0,-0.5,0\n0.001,0.1,1e-07,0\n0.002,0.3333333333333333,2,0\n");
}

TEST(Tubes, AreNotMadeOfOtherPrograms) {
  const machine::Machine machine = machine_of(tube_fragments().front().program, millisecond);
  for (const char* text : {"G64 P0.01 F6000\nG1 Z1\nM2\n", "G61.1 F6000\nG1 X1\nM2\n", "G64 P0.01\nG0 X1\nM2\n"}) {
    const auto made = tube_of({std::string("G21 G90 G17 G94\n") + text}, machine);
    ASSERT_FALSE(made) << text;
    EXPECT_EQ(made.error().code, "no-tube") << text;
  }
  EXPECT_FALSE(tube_of({"G1 X\n"}, machine));
}

TEST(LongTube, RecordedTimesAreFoundAgainAndKept) {
  const Rows rows = tube_rows({});
  expect_none_published(rows);
  for (const TubeFragment& each : tube_fragments()) {
    const std::string group = circumstances(each.program);
    EXPECT_EQ(verdict(rows, group, "least time in the tube"), "reproduced") << group;
    EXPECT_EQ(verdict(rows, group, "least time: deviation from the program"), "kept") << group;
    EXPECT_EQ(verdict(rows, group, "least time: objections of the referee"), "kept") << group;
    EXPECT_GE(ours(rows, group, "time planned over least time"), 1) << group;
  }
}

TEST(LongTube, OtherStartsEndNoSoonerThanRecorded) {
  for (const TubeFragment& each : tube_fragments()) {
    const Tube around = tube(each.program);
    for (unsigned seed = 1; seed <= 2; ++seed) {
      const double ratio = least_time(around, random_start(around, seed)) / each.least;
      EXPECT_GE(ratio, 1 - least_accuracy) << each.program.name;
      EXPECT_LE(ratio, 1.003) << each.program.name;
    }
  }
}

}  // namespace test_tube
}  // namespace leadscrew::study::testing
