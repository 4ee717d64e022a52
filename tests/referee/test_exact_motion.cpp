// Motions that are exactly on the program are found to be so, whatever the path does.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_exact_motion {

constexpr double rounding = 1e-8;  // mm

void expect_sound(const Verdict& verdict) {
  EXPECT_FALSE(verdict.objects()) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, rounding);
  EXPECT_LE(verdict.start_error_mm, 1e-9);
  EXPECT_LE(verdict.end_error_mm, 1e-9);
}

constexpr std::int64_t periods[] = {10'000, 100'000, 250'000, 1'000'000, 3'000'000, 20'000'000};

RC_GTEST_PROP(ExactMotion, DeviatesByRoundingOnly, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const int blocks = *rc::gen::inRange(1, 14);
  const base::Period period{*rc::gen::elementOf(std::vector<std::int64_t>(std::begin(periods) + 1, std::end(periods)))};
  const double size = *rc::gen::element(0.05, 2.0, 40.0);
  const double offset = *rc::gen::element(0.0, 300.0, -990.0);
  const machine::Machine machine = five_axes();
  const Program program = random_program(random, blocks, size, offset);
  const Verdict verdict = judge(program.moves, exact_motion(program, machine, period), machine, period);
  if (verdict.objects() || verdict.deviation_mm > rounding) RC_FAIL(describe(verdict));
  RC_ASSERT(verdict.end_error_mm <= 1e-9);
  RC_ASSERT(verdict.start_error_mm <= 1e-9);
}

TEST(ExactMotion, SlotMilledBackAndForthAHundredTimes) {
  const machine::Machine machine = machine::mill3();
  for (const std::int64_t nanoseconds : periods) {
    for (const double length : {20.0, 0.7, 0.01, 1e-5}) {
      if (nanoseconds == 10'000 && length > 0.1) continue;
      Program program;
      at(program.position, Axis::X) = 123.456;
      for (int i = 0; i < 100; ++i) program.line(123.456 + length, 7.7 / 3).line(123.456, 0);
      SCOPED_TRACE(std::to_string(nanoseconds) + " ns, " + std::to_string(length));
      const base::Period period{nanoseconds};
      expect_sound(judge(program.moves, exact_motion(program, machine, period), machine, period));
    }
  }
}

TEST(ExactMotion, CircleMilledThreeTimesInOneBlockAndInThree) {
  const machine::Machine machine = machine::mill3();
  for (const std::int64_t nanoseconds : periods) {
    for (const double radius : {30.0, 0.5, 0.01, 1e-4}) {
      if (nanoseconds == 10'000 && radius > 1) continue;
      Program program;
      program.line(radius, 0).circle(0, 0, 3).circle(0, 0, 1).circle(0, 0, 1).circle(0, 0, 1).circle(0, 0, -2).line(0,
                                                                                                                    5);
      SCOPED_TRACE(std::to_string(nanoseconds) + " ns, " + std::to_string(radius));
      const base::Period period{nanoseconds};
      expect_sound(judge(program.moves, exact_motion(program, machine, period), machine, period));
    }
  }
}

TEST(ExactMotion, CrossingsAndDwellsAtThem) {
  const machine::Machine machine = machine::mill3();
  const base::Period period{1'000'000};
  Program program;
  for (int i = 0; i < 10; ++i) program.line(10, 0).line(5, 0).line(5, 5).line(5, -5).line(5, 0).line(0, 0);
  std::vector<double> durations = durations_of(program.moves, machine);
  Move wait;
  wait.kind = Move::Kind::dwell;
  wait.dwell_seconds = 0.05;
  std::vector<Move> with_dwells;
  std::vector<double> with_times;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    with_dwells.push_back(program.moves[i]);
    with_times.push_back(durations[i]);
    wait.start = wait.end = program.moves[i].end;
    with_dwells.push_back(wait);
    with_times.push_back(wait.dwell_seconds);
  }
  expect_sound(judge(with_dwells, sample(with_dwells, with_times, period), machine, period));
}

TEST(ExactMotion, ManyBlocksWithinOnePeriod) {
  const machine::Machine machine = machine::mill3();
  for (const std::int64_t nanoseconds : {1'000'000, 20'000'000}) {
    for (const double step : {1e-6, 1e-3}) {
      Program fine, whole;
      for (int i = 1; i <= 3000; ++i) fine.line(i * step, i * step / 2);
      whole.line(3000 * step, 1500 * step);
      const base::Period period{nanoseconds};
      expect_sound(judge(fine.moves, exact_motion(whole, machine, period), machine, period));
    }
  }
}

TEST(ExactMotion, StandingStill) {
  const machine::Machine machine = machine::mill3();
  const base::Period period{1'000'000};
  expect_sound(judge({}, Words(5), machine, period));
  expect_sound(judge(Program().line(0, 0).moves, Words(5), machine, period));
  EXPECT_TRUE(has(judge(Program().line(0, 0).moves, {}, machine, period), "no words"));
  AxisVector moved{};
  at(moved, Axis::X) = 1e-3;
  Words words(5);
  words.push_back(moved);
  EXPECT_TRUE(has(judge(Program().line(0, 0).moves, words, machine, period), "deviation"));
}

}  // namespace test_exact_motion
}  // namespace leadscrew::referee::test
