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
namespace {

/// A clock that goes on by a microsecond whenever it is looked at.
Host ticking() {
  const auto clock = [] {
    static double now = 0;
    return now += 1e-6;
  };
  return {clock, clock};
}

const Rows& rows() {
  static const Rows rows = limits_rows(ticking());
  return rows;
}

std::vector<std::string> groups() {
  std::vector<std::string> groups;
  for (const OptimumPath* path : {&cubic_optima(), &circle_optima(), &butterfly_optima()}) {
    for (const Optimum& optimum : path->optima) groups.push_back(circumstances(*path, optimum));
  }
  return groups;
}

class PublishedTimes : public ::testing::TestWithParam<std::string> {};

// On the butterfly at 100 mm/s the published T2 is that of coarse knots: it is up to 0.08 % above what dense knots give
// (test_butterfly.cpp).
TEST_P(PublishedTimes, BoundIsT2) {
  const Row row = found(rows(), GetParam(), "least time without a limit of jerk");
  if (GetParam().starts_with("butterfly, F 100")) {
    EXPECT_LT(row.ours.value_or(NAN), *row.published);
    EXPECT_GT(row.ours.value_or(NAN), *row.published * 0.999);
  } else {
    EXPECT_EQ(row.verdict, Verdict::exact);
  }
}

TEST_P(PublishedTimes, NothingIsFasterThanTheOptimum) {
  EXPECT_GT(ours(rows(), GetParam(), "time over optimum"), 0.998);
}

TEST_P(PublishedTimes, LimitsAreKeptByPlanAndWords) {
  for (const char* who : {"plan", "words at 1 ms", "words at 0.25 ms"}) {
    for (const char* what : {"velocity", "acceleration", "jerk"}) {
      const std::string row = std::string(who) + ": largest " + what + " over limit";
      EXPECT_EQ(verdict(rows(), GetParam(), row), "kept") << row;
      EXPECT_GT(ours(rows(), GetParam(), row), 0) << row;
    }
  }
  EXPECT_EQ(verdict(rows(), GetParam(), "deviation from the program"), "kept");
}

TEST_P(PublishedTimes, EffortIsToldByTheClockThatWasLent) {
  EXPECT_GT(ours(rows(), GetParam(), "planning over motion time"), 0);
  EXPECT_NEAR(ours(rows(), GetParam(), "longest call of the planner"), 0.001, 1e-6);
  EXPECT_NEAR(ours(rows(), GetParam(), "cycle, median"), 1000, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(All, PublishedTimes, ::testing::ValuesIn(groups()));

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

}  // namespace
}  // namespace leadscrew::study::testing
