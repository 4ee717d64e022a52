// The rules of parameter steps, against the plane cubic written out by hand.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <allocations.hpp>
#include <cmath>
#include <leadscrew/interpolator/parameter_steps.hpp>

namespace test_parameter_steps {

using namespace leadscrew;
using geometry::Nurbs;
using geometry::NurbsForm;
using interpolator::next_parameter;
using interpolator::StepRule;

geometry::Point at(std::size_t coordinate, double x, double y) {
  geometry::Point point{};
  point[coordinate] = x;
  point[coordinate + 1] = y;
  return point;
}

/// x = 20u, y = −50u³ + 80u² − 10u, in two neighbouring coordinates from this one.
Nurbs cubic(std::size_t coordinate = 0) {
  const NurbsForm form{
      3,
      {0, 0, 0, 0, 1, 1, 1, 1},
      {at(coordinate, 0, 0), at(coordinate, 20 / 3.0, -10 / 3.0), at(coordinate, 40 / 3.0, 20), at(coordinate, 20, 20)},
      {1, 1, 1, 1}};
  return geometry::smooth_pieces(form).front();
}

double y(double u) {
  return ((-50 * u + 80) * u - 10) * u;
}
double y_first(double u) {
  return (-150 * u + 160) * u - 10;
}
double speed(double u) {
  return std::hypot(20, y_first(u));
}

/// Simpson's rule, far finer than anybody needs.
double length_between(double a, double b) {
  constexpr int parts = 2000;
  const double h = (b - a) / parts;
  double sum = speed(a) + speed(b);
  for (int i = 1; i < parts; ++i) sum += (i % 2 == 1 ? 4 : 2) * speed(a + i * h);
  return sum * h / 3;
}

rc::Gen<double> parameters() {
  return rc::gen::map(rc::gen::inRange(0, 970000), [](int millionths) { return millionths / 1e6; });
}

RC_GTEST_PROP(ParameterSteps, FirstOrderIsTheWayOverTheParametricSpeed, ()) {
  const Nurbs curve = cubic();
  const double u = *parameters(), distance = *rc::gen::element(0.001, 0.02, 0.1, 0.5);
  RC_ASSERT(std::abs(next_parameter(curve, StepRule::taylor1, u, 0, distance) - (u + distance / speed(u))) < 1e-12);
}

RC_GTEST_PROP(ParameterSteps, SecondOrderIsTaylorsPolynomial, ()) {
  const Nurbs curve = cubic();
  const double u = *parameters(), distance = *rc::gen::element(0.001, 0.02, 0.1, 0.5);
  // u″ at constant speed, from a difference quotient of u′ = V/|C′(u)| along the curve, not from the rule's formula.
  const double h = 1e-5, rate = 1 / speed(u);
  const double bend = (1 / speed(u + h) - 1 / speed(u - h)) / (2 * h) * rate;
  const double expected = u + rate * distance + bend * distance * distance / 2;
  RC_ASSERT(std::abs(next_parameter(curve, StepRule::taylor2, u, 0, distance) - expected) < 1e-9);
}

RC_GTEST_PROP(ParameterSteps, NewtonMakesTheChordAsLongAsTheWay, ()) {
  const Nurbs curve = cubic();
  const double u = *parameters(), distance = *rc::gen::element(0.001, 0.02, 0.1, 0.5);
  const double next = next_parameter(curve, StepRule::newton, u, 0, distance);
  RC_ASSERT(std::abs(std::hypot(20 * (next - u), y(next) - y(u)) / distance - 1) < 1e-7);
}

RC_GTEST_PROP(ParameterSteps, ArcLengthGoesWhereTheLawSays, ()) {
  const Nurbs curve = cubic();
  const double s = *rc::gen::inRange(0, 29000) / 1e3, distance = *rc::gen::element(0.001, 0.02, 0.1, 0.5);
  const double anywhere = *parameters();
  const double next = next_parameter(curve, StepRule::arc_length, anywhere, s, distance);
  RC_ASSERT(std::abs(length_between(0, next) - (s + distance)) < 1e-6);
}

RC_GTEST_PROP(ParameterSteps, UniformDividesTheParameterAsTheWayDividesTheLength, ()) {
  const Nurbs curve = cubic();
  const double u = *parameters(), distance = *rc::gen::element(0.001, 0.02, 0.1, 0.5);
  RC_ASSERT(std::abs(next_parameter(curve, StepRule::uniform, u, 0, distance) - (u + distance / length_between(0, 1))) <
            1e-9);
}

TEST(ParameterSteps, StopAtTheEnd) {
  const Nurbs curve = cubic();
  for (const StepRule rule : interpolator::all_step_rules) {
    EXPECT_EQ(next_parameter(curve, rule, 0.9999, 29.84, 1), 1) << name(rule);
    EXPECT_EQ(next_parameter(curve, rule, 1, curve.length(), 1), 1) << name(rule);
  }
}

TEST(ParameterSteps, StandStillWhereNothingIsToBeTravelled) {
  const Nurbs curve = cubic();
  for (const StepRule rule : interpolator::all_step_rules) {
    const double u = curve.parameter(7);
    EXPECT_EQ(next_parameter(curve, rule, u, 7, 0), u) << name(rule);
  }
}

TEST(ParameterSteps, AreCountedInTheCoordinatesThatTellTheLength) {
  const Nurbs tool = cubic(0), rotary = cubic(base::index(base::Axis::A)), second = cubic(base::index(base::Axis::U));
  for (const StepRule rule : interpolator::all_step_rules) {
    const double expected = next_parameter(tool, rule, 0.3, 9, 0.1);
    EXPECT_DOUBLE_EQ(next_parameter(rotary, rule, 0.3, 9, 0.1), expected) << name(rule);
    EXPECT_DOUBLE_EQ(next_parameter(second, rule, 0.3, 9, 0.1), expected) << name(rule);
  }
}

// C = (u², 0) begins with C′ = 0, where distance/|C′| is infinite; and a curve that ends where it begins, so that the
// end is at distance 0.
TEST(ParameterSteps, DoNotJumpFromACusp) {
  const NurbsForm straight{2, {0, 0, 0, 1, 1, 1}, {at(0, 0, 0), at(0, 0, 0), at(0, 1, 0)}, {1, 1, 1}};
  const NurbsForm loop{3, {0, 0, 0, 0, 1, 1, 1, 1}, {at(0, 0, 0), at(0, 0, 0), at(0, 4, 3), at(0, 0, 0)}, {1, 1, 1, 1}};
  for (const NurbsForm& form : {straight, loop}) {
    const Nurbs curve = geometry::smooth_pieces(form).front();
    const double u = curve.first_parameter();
    for (const StepRule rule : {StepRule::uniform, StepRule::taylor1, StepRule::taylor2, StepRule::newton}) {
      const double next = next_parameter(curve, rule, u, 0, 0.001);
      const geometry::PointJet there = curve.jets_at(next);
      EXPECT_GT(next, u) << name(rule);
      EXPECT_LT(next, curve.last_parameter()) << name(rule);
      EXPECT_LT(std::hypot(there[0].value, there[1].value), 0.011) << name(rule);
    }
  }
}

// Along u² the second order asks for Δu = h − h²/(2u)…, with h = distance/(2u): back, where the distance is long.
TEST(ParameterSteps, NeverGoBack) {
  const NurbsForm form{2, {0, 0, 0, 1, 1, 1}, {at(0, 0, 0), at(0, 0, 0), at(0, 1, 0)}, {1, 1, 1}};
  const Nurbs curve = geometry::smooth_pieces(form).back();
  for (double u = curve.first_parameter(); u < 0.9; u += 0.01) {
    for (const double distance : {1e-6, 1e-3, 0.01, 0.1}) {
      for (const StepRule rule : {StepRule::uniform, StepRule::taylor1, StepRule::taylor2, StepRule::newton})
        EXPECT_GT(next_parameter(curve, rule, u, 0, distance), u) << name(rule) << " at " << u << " by " << distance;
    }
  }
}

TEST(ParameterSteps, DoNotAllocate) {
  const Nurbs curve = cubic();
  const auto before = testing_support::allocations();
  double sum = 0;
  for (const StepRule rule : interpolator::all_step_rules) sum += next_parameter(curve, rule, 0.3, 9, 0.1);
  EXPECT_EQ(testing_support::allocations(), before);
  EXPECT_GT(sum, 0);
}

}  // namespace test_parameter_steps
