#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/geometry/curve.hpp>

namespace test_curves {

using leadscrew::geometry::Arc;
using leadscrew::geometry::Curve;
using leadscrew::geometry::Line;
using leadscrew::geometry::Point;
using leadscrew::geometry::PointJet;
using leadscrew::numeric::DoubleDouble;

rc::Gen<double> coordinates() {
  return rc::gen::map(rc::gen::inRange(-1000000, 1000001), [](int thousandths) { return thousandths / 1000.0; });
}

Curve random_line() {
  Point start{}, end{};
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] = *coordinates();
    end[i] = *coordinates();
  }
  RC_PRE(start != end);
  return Line(start, end, std::hypot(start[0] - end[0], start[1] - end[1], start[2] - end[2]) + 0.5);
}

Curve random_arc() {
  Point start{}, end{};
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] = *coordinates();
    end[i] = *coordinates();
  }
  const std::size_t first = *rc::gen::inRange<std::size_t>(0, 3), second = (first + 1) % 3;
  const double center_first = *coordinates(), center_second = *coordinates();
  const double x = start[first] - center_first, y = start[second] - center_second;
  RC_PRE(std::hypot(x, y) > 1e-3);
  const double angle = *rc::gen::inRange(-20000, 20001) / 1000.0;
  RC_PRE(std::abs(angle) > 1e-3);
  end[first] = center_first + x * std::cos(angle) - y * std::sin(angle);
  end[second] = center_second + x * std::sin(angle) + y * std::cos(angle);
  return Arc(start, end, first, second, center_first, center_second, angle,
             Arc::helix_length(std::hypot(x, y), angle, end[(first + 2) % 3] - start[(first + 2) % 3]));
}

Curve random_curve() {
  return *rc::gen::arbitrary<bool>() ? random_line() : random_arc();
}

double ulp(double x) {
  return std::nextafter(std::abs(x), INFINITY) - std::abs(x);
}

/// What is not rounded is, once it is, and rates are the first derivatives: to the last bit.
RC_GTEST_PROP(Curves, SayTheSameUnroundedAndByRates, ()) {
  const Curve curve = random_curve();
  const double length = leadscrew::geometry::length(curve), s = length * *rc::gen::inRange(-1, 12) / 10;
  RC_ASSERT(leadscrew::geometry::rounded(leadscrew::geometry::evaluate_unrounded(curve, s)) ==
            leadscrew::geometry::evaluate(curve, s));
  const PointJet jets = leadscrew::geometry::jets(curve, s);
  for (const std::size_t first : {0, 3, 6}) {
    const auto rates = leadscrew::geometry::rates(curve, s, first);
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(rates[i] == jets[first + i].first);
  }
}

RC_GTEST_PROP(Curves, BeginAndEndExactlyWhereTheyShould, ()) {
  const Curve curve = random_curve();
  const double length = leadscrew::geometry::length(curve);
  RC_ASSERT(leadscrew::geometry::evaluate(curve, 0.0) == leadscrew::geometry::start(curve));
  RC_ASSERT(leadscrew::geometry::evaluate(curve, length) == leadscrew::geometry::end(curve));
}

RC_GTEST_PROP(Curves, ApproachTheirEndsWithoutAStep, ()) {
  const Curve curve = random_curve();
  const double length = leadscrew::geometry::length(curve);
  const Point before = leadscrew::geometry::evaluate(curve, DoubleDouble(length, -length * 1e-20));
  const Point& end = leadscrew::geometry::end(curve);
  for (std::size_t i = 0; i < end.size(); ++i) RC_ASSERT(std::abs(before[i] - end[i]) <= 2.3e-13);
}

RC_GTEST_PROP(Curves, JetsAreDerivativesOfOneAnother, ()) {
  // The k-th derivative is the fourth-order central difference of the one before; the first, of positions.
  const Curve curve = random_curve();
  const double length = leadscrew::geometry::length(curve);
  const double s = length * *rc::gen::inRange(10, 91) / 100.0;
  const auto* arc = std::get_if<Arc>(&curve);
  const double h = arc ? std::min(0.01 / std::abs(arc->angle_rate()), length / 50) : length / 50;
  const auto jet_at = [&](int k) { return leadscrew::geometry::jets(curve, s + k * h); };
  const PointJet here = jet_at(0), one = jet_at(1), two = jet_at(2), back = jet_at(-1), back_two = jet_at(-2);
  for (std::size_t i = 0; i < here.size(); ++i) {
    const auto slope = [&](double leadscrew::numeric::Jet<>::* member) {
      return (8 * (one[i].*member - back[i].*member) - (two[i].*member - back_two[i].*member)) / (12 * h);
    };
    using leadscrew::numeric::Jet;
    const double scale = 1e-7 * (1 + std::abs(here[i].first));
    const double rate = arc ? 1 + std::abs(arc->angle_rate()) : 1;
    RC_ASSERT(std::abs(slope(&Jet<>::value) - here[i].first) <= scale + 1e-12 * 1000 / h);
    RC_ASSERT(std::abs(slope(&Jet<>::first) - here[i].second) <= scale * rate);
    RC_ASSERT(std::abs(slope(&Jet<>::second) - here[i].third) <= scale * rate * rate);
    RC_ASSERT(std::abs(here[i].value - leadscrew::geometry::evaluate(curve, s)[i]) <= 1e-11);
  }
}

RC_GTEST_PROP(Curves, HavePartsThatAreThemselves, ()) {
  const Curve curve = random_curve();
  const double length = leadscrew::geometry::length(curve);
  const double from = length * *rc::gen::inRange(0, 900) / 1000.0;
  const double to = from + (length - from) * *rc::gen::inRange(1, 1001) / 1000.0;
  const Curve part = leadscrew::geometry::part(curve, from, to);
  RC_ASSERT(leadscrew::geometry::length(part) == to - from);
  RC_ASSERT(leadscrew::geometry::start(part) == leadscrew::geometry::evaluate(curve, from));
  RC_ASSERT(leadscrew::geometry::end(part) == leadscrew::geometry::evaluate(curve, to));
  const double s = (to - from) * *rc::gen::inRange(0, 1001) / 1000.0;
  const Point here = leadscrew::geometry::evaluate(part, s);
  const Point there = leadscrew::geometry::evaluate(curve, DoubleDouble(from) + DoubleDouble(s));
  const PointJet of_part = leadscrew::geometry::jets(part, s), whole = leadscrew::geometry::jets(curve, from + s);
  for (std::size_t i = 0; i < here.size(); ++i) {
    RC_ASSERT(std::abs(here[i] - there[i]) <= 2e-12);
    RC_ASSERT(std::abs(of_part[i].first - whole[i].first) <= 1e-12 + 1e-12 / (to - from));
    RC_ASSERT(std::abs(of_part[i].second - whole[i].second) <= 1e-9 * (1 + std::abs(whole[i].second)));
  }
}

RC_GTEST_PROP(Lines, AreRoundedOnce, ()) {
  // Extended precision (64 bits) judges: the nearest double, or one of two that are equally near.
  const Curve curve = random_line();
  const Line& line = std::get<Line>(curve);
  const double s = line.length() * *rc::gen::inRange(1, 1000000) / 1000000.0;
  const Point position = line.evaluate(s);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const long double exact = line.start()[i] + (static_cast<long double>(line.end()[i]) - line.start()[i]) *
                                                    (static_cast<long double>(s) / line.length());
    RC_ASSERT(std::abs(static_cast<double>(position[i] - exact)) <= 0.501 * ulp(position[i]) + 1e-16);
  }
}

RC_GTEST_PROP(Arcs, AreWithinAUnitInTheLastPlace, ()) {
  const Curve curve = random_arc();
  const Arc& arc = std::get<Arc>(curve);
  const double s = arc.length() * *rc::gen::inRange(1, 1000000) / 1000000.0;
  const Point position = arc.evaluate(s);
  const std::size_t first = arc.first(), second = arc.second();
  // The circle itself: the distance from the centre stays the radius. The centre is found back from the jet: q″ = −ω²(q
  // − c).
  const PointJet jet = arc.jets(s);
  const long double w2 = static_cast<long double>(arc.angle_rate()) * arc.angle_rate();
  const double center_first = static_cast<double>(jet[first].value + jet[first].second / w2);
  const double center_second = static_cast<double>(jet[second].value + jet[second].second / w2);
  const double reach = std::max(std::abs(center_first), std::abs(center_second)) + arc.radius();
  RC_ASSERT(std::abs(std::hypot(position[first] - center_first, position[second] - center_second) - arc.radius()) <=
            8 * ulp(reach));
}

TEST(Arcs, MatchExtendedPrecision) {
  // A full circle about the origin from (R, 0): R cos θ, R sin θ in extended precision.
  const double radius = 10;
  Point start{};
  start[0] = radius;
  const DoubleDouble sweep = leadscrew::geometry::sweep_angle(radius, 0, radius, 0, 1);
  const Arc arc(start, start, 0, 1, 0, 0, sweep, Arc::helix_length(radius, sweep, 0));
  for (int k = 1; k < 20000; ++k) {
    const double s = arc.length() * k / 20000;
    const long double angle =
        static_cast<long double>(s) * (sweep.hi + static_cast<long double>(sweep.lo)) / arc.length();
    const Point position = arc.evaluate(s);
    ASSERT_NEAR(position[0], static_cast<double>(radius * std::cos(angle)), ulp(radius));
    ASSERT_NEAR(position[1], static_cast<double>(radius * std::sin(angle)), ulp(radius));
  }
}

TEST(SweepAngle, CountsTurnsAndDirections) {
  const double pi = std::acos(-1.0);
  const auto sweep = [](double x0, double y0, double x1, double y1, int turns) {
    return leadscrew::geometry::sweep_angle(x0, y0, x1, y1, turns).value();
  };
  EXPECT_DOUBLE_EQ(sweep(1, 0, 0, 1, 1), pi / 2);
  EXPECT_DOUBLE_EQ(sweep(1, 0, 0, 1, -1), -3 * pi / 2);
  EXPECT_DOUBLE_EQ(sweep(1, 0, 0, 1, 3), pi / 2 + 4 * pi);
  EXPECT_DOUBLE_EQ(sweep(1, 0, 0, 1, -2), -3 * pi / 2 - 2 * pi);
  EXPECT_DOUBLE_EQ(sweep(1, 0, 1, 0, 1), 2 * pi);
  EXPECT_DOUBLE_EQ(sweep(1, 0, 1, 0, -2), -4 * pi);
  EXPECT_DOUBLE_EQ(sweep(1, 0, -1, 0, 1), pi);
  EXPECT_DOUBLE_EQ(sweep(1, 0, -1, 0, -1), -pi);
}

}  // namespace test_curves
