// What the feed check counts of a curve between two words is no more than the words tell.

#include <gtest/gtest.h>

#include "curves.hpp"

namespace leadscrew::referee::test {
namespace test_curve_travel {

const base::Period period{8'500'000};
constexpr double feed = 1e-3;  // mm/s: 8.5 nm a word
const double step = feed * period.seconds();

gcode::ControlPoint at_xy(double x, double y) {
  return {{x, y}, 1};
}

Verdict judge_fed(const NurbsCurve& curve, const Words& words) {
  Program program;
  program.fed(feed);
  add_curve(program, curve);
  return judge(program.moves, words, machine::mill3(), period);
}

/// Along X to a tip and back to 0, each word `speed` steps behind the last, one of them `share` of a step past the tip.
Words there_and_back(double tip, double share, double speed) {
  Words words;
  const double begin = std::fmod(tip + share * step, speed * step);
  words.push_back({});
  for (double travel = begin; travel < 2 * tip; travel += speed * step) {
    words.push_back({travel <= tip ? travel : 2 * tip - travel});
  }
  words.push_back({});
  return words;
}

TEST(CurveTravel, ATipBetweenWordsIsNotCountedTwice) {
  // Both sides of the tip are one line, so that a word beside it may lie on either.
  const NurbsCurve to_and_fro = clamped(2, {at_xy(0, 0), at_xy(2e-4, 0), at_xy(0, 0)});
  for (int i = 0; i <= 200; ++i) {
    const Verdict verdict = judge_fed(to_and_fro, there_and_back(1e-4, i / 200.0, 1));
    EXPECT_FALSE(verdict.objects()) << i << ": " << describe(verdict);
    EXPECT_LE(verdict.feed_max_ratio, 1 + 1e-6) << i;
  }
}

TEST(CurveTravel, ATipBetweenWordsFarApartIsNotCountedTwice) {
  // So far apart that the bend of the tip is not lost in a nanometre: what counts is which place the words are at.
  const base::Period long_period{20'000'000};
  constexpr double tip = 0.4, fast = 2;  // mm, mm/s
  const double apart = fast * long_period.seconds();
  Program program;
  program.fed(fast);
  add_curve(program, clamped(2, {at_xy(0, 0), at_xy(2 * tip, 0), at_xy(0, 0)}));
  for (int i = 0; i <= 200; ++i) {
    Words words(3);
    for (double travel = std::fmod(tip + apart * i / 200, apart); travel < 2 * tip; travel += apart) {
      words.push_back({travel <= tip ? travel : 2 * tip - travel});
    }
    words.push_back({});
    const Verdict verdict = judge(program.moves, words, machine::mill3(), long_period);
    EXPECT_FALSE(has(verdict, "feed")) << i << ": " << describe(verdict);
    EXPECT_LE(verdict.feed_max_ratio, 1 + 1e-6) << i;
  }
}

TEST(CurveTravel, BothSidesOfANarrowTipAreSeenApart) {
  // A tip 0.2 nm wide; words on its way there, and back on a line between both sides.
  const double width = 2e-7;
  const NurbsCurve narrow = clamped(2, {at_xy(0, 0), at_xy(2e-4, width), at_xy(0, width)});
  for (int i = 0; i <= 200; ++i) {
    Words words = there_and_back(1e-4, i / 200.0, 1);
    for (AxisVector& word : words) at(word, Axis::Y) = width / 2;
    const Verdict verdict = judge_fed(narrow, words);
    EXPECT_FALSE(verdict.objects()) << i << ": " << describe(verdict);
  }
}

TEST(CurveTravel, ABendThatWordsCutWithinANanometreIsNotCounted) {
  // Waves as long as two words and a nanometre high; the motion goes straight through them.
  std::vector<gcode::ControlPoint> points;
  for (int i = 0; i <= 40; ++i) points.push_back(at_xy(i * step, i == 0 || i == 40 ? 0 : i % 2 == 0 ? -1e-6 : 1e-6));
  const NurbsCurve wave = clamped(2, points);
  for (int i = 0; i < 20; ++i) {
    Words words{{}};
    for (double travel = step * (i + 1) / 20; travel < 40 * step; travel += step) words.push_back({travel});
    words.push_back({40 * step});
    const Verdict verdict = judge_fed(wave, words);
    EXPECT_FALSE(has(verdict, "feed")) << i << ": " << describe(verdict);
  }
}

TEST(CurveTravel, APercentTooFastBesideATipIsSeen) {
  const NurbsCurve to_and_fro = clamped(2, {at_xy(0, 0), at_xy(2e-4, 0), at_xy(0, 0)});
  const Verdict verdict = judge_fed(to_and_fro, there_and_back(1e-4, 0.3, 1.01));
  EXPECT_TRUE(has(verdict, "feed", 1)) << describe(verdict);
  EXPECT_NEAR(verdict.feed_max_ratio, 1.01, 1e-6);
}

TEST(CurveTravel, APercentTooFastAroundABendIsSeen) {
  // A circle of eight words: their chords are 2.5 % short of it.
  constexpr double fast = 10;  // mm/s
  const double length = 8 * fast * period.seconds(), radius = length / (2 * std::numbers::pi);
  Program program;
  program.fed(fast);
  add_curve(program, circle_curve(0, 0, radius));
  for (const double ratio : {0.999, 1.01}) {
    Words words;
    for (int i = 0; i * ratio < 8; ++i) {
      const double angle = i * ratio * 2 * std::numbers::pi / 8;
      words.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    words.push_back({radius});
    const Verdict verdict = judge(program.moves, words, machine::mill3(), period);
    EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << describe(verdict);
    EXPECT_NEAR(verdict.feed_max_ratio, ratio, 1e-6);
  }
}

}  // namespace test_curve_travel
}  // namespace leadscrew::referee::test
