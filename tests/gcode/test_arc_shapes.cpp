// Arcs of random shape: what the reader says of them is what was written, and its circle passes through both ends.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/gcode/arc.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_arc_shapes {

constexpr double pi = std::numbers::pi;

double millimetres(int least, int most) {
  return *rc::gen::inRange(least, most) / 1000.0;
}

RC_GTEST_PROP(ArcByCentre, WithRoundedCoordinatesPassesThroughBothEnds, ()) {
  const double radius = millimetres(100, 200'000);
  const double from = millimetres(0, 6283), angle = millimetres(1, 6283);
  const int direction = *rc::gen::element(-1, 1);
  const PlanePoint center{millimetres(-200'000, 200'000), millimetres(-200'000, 200'000)};
  const auto rounded = [](double x) { return std::round(x * 1000) / 1000; };
  const PlanePoint start{rounded(center.first + radius * std::cos(from)),
                         rounded(center.second + radius * std::sin(from))};
  const PlanePoint end{rounded(center.first + radius * std::cos(from + direction * angle)),
                       rounded(center.second + radius * std::sin(from + direction * angle))};
  RC_PRE(start.first != end.first || start.second != end.second);
  const ArcCircle circle = circle_by_center(start, end, center, direction, 1, arc_tolerance(false));
  RC_ASSERT(circle.problem == ArcCircle::Problem::none);
  const double at_start = std::hypot(start.first - circle.center.first, start.second - circle.center.second);
  const double at_end = std::hypot(circle.end.first - circle.center.first, circle.end.second - circle.center.second);
  RC_ASSERT(std::fabs(at_start - at_end) < 16 * std::numeric_limits<double>::epsilon() * 500);
  // The middle of the arc stays where it was to within a few roundings.
  const double middle = from + direction * angle / 2;
  const double half = sweep(start, circle.end, circle.center, direction) / 2;
  const double a =
      std::atan2(start.second - circle.center.second, start.first - circle.center.first) + direction * half;
  const PlanePoint meant{center.first + radius * std::cos(middle), center.second + radius * std::sin(middle)};
  const PlanePoint found{circle.center.first + at_start * std::cos(a), circle.center.second + at_start * std::sin(a)};
  RC_ASSERT(std::hypot(meant.first - found.first, meant.second - found.second) < 0.006);
}

RC_GTEST_PROP(ArcByRadius, GivesTheSignedRadiusBack, ()) {
  const PlanePoint start{millimetres(-100'000, 100'000), millimetres(-100'000, 100'000)};
  const PlanePoint end{millimetres(-100'000, 100'000), millimetres(-100'000, 100'000)};
  const double half = std::hypot(end.first - start.first, end.second - start.second) / 2;
  RC_PRE(half > 0.01);
  const double size = half * (1.001 + millimetres(0, 3000));
  const int direction = *rc::gen::element(-1, 1);
  const bool is_long = *rc::gen::arbitrary<bool>();
  const ArcCircle circle = circle_by_radius(start, end, is_long ? -size : size, direction, arc_tolerance(false));
  RC_ASSERT(circle.problem == ArcCircle::Problem::none);
  RC_ASSERT(std::fabs(std::hypot(start.first - circle.center.first, start.second - circle.center.second) - size) <
            1e-12 * size);
  RC_ASSERT((sweep(start, end, circle.center, direction) > pi) == is_long);
}

RC_GTEST_PROP(ArcExtent, HoldsEveryPointOfTheArcAndNoMore, ()) {
  const double radius = millimetres(100, 100'000), from = millimetres(0, 6283), angle = millimetres(1, 6283);
  const int direction = *rc::gen::element(-1, 1);
  const PlanePoint start{radius * std::cos(from), radius * std::sin(from)};
  const PlanePoint end{radius * std::cos(from + direction * angle), radius * std::sin(from + direction * angle)};
  const PlaneBox box = arc_extent(start, end, {0, 0}, direction);
  PlaneBox seen{start, start};
  constexpr int count = 2000;
  for (int i = 0; i <= count; ++i) {
    const double a = from + direction * angle * i / count;
    seen.low.first = std::min(seen.low.first, radius * std::cos(a));
    seen.low.second = std::min(seen.low.second, radius * std::sin(a));
    seen.high.first = std::max(seen.high.first, radius * std::cos(a));
    seen.high.second = std::max(seen.high.second, radius * std::sin(a));
  }
  const double sag = radius * 1e-5;  // of the widest gap between the points
  const auto close = [&](double outer, double inner) { return outer - inner > -1e-9 && outer - inner < sag; };
  RC_ASSERT(close(box.high.first, seen.high.first));
  RC_ASSERT(close(box.high.second, seen.high.second));
  RC_ASSERT(close(-box.low.first, -seen.low.first));
  RC_ASSERT(close(-box.low.second, -seen.low.second));
}

}  // namespace test_arc_shapes
}  // namespace leadscrew::gcode
