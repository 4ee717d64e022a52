// Velocity, acceleration and jerk agree with those of motions whose derivatives are known.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/referee/derivative_check.hpp>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_derivative_check {

/// One axis to and fro: amplitude·sin, faded in and out by rest-to-rest polynomials a second long.
Words oscillation(Axis axis, double amplitude, double frequency, base::Period period, double offset = 0) {
  Words words;
  const double T = period.seconds();
  for (std::int64_t n = 0; static_cast<double>(n) * T <= 4; ++n) {
    const double t = static_cast<double>(n) * T;
    AxisVector word{};
    at(word, axis) = offset + amplitude * law(t) * law(4 - t) * std::sin(2 * std::numbers::pi * frequency * t);
    words.push_back(word);
  }
  return words;
}

const AxisVerdict& verdict_of(const Verdict& verdict, Axis axis) {
  return *std::find_if(verdict.axes.begin(), verdict.axes.end(),
                       [&](const AxisVerdict& one) { return one.axis == axis; });
}

RC_GTEST_PROP(DerivativeCheck, AgreeWithASinusoid, ()) {
  const double frequency = *rc::gen::element(9.0, 17.0, 31.0);
  const base::Period period{*rc::gen::element<std::int64_t>(100'000, 250'000, 1'000'000, 2'000'000)};
  const Axis axis = *rc::gen::element(Axis::X, Axis::Y, Axis::Z, Axis::C);
  const double amplitude = *rc::gen::element(0.1, 1.0, 12.0);
  machine::Machine machine = five_axes();
  const Verdict verdict = judge({}, oscillation(axis, amplitude, frequency, period), machine, period);
  RC_ASSERT(verdict.axes.size() == std::size_t{5});
  const double omega = 2 * std::numbers::pi * frequency;
  const machine::AxisLimits& limits = machine.limits(axis);
  // The fading adds less than 0.3 % at these frequencies. A k-th difference averages the derivative over k periods:
  // sinc(ωT/2)ᵏ of it for a sinusoid. Samples miss the peak by half a period at most.
  const double half = omega * period.seconds() / 2;
  const double sinc = std::sin(half) / half;
  const double expected[] = {amplitude * omega * sinc / limits.velocity,
                             amplitude * omega * omega * sinc * sinc / limits.acceleration,
                             amplitude * omega * omega * omega * sinc * sinc * sinc / limits.jerk};
  const AxisVerdict& found = verdict_of(verdict, axis);
  const double ratios[] = {found.velocity_ratio, found.acceleration_ratio, found.jerk_ratio};
  for (int k = 0; k < 3; ++k) {
    RC_ASSERT(ratios[k] <= expected[k] * 1.003);
    RC_ASSERT(ratios[k] >= expected[k] * (std::cos(half) - 1e-6) - 1e-9 / std::pow(period.seconds(), k + 1) / 1e3);
  }
  for (const AxisVerdict& other : verdict.axes) {
    if (other.axis != axis)
      RC_ASSERT(other.velocity_ratio == 0 && other.acceleration_ratio == 0 && other.jerk_ratio == 0);
  }
}

TEST(DerivativeCheck, RoundingIsForgivenAtTheShortestPeriod) {
  const machine::Machine machine = five_axes();
  const base::Period period{10'000};
  Words words;
  for (int n = 0; n < 200'000; ++n) {
    AxisVector word{};
    at(word, Axis::X) =
        800 + 5 * law(n / 2e5);  // third differences of rounding alone: 2e-13/1e-15 = 227 mm/s³ and more
    words.push_back(word);
  }
  const Verdict verdict = judge({}, words, machine, period);
  EXPECT_LT(verdict_of(verdict, Axis::X).jerk_ratio, 0.01);
  EXPECT_LT(verdict_of(verdict, Axis::X).acceleration_ratio, 0.02);
}

TEST(DerivativeCheck, TheRoundingBoundIsEightUnitsInTheLastPlace) {
  EXPECT_EQ(rounding_of(1), 8 * std::ldexp(1, -52));
  EXPECT_EQ(rounding_of(1000), 8 * std::ldexp(1, -43));
}

TEST(DerivativeCheck, MoreJerkThanRoundingExplainsIsSeenFarFromZeroAtTheShortestPeriod) {
  // At 800 mm and 10 µs a third difference that rounding explains is 909 mm/s³; here are 10 000 beyond the limit.
  const machine::Machine machine = five_axes();
  const base::Period period{10'000};
  const double T = period.seconds();
  for (const double jerk : {19'000., 30'000.}) {
    Words words(10, {800});
    double q = 800, v = 0, a = 0;
    for (int n = 0; n < 400; ++n) {
      a += (n < 100 || n >= 300 ? jerk : -jerk) * T;
      v += a * T;
      q += v * T;
      words.push_back({q});
    }
    words.insert(words.end(), 10, {q});
    const Verdict verdict = judge({}, words, machine, period);
    EXPECT_EQ(has(verdict, "X jerk"), jerk > 20'000) << describe(verdict);
    EXPECT_NEAR(verdict_of(verdict, Axis::X).jerk_ratio, jerk / 20'000, 0.1);
  }
}

TEST(DerivativeCheck, StartingAtFullSpeedIsAJump) {
  const machine::Machine machine = machine::mill3();
  const base::Period period{1'000'000};
  Words words;
  for (int n = 0; n <= 1000; ++n) {
    AxisVector word{};
    at(word, Axis::Y) = 0.05 * n;  // 50 mm/s from the first word to the last
    words.push_back(word);
  }
  const Verdict verdict = judge(Program().line(0, 50).moves, words, machine, period);
  EXPECT_TRUE(has(verdict, "Y acceleration", 1)) << describe(verdict);
  EXPECT_TRUE(has(verdict, "Y jerk", 1));
  EXPECT_FALSE(has(verdict, "Y velocity"));
  EXPECT_NEAR(verdict_of(verdict, Axis::Y).velocity_ratio, 0.25, 1e-9);
  EXPECT_NEAR(verdict_of(verdict, Axis::Y).acceleration_ratio, 50, 1e-6);  // 50 mm/s in 1 ms, of 1000 mm/s²
  // Both ends: at the start one acceleration and two jerks, the same at the end.
  EXPECT_EQ(verdict.violation_count, 6) << describe(verdict);
}

TEST(DerivativeCheck, AHalfPercentOfJerkOnOneAxisIsSeen) {
  machine::Machine machine = machine::mill3();
  const base::Period period{1'000'000};
  Program program;
  program.line(20, 12);
  const double duration = 1.0;
  const Words words = sample(program.moves, {duration}, period, 0);
  // Limits put just above and just below the largest jerk, which for this law is at both ends of the motion and its
  // middle.
  const Verdict loose = judge(program.moves, words, machine, period);
  const double jerk = verdict_of(loose, Axis::X).jerk_ratio * machine.limits(Axis::X).jerk;
  EXPECT_NEAR(jerk, law_jerk * 20, 0.01 * jerk);
  machine.axes[base::index(Axis::X)]->jerk = jerk / 1.0005;
  EXPECT_FALSE(judge(program.moves, words, machine, period).objects());
  machine.axes[base::index(Axis::X)]->jerk = jerk / 1.005;
  const Verdict strict = judge(program.moves, words, machine, period);
  EXPECT_TRUE(has(strict, "X jerk", 1) && has_only(strict, "X jerk")) << describe(strict);
  double greatest = 0;
  for (const Violation& violation : strict.violations) greatest = std::max(greatest, violation.value);
  EXPECT_NEAR(greatest, jerk, 1e-6 * jerk);
  EXPECT_EQ(strict.violation_count, static_cast<std::int64_t>(strict.violations.size()));
}

TEST(DerivativeCheck, NoViolationThatTheRatioDenies) {
  // Near 0 a difference exceeds the limit by less than the rounding bound of the positions reached later.
  machine::Machine machine = machine::mill3();
  machine.axes[0]->jerk = 1000;
  const base::Period period{10'000};
  for (const double farthest : {0.001, 400.0}) {
    Words words(10);
    const double T = period.seconds();
    double q = 0, v = 0, a = 0;
    for (int n = 0; n < 60; ++n) {  // jerk of 1100 mm/s³, forth and back
      const double jerk = n < 15 || n >= 45 ? 1100 : -1100;
      a += jerk * T;
      v += a * T;
      q += v * T;
      words.push_back({q});
    }
    const double rest = q;
    for (int n = 0; n < 10; ++n) words.push_back({rest});
    for (int n = 1; n <= 200'000; ++n) words.push_back({rest + (farthest - rest) * law(n / 2e5) * 1e-3});
    if (farthest > 1) words.push_back({farthest});
    const Verdict verdict = judge({}, words, machine, period);
    std::int64_t listed = 0;
    for (const Violation& violation : verdict.violations) listed += violation.what == "X jerk" && violation.t < 0.001;
    EXPECT_EQ(listed > 0, farthest < 1) << describe(verdict);
  }
}

TEST(DerivativeCheck, WhatIsNoNumberIsAnObjection) {
  const base::Period period{1'000'000};
  Words words(5);
  at(words[2], Axis::Z) = std::nan("");
  EXPECT_TRUE(has_only(judge({}, words, machine::mill3(), period), "not a number"));
}

}  // namespace test_derivative_check
}  // namespace leadscrew::referee::test
