// Why passes cannot go on: each reason by a surface and a tool that give it, found in bounded work.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/surfaces/passes.hpp>

#include "patches.hpp"

namespace leadscrew::surfaces {
namespace test_pass_failures {

using Kind = PassFailure::Kind;

struct Outcome {
  std::size_t told = 0;
  std::optional<PassFailure> failure;
  std::optional<Passes::Least> least;
};
Outcome outcome_of(const Machining& machining) {
  Passes passes(machining);
  Outcome outcome;
  while (passes.next()) ++outcome.told;
  outcome.failure = passes.failure();
  outcome.least = passes.least_clearance();
  EXPECT_FALSE(passes.next());
  return outcome;
}
std::optional<Kind> kind_of(const Machining& machining) {
  const Outcome outcome = outcome_of(machining);
  return outcome.failure ? std::optional(outcome.failure->kind) : std::nullopt;
}

constexpr std::array all_patterns = {Pattern::zig, Pattern::zigzag, Pattern::spiral_in, Pattern::iso_scallop,
                                     Pattern::planar};

TEST(PassFailure, ABallGougesPatchAFromItsSmallestRadiusOfCurvatureOn) {
  for (const Direction along : {Direction::u, Direction::v}) {
    Machining machining = test::ball_on(test::patch_a(), 45.4);
    machining.along = along;
    EXPECT_FALSE(kind_of(machining));
    machining.cutter = {45.5, 45.5};
    const Outcome outcome = outcome_of(machining);
    ASSERT_TRUE(outcome.failure);
    EXPECT_EQ(outcome.failure->kind, Kind::gouge);
    EXPECT_LT(outcome.failure->amount, 0);
    EXPECT_NEAR(std::max(outcome.failure->u, outcome.failure->v), 0.9, 0.05);
    machining.allows_gouging = true;
    const Outcome allowed = outcome_of(machining);
    EXPECT_FALSE(allowed.failure);
    EXPECT_NEAR(allowed.least->clearance, 1 / 45.5 - 0.022005, 1e-6);
  }
}

TEST(PassFailure, TooManyPassesAreFoundBeforeAnyIsMade) {
  for (const Pattern pattern : all_patterns) {
    Machining machining = test::ball_on(test::patch_a());
    machining.pattern = pattern;
    machining.scallop = 0;
    for (const double step : {1e-6, 1e-300}) {
      machining.step = step;
      const Outcome outcome = outcome_of(machining);
      ASSERT_TRUE(outcome.failure);
      EXPECT_EQ(outcome.failure->kind, Kind::too_many);
      EXPECT_GT(outcome.failure->amount, most_passes);
      EXPECT_EQ(outcome.told, 0u);
    }
  }
}

TEST(PassFailure, NoStepIsFoundWhereTheToolFillsTheSurface) {
  Machining machining = test::ball_on(test::cylinder(5, 30));
  machining.orientation.rule = Orientation::Rule::normal;
  EXPECT_EQ(kind_of(machining), Kind::no_step);
  machining.cutter = {5, 0};
  machining.side = -1;
  machining.orientation = Orientation::leaning(0, 0.2);
  EXPECT_EQ(kind_of(machining), Kind::no_step);  // a sharp edge towards the next pass
}

TEST(PassFailure, TheNormalVanishes) {
  SurfaceForm form = test::patch_a();
  for (std::size_t i = 0; i < 4; ++i) form.net[i].position = {30, 0, 0};
  const Outcome outcome = outcome_of(test::ball_on(form));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->kind, Kind::normal);
  EXPECT_EQ(outcome.failure->v, 0);
}

TEST(PassFailure, AnEdgeTurnsTheNormal) {
  SurfaceForm form{{1, 1}, {uniform_knots(3, 1), uniform_knots(2, 1)}, {3, 2}, {}};
  for (const double y : {0.0, 20.0}) {
    for (const double x : {0.0, 10.0, 20.0}) form.net.push_back({{x, y, x == 10 ? 5.0 : 0.0}, 1});
  }
  for (const Direction along : {Direction::u, Direction::v}) {
    Machining machining = test::ball_on(form);
    machining.along = along;
    const Outcome outcome = outcome_of(machining);
    ASSERT_TRUE(outcome.failure);
    EXPECT_EQ(outcome.failure->kind, Kind::edge);
    EXPECT_EQ(outcome.failure->u, 0.5);
    EXPECT_EQ(outcome.told, 0u);
    machining.u = {0.5, 1};
    EXPECT_FALSE(kind_of(machining));
  }
}

TEST(PassFailure, ATipStandsStillWhileTheBallTurnsInACylinderOfItsOwnRadius) {
  Machining machining = test::ball_on(test::cylinder(5, 30));
  machining.side = 1;
  machining.orientation.axis = {0, -1, 0};
  machining.along = Direction::v;
  machining.scallop = 0;
  machining.step = 1;
  EXPECT_EQ(kind_of(machining), Kind::cusp);
}

TEST(PassFailure, TheAxisPointsIntoTheSurface) {
  Machining machining = test::ball_on(test::cylinder(20, 50));
  EXPECT_EQ(kind_of(machining), Kind::overhang);
  machining.side = -1;
  EXPECT_FALSE(kind_of(machining));
}

TEST(PassFailure, AFlatStandsOnADome) {
  const SurfaceForm dome = test::bicubic({{{0, 2, 2, 0}, {2, 6, 6, 2}, {2, 6, 6, 2}, {0, 2, 2, 0}}});
  for (const double corner : {0.0, 1.0}) {
    Machining machining = test::ball_on(dome);
    machining.cutter = {5, corner};
    machining.equal_steps = true;
    EXPECT_EQ(kind_of(machining), Kind::flat_contact);
    machining.surface = std::make_shared<Surface>(test::plane());
    EXPECT_FALSE(kind_of(machining));
  }
}

TEST(PassFailure, PlanesMeetAFoldInLinesThatDoubleBack) {
  Machining machining = test::ball_on(test::cylinder(20, 50));
  machining.side = -1;
  machining.pattern = Pattern::planar;
  machining.along = Direction::u;
  EXPECT_EQ(kind_of(machining), Kind::section);
  machining.v = {0.1, 1};  // off the place where y is greatest
  EXPECT_FALSE(kind_of(machining));
}

TEST(PassFailure, NoLinkTurnsTheToolOver) {
  Machining machining = test::ball_on(test::plane());
  machining.orientation = Orientation::leaning(1.5705, 0);
  const Outcome outcome = outcome_of(machining);
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->kind, Kind::link);
  EXPECT_EQ(outcome.told, 1u);
}

TEST(Passes, AreFewWhereTheRangeIsNarrowOrTheStepIsWide) {
  for (const Pattern pattern : all_patterns) {
    Machining machining = test::ball_on(test::patch_a());
    machining.pattern = pattern;
    machining.v = {0.3, 0.3 + 1e-7};
    const Outcome narrow = outcome_of(machining);
    EXPECT_FALSE(narrow.failure);
    EXPECT_GE(narrow.told, 3u);
    EXPECT_LE(narrow.told, 5u);
    machining.v = {0, 1};
    machining.scallop = 0;
    machining.step = 1e9;
    const Outcome wide = outcome_of(machining);
    EXPECT_FALSE(wide.failure);
    EXPECT_LE(wide.told, 5u);
  }
}

}  // namespace test_pass_failures
}  // namespace leadscrew::surfaces
