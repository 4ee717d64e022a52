#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <numbers>
#include <random_numbers.hpp>
#include <vector>

#include "blended.hpp"
#include "five_axes.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Programs under G64 at servo periods up to the longest: chords between words are inside the tolerance as the path is,
// and rounding is no slower than a stop at every joint. Of five axes, where control of the tip begins and ends between
// words so far apart that any two might be at rest.

namespace test_periods {

using namespace leadscrew;
using namespace leadscrew::testing_support;

constexpr base::Period milliseconds(std::int64_t count) {
  return {count * 1'000'000};
}

/// The last word comes a period later at most.
double period_of(base::Period period) {
  return period.seconds() + 1e-9;
}

/// Lines of lengths alike or not that turn anyhow.
std::string random_lines() {
  std::string text =
      "G21 G90 G17 G94 F" + std::to_string(any(100, 12000)) + " G64" + word('P', logarithmic(1e-3, 0.3), 6) + '\n';
  const double usual = logarithmic(0.01, 20), spread = logarithmic(1, 30), sharpest = logarithmic(0.05, 3.1);
  double x = 0, y = 0, angle = any(0, 6283) / 1000.0;
  for (int k = any(2, 30); k > 0; --k) {
    const double length = usual * logarithmic(1 / spread, spread);
    angle += sharpest * any(-1000, 1001) / 1000.0;
    x += length * std::cos(angle);
    y += length * std::sin(angle);
    text += "G1" + word('X', x, 4) + word('Y', y, 4) + '\n';
  }
  return text + "M2\n";
}

void keep_promises_and_lose_no_time_at_any_period() {
  const std::string text = random_lines();
  const base::Period period = milliseconds(*rc::gen::element(1, 2, 4, 10, 20));
  RC_LOG() << text << "period " << period.nanoseconds << " ns";
  const Outcome outcome = run(text, {}, period), stopping = run_with_stops(text, period);
  RC_ASSERT(keeps_promises(outcome));
  RC_ASSERT(outcome.summary.time_s <= stopping.summary.time_s + period_of(period));
}

RC_GTEST_PROP(RandomPeriods, KeepEveryPromiseAndAreNoSlowerThanWithStops, ()) {
  keep_promises_and_lose_no_time_at_any_period();
}
RC_GTEST_PROP(LongRandomPeriods, KeepEveryPromiseAndAreNoSlowerThanWithStops, ()) {
  constexpr int programs = 2;  // a case
  for (int k = 0; k < programs; ++k) keep_promises_and_lose_no_time_at_any_period();
}

void keep_five_axes_within_limits_at_any_period() {
  machine::Machine machine = five_axes();
  machine.period = {1000 * static_cast<std::int64_t>(logarithmic(1000, 50'000))};
  const std::string text = FiveAxisProgram(machine).make(any(1, 6));
  RC_LOG() << machine.kinematics << "\n"
           << text << limits_of(machine) << "period " << machine.period.nanoseconds << " ns";
  const Judged outcome = judge(text, machine);
  RC_ASSERT(outcome.errors == 0);
  for (const referee::Violation& each : outcome.verdict.violations)
    RC_LOG() << "\n"
             << each.what << " " << each.value << " of " << each.limit << " at " << each.t << " line "
             << base::number(each.line);
  RC_ASSERT(outcome.verdict.violation_count == 0);
  RC_ASSERT(worst_judged(outcome.verdict) <= 1.001);
  RC_ASSERT(outcome.verdict.deviation_mm <= outcome.verdict.tolerance_mm + 1e-6);
}

RC_GTEST_PROP(RandomPeriods, KeepFiveAxesWithinTheirLimits, ()) {
  keep_five_axes_within_limits_at_any_period();
}
RC_GTEST_PROP(LongRandomPeriods, KeepFiveAxesWithinTheirLimits, ()) {
  constexpr int programs = 4;  // a case
  for (int k = 0; k < programs; ++k) keep_five_axes_within_limits_at_any_period();
}

using Corners = std::vector<base::AxisVector>;

/// `count` corners, `leg` mm apart, that turn by this angle, one way and then the other.
Corners stairs(int count, double leg, double degrees) {
  Corners corners(1);
  for (int k = 0; k < count; ++k) {
    const double angle = (k % 2 == 0 ? 0.1 : 0.1 + degrees * std::numbers::pi / 180);
    base::AxisVector next = corners.back();
    next[0] += leg * std::cos(angle);
    next[1] += leg * std::sin(angle);
    corners.push_back(next);
  }
  return corners;
}

std::string lines_through(const Corners& corners) {
  std::string text = head;
  for (std::size_t k = 1; k < corners.size(); ++k)
    text += "G1" + word('X', corners[k][0], 9) + word('Y', corners[k][1], 9) + '\n';
  return text + "M2\n";
}

std::vector<base::AxisVector> words_of(const std::string& text, base::Period period) {
  machine::Machine machine = wide_mill();
  machine.period = period;
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  std::vector<base::AxisVector> words;
  while (program.prepare()) words.push_back(program.cycle().position);
  return words;
}

double distance_to(const std::vector<base::AxisVector>& words, const base::AxisVector& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < words.size(); ++k)
    nearest = std::min(nearest, numeric::distance_to_segment(place, words[k - 1], words[k]));
  return nearest;
}

/// Without the referee's allowance for sampling. Where a period is longer than a blend takes, braking before it and behind
/// it adds to the chord's departure, no more than a stop at the corner has: its words are j(T/2)³/6 before and behind.
TEST(Periods, ChordsBetweenWordsPassCornersWithinTheTolerance) {
  for (const std::int64_t period : {10, 20}) {
    const double half = milliseconds(period).seconds() / 2;
    const double allowed = 0.01 + (period > 10 ? 20'000 * half * half * half / 6 : 0);
    for (const double degrees : {45.0, 60.0, 90.0, 135.0}) {
      const Corners corners = stairs(12, 5, degrees);
      const std::vector<base::AxisVector> words = words_of(lines_through(corners), milliseconds(period));
      for (const base::AxisVector& corner : corners)
        EXPECT_LE(distance_to(words, corner), allowed) << period << ' ' << degrees;
    }
  }
}

/// Four corners: at 20 ms by no more than the periods in which a stop would be made.
TEST(Periods, RoundingASquareIsFasterThanStopsAtEach) {
  const std::string square = head + "G1 X10\nY10\nX0\nY0\n";
  for (const std::int64_t period : {1, 2, 4, 10, 20}) {
    const Outcome outcome = run(square, {}, milliseconds(period));
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_LT(outcome.summary.time_s, run_with_stops(square, milliseconds(period)).summary.time_s - 0.019) << period;
  }
}

/// Where chords of 1 µm allow next to no speed through a bend, at no tolerance worth it, motion stops.
TEST(Periods, CornersAreNoSlowerThanStopsWhereNextToNothingMayBeRounded) {
  for (const double degrees : {10.0, 20.0, 45.0, 90.0, 135.0}) {
    std::string text = lines_through(stairs(20, 2, degrees));
    text.replace(text.find("P0.01"), 5, "P0.001");
    const Outcome outcome = run(text, {}, milliseconds(20));
    EXPECT_TRUE(keeps_promises(outcome)) << degrees;
    EXPECT_LE(outcome.summary.time_s, run_with_stops(text, milliseconds(20)).summary.time_s + 1e-9) << degrees;
  }
}

/// A smooth curve as short lines: chords of the words may use the tolerance.
TEST(Periods, FittedCurvesAreTravelledFasterThanTheChordErrorOfExactOnesAllows) {
  std::string lines;
  for (int k = 1; k <= 90; ++k) {
    const double angle = k * std::numbers::pi / 90;
    lines += "G1" + word('X', 5 * std::sin(angle), 6) + word('Y', 5 - 5 * std::cos(angle), 6) + '\n';
  }
  const std::string exact = "G21 G90 G17 G94 F6000 G61\nG3 X0 Y10 J5\n";
  const base::Period period = milliseconds(20);
  EXPECT_LT(run(head + lines, {}, period).summary.time_s, 0.6 * run(exact, {}, period).summary.time_s);
}

}  // namespace test_periods
