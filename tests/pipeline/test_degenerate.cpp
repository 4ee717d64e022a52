#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>

// What no CAM should write and some do: programs at the edge of having a motion at all. Each runs to its end, judged by
// the referee, or is refused with a diagnostic.

namespace test_degenerate {

using namespace leadscrew;

struct Outcome {
  pipeline::Summary summary;
  referee::Verdict verdict;
  std::vector<std::string> errors;  ///< codes
  std::int64_t words = 0;
  base::AxisVector last{};
  bool ended = false;  ///< within the words allowed
};

/// What takes days is cut off after so many.
constexpr std::int64_t most_words = 300'000;

/// Read whole first, and moved only if nothing is wrong, as the command does it.
Outcome run(const std::string& text, const machine::Machine& machine) {
  Outcome outcome;
  const machine::ToolTable tools;
  gcode::Reader checked(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error) outcome.errors.emplace_back(problem.code);
  });
  gcode::Move move;
  while (checked.next(move)) {
  }
  if (!outcome.errors.empty()) return outcome;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& next) { return judged.next(next); }, machine, machine.period);
  while (outcome.words < most_words && program.prepare()) {
    const base::Word word = program.cycle();
    referee.observe(word.position);
    outcome.last = word.position;
    ++outcome.words;
  }
  outcome.ended = outcome.words < most_words;
  outcome.summary = program.summary();
  if (outcome.ended) outcome.verdict = referee.conclude();
  return outcome;
}

void passes(const Outcome& outcome, const base::AxisVector& end) {
  ASSERT_TRUE(outcome.errors.empty()) << outcome.errors[0];
  ASSERT_TRUE(outcome.ended);
  EXPECT_LE(outcome.summary.plan.greatest(), 1.001);
  for (const auto& axis : outcome.verdict.axes) {
    EXPECT_LE(std::max({axis.velocity_ratio, axis.acceleration_ratio, axis.jerk_ratio}), 1.001)
        << base::letter(axis.axis);
  }
  EXPECT_LE(outcome.verdict.feed_max_ratio, 1.001);
  EXPECT_LE(outcome.verdict.deviation_mm, outcome.verdict.tolerance_mm + 1e-6);
  EXPECT_EQ(outcome.verdict.start_error_mm, 0);
  EXPECT_LE(outcome.verdict.end_error_mm, 1e-9);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
  EXPECT_EQ(outcome.last, end);
}

void passes(const std::string& text, const base::AxisVector& end) {
  SCOPED_TRACE(text);
  passes(run(text, machine::mill3()), end);
}

void is_refused(const std::string& text, const std::string& code) {
  const Outcome outcome = run(text, machine::mill3());
  ASSERT_FALSE(outcome.errors.empty()) << text;
  EXPECT_EQ(outcome.errors[0], code) << text;
  EXPECT_EQ(outcome.words, 0);
}

TEST(Degenerate, MovesOfZeroLength) {
  passes("G21 G90 G1 X0 Y0 F600\nM2\n", {});
  passes("G21 G90 G0 X0\nG1 X0 F600\nG1 X0\nM2\n", {});
  passes("G21 G90 G1 X5 F600\nX5\nX5\nX10\nX10\nM2\n", {10});
  passes("G21 G90 G1 X5 F600\nG4 P0\nX5\nG5 X5 Y0 I0 J0 P0 Q0\nG1 X10\nM2\n", {10});
  passes("G21 G91 G1 X0 Y0 Z0 F600\nX1\nX0\nX1\nM2\n", {2});
}

TEST(Degenerate, OneBlock) {
  passes("G1 X10 F600\n", {10});
  passes("G1 X10 F600", {10});
  passes("G0 X10\n", {10});
  passes("G3 X0 Y0 I5 F600\n", {});
  passes("G5 X10 Y10 I5 J0 P0 Q-5 F600\n", {10, 10});
  is_refused("", "empty-program");
  is_refused("\n\n\n", "empty-program");
  passes("M2\n", {});
}

/// Full multiplicity inside: what is joined there need not have a tangent in common.
TEST(Degenerate, NurbsWithAKinkAtARepeatedKnot) {
  passes(
      "G6.2 P4 K0 X0 Y0 F6000\nK0 X5 Y10\nK0 X10 Y10\nK0 X10 Y0\nK0.5 X20 Y5\nK0.5 X20 Y-10\nK0.5 X30 "
      "Y0\nK1\nK1\nK1\nK1\nM2\n",
      {30});
  // Where the points about it lie on one line, evenly, there is no kink.
  passes(
      "G6.2 P4 K0 X0 Y0 F6000\nK0 X5 Y10\nK0 X10 Y10\nK0 X15 Y10\nK0.5 X20 Y10\nK0.5 X25 Y10\nK0.5 X30 "
      "Y0\nK1\nK1\nK1\nK1\nM2\n",
      {30});
}

TEST(Degenerate, NurbsWithCoincidingPoints) {
  passes("G6.2 P4 K0 X0 Y0 F6000\nK0 X0 Y0\nK0 X10 Y10\nK0 X20 Y10\nK0.5 X20 Y10\nK0.7 X30 Y0\nK1\nK1\nK1\nK1\nM2\n",
         {30});
  passes("G6.2 P4 K0 X0 Y0 F6000\nK0 X10 Y10\nK0 X10 Y10\nK0 X10 Y10\nK0.3 X10 Y10\nK0.6 X30 Y0\nK1\nK1\nK1\nK1\nM2\n",
         {30});
  passes("G6.2 P3 K0 X0 Y0 F6000\nK0 X0 Y0\nK0 X0 Y0\nK1\nK1\nK1\nG1 X5\nM2\n", {5});
}

TEST(Degenerate, NurbsWithKnotsCloseTogether) {
  passes(
      "G6.2 P4 K0 X0 Y0 F6000\nK0 X5 Y10\nK0 X10 Y10\nK0 X15 Y0\nK0.5 X20 Y10\nK0.500001 X25 Y10\nK0.7 X30 "
      "Y0\nK1\nK1\nK1\nK1\nM2\n",
      {30});
}

TEST(Degenerate, Cusp) {
  // x′ = 30(1 − 2t)², y′ = 30(1 − 2t): up, and back down the other side.
  passes("G5 X10 Y0 I10 J10 P-10 Q10 F3000\nM2\n", {10});
  passes("G5.1 X0 Y0 I10 J0 F3000\nM2\n", {});  // there and back on a line
}

/// A parabola with a tip of so small a radius that nothing tells of it but the curve itself: to go round it takes no
/// longer than to stop there.
TEST(Degenerate, NurbsThatTurnsBackRoundATip) {
  const auto parabola = [](double radius) {
    const double half = std::sqrt(20 * radius);
    char text[120];
    std::snprintf(text, sizeof text, "F3000\nG6.2 P3 K0 X0 Y0\nK0 X%.9f Y20\nK0 X%.9f Y0\nK1\nK1\nK1\nM2\n", half,
                  2 * half);
    return std::string(text);
  };
  const double with_stop = run(parabola(0), machine::mill3()).summary.time_s;
  for (const double radius : {1e-9, 1e-8, 1e-7, 3.2e-7, 1e-6, 3.2e-6, 1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(radius);
    const Outcome outcome = run(parabola(radius), machine::mill3());
    passes(outcome, {outcome.last[0]});
    EXPECT_LE(outcome.summary.time_s, with_stop + 0.002);
  }
}

/// The same where a rotary axis turns back and a linear one all but stands.
TEST(Degenerate, NurbsWhoseRotaryAxisTurnsBackRoundATip) {
  machine::Machine machine = machine::mill3();
  machine.axes[base::index(base::Axis::A)] = machine::AxisLimits{-36000, 36000, 90, 500, 5000, 0.001};
  const std::string spline =
      "G6.2 P4 K0 X-10.8897 A21.0189\nK0 X-11.5127 A20.4811\nK0 X-11.2813 A20.6084\nK0 X-11.2813 A20.2807\n"
      "K1 X-11.2813 A19.8355\nK2 X-11.2785 A20.5157\nK3 X-11.3497 A20.5157\nK4 X-10.8409 A19.9465\n"
      "K5\nK5\nK5\nK5\nM2\n";
  const Outcome outcome = run("F1652 G1 X-10.8897 A21.0189\nG61.1\n" + spline, machine);
  passes(outcome, {-10.8409, 0, 0, 19.9465});
  EXPECT_LE(outcome.summary.time_s, 3);
}

TEST(Degenerate, StraightNurbs) {
  passes("G6.2 P4 K0 X0 Y0 F6000\nK0 X10 Y5\nK0 X20 Y10\nK0 X30 Y15\nK1\nK1\nK1\nK1\nM2\n", {30, 15});
  passes("G6.2 P4 K0 X0 Y0 F6000\nK0 X1 Y0.5 R3\nK0 X29 Y14.5\nK0 X30 Y15\nK1\nK1\nK1\nK1\nM2\n", {30, 15});
  passes("G6.2 P2 K0 X0 F6000\nK0 X20\nK1\nK1\nM2\n", {20});
  passes("G6.2 P2 K0 X0 Y0 F6000\nK0 X20 Y0\nK1 X20 Y10\nK2\nK2\nM2\n", {20, 10});  // a corner
}

TEST(Degenerate, WeightsThatAreNone) {
  for (const char* weight : {"0", "-1", "-0.001"}) {
    is_refused(std::string("G6.2 P3 K0 X0 Y0 F600\nK0 X10 Y10 R") + weight + "\nK0 X20\nK1\nK1\nK1\nM2\n",
               "bad-weight");
  }
}

TEST(Degenerate, WeightsOfVeryDifferentSize) {
  passes("G6.2 P3 K0 X0 Y0 R1 F6000\nK0 X10 Y10 R0.001\nK0 X20 Y0 R1\nK1\nK1\nK1\nM2\n", {20});
  passes("G6.2 P3 K0 X0 Y0 R1 F6000\nK0 X10 Y10 R1000\nK0 X20 Y0 R1\nK1\nK1\nK1\nM2\n", {20});
}

TEST(Degenerate, KnotsOutOfOrder) {
  is_refused("G6.2 P3 K0 X0 Y0 F600\nK0 X10 Y10\nK0 X20\nK2\nK1\nK1\nM2\n", "knot-order");
  is_refused("G6.2 P3 K1 X0 Y0 F600\nK0 X10 Y10\nK0 X20\nK1\nK1\nK1\nM2\n", "knot-order");
}

TEST(Degenerate, ArcOfANanometre) {
  passes("G1 X10 F600\nG3 X9.9999999999 Y0.000001 I-10 J0\nM2\n", {9.9999999999, 0.000001});
  passes("G3 X0.000001 Y0.000001 I0 J0.000001 F600\nM2\n", {0.000001, 0.000001});
  passes("G3 X0 Y0 I0 J0.000001 F600\nM2\n", {});
}

TEST(Degenerate, LineOfANanometre) {
  passes("G1 X0.000001 F600\nM2\n", {0.000001});
  passes("G1 X10 F600\nX10.000001\nX20\nM2\n", {20});
  passes("G1 X10 F600\nX10 Y0.000001\nX20 Y0.000001\nM2\n", {20, 0.000001});
}

TEST(Degenerate, LineOfAKilometre) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->travel_min = -2e6, axis->travel_max = 2e6, axis->velocity = 20000;
  }
  machine.period = base::longest_period;
  passes(run("G1 X1000000 F600000\nM2\n", machine), {1e6});
  passes(run("G1 X1000000 F600000\nX1000000.000001\nM2\n", machine), {1000000.000001});
  passes(run("G2 X1000000 Y0 I500000 J0 F600000\nM2\n", machine), {1e6});
}

// A thousandth of a millimetre a minute is a nanometre in 60 ms.
TEST(Degenerate, SlowestFeeds) {
  passes("G1 X0.000001 F0.001\nM2\n", {0.000001});
  passes("G3 X0 Y0 I0.000001 J0 F0.01\nM2\n", {});
  is_refused("G3 X0 Y0 I0.00000001 J0 F0.001\nM2\n", "arc-radius");
  const Outcome line = run("G1 X10 F0.001\nM2\n", machine::mill3());  // takes a week: it is on its way
  EXPECT_TRUE(line.errors.empty());
  EXPECT_FALSE(line.ended);
  EXPECT_NEAR(line.last[0], most_words * 1e-3 * 0.001 / 60, 2e-8);
}

/// How far a motion that goes on for days has come after so many words, mm.
double travelled(const std::string& text, std::int64_t words) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  base::Word word{};
  for (std::int64_t k = 0; k < words && program.prepare(); ++k) word = program.cycle();
  return word.path_length;
}

TEST(Degenerate, SlowestFeedsAlongCurves) {
  // Windows are as short as the feed is slow, so that a week of motion is a billion of them: the first ten words.
  for (const char* text : {"G3 X10 Y10 I10 F0.001\nM2\n", "G5 X10 Y10 I5 J0 P0 Q-5 F0.001\nM2\n"}) {
    EXPECT_NEAR(travelled(text, 11), 10 * 1e-3 * 0.001 / 60, 2e-9) << text;
  }
  for (const char* text : {"G3 X10 Y10 I10 F1\nM2\n", "G5 X10 Y10 I5 J0 P0 Q-5 F1\nM2\n"}) {
    EXPECT_NEAR(travelled(text, 1001), 1.0 / 60, 1e-4) << text;
  }
}

TEST(Degenerate, FastestFeeds) {
  is_refused("G1 X10 F1e9\nM2\n", "unused-word");  // no exponents in RS274
  passes("G1 X10 F1000000000\nM2\n", {10});
  passes("G1 X10 F1000000000\nG3 X10 Y0 I-5 J0\nM2\n", {10});
  passes("G5 X10 Y10 I5 J0 P0 Q-5 F1000000000\nM2\n", {10, 10});
}

/// Where control points coincide a curve's parameter stands, and its derivatives by arc length are made of ever smaller numbers.
TEST(Degenerate, CurvesWithControlPointsThatCoincide) {
  const std::string curves[] = {
      "F1000\nG5.2 X-0.007 Y0.004 P10 L5\nX-0.007 Y0.004 P10\nX-0.007 Y0.004 P2\nX-0.007 Y0.004 P10\nX9 Y0.01 P10\nX8 "
      "Y-7 P1\nX8 Y-7 P10\nX8 Y-7 P1\nX8 Y-7 P1\n",
      "F1000\nG5.2 X0.009 Y0.008 P1 L5\nX0.008 Y0.003 P1\nX-1 Y4 P1\nX-1 Y4 P1\nX0.008 Y0.005 P1\nX-0.005 Y-3 "
      "P0.5\nX-9 Y-7 P1\nX-9 Y-7 P1\nX-9 Y-7 P0.5\nX-9 Y-7 P1\n",
      "F1000\nG5.2 X8 Y-9 P1 L6\nX8 Y-9 P0.5\nX8 Y-9 P0.5\nX8 Y-9 P0.5\nX8 Y-9 P10\nX10 Y3 P1\nX1 Y0 P2\nX1 Y0 "
      "P0.5\nX1 Y0 P2\n",
      "F1000\nG5.2 X-20 Y-70 P0.5 L6\nX-20 Y-70 P0.5\nX-3 Y0 P1\nX-3 Y0 P10\nX-3 Y0 P2\nX-3 Y0 P0.5\nX9 Y100 P10\nX9 "
      "Y100 P1\nX9 Y100 P10\nX9 Y100 P0.5\n",
      "F6000\nG5.2 X4 Y-0.01 P10 L5\nX0.003 Y-4 P0.5\nX0.003 Y-4 P2\nX0.003 Y-4 P1\nX0.003 Y-4 P10\nX0.006 Y-5 P2\nX-7 "
      "Y0.01 P1\nX10 Y0.008 P10\nX10 Y0.008 P1\nX0.003 Y-6 P2\nX0.003 Y-6 P2\nX0.003 Y-6 P1\nX0.003 Y-6 P10\nX0.003 "
      "Y-6 P0.5\n",
      "F1000\nG5.2 X-8 Y-7 P1 L5\nX-8 Y-7 P2\nX-8 Y-7 P2\nX-8 Y-7 P1\nX9 Y8 P2\nX-1 Y0 P1\nX-5 Y-8 P1\nX-8 Y1 P2\nX-8 "
      "Y1 P1\nX-8 Y1 P10\nX-8 Y1 P0.5\nX-8 Y1 P2\n",
      "F6000\nG5.2 X-40 Y3 P10 L6\nX50 Y7 P1\nX50 Y7 P1\nX50 Y7 P0.5\nX20 Y4 P0.5\nX20 Y4 P1\nX20 Y4 P1\nX20 Y4 "
      "P2\nX20 Y4 P0.5\n",
      "F6000\nG5.2 X6 Y0 P1 L5\nX6 Y0 P0.5\nX6 Y0 P1\nX6 Y0 P10\nX0.003 Y0.008 P0.5\nX0.003 Y0.008 P1\nX0.003 Y0.008 "
      "P2\nX0.003 Y0.008 P1\n",
      "F6000\nG5.2 X90 Y60 P10 L6\nX4 Y4 P0.5\nX4 Y4 P2\nX-80 Y-20 P10\nX-80 Y-20 P1\nX-80 Y-20 P0.5\nX-80 Y-20 "
      "P1\nX-80 Y-20 P1\nX20 Y0 P2\nX20 Y0 P10\nX20 Y-5 P1\n",
  };
  for (const std::string& curve : curves) passes(curve + "G5.3\nG1 X10 Y3\nM2\n", {10, 3});
}

/// The same, where steps of q‴ near such a point were a thousandth of jerk too many.
TEST(Degenerate, StepsOfACurveNearControlPointsThatCoincide) {
  const Outcome outcome =
      run("F1000\nG5.2 X0 Y-6 P2 L4\nX-0.007 Y9 P1\nX-0.007 Y9 P1\nX-0.007 Y9 P1\nX-5 Y3 P2\nX-2 Y-5 P1\nX-2 Y-5 P2\n"
          "X-2 Y-5 P2\nX-7 Y9 P0.5\nG5.3\nG1 X10 Y3\nM2\n",
          machine::mill3());
  EXPECT_TRUE(outcome.ended);
  EXPECT_LE(outcome.summary.plan.greatest(), 1.001);
  EXPECT_LE(outcome.verdict.end_error_mm, 1e-9);
  EXPECT_EQ(outcome.verdict.violation_count, 0);
}

}  // namespace test_degenerate
