// Distances from ellipses: closed forms on the axes and along normals, and points of the ellipse by brute force.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/nc/ellipse_distance.hpp>
#include <numbers>

namespace leadscrew::nc {
namespace test_ellipse_distance {

/// Far out along the axes; inside, on the longer one, the foot leaves the axis at the centre of curvature.
TEST(EllipseDistance, OnTheAxesIsClosed) {
  EXPECT_DOUBLE_EQ(foot_on_ellipse(10, 4, 13, 0).distance, 3);
  EXPECT_DOUBLE_EQ(foot_on_ellipse(10, 4, 0, -9).distance, 5);
  EXPECT_DOUBLE_EQ(foot_on_ellipse(10, 4, 0, 0).distance, -4);
  EXPECT_DOUBLE_EQ(foot_on_ellipse(10, 4, 9, 0).distance, -1);
  // Nearer to the middle than (a² − b²)/a = 8.4: b √(1 − x²/(a² − b²)).
  EXPECT_NEAR(foot_on_ellipse(10, 4, -6, 0).distance, -4 * std::sqrt(1 - 36.0 / 84), 1e-14);
  EXPECT_NEAR(foot_on_ellipse(4, 10, 0, 6).distance, -4 * std::sqrt(1 - 36.0 / 84), 1e-14);
}

/// A place that was set off along the normal, inward no farther than to the longer axis, has its foot where it began.
TEST(EllipseDistance, FindsTheFootOfANormal) {
  for (const auto& [a, b] : {std::pair{10.0, 4.0}, {3.0, 200.0}, {1e6, 7e5}, {50.0, 50.0}, {1e9, 1.0}}) {
    for (int i = 0; i <= 60; ++i) {
      const double angle = 2 * std::numbers::pi * i / 60;
      const double u = a * std::cos(angle), v = b * std::sin(angle);
      const double normal_x = std::cos(angle) * b, normal_y = std::sin(angle) * a;
      const double length = std::hypot(normal_x, normal_y), to_axis = std::min(a, b) / std::max(a, b) * length;
      for (const double off : {2.0, 0.3, -0.9 * std::min(1.0, to_axis)}) {
        const EllipseFoot foot = foot_on_ellipse(a, b, u + off * normal_x / length, v + off * normal_y / length);
        const double close = 1e-13 * std::max(a, b) + 1e-12;
        EXPECT_NEAR(foot.distance, off, close) << a << ' ' << b << " at " << i;
      }
    }
  }
}

TEST(EllipseDistance, IsThatOfTheNearestPoint) {
  for (const auto& [a, b] : {std::pair{7.0, 4.0}, {2.0, 9.0}, {12.0, 1.0}}) {
    for (double x = -a - 2; x <= a + 2; x += 1.7) {
      for (double y = -b - 2; y <= b + 2; y += 1.3) {
        const auto from = [&](double angle) { return std::hypot(a * std::cos(angle) - x, b * std::sin(angle) - y); };
        double width = 2 * std::numbers::pi / 2000, best = 0;
        for (int i = 1; i < 2000; ++i) best = from(width * i) < from(best) ? width * i : best;
        for (; width > 1e-9; width /= 2) {
          for (const double tried : {best - width, best + width}) best = from(tried) < from(best) ? tried : best;
        }
        const double least = from(best);
        EXPECT_NEAR(std::abs(foot_on_ellipse(a, b, x, y).distance), least, 1e-12)
            << a << ' ' << b << ": " << x << ' ' << y;
      }
    }
  }
}

}  // namespace test_ellipse_distance
}  // namespace leadscrew::nc
