// The studies of closed loops: every figure that was published comes out as its row says.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/studies.hpp>
#include <set>

#include "found.hpp"

namespace {

using namespace leadscrew::study;
using leadscrew::study::testing::ours;

TEST(ClosedLoopStudy, ComesOut) {
  const Rows rows = closed_loop_rows({});
  EXPECT_EQ(rows.size(), 17u);
  for (const Row& row : rows) {
    const bool good = row.verdict == Verdict::reproduced || row.verdict == Verdict::exact ||
                      row.verdict == Verdict::kept || row.verdict == Verdict::measured;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
  }
}

/// 2.50, 50.00 pps, 1500 of 1500; 10 at a gain of 5.
TEST(ClosedLoopStudy, HasTheFiguresOfTheLecture) {
  const Rows rows = closed_loop_rows({});
  constexpr const char *fast = "pulse-driven axis, Kv 20 1/s, 3000 pulses/min, 1500 pulses",
                       *slow = "pulse-driven axis, Kv 5 1/s, 3000 pulses/min, 1500 pulses";
  EXPECT_NEAR(ours(rows, fast, "up-down counter"), 2.5, 0.005);
  EXPECT_NEAR(ours(rows, slow, "up-down counter"), 10, 0.005);
  EXPECT_EQ(ours(rows, fast, "pulses of the encoder"), 1500);
  EXPECT_NEAR(ours(rows, fast, "at rest after"), 30.13, 0.005);
  EXPECT_NEAR(ours(rows, slow, "at rest after"), 30.56, 0.005);
}

/// 3.0 s against 10.1 and 10.4 s, 3.5 times.
TEST(RealTimeStudy, ComesOut) {
  const Rows rows = real_time_rows({});
  EXPECT_EQ(rows.size(), 27u);
  int exact = 0;
  for (const Row& row : rows) {
    const bool good = row.verdict == Verdict::exact || row.verdict == Verdict::kept || row.verdict == Verdict::measured;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
    exact += row.verdict == Verdict::exact;
  }
  EXPECT_EQ(exact, 4);
}

/// Published as pictures without a plant: 3.1 v 43.5 % and 1.9 v 54.1 % are a reference calculation's, of two plants.
TEST(RealTimeStudy, MeasuresTheOvershootOfBothSetsOfGains) {
  const Rows rows = real_time_rows({});
  const auto overshoot = [&](const char* group) { return ours(rows, group, "curve: overshoot of the feed"); };
  EXPECT_NEAR(overshoot("gains (P, I, D) = (2, 2, 15), K 10.0, τ 20 ms"), 3.1, 0.05);
  EXPECT_NEAR(overshoot("gains (P, I, D) = (6, 50, 25), K 10.0, τ 20 ms"), 43.5, 0.05);
  EXPECT_NEAR(overshoot("gains (P, I, D) = (2, 2, 15), K 17.8, τ 50 ms"), 1.9, 0.05);
  EXPECT_NEAR(overshoot("gains (P, I, D) = (6, 50, 25), K 17.8, τ 50 ms"), 54.1, 0.05);
}

TEST(RealTimeStudy, NeverReachesTheFeedOnLines) {
  const Rows rows = real_time_rows({});
  constexpr const char* group = "times, 10 mm/s, T 10 ms";
  EXPECT_NEAR(ours(rows, group, "greatest feed along any line"), 6.7, 0.05);
  EXPECT_NEAR(ours(rows, group, "least of the greatest"), 4.8, 0.05);
  EXPECT_NEAR(ours(rows, group, "92 lines: reading and decoding one"), 3.26, 0.005);
}

/// Without a stop at each, lines take no longer than the curve; and a curve is a shorter program.
TEST(RealTimeStudy, TakesLinesAsFastAsTheCurve) {
  const Rows rows = real_time_rows({});
  constexpr const char* group = "this planner, 10 mm/s, a 1000 mm/s², j 20000 mm/s³";
  const double curve = ours(rows, group, "one block for the curve");
  EXPECT_NEAR(curve, 3.028, 0.001);
  EXPECT_NEAR(ours(rows, group, "92 lines within 10 µm"), curve, 0.002);
  EXPECT_GT(ours(rows, group, "92 lines, a stop at each"), 2 * curve);
  EXPECT_GT(ours(rows, "sizes of both programs", "92 lines"), 10 * ours(rows, "sizes of both programs", "curve"));
}

/// With the acceleration that the published time tells of, but for each axis: the diagonal has up to √2 times as much.
TEST(RealTimeStudy, StopsAtEachLineInNoMoreThanThePublishedTime) {
  const Rows rows = real_time_rows({});
  constexpr const char* group = "this planner, 10 mm/s, a 106.3 mm/s², j 1000000 mm/s³";
  const double stops = ours(rows, group, "92 lines, a stop at each");
  EXPECT_LT(stops, 10.1);
  EXPECT_GT(stops, 10.1 / std::sqrt(std::sqrt(2)));
  EXPECT_NEAR(ours(rows, group, "one block for the curve"), 3 + 10 / 106.3, 0.03);
}

/// Beyond 1.25 limits for no longer than 150 ms after the depth has doubled, without a limit cycle, from 50 to 200 %,
/// in less time than at the constant safe feed; with a sensor that fails, at the programmed feed times the safe factor.
TEST(AdaptiveStudy, ComesOut) {
  const Rows rows = adaptive_rows({});
  EXPECT_EQ(rows.size(), 46u);
  for (const Row& row : rows) {
    const bool good = row.verdict == Verdict::exact || row.verdict == Verdict::reproduced ||
                      row.verdict == Verdict::kept || row.verdict == Verdict::measured;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
  }
  for (const char* group : {"override of the planner, 10 mm/s", "override of the NC program, 10 mm/s"}) {
    EXPECT_NEAR(ours(rows, group, "override from 12 mm on, 4.00 mm deep"), 50, 1);
    EXPECT_NEAR(ours(rows, group, "override from 36 mm on, 1.25 mm deep"), 160, 3.2);
    EXPECT_EQ(ours(rows, group, "override from 64 mm on, 0.50 mm deep"), 200);
    const double excess = ours(rows, group, "force beyond 1.25 limits at a stretch");
    EXPECT_GT(excess, 0);  // the depth does double
    EXPECT_LE(excess, 150);
    EXPECT_LT(ours(rows, group, "swing of the override, noise 10 %"), 1.77);
    EXPECT_GT(ours(rows, group, "swing of the override, noise 10 %"), 0.5);  // there is noise
    EXPECT_LT(ours(rows, group, "swing of the override, no noise"), 0.1);
    EXPECT_GT(ours(rows, group, "time saved"), 45);
    EXPECT_GT(ours(rows, group, "greatest mean force over a turn"), 150);
  }
}

}  // namespace
