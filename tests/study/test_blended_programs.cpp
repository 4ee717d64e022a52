// Short lines and corners, blended: the times that must be reached, within every limit and the tolerance.

#include <gtest/gtest.h>

#include <leadscrew/study/blended_programs.hpp>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_blended_programs {

BlendedProgram program(std::string_view name, double tolerance) {
  for (const BlendedProgram& each : blended_programs()) {
    if (each.name == name && each.tolerance == tolerance) return each;
  }
  ADD_FAILURE() << "no " << name << " within " << tolerance << " mm";
  return blended_programs().front();
}

void limits_are_kept(const Rows& rows, const std::string& group) {
  for (const char* who : {"plan", "words at 1 ms"}) {
    for (const char* what : {"velocity", "acceleration", "jerk"}) {
      const double ratio = ours(rows, group, std::string(who) + ": largest " + what + " over limit");
      EXPECT_LE(ratio, 1.001) << who << ", " << what;
      EXPECT_GT(ratio, 0.1) << who << ", " << what;
    }
  }
  const Row objections = found(rows, group, "objections of the referee");
  EXPECT_EQ(objections.ours, 0) << objections.why;
}

/// The time of the motion, s, which is within every limit, at most as far off as told, mm, and says so in its verdicts.
double time_within(double deviation, const BlendedProgram& program) {
  const std::string group = circumstances(program);
  const Rows rows = blended_rows(program, {});
  expect_none_published(rows);
  limits_are_kept(rows, group);
  EXPECT_LE(ours(rows, group, "deviation from the program"), deviation * 1e3);
  EXPECT_EQ(verdict(rows, group, "deviation from the program"), "kept");
  EXPECT_EQ(verdict(rows, group, "time"), "no worse");
  return ours(rows, group, "time");
}

double stopping_time(const BlendedProgram& program) {
  return plan(stopping(program), machine_of(program, base::Period{}), {})->seconds;
}

std::size_t blocks_of(const BlendedProgram& program, std::string_view code) {
  const std::string blocks = "\n" + program.contour().blocks, begin = "\n" + std::string(code) + " ";
  std::size_t count = 0;
  for (std::size_t at = blocks.find(begin); at != std::string::npos; at = blocks.find(begin, at + 1)) ++count;
  return count;
}

TEST(BlendedPrograms, SquareTakesAtMost958Milliseconds) {
  EXPECT_LE(time_within(0.01, program("square of 10 mm", 0.01)), 0.958);
}

TEST(BlendedPrograms, StarIsFasterThanWithStops) {
  const BlendedProgram star = program("five-pointed star, R 10 mm", 0.01);
  EXPECT_LT(time_within(0.01, star), stopping_time(star));
}

TEST(BlendedPrograms, CubicAs92LinesTakesAtMost474Milliseconds) {
  EXPECT_LE(time_within(0.01, program("plane cubic as 92 lines", 0.01)), 0.474);
}

TEST(BlendedPrograms, CubicAs1000LinesTakesAtMost474Milliseconds) {
  EXPECT_LE(time_within(0.01, program("plane cubic as 1000 lines", 0.01)), 0.474);
}

TEST(BlendedPrograms, RoundedCubicTakesAtMost474MillisecondsWithinFiveMicrometres) {
  EXPECT_LE(time_within(0.005, program("plane cubic as 1000 lines rounded to 1 µm", 0.005)), 0.474);
}

TEST(BlendedPrograms, CubicWithATurningAxisTakesAtMost475Milliseconds) {
  EXPECT_LE(time_within(0.01, program("plane cubic as 1000 lines rounded to 1 µm, A turning 3°", 0.01)), 0.475);
}

TEST(BlendedPrograms, CollinearLinesTakeAtMost652MillisecondsAndStayOnTheirLine) {
  EXPECT_LE(time_within(1e-6, program("5000 collinear lines of 10 µm", 0.01)), 0.652);
}

TEST(BlendedPrograms, PocketTakesAtMostSixSeconds) {
  EXPECT_LE(time_within(0.02, program("pocket, 16 lines and 15 quarter arcs R 1 mm", 0.02)), 6.0);
}

TEST(BlendedPrograms, CircleAs2000LinesTakesAtMost788Milliseconds) {
  EXPECT_LE(time_within(0.01, program("circle R 10 mm as 2000 lines", 0.01)), 0.788);
}

TEST(BlendedPrograms, FinishingIsFasterThanWithStopsAndFasterStillWithinTwiceTheTolerance) {
  const BlendedProgram fine = program("finishing, 900 lines and 32 corners", 0.01);
  const BlendedProgram coarse = program("finishing, 900 lines and 32 corners", 0.02);
  const double fine_time = time_within(0.01, fine);
  EXPECT_LT(fine_time, stopping_time(fine));
  EXPECT_LT(time_within(0.02, coarse), fine_time);
}

TEST(BlendedPrograms, AreWhatTheirNamesSay) {
  EXPECT_EQ(blocks_of(program("plane cubic as 92 lines", 0.01), "G1"), 92);
  EXPECT_EQ(blocks_of(program("5000 collinear lines of 10 µm", 0.01), "G1"), 5000);
  EXPECT_EQ(blocks_of(program("circle R 10 mm as 2000 lines", 0.01), "G1"), 2000);
  EXPECT_EQ(blocks_of(program("finishing, 900 lines and 32 corners", 0.01), "G1"), 900);

  const BlendedProgram pocket = program("pocket, 16 lines and 15 quarter arcs R 1 mm", 0.02);
  EXPECT_EQ(blocks_of(pocket, "G1"), 16);
  EXPECT_EQ(blocks_of(pocket, "G3"), 15);
  EXPECT_NEAR(judge(stopping(pocket), machine_of(pocket, base::Period{}))->summary.length_mm, 376, 1e-9);
}

TEST(BlendedPrograms, StoppingSquareTakesThePublishedTime) {
  EXPECT_NEAR(stopping_time(program("square of 10 mm", 0.01)), 1.0246, 5e-5);
}

}  // namespace test_blended_programs
}  // namespace leadscrew::study::testing
