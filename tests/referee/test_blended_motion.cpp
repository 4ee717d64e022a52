// Motions within the tolerance of a program are found to be so; beyond it they are not.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_blended_motion {

const machine::Machine mill = machine::mill3();

/// One motion along straight lines through these points, rest to rest at each.
Words through(const std::vector<AxisVector>& points, base::Period period) {
  Program program;
  program.position = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) program.line(points[i]);
  return exact_motion(program, mill, period);
}

TEST(BlendedMotion, TurnsBackBeforeTheTip) {
  for (const std::int64_t nanoseconds : {100'000, 1'000'000, 20'000'000}) {
    const base::Period period{nanoseconds};
    Program program;
    program.blended(0.5);
    for (int i = 0; i < 5; ++i) program.line(10, 0).line(0, 0);
    for (const double short_of : {0.4, 0.499, 0.6}) {
      std::vector<AxisVector> points = {{0}};
      for (int i = 0; i < 5; ++i) {
        points.push_back({10 - short_of});
        points.push_back({i < 4 ? short_of : 0.0});
      }
      const Verdict verdict = judge(program.moves, through(points, period), mill, period);
      const double excuse = 1733 * period.seconds() * period.seconds() / 8;
      EXPECT_EQ(verdict.objects(), short_of > 0.5 + excuse) << describe(verdict);
      EXPECT_NEAR(verdict.deviation_mm, short_of, 0.005 + excuse) << describe(verdict);
      if (short_of < 0.5) {
        EXPECT_LE(verdict.deviation_mm, short_of + 1e-9);
      }
      EXPECT_DOUBLE_EQ(verdict.tolerance_mm, 0.5);
    }
  }
}

TEST(BlendedMotion, LeavesOutASpikeWithinTheTolerance) {
  const base::Period period{100'000};
  for (const double height : {0.003, 0.0099, 0.0101}) {
    Program program;
    program.blended(0.01).line(5, 0).line(5, height).line(5, 0).line(10, 0);
    const Verdict verdict = judge(program.moves, through({{0}, {10}}, period), mill, period);
    EXPECT_EQ(verdict.objects(), height > 0.01) << describe(verdict);
    EXPECT_NEAR(verdict.deviation_mm, height, 2e-5) << describe(verdict);
    EXPECT_EQ(has(verdict, "skipped path", 2), height > 0.01) << describe(verdict);
  }
}

TEST(BlendedMotion, CutsACornerByTheToleranceAndNoMore) {
  for (const std::int64_t nanoseconds : {100'000, 1'000'000}) {
    const base::Period period{nanoseconds};
    for (const double cut : {0.098, 0.102}) {
      // A straight bevel whose middle is `cut` from the corner.
      const double leg = cut * std::sqrt(2.0);
      Program program;
      program.blended(0.1).line(10, 0).line(10, 10);
      const Verdict verdict =
          judge(program.moves, through({{0}, {10 - leg}, {10, leg}, {10, 10}}, period), mill, period);
      EXPECT_EQ(verdict.objects(), cut > 0.1) << describe(verdict);
      EXPECT_NEAR(verdict.deviation_mm, cut, 1e-3);
    }
  }
}

RC_GTEST_PROP(BlendedMotion, StraightThroughNoiseOfAPolyline, (std::uint64_t seed)) {
  // Vertices within the tolerance of a straight line, some of them behind the vertex before.
  std::mt19937_64 random(seed);
  const double tolerance = *rc::gen::element(0.001, 0.02, 0.5);
  const double step = *rc::gen::element(0.0005, 0.01, 0.3);
  const base::Period period{*rc::gen::element<std::int64_t>(100'000, 1'000'000, 20'000'000)};
  std::uniform_real_distribution<double> noise(-0.7 * tolerance, 0.7 * tolerance);
  Program program;
  program.blended(tolerance);
  for (double x = step; x < 3; x += step) program.line(x + noise(random), noise(random));
  program.line(3, 0);
  const Verdict verdict = judge(program.moves, through({{0}, {3}}, period), mill, period);
  if (verdict.objects()) RC_FAIL(describe(verdict));
  RC_ASSERT(verdict.deviation_mm <= tolerance + 1e-6);
  RC_ASSERT(verdict.end_error_mm == 0);
}

TEST(BlendedMotion, TenThousandVerticesWithinAMicrometre) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> noise(-0.5e-3, 0.5e-3);
  Program program;
  program.blended(0.01).line(5, 0);
  for (int i = 0; i < 10'000; ++i) program.line(5 + noise(random), noise(random));
  program.line(10, 0);
  for (const std::int64_t nanoseconds : {100'000, 20'000'000}) {
    const base::Period period{nanoseconds};
    const Verdict verdict = judge(program.moves, through({{0}, {10}}, period), mill, period);
    EXPECT_FALSE(verdict.objects()) << describe(verdict);
    EXPECT_LE(verdict.deviation_mm, 0.0011);
  }
}

TEST(BlendedMotion, ATighterBlockInTheMiddleIsJudgedByItsOwnTolerance) {
  const base::Period period{1'000'000};
  Program program;
  program.blended(0.1).line(10, 0).blended(0.01).line(20, 0).blended(0.1).line(30, 0);
  Words words = through({{0}, {30}}, period);
  for (AxisVector& word : words) word[1] = 0.05 * law(word[0] / 3) * law((30 - word[0]) / 3);
  const Verdict wide = judge(program.moves, words, mill, period);
  EXPECT_TRUE(has(wide, "deviation", 2)) << describe(wide);
  EXPECT_FALSE(has(wide, "deviation", 1) || has(wide, "deviation", 3)) << describe(wide);
  for (AxisVector& word : words) {
    if (word[0] > 6 && word[0] < 24) word[1] = 0.05 - 0.045 * law((word[0] - 6) / 4) * law((24 - word[0]) / 4);
  }
  EXPECT_FALSE(has(judge(program.moves, words, mill, period), "deviation"));
}

TEST(BlendedMotion, ABlockKeepsItsOwnToleranceBesideAWiderOne) {
  // A bevel whose middle is `cut` from the corner; each block's end is visited as closely as its own tolerance asks.
  for (const std::int64_t nanoseconds : {100'000, 1'000'000, 10'000'000}) {
    const base::Period period{nanoseconds};
    for (const auto& [before, behind] : {std::pair{0.01, 0.5}, std::pair{0.5, 0.01}}) {
      for (const double cut : {0.009, 0.012, 0.1, 0.4}) {
        const double leg = cut * std::sqrt(2.0);
        Program program;
        program.blended(before).line(10, 0).blended(behind).line(10, 10);
        const Words words = through({{0}, {10 - leg}, {10, leg}, {10, 10}}, period);
        const Verdict verdict = judge(program.moves, words, mill, period);
        const double excuse = 1733 * period.seconds() * period.seconds() / 8;
        if (cut > 0.01 + excuse) {
          EXPECT_TRUE(has(verdict, "skipped path") || has(verdict, "deviation")) << describe(verdict);
        }
        if (cut < 0.01) {
          EXPECT_FALSE(verdict.objects()) << describe(verdict);
          EXPECT_NEAR(verdict.deviation_mm, cut, 0.0013 + excuse) << describe(verdict);
        }
      }
    }
  }
}

}  // namespace test_blended_motion
}  // namespace leadscrew::referee::test
