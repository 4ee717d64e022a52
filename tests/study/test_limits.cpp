// Times and limits of motion along the three paths, beside the numerical optima.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/study/butterfly.hpp>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/optima.hpp>
#include <leadscrew/study/studies.hpp>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_limits {

/// A clock that goes on by a microsecond whenever it is looked at.
Host ticking() {
  const auto clock = [] {
    static double now = 0;
    return now += 1e-6;
  };
  return {clock, clock};
}

const Rows& rows() {
  static const Rows rows = curve_rows(ticking());
  return rows;
}

std::vector<std::string> groups() {
  std::vector<std::string> groups;
  for (const OptimumPath* path : {&cubic_optima(), &circle_optima(), &butterfly_optima()}) {
    for (const Optimum& optimum : path->optima) groups.push_back(circumstances(*path, optimum));
  }
  return groups;
}

// All in one test, as all rows take but one run of the study.
//
// On the butterfly at 100 mm/s the expected T2 is that of coarse knots: it is up to 0.08 % above what dense knots give
// (test_butterfly.cpp).
void bound_is_t2(const std::string& group) {
  const Row row = found(rows(), group, "least time without a limit of jerk");
  if (group.starts_with("butterfly, F 100")) {
    EXPECT_LT(row.ours.value_or(NAN), *row.expected);
    EXPECT_GT(row.ours.value_or(NAN), *row.expected * 0.999);
  } else {
    EXPECT_EQ(row.verdict, Verdict::exact);
  }
}

void time_is_the_optimum(const std::string& group) {
  const double ratio = ours(rows(), group, "time over optimum");
  EXPECT_GT(ratio, 0.998);
  EXPECT_LE(ratio, 1.005);
}

void limits_are_kept_by_plan_and_words(const std::string& group) {
  for (const char* who : {"plan", "words at 1 ms", "words at 0.25 ms"}) {
    for (const char* what : {"velocity", "acceleration", "jerk"}) {
      const std::string row = std::string(who) + ": largest " + what + " over limit";
      EXPECT_EQ(verdict(rows(), group, row), "kept") << row;
      EXPECT_GT(ours(rows(), group, row), 0) << row;
    }
  }
  EXPECT_EQ(verdict(rows(), group, "deviation from the program"), "kept");
}

void effort_is_told_by_the_clock_that_was_lent(const std::string& group) {
  EXPECT_GT(ours(rows(), group, "planning over motion time"), 0);
  EXPECT_NEAR(ours(rows(), group, "longest call of the planner"), 0.001, 1e-6);
  EXPECT_NEAR(ours(rows(), group, "cycle, median"), 1000, 1e-3);
}

TEST(ExpectedTimes, AreOfNoPaperAndReachedWithinTheLimits) {
  expect_none_published(rows());
  for (const std::string& group : groups()) {
    SCOPED_TRACE(group);
    bound_is_t2(group);
    time_is_the_optimum(group);
    limits_are_kept_by_plan_and_words(group);
    effort_is_told_by_the_clock_that_was_lent(group);
  }
}

TEST(Effort, WithoutAClockIsNotRun) {
  const Planned planned = *plan(circle_program(10, 100), machine_with({200, 1000, 20000}, base::Period{}), {});
  EXPECT_EQ(planned.cpu.plan, 0);
  EXPECT_EQ(planned.cycle.max, 0);
  EXPECT_GT(planned.seconds, 0.727);
}

TEST(Programs, OfCurvesReadBackBitForBit) {
  for (const geometry::NurbsForm& form : {plane_cubic(), butterfly()}) {
    const PartProgram program = program_of(form, 100);
    const machine::Machine machine = machine::mill3();
    const machine::ToolTable tools;
    gcode::ReaderOptions options;
    options.start = program.start;
    gcode::Reader reader(gcode::text_source(program.text), machine, tools, options,
                         [](const base::Diagnostic& d) { ADD_FAILURE() << d.place.line << ": " << d.message; });
    gcode::Move move;
    do {
      ASSERT_TRUE(reader.next(move));
    } while (move.kind == gcode::Move::Kind::event);
    ASSERT_EQ(move.kind, gcode::Move::Kind::nurbs);
    EXPECT_EQ(move.feed.value, 100);
    EXPECT_EQ(move.curve.degree, form.degree);
    EXPECT_EQ(move.curve.knots, form.knots);
    ASSERT_EQ(move.curve.points.size(), form.points.size());
    for (std::size_t i = 0; i < form.points.size(); ++i) {
      EXPECT_EQ(move.curve.points[i].position, form.points[i]);
      EXPECT_EQ(move.curve.points[i].weight, form.weights[i]);
    }
  }
}

}  // namespace test_limits
}  // namespace leadscrew::study::testing
