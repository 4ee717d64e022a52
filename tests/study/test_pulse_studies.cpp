// Koren's tables and the comparison of circular interpolators, by the rows of the studies.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/study/chopped.hpp>
#include <leadscrew/study/studies.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_pulse_studies {

TEST(Chopped, CutsTowardsZero) {
  constexpr double unit = 1.0 / (1 << 26);
  EXPECT_EQ(Chopped(1 + unit).value(), 1 + unit);
  EXPECT_EQ(Chopped(1 + 1.99 * unit).value(), 1 + unit);
  EXPECT_EQ(Chopped(-1 - 1.99 * unit).value(), -1 - unit);
  // (1 + u)(1 − u) = 1 − u²: just below 1, although double rounds it to 1.
  EXPECT_EQ((Chopped(1 + unit) * Chopped(1 - unit / 2)).value(), 1 + unit / 2 - unit / 2);
  EXPECT_LT((Chopped(1) - Chopped(1e-30)).value(), 1);
  EXPECT_EQ((Chopped(1) + Chopped(1e-30)).value(), 1);
}

const char* digits_of(std::size_t column) {
  constexpr std::array<const char*, 6> names = {"T = 1",     "T = 0.1",    "T = 0.01",
                                                "T = 0.001", "T = 0.0001", "T = 0.00001"};
  return names[column];
}

/// Every figure but the two that the paper has otherwise.
TEST(KorenTable1, ComesOutInChoppedNumbers) {
  const Rows rows = table_1_rows({});
  ASSERT_EQ(rows.size(), 26u);
  int exact = 0, reproduced = 0;
  for (const Row& row : rows) {
    exact += row.verdict == Verdict::exact;
    reproduced += row.verdict == Verdict::reproduced;
  }
  EXPECT_EQ(exact, 19);
  EXPECT_EQ(reproduced, 1);
  EXPECT_EQ(ours(rows, "Euler", digits_of(2)), 10160);
  EXPECT_EQ(ours(rows, "Tustin", digits_of(0)), 9460);
  EXPECT_NEAR(ours(rows, "Runge-Kutta", digits_of(0)), 9795.53, 0.005);
  EXPECT_EQ(ours(rows, "state transition", digits_of(5)), 9945);
  EXPECT_EQ(verdict(rows, "Tustin", digits_of(1)), "differs");
  EXPECT_EQ(verdict(rows, "state transition", digits_of(3)), "differs");
}

/// A column of the table, from T = 1 to T = 1e-5: what is printed, and ours before it is rounded to four digits.
struct Cell {
  double published, ours;
};

void expect_column(const char* method, const std::vector<std::optional<Cell>>& cells, double accuracy) {
  const Rows rows = table_1_rows({});
  for (std::size_t column = 0; column < cells.size(); ++column) {
    if (!cells[column]) continue;
    const Row row = found(rows, method, digits_of(column));
    EXPECT_EQ(published(row), cells[column]->published) << method << column;
    EXPECT_NEAR(row.ours.value_or(NAN), cells[column]->published, accuracy) << method << column;
    EXPECT_NEAR(std::stod(row.why), cells[column]->ours, 0.25) << row.why;
  }
}

TEST(KorenTable1, EulerColumn) {
  expect_column("Euler",
                {{}, {}, Cell{10160, 10158.21}, Cell{10020, 10015.53}, Cell{10000, 9999.72}, Cell{9982, 9981.66}}, 0);
}

/// 9795 is the sum of printed figures: 9.695 + 10 − 9.900.
TEST(KorenTable1, RungeKuttaColumn) {
  expect_column("Runge-Kutta",
                {Cell{9795, 9795.53}, Cell{10000, 10000}, Cell{10000, 9999.98}, Cell{10000, 9999.81},
                 Cell{9998, 9998.15}, Cell{9982, 9981.51}},
                0.6);
}

/// All but that of T = 0.001, which is one off in the last digit.
TEST(KorenTable1, StateTransitionColumn) {
  expect_column(
      "state transition",
      {Cell{10000, 10000}, Cell{10000, 10000}, Cell{10000, 9999.96}, {}, Cell{9996, 9996.02}, Cell{9945, 9944.75}}, 0);
}

/// All but that of T = 0.1, a misprint or read at nT = 3.0.
TEST(KorenTable1, TustinColumn) {
  expect_column(
      "Tustin",
      {Cell{9460, 9460.07}, {}, Cell{10000, 9999.98}, Cell{10000, 9999.85}, Cell{9997, 9997.09}, Cell{9963, 9963.12}},
      0);
}

TEST(KorenTable1, LeavesEulers20100And11661Blank) {
  const Rows rows = table_1_rows({});
  EXPECT_NEAR(ours(rows, "Euler", digits_of(0)), 20100, 50);
  EXPECT_NEAR(ours(rows, "Euler", digits_of(1)), 11661, 0.5);
}

/// It says "radius"; of Tustin's method that is R whatever the step.
TEST(KorenTable1, IsNotOfRadiiWhichWouldBe10000And9818) {
  const Rows rows = table_1_rows({});
  EXPECT_NEAR(ours(rows, "the radius itself", "Tustin, T = 1"), 10000, 0.01);
  EXPECT_NEAR(ours(rows, "the radius itself", "Runge-Kutta, T = 1"), 9818, 0.5);
}

TEST(KorenOrders, AreTwoFourAndSixAStep) {
  const Rows rows = orders_rows({});
  for (const char* method : {"Euler", "Heun, eq. 23", "Runge-Kutta"}) {
    EXPECT_EQ(verdict(rows, method, "exponent of T, each step"), "exact") << method;
    EXPECT_EQ(verdict(rows, method, "exponent of T, half a turn"), "exact") << method;
  }
  EXPECT_EQ(verdict(rows, "the proposed method, eq. 27", "exponent of T, greatest of a turn"), "differs");
  EXPECT_NEAR(ours(rows, "the proposed method, eq. 27", "exponent of T, greatest of a turn"), 1, 0.01);
}

/// Told to be of Heun's order, T⁴; but A² + B² = 1, and the place has T³ as Heun's has.
TEST(KorenOrders, TustinErrsInAngleAlone) {
  const Rows rows = orders_rows({});
  constexpr const char* what = "exponent of T, place after each step";
  EXPECT_EQ(published(found(rows, "Tustin, eq. 25", what)), 4);
  EXPECT_EQ(verdict(rows, "Tustin, eq. 25", what), "differs");
  EXPECT_NEAR(ours(rows, "Tustin, eq. 25", what), 3, 0.01);
  EXPECT_NEAR(ours(rows, "Heun, eq. 23", what), 3, 0.01);
  EXPECT_EQ(verdict(rows, "Tustin, eq. 25", "error of the radius after a turn"), "kept");
}

/// To leading order after a turn, with N T = 2π: Heun's radius grows by R N T⁴/8, its place is ahead by R N T³/6;
/// Tustin's is behind by R N T³/12.
TEST(KorenReferenceWords, KeepTheCircleByEquations22To25) {
  const Rows rows = orders_rows({});
  const std::string circle = "words of a circle of 10 mm, 100 mm/s, T 1 ms, ";
  constexpr const char *radius = "radius after a turn, off R", *place = "place after a turn, ahead along the circle";
  constexpr double micrometres = 10'000, t = 0.01, count = 628;
  EXPECT_NEAR(ours(rows, circle + "eq. 22", radius), 0, 1e-6);
  EXPECT_NEAR(ours(rows, circle + "eq. 22", place), 0, 1e-6);
  EXPECT_NEAR(ours(rows, circle + "eqs. 23 and 24", radius), micrometres * count * std::pow(t, 4) / 8, 1e-5);
  EXPECT_NEAR(ours(rows, circle + "eqs. 23 and 24", place), micrometres * count * std::pow(t, 3) / 6, 1e-4);
  EXPECT_NEAR(ours(rows, circle + "eqs. 24 and 25", radius), 0, 1e-6);
  EXPECT_NEAR(ours(rows, circle + "eqs. 24 and 25", place), -micrometres * count * std::pow(t, 3) / 12, 1e-4);
  for (const Row& row : rows) {
    const bool is_of_words = row.group.starts_with("words");
    EXPECT_TRUE(!is_of_words || row.verdict == Verdict::exact) << row.group << ": " << row.what;
  }
}

TEST(KorenEq27, ErrsAQuarterOfABluAndNeverMore) {
  const Rows rows = orders_rows({});
  EXPECT_EQ(verdict(rows, "the proposed method, eq. 27", "greatest error of a turn, T = 1/R"), "exact");
  EXPECT_EQ(verdict(rows, "the proposed method, eq. 27", "farthest that x² − Txy + y² is from R²"), "kept");
}

/// As T² or better: no step need fall on half a turn.
TEST(KorenEq27, ErrsByHalfOfTSquaredAtHalfATurn) {
  const Rows rows = orders_rows({});
  EXPECT_EQ(verdict(rows, "the proposed method, eq. 27", "error at half a turn"), "kept");
  EXPECT_GT(ours(rows, "the proposed method, eq. 27", "error at half a turn"), 0.4);
}

TEST(KorenHardware, DriftsByPiBluARevolution) {
  const Rows rows = half_circle_rows({});
  EXPECT_EQ(verdict(rows, "Euler's method in real numbers", "drift of half a turn"), "exact");
  EXPECT_EQ(verdict(rows, "Euler's method in real numbers", "drift of a turn"), "exact");
}

TEST(Koren10001, ComesOut) {
  const Rows rows = half_circle_rows({});
  EXPECT_EQ(verdict(rows, "eq. 27, remainders empty, r > q", "|x| after half a turn"), "exact");
  EXPECT_EQ(ours(rows, "eq. 27, two's complement", "|x| after half a turn"), 10000);
  EXPECT_EQ(ours(rows, "as in hardware, remainders empty", "|x| after half a turn"), 10001);
  EXPECT_EQ(ours(rows, "as in hardware, two's complement, half full", "|x| after half a turn"), 10002);
  EXPECT_EQ(verdict(rows, "eq. 27, remainders empty", "|x| after half a turn"), "measured");
  EXPECT_EQ(ours(rows, "eq. 27, remainders empty", "|x| after half a turn"), 10001);
  EXPECT_EQ(ours(rows, "eq. 27, remainders half full", "|x| after half a turn"), 10000);
  EXPECT_EQ(ours(rows, "as in hardware, remainders half full", "|x| after half a turn"), 10002);
}

/// Whatever the remainders hold at first; the paper has them empty.
TEST(Koren10001, ComesOutOfSignedRemaindersToo) {
  const Rows rows = half_circle_rows({});
  constexpr const char* what = "|x| after half a turn";
  EXPECT_EQ(verdict(rows, "eq. 27, signed remainders, empty", what), "fitted");
  for (const char* group : {"eq. 27, signed remainders, half full", "eq. 27, signed remainders, full"}) {
    EXPECT_EQ(verdict(rows, group, what), "measured") << group;
    EXPECT_EQ(ours(rows, group, what), 10001) << group;
  }
}

/// All rows of a study are exact, but for these.
void expect_exact(const Rows& rows, const std::map<std::string, Verdict>& others) {
  for (const Row& row : rows) {
    const auto other = others.find(row.what);
    const bool is_compared = row.published.has_value() || row.expected.has_value();
    const Verdict told = other != others.end() ? other->second : is_compared ? Verdict::exact : Verdict::measured;
    EXPECT_EQ(row.verdict, told) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN);
  }
}

TEST(LectureStudy, ComesOut) {
  const Rows rows = lecture_rows({});
  expect_exact(rows, {{"out of the feed DDA", Verdict::reproduced},  // 29309.43
                      {"feed of Y, not rounded", Verdict::differs},  // 1341.5
                      {"2ⁿ − 1", Verdict::differs},                  // 65536
                      {"load of the shortest delay", Verdict::differs}});
  EXPECT_EQ(rows.size(), 31u);
  EXPECT_NEAR(ours(rows, "problem 2: a linear interpolator of DDAs", "out of the feed DDA"), 29309.45, 0.005);
  EXPECT_NEAR(ours(rows, "problem 2: a linear interpolator of DDAs", "out of the feed DDA, nothing rounded"), 29308.59,
              0.005);
}

/// A BLU of 0.02 mm; 60 and 80 mm/min, 3000 and 4000 pulses a minute, 1500 and 2000 pulses in 30 s.
TEST(LectureProblem1, Gives3000And4000PulsesAMinuteAnd1500And2000Pulses) {
  const Rows rows = lecture_rows({});
  constexpr const char* group = "problem 1: a pulse-driven axis";
  EXPECT_DOUBLE_EQ(ours(rows, group, "basic length unit"), 0.02);
  EXPECT_DOUBLE_EQ(ours(rows, group, "feed of X"), 60);
  EXPECT_DOUBLE_EQ(ours(rows, group, "pulse rate of X"), 3000);
  EXPECT_DOUBLE_EQ(ours(rows, group, "pulses of X"), 1500);
  EXPECT_DOUBLE_EQ(ours(rows, group, "feed of Y"), 80);
  EXPECT_DOUBLE_EQ(ours(rows, group, "pulse rate of Y"), 4000);
  EXPECT_DOUBLE_EQ(ours(rows, group, "pulses of Y"), 2000);
  EXPECT_DOUBLE_EQ(ours(rows, group, "time"), 30);
}

/// 447392 · 3e6/11180/4096, by hand.
TEST(LectureProblem2, Gives29309PulsesASecondOutOfTheFeedDda) {
  const Rows rows = lecture_rows({});
  constexpr const char* group = "problem 2: a linear interpolator of DDAs";
  const Row row = found(rows, group, "out of the feed DDA");
  EXPECT_EQ(published(row), 29309.43);
  EXPECT_EQ(row.verdict, Verdict::reproduced);
  EXPECT_NEAR(row.ours.value_or(NAN), 447392 * (3e6 / 11180) / 4096, 1e-6);
  EXPECT_NEAR(row.ours.value_or(NAN), 29309.43, 0.025);
}

/// Both along a line of 3 m/min; 1341.5, which was published, is a misprint of 2236 · 0.6.
TEST(LectureProblem2, Gives2683And1341MillimetresAMinute) {
  const Rows rows = lecture_rows({});
  constexpr const char* group = "problem 2: a linear interpolator of DDAs";
  EXPECT_NEAR(ours(rows, group, "feed of X"), 3000 * 2 / std::sqrt(5), 1e-6);
  EXPECT_NEAR(ours(rows, group, "feed of Y, not rounded"), 3000 / std::sqrt(5), 1e-6);
  EXPECT_NEAR(ours(rows, group, "feed along the line"), 3, 1e-9);
}

/// It says 3, with which the first overflow comes after 8192/3 clocks of 1/1024 s.
TEST(LectureProblem3, NeedsTheLoad4ForTwoSeconds) {
  const Rows rows = lecture_rows({});
  constexpr const char* group = "problem 3: the DDA as a timer";
  EXPECT_EQ(published(found(rows, group, "load of the shortest delay")), 3);
  EXPECT_EQ(ours(rows, group, "load of the shortest delay"), 4);
  EXPECT_EQ(ours(rows, group, "first overflow of load 3"), 2731.0 / 1024);
}

TEST(LectureStudy, HoldsTheFeedWord268) {
  const Rows rows = lecture_rows({});
  constexpr const char* group = "problem 2, the feed word as a register holds it";
  EXPECT_EQ(ours(rows, group, "feed word"), 268);
  EXPECT_NEAR(ours(rows, group, "steps of X"), 4466.67, 0.005);
  EXPECT_NEAR(ours(rows, group, "steps of Y"), 2233.33, 0.005);
  EXPECT_NEAR(ours(rows, group, "feed along the line"), 2996.33, 0.005);
  EXPECT_NEAR(ours(rows, group, "time of the line"), 2.2388, 5e-5);
}

/// 2 MHz, f = 600 V/L, 5000 pulses/s, 200 µs, f = 100 V0, q0 = 3000, 2056.67 pulses/s.
TEST(KorenFeedStudy, ComesOut) {
  const Rows rows = feed_code_rows({});
  expect_exact(rows, {{"instructions of the longest interrupt", Verdict::no_worse},
                      {"time of the longest interrupt", Verdict::no_worse},
                      {"load", Verdict::no_worse},
                      {"an axis beside the other's coordinate summed over q, eq. 12", Verdict::kept},
                      {"feed along the path", Verdict::reproduced},
                      {"time measured on their computer", Verdict::not_reproducible}});
  EXPECT_EQ(rows.size(), 28u);
}

/// 20 000 commands a second, a sixth of a radian a second: what the registers are found to do, beside figures of hand.
TEST(KorenFeedStudy, ClocksACircleByTheRegistersOfTheHardware) {
  const Rows rows = feed_code_rows({});
  constexpr const char* group =
      "a circle of 1 in at 10 in/min by the registers of the hardware, eqs. 12, 13, 15 and 17";
  EXPECT_NEAR(ours(rows, group, "f by pulses, eq. 17"), 100, 1e-9);
  EXPECT_NEAR(ours(rows, group, "commands, eq. 6"), 20'000, 0.1);
  EXPECT_LE(ours(rows, group, "an axis beside the other's coordinate summed over q, eq. 12"), 1);
  EXPECT_EQ(ours(rows, group, "commands of the quarter"), 188'496);
  EXPECT_NEAR(ours(rows, group, "angular velocity, eq. 13"), 1.0 / 6, 5e-6);
  EXPECT_NEAR(ours(rows, group, "time of a turn"), 37.699, 5e-4);
  EXPECT_NEAR(ours(rows, group, "feed along the path"), 1666.67, 0.17);
}

/// A register for 12 in works at a sixth of its clock along 2 in; with q = L each command is a pulse.
TEST(KorenFeedStudy, CountsTheEfficiencyOfALine) {
  const Rows rows = feed_code_rows({});
  constexpr const char* group = "efficiency L/q of a line of 2 in";
  EXPECT_NEAR(ours(rows, group, "q of the register, 12 in"), 1.0 / 6, 1e-12);
  EXPECT_EQ(published(found(rows, group, "q = L")), 1);
  EXPECT_EQ(ours(rows, group, "q = L"), 1);
}

/// The figures of the paper are not made of themselves: ours are counted, as test_nc_program has them one by one.
TEST(KorenFeedStudy, CountsTheInstructionsOfAnInterrupt) {
  const Rows rows = feed_code_rows({});
  constexpr const char* group = "the NC program's share of the computer";
  EXPECT_EQ(published(found(rows, group, "instructions of the longest interrupt")), 85);
  EXPECT_EQ(ours(rows, group, "instructions of the longest interrupt"), 39);
  EXPECT_EQ(published(found(rows, group, "time of the longest interrupt")), 170);
  EXPECT_EQ(ours(rows, group, "time of the longest interrupt"), 78);
  EXPECT_EQ(published(found(rows, group, "load")), 85);
  EXPECT_EQ(ours(rows, group, "load"), 39);
  const double mean = ours(rows, group, "instructions of the mean interrupt");
  EXPECT_GT(mean, 20);
  EXPECT_LT(mean, 39);
  // Two displacements, counters, signs and remainders, and the coordinates of the start; a root digit by digit.
  EXPECT_EQ(ours(rows, group, "instructions with the initiator's"), 39 + 8 + 2 + 12 + 31 + 31 + 1 + 1);
}

/// m = 2ⁿ and the counters; v/R = vx/x is a misprint.
TEST(DigitalIntegralsStudy, ComesOut) {
  const Rows rows = digital_integrals_rows({});
  expect_exact(rows, {{"vx/v", Verdict::differs},
                      {"vy/v", Verdict::differs},
                      {"arcs in a quadrant tried", Verdict::not_reproducible}});
  EXPECT_EQ(rows.size(), 8u);
  EXPECT_EQ(published(found(rows, "lines", "cycles to the end, n = 8, register empty")), 256);
  EXPECT_EQ(ours(rows, "speeds on a circle, at (3, 4)", "vx/v"), 0.8);
  EXPECT_EQ(ours(rows, "speeds on a circle, at (3, 4)", "vy/v"), 0.6);
}

TEST(DigitalIntegrals, EveryEndIsReachedAfter2ToTheNCycles) {
  const Rows rows = digital_integrals_rows({});
  for (const char* what : {"ends missed after 2ⁿ cycles, registers empty", "ends missed after 2ⁿ cycles, half full"}) {
    EXPECT_EQ(found(rows, "lines", what).expected, 0);
    EXPECT_EQ(ours(rows, "lines", what), 0);
    EXPECT_EQ(found(rows, "lines", what).why.substr(0, 7), "of 510:");  // Σ 2ⁿ, n = 1 … 8
  }
}

TEST(DigitalIntegrals, CountersEndEveryArcOfAQuadrant) {
  const Rows rows = digital_integrals_rows({});
  for (const char* what :
       {"arcs in a quadrant that do not end, registers empty", "arcs in a quadrant that do not end, half full"}) {
    EXPECT_EQ(ours(rows, "arcs", what), 0);
    EXPECT_GT(std::stoi(found(rows, "arcs", what).why.substr(3)), 7680);  // at least as many as were tried elsewhere
  }
}

}  // namespace test_pulse_studies
}  // namespace leadscrew::study::testing
