// Ellipses by the integrators of circles: the circle among them, distances by brute force, every quadrant and direction.

#include <gtest/gtest.h>

#include <leadscrew/pulse/elliptic_dda.hpp>
#include <numbers>
#include <vector>

#include "lattice_arcs.hpp"
#include "tracing.hpp"

namespace leadscrew::pulse::testing {
namespace test_ellipse {

constexpr std::array all_orders = {Order::parallel, Order::x_first, Order::shrinking_first, Order::growing_first};
constexpr std::array all_preloads = {Preload::none, Preload::half, Preload::half_lagging, Preload::full,
                                     Preload::minus_one};
constexpr std::array both_ways = {Direction::clockwise, Direction::counterclockwise};

template <typename Take>
void each_convention(const Take& take) {
  for (const Order order : all_orders) {
    for (const Preload preload : all_preloads) take(CircularDdaOptions{order, preload});
  }
}

/// From the ellipse, by points of it that lie ever closer together.
double distance(SemiAxes axes, Point at) {
  const double a = static_cast<double>(axes.x), b = static_cast<double>(axes.y);
  const double x = static_cast<double>(absolute(at.x)), y = static_cast<double>(absolute(at.y));
  const auto from = [&](double angle) { return std::hypot(a * std::cos(angle) - x, b * std::sin(angle) - y); };
  constexpr int parts = 32;
  double width = std::numbers::pi / 2 / parts, best = 0;
  for (int i = 1; i <= parts; ++i) best = from(width * i) < from(best) ? width * i : best;
  for (; width > 1e-5; width /= 2) {
    for (const double tried : {best - width, best + width}) best = from(tried) < from(best) ? tried : best;
  }
  return from(best);
}

Trace trace_ellipse(SemiAxes axes, const Arc& arc, CircularDdaOptions options) {
  return trace(EllipticDda(arc, axes, options), arc.start, arc.end, 20 * axes.longer() + 100,
               [&](Point at) { return distance(axes, at); });
}

TEST(Ellipse, WithEqualAxesIsTheCircleClockByClock) {
  testing_support::each_lattice_arc(13, [](const Arc& arc) {
    const std::int64_t radius = root(arc.squared_radius(), 0);
    if (radius * radius != arc.squared_radius()) return;
    each_convention([&](CircularDdaOptions options) {
      for (const std::int32_t capacity : {0, 16}) {
        options.capacity = capacity;
        CircularDda circle(arc, options);
        EllipticDda ellipse(arc, {radius, radius}, options);
        while (!circle.done()) {
          ASSERT_EQ(ellipse.x().integrator.remainder(), circle.x().remainder());
          ASSERT_EQ(ellipse.y().left, circle.left_y());
          ASSERT_EQ(ellipse.step(), circle.step());
          ASSERT_EQ(ellipse.in_quadrant(), circle.in_quadrant());
        }
        ASSERT_TRUE(ellipse.done());
      }
    });
  });
}

/// A quarter from (a, 0) to (0, b), x before y and half full, with a²y and b²x against q·a·b: common divisors change no
/// pulse.
TEST(Ellipse, InLowestTermsHasThePulsesOfAllTerms) {
  for (std::int64_t a = 1; a <= 30; ++a) {
    for (std::int64_t b = 1; b <= 30; ++b) {
      EllipticDda ellipse({{a, 0}, {0, b}, Direction::counterclockwise}, {a, b}, {Order::x_first, Preload::half});
      const SemiAxes least = SemiAxes{a, b}.lowest_terms();
      const std::int64_t capacity = std::max(a, b) * a * b, common = a * b / (least.x * least.y);
      std::int64_t x = a, y = 0, of_x = capacity / common / 2 * common, of_y = of_x;
      while (x > 0 || y < b) {
        Pulse<2> expected;
        if (x > 0) of_x += a * a * y;
        if (x > 0 && of_x >= capacity) {
          of_x -= capacity;
          --x;
          expected.step[0] = -1;
        }
        if (y < b) of_y += b * b * x;
        if (y < b &&
            (of_y >= capacity || (x == 0 && expected.step[0] == 0))) {  // the latter: nothing is added any more
          of_y -= capacity;
          ++y;
          expected.step[1] = 1;
        }
        ASSERT_EQ(ellipse.step(), expected) << a << ' ' << b << " at " << x << ' ' << y;
      }
      ASSERT_TRUE(ellipse.done());
    }
  }
}

/// Where q is far more than the axes, the place after n clocks is that at the angle n/q.
TEST(Ellipse, FollowsTheAngle) {
  for (const SemiAxes axes : {SemiAxes{60, 25}, {17, 40}, {100, 99}, {80, 9}}) {
    for (const Direction direction : both_ways) {
      const double sense = static_cast<double>(direction);
      const std::int32_t capacity = 1 << 20;
      EllipticDda ellipse({{axes.x, 0}, {axes.x, 0}, direction}, axes, {Order::x_first, Preload::half, 0, capacity});
      for (std::int64_t clock = 1; !ellipse.done(); ++clock) {
        ellipse.step();
        const double angle = sense * static_cast<double>(clock) / capacity;
        if (clock % 997 != 0 || std::abs(angle) > 1.4) continue;  // at a border it waits for its counters
        ASSERT_NEAR(static_cast<double>(ellipse.at().x), static_cast<double>(axes.x) * std::cos(angle), 0.75);
        ASSERT_NEAR(static_cast<double>(ellipse.at().y), static_cast<double>(axes.y) * std::sin(angle), 0.75);
      }
    }
  }
}

struct Bound {
  Order order;
  Preload preload;
  double least, greatest;  ///< of the greatest error of all ellipses, BLU
};

/// Every ellipse with semi-axes to 20, both ways, from each of its ends.
TEST(Ellipse, KeepsItsBoundWholeAndInEveryQuadrant) {
  for (const auto& [order, preload, least, greatest] :
       {Bound{Order::parallel, Preload::half, 1.15, 1.29}, Bound{Order::x_first, Preload::half, 0.9, 0.98},
        Bound{Order::shrinking_first, Preload::half, 0.9, 0.98}, Bound{Order::growing_first, Preload::half, 0.9, 0.98},
        Bound{Order::x_first, Preload::none, 1.4, 2.0}}) {
    double worst = 0;
    for (std::int64_t a = 1; a <= 20; ++a) {
      for (std::int64_t b = 1; b <= 20; ++b) {
        for (const Point end : {Point{a, 0}, {0, b}, {-a, 0}, {0, -b}}) {
          for (const Direction direction : both_ways) {
            const Trace trace = trace_ellipse({a, b}, {end, end, direction}, {order, preload});
            ASSERT_TRUE(trace.ends) << a << ' ' << b;
            worst = std::max(worst, trace.worst);
          }
        }
      }
    }
    EXPECT_LT(worst, greatest) << static_cast<int>(order) << ' ' << static_cast<int>(preload);
    EXPECT_GT(worst, least) << static_cast<int>(order) << ' ' << static_cast<int>(preload);
  }
}

/// The places within half a BLU of it.
std::vector<Point> places_beside(SemiAxes axes) {
  std::vector<Point> places;
  for (std::int64_t x = -axes.x; x <= axes.x; ++x) {
    for (std::int64_t y = -axes.y; y <= axes.y; ++y) {
      if (distance(axes, {x, y}) <= 0.5 && Point{x, y} != Point{}) places.push_back({x, y});
    }
  }
  return places;
}

TEST(Ellipse, EndsAtEveryPlaceBesideIt) {
  for (const SemiAxes axes : {SemiAxes{7, 4}, {5, 9}, {12, 1}, {1, 6}}) {
    const std::vector<Point> places = places_beside(axes);
    for (const Point start : places) {
      for (const Point end : places) {
        for (const Direction direction : both_ways) {
          each_convention([&](CircularDdaOptions options) {
            EllipticDda ellipse({start, end, direction}, axes, options);
            Point at = start;
            std::int64_t clocks = 0;
            for (; !ellipse.done() && clocks < 400; ++clocks) {
              const auto [x, y] = ellipse.step().step;
              at = {at.x + x, at.y + y};
              ASSERT_EQ(at, ellipse.at());
            }
            ASSERT_TRUE(ellipse.done()) << axes.x << ' ' << axes.y << ": " << start.x << ' ' << start.y;
            ASSERT_EQ(at, end);
          });
        }
      }
    }
  }
}

/// Mirrored at an axis it goes the other way round; with axes that are exchanged, registers clocked together do not tell.
TEST(Ellipse, IsItsMirrorImage) {
  for (const SemiAxes axes : {SemiAxes{30, 11}, {8, 21}}) {
    each_convention([&](CircularDdaOptions options) {
      EllipticDda one({{axes.x, 0}, {axes.x, 0}, Direction::counterclockwise}, axes, options);
      EllipticDda mirrored({{-axes.x, 0}, {-axes.x, 0}, Direction::clockwise}, axes, options);
      EllipticDda below({{axes.x, 0}, {axes.x, 0}, Direction::clockwise}, axes, options);
      EllipticDda exchanged({{0, axes.x}, {0, axes.x}, Direction::clockwise}, {axes.y, axes.x}, options);
      while (!one.done()) {
        const auto [x, y] = one.step().step;
        const auto minus = [](std::int8_t step) { return static_cast<std::int8_t>(-step); };
        ASSERT_EQ(mirrored.step(), (Pulse<2>{{minus(x), y}}));
        ASSERT_EQ(below.step(), (Pulse<2>{{x, minus(y)}}));
        if (options.order != Order::x_first) {
          ASSERT_EQ(exchanged.step(), (Pulse<2>{{y, x}}));
        }
      }
    });
  }
}

}  // namespace test_ellipse
}  // namespace leadscrew::pulse::testing
