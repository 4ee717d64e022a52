#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <random_numbers.hpp>

namespace test_constraints {

using namespace leadscrew;
using base::Axis;
using constraints::Constraints;
using constraints::LimitRatios;
using constraints::PathRates;
using testing_support::any;
using testing_support::logarithmic;

// ---------------------------------------------------------------------------------------------------------------------
// Rows are the axes' derivatives by time.

machine::Machine random_machine() {
  machine::Machine machine = machine::mill3();
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e6, 1e6, logarithmic(8, 500), logarithmic(30, 1e4), logarithmic(1000, 1e6), 0.001};
  }
  return machine;
}

numeric::Jet<> random_jet() {
  return {logarithmic(0.1, 10), any(-10, 11) / 10.0, any(-10, 11) / 20.0, any(-10, 11) / 30.0};
}

/// q(s(t)) near t = 0, s(t) = vt + at²/2 + jt³/6, q by its Taylor polynomial of the third order.
long double coordinate(const numeric::Jet<>& q, const PathRates& rates, long double t) {
  const long double s = t * (rates.speed + t * (rates.acceleration / 2.0L + t * rates.jerk / 6.0L));
  return q.value + s * (q.first + s * (q.second / 2.0L + s * q.third / 6.0L));
}

RC_GTEST_PROP(Constraints, RatiosAreDerivativesByTimeOverLimits, ()) {
  const machine::Machine machine = random_machine();
  geometry::PointJet jet{};
  for (const std::size_t i : {0, 1, 2, 3}) jet[i] = random_jet();
  const PathRates rates{any(1, 100) / 10.0, any(-100, 101) / 10.0, any(-100, 101) / 10.0};
  const LimitRatios ratios = Constraints(machine).ratios({jet, INFINITY}, rates);
  constexpr long double h = 1e-3L;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::A}) {
    const auto q = [&](int k) { return coordinate(jet[base::index(axis)], rates, k * h); };
    // Central differences of the second order, improved by Richardson from twice the step.
    const auto improved = [](long double fine, long double coarse) { return fine + (fine - coarse) / 3; };
    const long double velocity = improved((q(1) - q(-1)) / (2 * h), (q(2) - q(-2)) / (4 * h));
    const long double acceleration =
        improved((q(1) - 2 * q(0) + q(-1)) / (h * h), (q(2) - 2 * q(0) + q(-2)) / (4 * h * h));
    const auto third = [&](int k) {
      return (q(2 * k) - 2 * q(k) + 2 * q(-k) - q(-2 * k)) / (2 * k * k * k * h * h * h);
    };
    const long double jerk = improved(third(1), third(2));
    const machine::AxisLimits& limits = machine.limits(axis);
    const machine::Derivatives of_axis = ratios.of_axis(axis);
    const auto is_near = [](double ratio, long double value, double limit) {
      return std::abs(static_cast<double>(std::abs(value)) / limit - ratio) <= 1e-6 * (1 + ratio);
    };
    RC_ASSERT(is_near(of_axis.velocity, velocity, limits.velocity));
    RC_ASSERT(is_near(of_axis.acceleration, acceleration, limits.acceleration));
    RC_ASSERT(is_near(of_axis.jerk, jerk, limits.jerk));
  }
}

TEST(Constraints, AskNothingOfAnAxisTheMachineLacks) {
  geometry::PointJet jet{};
  jet[base::index(Axis::A)] = {0, 1, 1, 1};
  const Constraints constraints(machine::mill3());
  EXPECT_EQ(constraints.ratios({jet, INFINITY}, {1, 1, 1}), LimitRatios());
  EXPECT_EQ(constraints.along_tangent({jet, INFINITY}), (machine::Derivatives{INFINITY, INFINITY, INFINITY}));
  EXPECT_EQ(constraints.of_axis(Axis::A), (machine::Derivatives{INFINITY, INFINITY, INFINITY}));
}

TEST(Constraints, NameFeedAsALimitOfThePath) {
  const auto jet = geometry::Line({}, {10}, 10).jets(0);
  const LimitRatios ratios = Constraints(machine::mill3()).ratios({jet, 50}, {25, 0, 0});
  EXPECT_EQ(ratios.of_path()[0].name, "feed");
  EXPECT_DOUBLE_EQ(ratios.of_path()[0].ratio, 0.5);
  EXPECT_DOUBLE_EQ(ratios.of_axis(Axis::X).velocity, 25.0 / 200);
  EXPECT_DOUBLE_EQ(ratios.greatest(), 0.5);
}

/// |q″|x ≤ a and |q‴|x√x ≤ j with equality.
TEST(Constraints, MeetTheFirstLimitAtTheGreatestSquareByCurve) {
  geometry::PointJet jet{};
  jet[0] = {0, 0.6, 0.02, 0};
  jet[1] = {0, 0.8, 0, 0.004};
  const Constraints constraints(machine::mill3());
  const double speed = std::sqrt(constraints.greatest_square_by_curve({jet, INFINITY}));
  const LimitRatios ratios = constraints.ratios({jet, INFINITY}, {speed, 0, 0});
  EXPECT_NEAR(std::max(ratios.of_axis(Axis::X).acceleration, ratios.of_axis(Axis::Y).jerk), 1, 1e-14);
}

// ---------------------------------------------------------------------------------------------------------------------

/// ε = ρ − √(ρ² − (VT/2)²), to its first term (VT)²/8ρ.
RC_GTEST_PROP(GreatestSquare, KeepsTheChordError, ()) {
  machine::Machine machine = machine::mill3();
  machine.period = {*rc::gen::inRange(1, 11) * 1'000'000};
  machine.chord_error = *rc::gen::element(1e-5, 1e-4, 1e-3);
  const double radius = std::pow(10.0, *rc::gen::inRange(-1000, 3000) / 1000.0);
  const geometry::Arc circle({radius}, {radius}, 0, 1, 0, 0, numeric::two_pi, numeric::two_pi.value() * radius);
  const auto jet = circle.jets(0);
  for (auto& axis : machine.axes) {
    if (axis) axis->velocity = 1e9;
  }
  const double square = Constraints(machine).greatest_square({jet, 1e9}),
               step_length = std::sqrt(square) * machine.period.seconds();
  RC_ASSERT(std::abs(step_length * step_length / (8 * radius) / machine.chord_error - 1) <= 1e-12);
  // A tolerance that leaves more than the machine's chord error leaves as much more to x; one that leaves less, nothing.
  const double more = *rc::gen::element(0.5, 1.0, 4.0);
  const double with_tolerance = Constraints(machine).greatest_square({jet, 1e9, {more * machine.chord_error, {}}});
  RC_ASSERT(std::abs(with_tolerance / square - std::max(1.0, more)) <= 1e-12);
  if (machine.chord_error < 1e-3 * radius) {
    const double chord = radius - std::sqrt(radius * radius - step_length * step_length / 4);
    RC_ASSERT(std::abs(chord / machine.chord_error - 1) <= 2e-3);
  }
}

RC_GTEST_PROP(GreatestSquare, KeepsFeedAndEveryAxisVelocity, ()) {
  machine::Machine machine = machine::mill3();
  geometry::Point end{};
  for (const std::size_t i : {0, 1, 2}) {
    machine.axes[i]->velocity = *rc::gen::inRange(1, 5000) / 10.0;
    end[i] = *rc::gen::inRange(-10, 11);
  }
  RC_PRE(std::hypot(end[0], end[1], end[2]) > 0);
  const double length = std::hypot(end[0], end[1], end[2]);
  double least = 1e300;
  for (const std::size_t i : {0, 1, 2}) {
    if (end[i] != 0) least = std::min(least, machine.axes[i]->velocity * length / std::abs(end[i]));
  }
  const auto jet = geometry::Line({}, end, length).jets(0);
  RC_ASSERT(std::abs(std::sqrt(Constraints(machine).greatest_square({jet, INFINITY})) / least - 1) <= 1e-14);
  const double feed = least * *rc::gen::inRange(1, 3000) / 1000.0;
  RC_ASSERT(std::abs(std::sqrt(Constraints(machine).greatest_square({jet, feed})) / std::min(feed, least) - 1) <=
            1e-14);
}

}  // namespace test_constraints
