#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/sampling.hpp>
#include <leadscrew/toolpath/swing.hpp>
#include <numbers>

// How a tolerance is divided between curves and chords between words.

namespace test_sampling {

using namespace leadscrew;
using namespace leadscrew::toolpath;
using geometry::Point;

machine::Machine mill_at(std::int64_t milliseconds) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->velocity = 200, axis->acceleration = 1000, axis->jerk = 20'000;
  }
  machine.period = {milliseconds * 1'000'000};
  return machine;
}

Point direction(double degrees) {
  Point direction{};
  direction[0] = std::cos(degrees * std::numbers::pi / 180);
  direction[1] = std::sin(degrees * std::numbers::pi / 180);
  return direction;
}

Leg leg_along(double degrees, double feed, double tolerance) {
  Point end = direction(degrees);
  for (double& x : end) x *= 5;
  Leg leg{geometry::Line({}, end, 5), feed};
  leg.allowance = {tolerance, tolerance};
  return leg;
}

constexpr double fast = 100;

TEST(Sampling, KeepsNothingWhereWordsAreClose) {
  const Sampling none, at_1_ms(mill_at(1));
  for (const Sampling* sampling : {&none, &at_1_ms}) {
    for (const double tolerance : {0.001, 0.01, 0.1, 1.0}) {
      EXPECT_EQ(sampling->kept_beside_spline(leg_along(0, fast, tolerance)), 0);
      EXPECT_EQ(sampling->beside_blend(tolerance, direction(0), direction(90), fast, true).kept, 0);
      EXPECT_TRUE(sampling->suits_spline(leg_along(0, fast, tolerance), 1));
    }
  }
}

TEST(Sampling, KeepsNothingWhereFeedIsSlow) {
  const Sampling sampling(mill_at(20));
  EXPECT_EQ(sampling.beside_blend(0.1, direction(0), direction(90), 1, true).kept, 0);
  EXPECT_EQ(sampling.kept_beside_spline(leg_along(0, 1, 0.1)), 0);
  EXPECT_GT(sampling.beside_blend(0.1, direction(0), direction(90), fast, true).kept, 0);
  EXPECT_GT(sampling.kept_beside_spline(leg_along(0, fast, 0.1)), 0);
}

/// By differences of the blend that is made, passed in the time of its constant jerk.
TEST(Sampling, LeavesToChordsWhatMotionAtTheLimitOfJerkTakes) {
  const machine::Machine machine = mill_at(10);
  const double tolerance = 0.01, period = machine.period.seconds();
  const Division division = Sampling(machine).beside_blend(tolerance, direction(0), direction(90), fast, true);
  ASSERT_EQ(division.rounding, Rounding::wide);
  Point corner{}, end{};
  corner[0] = end[0] = end[1] = 5;
  const std::optional<Blend> found =
      blend({geometry::Line({}, corner, 5), geometry::Line(corner, end, 5), {}, {}, 4, 4}, tolerance - division.kept);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->deviation, tolerance - division.kept, 1e-12);
  // Across the corner both axes have their jerk.
  const double scale = found->behind / Swing(std::numbers::sqrt2).reach();
  const double time = std::cbrt(6 * scale / (std::numbers::sqrt2 * 20'000));
  const double first = found->curve.first_parameter(), last = found->curve.last_parameter();
  const double step = 1e-3, middle = (first + last) / 2;
  const auto at = [&](double share) { return found->curve.jets_at(middle + share * (last - first)); };
  double across = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double second = (at(step)[i].value - 2 * at(0)[i].value + at(-step)[i].value) / (step * step);
    across += second * second;
  }
  const double sagitta = std::sqrt(across) / (time * time) * period * period / 8;
  EXPECT_NEAR(sagitta, division.kept, 1e-3 * sagitta);
}

RC_GTEST_PROP(Sampling, LeavesTheLessToCurvesTheFartherWordsAreApart, ()) {
  const double turn = *rc::gen::inRange(5, 170), tolerance = *rc::gen::element(0.001, 0.005, 0.01, 0.05, 0.2);
  double before = 0;
  for (const std::int64_t period : {1, 2, 4, 10, 20}) {
    const Sampling sampling(mill_at(period));
    const Division division = sampling.beside_blend(tolerance, direction(20), direction(20 + turn), fast, true);
    RC_ASSERT(division.kept >= 0 && division.kept <= tolerance);
    RC_ASSERT(division.kept == tolerance || tolerance - division.kept >= least_tolerance || division.kept == 0);
    const double kept = sampling.kept_beside_spline(leg_along(20, fast, tolerance));
    RC_ASSERT(kept >= before && kept <= tolerance / 2);
    before = kept;
  }
}

TEST(Sampling, StopsWhereABlendWouldBeTooSmallToBeShown) {
  const Sampling sampling(mill_at(20));
  EXPECT_EQ(sampling.beside_blend(0.001, direction(0), direction(90), fast, true).rounding, Rounding::none);
  EXPECT_EQ(sampling.beside_blend(0.01, direction(0), direction(90), fast, true).rounding, Rounding::cut);
  EXPECT_EQ(sampling.beside_blend(0.2, direction(0), direction(90), fast, true).rounding, Rounding::wide);
}

TEST(Sampling, TakesSharpTurnsIntoNoSplineWhereNextToNothingIsLeftToChords) {
  const Sampling sampling(mill_at(20));
  Leg leg = leg_along(0, fast, 0.001);
  leg.kept = sampling.kept_beside_spline(leg);
  EXPECT_TRUE(sampling.suits_spline(leg, 0.05));
  EXPECT_FALSE(sampling.suits_spline(leg, 1));
}

}  // namespace test_sampling
