// The studies of closed loops: every figure comes out as its row says.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/studies.hpp>
#include <set>
#include <string>

#include "found.hpp"

namespace test_servo_studies {

using namespace leadscrew::study;
using leadscrew::study::testing::found;
using leadscrew::study::testing::ours;
using leadscrew::study::testing::published;

TEST(ClosedLoopStudy, ComesOut) {
  const Rows rows = closed_loop_rows({});
  EXPECT_EQ(rows.size(), 22u);
  for (const Row& row : rows) {
    const bool good = row.verdict == Verdict::reproduced || row.verdict == Verdict::exact ||
                      row.verdict == Verdict::kept || row.verdict == Verdict::measured;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
  }
}

/// 2.50, 50.00 pps, 1500 of 1500; 10 at a gain of 5: of the lecture are 3000 pulses a minute and 1500 pulses.
TEST(ClosedLoopStudy, HasTheFiguresOfTheLecture) {
  const Rows rows = closed_loop_rows({});
  constexpr const char *fast = "pulse-driven axis, Kv 20 1/s, 3000 pulses/min, 1500 pulses",
                       *slow = "pulse-driven axis, Kv 5 1/s, 3000 pulses/min, 1500 pulses";
  EXPECT_NEAR(ours(rows, fast, "up-down counter"), 2.5, 0.005);
  EXPECT_NEAR(ours(rows, slow, "up-down counter"), 10, 0.005);
  EXPECT_EQ(ours(rows, fast, "pulses of the encoder"), 1500);
  EXPECT_EQ(published(found(rows, fast, "pulses of the encoder")), 1500);
  EXPECT_EQ(published(found(rows, fast, "rate of the encoder")), 50);
  EXPECT_EQ(published(found(rows, fast, "up-down counter")), std::nullopt);
  EXPECT_NEAR(ours(rows, fast, "at rest after"), 30.13, 0.005);
  EXPECT_NEAR(ours(rows, slow, "at rest after"), 30.56, 0.005);
}

/// The slides' contours, µm, and the figures that a wrong formula or gain would have them at: the difference is many
/// times the 0.2 µm that counts of 0.1 µm are good for.
TEST(ClosedLoopStudy, TellsContoursFromThoseOfWrongFormulas) {
  constexpr const char* group = "contours of two pulse-driven axes, 20 mm/s, BLU 0.1 µm, beside their closed forms";
  constexpr double accuracy = 0.2, radius = 10'000, frequency = 2;
  const Rows rows = closed_loop_rows({});
  const auto is_near = [&](const std::string& what, double figure) {
    const Row row = found(rows, group, what);
    EXPECT_EQ(row.verdict, Verdict::reproduced) << what;
    return std::abs(row.ours.value_or(NAN) - figure) <= accuracy;
  };
  const std::string line = "line at 30°, Kv 20 and 25 1/s, τ 20 ms: distance from it";
  const auto line_error = [&](double sine, double x, double y) { return 10'000 * sine * (1 / x - 1 / y); };
  EXPECT_TRUE(is_near(line, line_error(std::sqrt(0.75), 20, 25)));
  EXPECT_FALSE(is_near(line, line_error(std::sqrt(0.75), 25, 20)));    // the gains swapped
  EXPECT_FALSE(is_near(line, line_error(0.5, 20, 25)));                // sin α
  EXPECT_FALSE(is_near(line, line_error(std::sqrt(0.75), 20.1, 25)));  // a gain off by 0.5 %

  const auto circle_error = [&](double kv, double lag) {
    return radius * (1 / std::hypot(1 - lag * frequency * frequency / kv, frequency / kv) - 1);
  };
  const double textbook = -radius * frequency * frequency / (2 * 20 * 20);
  for (const double lag : {0.02, 0.001}) {
    const std::string circle =
        lag == 0.02 ? "circle of 10 mm, Kv 20 and 20 1/s, τ 20 ms: " : "circle of 10 mm, Kv 20 and 20 1/s, τ 1 ms: ";
    for (const char* axis : {"greater semi-axis", "lesser semi-axis"}) {
      EXPECT_TRUE(is_near(circle + axis, circle_error(20, lag)));
      EXPECT_FALSE(is_near(circle + axis, textbook));
      EXPECT_FALSE(is_near(circle + axis, circle_error(20.4, lag)));
    }
  }
  EXPECT_NEAR(ours(rows, group, "circle of 10 mm, Kv 20 and 20 1/s, τ 20 ms: share of the textbook's R·ω²/(2Kv²)"), 0.2,
              0.016);
  EXPECT_NEAR(ours(rows, group, "circle of 10 mm, Kv 20 and 20 1/s, τ 1 ms: share of the textbook's R·ω²/(2Kv²)"), 0.96,
              0.015);

  const std::string ellipse = "circle of 10 mm, Kv 20 and 25 1/s, τ 20 ms: ";
  EXPECT_FALSE(is_near(ellipse + "greater semi-axis", circle_error(20, 0.02)));
  EXPECT_FALSE(is_near(ellipse + "greater semi-axis", line_error(1, 20, 25)));  // by the line's formula alone
  EXPECT_NEAR(ours(rows, group, ellipse + "half the difference of its semi-axes"), line_error(1, 20, 25), 1.1);
}

/// 3.0 s; 10.1 and 10.4 s, 3.5 times, by an acceleration that was solved from them.
TEST(RealTimeStudy, ComesOut) {
  const Rows rows = real_time_rows({});
  EXPECT_EQ(rows.size(), 28u);
  int exact = 0, fitted = 0;
  for (const Row& row : rows) {
    const bool good = row.verdict == Verdict::exact || row.verdict == Verdict::fitted || row.verdict == Verdict::kept ||
                      row.verdict == Verdict::measured || row.verdict == Verdict::not_reproducible;
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
    exact += row.verdict == Verdict::exact;
    fitted += row.verdict == Verdict::fitted;
  }
  EXPECT_EQ(exact, 1);
  EXPECT_EQ(fitted, 3);
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

}  // namespace test_servo_studies
