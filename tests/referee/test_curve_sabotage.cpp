// What leaves a NURBS curve, or follows it too fast, is found and measured.

#include <gtest/gtest.h>

#include "curve_verdicts.hpp"

namespace leadscrew::referee::test {
namespace test_curve_sabotage {

class CurveSabotage : public testing::TestWithParam<std::int64_t> {
 protected:
  base::Period period{GetParam()};

  Verdict judge_words(const Program& program, const Words& words) const {
    return judge(program.moves, words, mill, period);
  }
  Words motion(const Program& program) const { return exact_words(program, mill, period); }

  /// A wave, 100 mm long.
  static Program wave() {
    std::vector<gcode::ControlPoint> points;
    for (int i = 0; i <= 20; ++i) points.push_back(at_xy(5 * i, i % 2 == 0 ? 0 : 10, 1 + 0.2 * (i % 3)));
    Program program = program_of(clamped(3, points));
    program.line(120, 0);
    return program;
  }

  /// How far two curves of the same knots are apart at the same parameter, largest; an upper bound of their distance.
  static double apart(const NurbsCurve& a, const NurbsCurve& b) {
    double largest = 0;
    for (const std::size_t span : spans_of(a)) {
      for (int i = 0; i <= 1000; ++i) {
        const double u = a.knots[span] + (a.knots[span + 1] - a.knots[span]) * i / 1000;
        const AxisVector p = position_on(a, span, u), q = position_on(b, span, u);
        largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
    }
    return largest;
  }

  /// Distance of the points of b from a, largest, by brute force.
  static double departs(const NurbsCurve& a, const NurbsCurve& b) {
    std::vector<AxisVector> points;
    for (const std::size_t span : spans_of(a)) {
      for (int i = 0; i <= 2000; ++i) {
        points.push_back(position_on(a, span, a.knots[span] + (a.knots[span + 1] - a.knots[span]) * i / 2000));
      }
    }
    double largest = 0;
    for (const std::size_t span : spans_of(b)) {
      for (int i = 0; i <= 50; ++i) {
        const AxisVector q = position_on(b, span, b.knots[span] + (b.knots[span + 1] - b.knots[span]) * i / 50);
        double least = 1e9;
        for (const AxisVector& p : points) least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
        largest = std::max(largest, least);
      }
    }
    return largest;
  }
};

TEST_P(CurveSabotage, NoneNoObjection) {
  expect_sound(judge_words(wave(), motion(wave())));
}

TEST_P(CurveSabotage, OneWordOffByAMicrometre) {
  Words words = motion(wave());
  const std::size_t n = words.size() / 3;
  at(words[n], Axis::Z) += 1e-3;
  const Verdict verdict = judge_words(wave(), words);
  EXPECT_NEAR(verdict.deviation_mm, 1e-3, 1e-9) << describe(verdict);
  EXPECT_TRUE(has(verdict, "deviation", 1)) << describe(verdict);
  EXPECT_FALSE(has(verdict, "deviation", 2)) << describe(verdict);
}

TEST_P(CurveSabotage, EveryWordOffByTwoNanometresOrHalfOfOne) {
  for (const double off : {0.5e-6, 2e-6}) {
    Words words = motion(wave());
    for (AxisVector& word : words) at(word, Axis::Z) += off;
    const Verdict verdict = judge_words(wave(), words);
    EXPECT_EQ(has(verdict, "deviation", 1), off > 1e-6) << describe(verdict);
    EXPECT_NEAR(verdict.deviation_mm, off, 1e-9);
  }
}

TEST_P(CurveSabotage, OffAcrossTheCurveByAMicrometreOutwards) {
  const Program program = program_of(circle_curve(100, 100, 20));
  Words words = motion(program);
  for (AxisVector& word : words) {
    const double x = word[0] - 100, y = word[1] - 100, longer = 1 + 1e-3 / 20;
    word[0] = 100 + x * longer;
    word[1] = 100 + y * longer;
  }
  const Verdict verdict = judge_words(program, words);
  EXPECT_NEAR(verdict.deviation_mm, 1e-3, 1e-9) << describe(verdict);
  EXPECT_TRUE(has(verdict, "deviation", 1) && has(verdict, "start", 1)) << describe(verdict);
}

TEST_P(CurveSabotage, AWrongWeight) {
  Program program = wave();
  const Words words = motion(program);
  NurbsCurve& curve = program.moves[0].curve;
  const NurbsCurve moved = curve;
  curve.points[9].weight *= 1.05;
  const Verdict verdict = judge_words(program, words);
  EXPECT_TRUE(has(verdict, "deviation", 1)) << describe(verdict);
  EXPECT_NEAR(verdict.deviation_mm, departs(curve, moved), 0.01 * verdict.deviation_mm) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, apart(curve, moved));
}

TEST_P(CurveSabotage, ALoopLeftOut) {
  // By symmetry the loop crosses itself at x = 5, at u and at 1 − u.
  const NurbsCurve loop = clamped(3, {at_xy(0, 0), at_xy(30, 20), at_xy(-20, 20), at_xy(10, 0)});
  double low = 0, high = 0.4;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (position_on(loop, 3, middle)[0] < 5 ? low : high) = middle;
  }
  const AxisVector crossing = position_on(loop, 3, low);
  const Program program = program_of(loop);
  const std::vector<Leg> legs = {{[&](double share) { return position_on(loop, 3, low * share); }, 1},
                                 {[&](double share) { return position_on(loop, 3, 1 - low * (1 - share)); }, 1}};
  const Verdict verdict = judge_words(program, sample(legs, period));
  EXPECT_TRUE(has(verdict, "skipped path", 1)) << describe(verdict);
  EXPECT_FALSE(has(verdict, "end"));
  // The loop's farthest point from the crossing.
  double farthest = 0;
  for (int i = 0; i <= 10000; ++i) {
    const AxisVector point = position_on(loop, 3, low + (1 - 2 * low) * i / 10000.0L);
    farthest = std::max(farthest, std::hypot(point[0] - crossing[0], point[1] - crossing[1]));
  }
  EXPECT_GE(verdict.deviation_mm, 0.9 * farthest);
  EXPECT_LE(verdict.deviation_mm, 1.5 * farthest);
}

TEST_P(CurveSabotage, ACornerCut) {
  // Heavy in its middle, so that it almost reaches the corner; the motion follows the chord instead.
  const Program program = program_of(clamped(2, {at_xy(0, 0), at_xy(10, 10, 50), at_xy(20, 0)}));
  Program cut;
  cut.line(20, 0);
  const Verdict verdict = judge_words(program, motion(cut));
  EXPECT_TRUE(verdict.objects());
  EXPECT_NEAR(verdict.deviation_mm, 10 * 50.0 / 51, 0.05) << describe(verdict);
}

TEST_P(CurveSabotage, Backwards) {
  const Program program = program_of(clamped(3, {at_xy(0, 0), at_xy(10, 30), at_xy(30, -20), at_xy(40, 0)}));
  Words words = motion(program);
  std::reverse(words.begin(), words.end());
  const Verdict verdict = judge_words(program, words);
  EXPECT_TRUE(has(verdict, "start", 1) && has(verdict, "end", 1)) << describe(verdict);
  EXPECT_NEAR(verdict.end_error_mm, 40, 1e-9);
  EXPECT_GE(verdict.deviation_mm, 40 - 1e-9) << describe(verdict);
}

TEST_P(CurveSabotage, AClosedCurveBackwards) {
  Words words = motion(program_of(circle_curve(0, 0, 10)));
  const Verdict sound = judge_words(program_of(circle_curve(0, 0, 10)), words);
  EXPECT_FALSE(sound.objects()) << describe(sound);
  std::reverse(words.begin(), words.end());
  const Verdict verdict = judge_words(program_of(circle_curve(0, 0, 10)), words);
  EXPECT_TRUE(verdict.objects());
  EXPECT_GE(verdict.deviation_mm, 10) << describe(verdict);
}

TEST_P(CurveSabotage, StopsEarly) {
  const Program program = program_of(clamped(3, {at_xy(0, 0), at_xy(10, 30), at_xy(30, -20), at_xy(40, 0)}));
  Words words = motion(program);
  while (words.back()[0] > 38) words.pop_back();
  const Verdict verdict = judge_words(program, words);
  EXPECT_TRUE(has(verdict, "end", 1)) << describe(verdict);
  EXPECT_GE(verdict.deviation_mm, 2) << describe(verdict);
}

TEST_P(CurveSabotage, ABulgeJumpedOverIsJudgedAsTheArcIs) {
  // A quarter arc with both its ends on the line between two words; its middle is 0.29 mm away.
  const double half = std::sqrt(0.5);
  Program arc;
  arc.line(2 - half, 0).arc({2 + half}, gcode::Plane::XY, 2, -half, -1).line(4, 0);
  Program curve;
  curve.line(2 - half, 0);
  add_curve(curve, clamped(2, {at_xy(2 - half, 0), at_xy(2, half, half), at_xy(2 + half, 0)}));
  curve.line(4, 0);
  const Words words = {{0}, {1}, {3}, {4}};
  const Verdict by_arc = judge_words(arc, words), by_curve = judge_words(curve, words);
  const double unseen = std::min(1000.0, 20000 * period.seconds());
  const double excuse = std::hypot(1000, unseen, unseen) * period.seconds() * period.seconds() / 8;
  EXPECT_NEAR(by_curve.deviation_mm, 1 - half - excuse, 1e-8) << describe(by_curve);
  EXPECT_NEAR(by_curve.deviation_mm, by_arc.deviation_mm, 1e-6);
  EXPECT_TRUE(has(by_curve, "skipped path", 2)) << describe(by_curve);
}

TEST_P(CurveSabotage, TheChordsOfATooFastCircleAreShortOfIt) {
  // A circle at an acceleration ten times the limit: its sagitta is ten times what is excused.
  const double radius = 10, period_s = period.seconds(), turn = 100 * period_s;  // v²/r = r·(turn/T)² = 10⁵ mm/s²
  const Program program = program_of(circle_curve(0, 0, radius));
  Words words(3, {radius});
  for (int n = 1; n * turn < 2 * std::numbers::pi; ++n) {
    words.push_back({radius * std::cos(n * turn), radius * std::sin(n * turn)});
  }
  words.push_back({radius});
  const Verdict verdict = judge_words(program, words);
  Program arc;
  arc.position = {radius};
  arc.circle(0, 0, 1);
  const Verdict by_arc = judge_words(arc, words);
  EXPECT_NEAR(verdict.deviation_mm, by_arc.deviation_mm, 1e-8 + 1e-6 * by_arc.deviation_mm);
  if (turn < 1) {
    const double unseen = std::min(1000.0, 20000 * period_s);  // in Z
    const double sagitta = radius * (1 - std::cos(turn / 2));
    const double excuse = std::hypot(1000, 1000, unseen) * period_s * period_s / 8;
    EXPECT_GE(verdict.deviation_mm, sagitta - excuse - 1e-8) << describe(verdict);
    EXPECT_LE(verdict.deviation_mm, sagitta) << describe(verdict);
  }
  EXPECT_TRUE(has(verdict, "skipped path", 1)) << describe(verdict);
}

TEST_P(CurveSabotage, WordsOfACircleAreJudgedAlikeByArcAndByCurve) {
  Program arc, curve;
  arc.position = {125, 100};
  arc.fed(30).circle(100, 100, 1);
  curve.fed(30);
  add_curve(curve, circle_curve(100, 100, 25));
  const Words words = exact_motion(arc, mill, period);
  const Verdict by_arc = judge_words(arc, words), by_curve = judge_words(curve, words);
  expect_sound(by_arc);
  expect_sound(by_curve);
  EXPECT_NEAR(by_curve.feed_max_ratio, by_arc.feed_max_ratio, 1e-6);
}

TEST_P(CurveSabotage, ATightCircleHalfAPercentTooFast) {
  Program arc, curve;
  arc.position = {1};
  arc.fed(20).circle(0, 0, 1);  // at 20 ms chords are 0.7 % shorter than the arc
  curve.fed(20);
  add_curve(curve, circle_curve(0, 0, 1));
  for (const double ratio : {0.9995, 1.005}) {
    const std::vector<double> duration = {law_velocity * length_of(arc.moves[0]) / (ratio * 20)};
    const Words words = sample(arc.moves, duration, period);
    const Verdict verdict = judge_words(curve, words);
    EXPECT_NEAR(verdict.feed_max_ratio, judge_words(arc, words).feed_max_ratio, 1e-6);
    EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << describe(verdict);
  }
}

TEST_P(CurveSabotage, FeedAlongARandomCurve) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 random(seed);
    Program program;
    program.fed(1);
    add_curve(program, random_curve(random, 3, 5, 0.5, 0));
    for (const double ratio : {0.998, 1.01}) {
      const machine::Machine machine = five_axes();
      const Words words = sample(legs_of(program.moves, machine, ratio), period);
      const Verdict verdict = judge(program.moves, words, machine, period);
      EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << seed << ": " << describe(verdict);
      EXPECT_LE(verdict.feed_max_ratio, ratio + 1e-3);
    }
  }
}

TEST_P(CurveSabotage, InverseTimeTellsTheWholeLength) {
  const NurbsCurve curve = circle_curve(50, 0, 10);
  Program program;
  program.feed = {gcode::Feed::Mode::per_second, 0.25};  // 20π mm in 4 s
  add_curve(program, curve);
  Program arc;
  arc.position = {60};
  arc.feed = program.feed;
  arc.circle(50, 0, 1);
  for (const double ratio : {0.995, 1.005}) {
    const Words words = sample(arc.moves, {law_velocity * 4 / ratio}, period);
    const Verdict verdict = judge_words(program, words);
    EXPECT_NEAR(verdict.feed_programmed_max, 5 * std::numbers::pi, 1e-6);
    EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << describe(verdict);
  }
}

TEST_P(CurveSabotage, FeedOfACurveOfRotaryAxesIsInDegrees) {
  const machine::Machine five = five_axes();
  Program program;
  program.feed = {gcode::Feed::Mode::per_second, 0.1};  // 90 degrees in 10 s
  gcode::ControlPoint begin, middle, end;
  at(middle.position, Axis::C) = 45;
  at(end.position, Axis::C) = 90;
  add_curve(program, clamped(2, {begin, middle, end}));
  for (const double ratio : {0.995, 1.005}) {
    const Move& move = program.moves[0];
    const std::vector<Leg> leg = {
        {[&](double share) { return position_on(move.curve, 2, share); }, law_velocity * 10 / ratio}};
    const Verdict verdict = judge(program.moves, sample(leg, period), five, period);
    EXPECT_NEAR(verdict.feed_programmed_max, 9, 1e-9);
    EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << describe(verdict);
    EXPECT_NEAR(verdict.feed_max_ratio, ratio, 1e-4);
  }
}

TEST_P(CurveSabotage, BlendedWithinTheToleranceAndNoMore) {
  // The straight line through a wave of 20 µm.
  std::vector<gcode::ControlPoint> points;
  for (int i = 0; i <= 40; ++i) points.push_back(at_xy(0.5 * i, i == 0 || i == 40 ? 0 : i % 2 == 0 ? -0.03 : 0.03));
  for (const double tolerance : {0.005, 0.04}) {
    Program program;
    program.blended(tolerance);
    add_curve(program, clamped(2, points));
    Program line;
    line.line(20, 0);
    const Verdict verdict = judge_words(program, motion(line));
    EXPECT_EQ(verdict.objects(), tolerance < 0.01) << describe(verdict);
    EXPECT_NEAR(verdict.deviation_mm, 0.015, 0.008) << describe(verdict);
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, CurveSabotage, testing::Values(100'000, 1'000'000, 20'000'000),
                         [](const auto& one) { return std::to_string(one.param / 1000) + "us"; });

}  // namespace test_curve_sabotage
}  // namespace leadscrew::referee::test
