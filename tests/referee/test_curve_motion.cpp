// Motions that are exactly on a NURBS curve are found to be so.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "curve_verdicts.hpp"

namespace leadscrew::referee::test {
namespace test_curve_motion {

Verdict judge_exact(const Program& program, base::Period period) {
  return judge(program.moves, exact_words(program, mill, period), mill, period);
}

constexpr std::int64_t periods[] = {100'000, 1'000'000, 3'000'000, 20'000'000};

RC_GTEST_PROP(CurveMotion, DeviatesByRoundingOnly, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const base::Period period{*rc::gen::element<std::int64_t>(250'000, 1'000'000, 3'000'000, 20'000'000)};
  const double size = *rc::gen::element(0.05, 2.0, 40.0);
  const double offset = *rc::gen::element(0.0, 100.0, -990.0);
  const int degree = *rc::gen::inRange(1, 6);
  const machine::Machine machine = five_axes();
  Program program;
  for (int i = *rc::gen::inRange(1, 3); i > 0; --i) {
    const NurbsCurve curve = random_curve(random, degree, *rc::gen::inRange(degree + 1, degree + 9), size, offset);
    const std::size_t first = spans_of(curve).front();
    program.line(position_on(curve, first, curve.knots[first]));
    add_curve(program, curve);
  }
  program.moves.front().start = program.moves.front().end;
  const Verdict verdict = judge(program.moves, exact_words(program, machine, period), machine, period);
  if (verdict.objects() || verdict.deviation_mm > rounding) RC_FAIL(describe(verdict));
  RC_ASSERT(verdict.end_error_mm <= 1e-9);
  RC_ASSERT(verdict.start_error_mm <= 1e-9);
}

TEST(CurveMotion, ShapesThatStandStillTurnBackOrCrossThemselves) {
  const std::vector<NurbsCurve> shapes = {
      clamped(3, {at_xy(0, 0), at_xy(10, 10), at_xy(0, 10), at_xy(10, 0)}),     // a cusp
      clamped(3, {at_xy(0, 0), at_xy(10, 9.999), at_xy(0, 10), at_xy(10, 0)}),  // nearly one
      clamped(3, {at_xy(0, 0), at_xy(30, 20), at_xy(-20, 20), at_xy(10, 0)}),   // a loop
      clamped(2, {at_xy(0, 0), at_xy(10, 0), at_xy(0, 0)}),                     // there and back
      clamped(5, {at_xy(0, 0), at_xy(40, 0), at_xy(-30, 0), at_xy(40, 0), at_xy(-30, 0), at_xy(10, 0)}),
      clamped(3, {at_xy(0, 0), at_xy(0, 0), at_xy(10, 0), at_xy(10, 0)}),  // straight
      clamped(3, {at_xy(0, 0), at_xy(0, 0), at_xy(0, 0), at_xy(7, 3), at_xy(7, 3), at_xy(7, 3)}),
      clamped(2, {at_xy(0, 0), at_xy(5, 5), at_xy(5, 5), at_xy(5, 5), at_xy(9, 0)}),  // stands at a corner
      clamped(1, {at_xy(0, 0), at_xy(5, 5), at_xy(5, 5), at_xy(0, 0), at_xy(5, 5), at_xy(9, 0)}),
      clamped(3, {at_xy(0, 0), at_xy(20, 20), at_xy(20, -20), at_xy(0, 0), at_xy(-20, 20), at_xy(-20, -20),
                  at_xy(0, 0)}),                                     // a butterfly
      clamped(2, {at_xy(0, 0), at_xy(10, 10, 200), at_xy(20, 0)}),   // nearly its corner
      clamped(2, {at_xy(0, 0), at_xy(10, 10, 5e-3), at_xy(20, 0)}),  // nearly its chord
      clamped(3, {at_xy(0, 0, 1e-3), at_xy(10, 10, 1e3), at_xy(0, 10, 1e-3), at_xy(10, 0, 1)}),
      circle_curve(100, 100, 25),
      circle_curve(100, 100, 1e-4),
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const std::int64_t nanoseconds : periods) {
      SCOPED_TRACE("shape " + std::to_string(i) + ", " + std::to_string(nanoseconds) + " ns");
      Program program = program_of(shapes[i]);
      expect_sound(judge_exact(program, base::Period{nanoseconds}));
    }
  }
}

TEST(CurveMotion, TheSameCurveAgainAndAgainAndBackwards) {
  NurbsCurve there = clamped(3, {at_xy(0, 0), at_xy(30, 20), at_xy(-20, 20), at_xy(10, 0), at_xy(0, 0)});
  NurbsCurve back = there;
  std::reverse(back.points.begin(), back.points.end());
  Program program;
  for (int i = 0; i < 5; ++i) {
    add_curve(program, there);
    if (i % 2 == 0) add_curve(program, back);
  }
  for (const std::int64_t nanoseconds : periods) expect_sound(judge_exact(program, base::Period{nanoseconds}));
}

RC_GTEST_PROP(CurveMotion, ExtremeWeightsCostNoAccuracy, (std::uint64_t seed)) {
  // Words anywhere along the curve, on a machine without limits: only their own distance counts.
  std::mt19937_64 random(seed);
  machine::Machine machine = five_axes();
  for (auto& axis : machine.axes) {
    if (axis) axis->velocity = axis->acceleration = axis->jerk = 1e30;
  }
  const int degree = *rc::gen::inRange(1, 6);
  NurbsCurve curve = random_curve(random, degree, *rc::gen::inRange(degree + 1, degree + 5), 20, 100);
  const double decades = *rc::gen::element(1.0, 4.0, 9.0);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  for (gcode::ControlPoint& point : curve.points) point.weight = std::pow(10, exponent(random));
  Words words;
  for (const std::size_t span : spans_of(curve)) {
    const double from = curve.knots[span], to = curve.knots[span + 1];
    for (int i = 0; i <= 200; ++i) words.push_back(position_on(curve, span, from + (to - from) * (i / 200.0)));
  }
  const Verdict verdict = judge(program_of(curve).moves, words, machine, base::Period{1'000'000});
  if (verdict.objects() || verdict.deviation_mm > rounding) RC_FAIL(describe(verdict));
}

TEST(CurveMotion, FourThousandControlPoints) {
  std::vector<gcode::ControlPoint> points;
  for (int i = 0; i < 4096; ++i) points.push_back(at_xy(100 + 0.01 * i, 100 + std::sin(0.05 * i), 1 + (i % 3)));
  const Program program = program_of(clamped(3, points));
  const NurbsCurve& curve = program.moves[0].curve;
  std::vector<Leg> legs;
  for (const std::size_t span : spans_of(curve)) {
    const double from = curve.knots[span];
    legs.push_back({[&curve, span, from](double share) { return position_on(curve, span, from + share); }, 0.1});
  }
  expect_sound(judge(program.moves, sample(legs, base::Period{3'000'000}), mill, base::Period{3'000'000}));
}

TEST(CurveMotion, ACurveThatDoesNotMoveIsPassedOver) {
  const AxisVector here{3, 4, 5};
  Program program = program_of(clamped(2, {{here}, {here, 2}, {here}}));
  program.line({10, 4, 5});
  expect_sound(judge_exact(program, base::Period{1'000'000}));
}

TEST(CurveMotion, WhatIsNoCurveIsALine) {
  NurbsCurve wrong = clamped(2, {at_xy(0, 0), at_xy(5, 5), at_xy(10, 0)});
  Program program = program_of(wrong);
  program.moves[0].curve.points.pop_back();
  Program line;
  line.line(10, 0);
  const base::Period period{1'000'000};
  expect_sound(judge(program.moves, exact_words(line, mill, period), mill, period));
}

}  // namespace test_curve_motion
}  // namespace leadscrew::referee::test
