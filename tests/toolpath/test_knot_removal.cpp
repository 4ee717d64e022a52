// Motions without the knots that they do not need, beside the motions themselves: by de Boor's recursion in long double.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/toolpath/knot_removal.hpp>
#include <random_numbers.hpp>

namespace leadscrew::toolpath::testing {
namespace test_knot_removal {

using testing_support::any;

/// The spline of order 4 − derivative at t, whose control points are differences of the given ones.
long double value_of(const SparseSpline& spline, std::size_t axis, int derivative, double t) {
  const auto knot = [&](std::ptrdiff_t k) -> long double {  // of point i are knots i to i + 4, so many before the first
    k -= 2;
    const auto last = static_cast<std::ptrdiff_t>(spline.knots.size()) - 1;
    if (k < 0) return spline.knots.front() + static_cast<double>(k);
    if (k > last) return spline.knots.back() + static_cast<double>(k - last);
    return spline.knots[static_cast<std::size_t>(k)];
  };
  std::size_t span = 3;
  while (span + 1 < spline.points.size() && knot(static_cast<std::ptrdiff_t>(span) + 1) <= t) ++span;
  std::array<long double, 4> d{};
  for (std::size_t i = 0; i < 4; ++i) d[i] = spline.points[span - 3 + i][axis];
  const auto first = static_cast<std::ptrdiff_t>(span) - 3;
  for (int k = 1; k <= derivative; ++k) {
    for (int i = 3; i >= k; --i) {
      const long double width = knot(first + i + 4 - k) - knot(first + i);
      d[static_cast<std::size_t>(i)] =
          (4 - k) * (d[static_cast<std::size_t>(i)] - d[static_cast<std::size_t>(i - 1)]) / width;
    }
  }
  for (int k = derivative + 1; k <= 3; ++k) {
    for (int i = 3; i >= k; --i) {
      const long double low = knot(first + i), high = knot(first + i + 4 - k);
      const long double share = (t - low) / (high - low);
      d[static_cast<std::size_t>(i)] =
          (1 - share) * d[static_cast<std::size_t>(i - 1)] + share * d[static_cast<std::size_t>(i)];
    }
  }
  return d[3];
}

SparseSpline all_of(const TimeSpline<3>& motion) {
  SparseSpline spline;
  for (std::size_t k = 0; k < motion.points.size(); ++k) {
    spline.knots.push_back(static_cast<double>(k) - 1);
    spline.points.push_back(motion.points[k]);
  }
  return spline;
}

/// From control points whose third differences are jerk in each interval.
TimeSpline<3> motion_of(const std::vector<Vector<3>>& jerk) {
  TimeSpline<3> motion;
  motion.interval = 1e-3;
  Vector<3> point{}, step{0.01, 0, 0}, bend{};
  motion.points = {point};
  for (const Vector<3>& j : jerk) {
    motion.points.push_back(point = along(point, 1, step));
    step = along(step, 1, bend);
    bend = along(bend, 1, j);
  }
  motion.points.push_back(point = along(point, 1, step));
  motion.points.push_back(along(point, 1, along(step, 1, bend)));
  return motion;
}

/// Jerk that is constant for long, jumps, and turns slowly.
std::vector<Vector<3>> random_jerk() {
  std::vector<Vector<3>> jerk;
  for (int part = any(1, 6); part > 0; --part) {
    const double size = 1e-7 * any(-1000, 1001), turn = any(0, 2) * 1e-4 * any(-1000, 1001), tilt = any(0, 100) / 50.0;
    for (int k = any(1, 200); k > 0; --k)
      jerk.push_back({size * std::cos(turn * k), size * std::sin(turn * k), size * tilt});
  }
  return jerk;
}

RC_GTEST_PROP(KnotRemoval, StaysNearTheMotion, ()) {
  const TimeSpline<3> motion = motion_of(random_jerk());
  const std::size_t n = motion.intervals();
  const auto first = static_cast<std::size_t>(any(0, static_cast<int>(n))),
             last = static_cast<std::size_t>(any(static_cast<int>(first) + 1, static_cast<int>(n) + 1));
  const double step = 1e-6 * any(1, 100);
  const Nearness near{std::pow(10.0, -any(3, 10)), {step, step, 2 * step}, 256};
  const SparseSpline spline = without_needless_knots(motion, first, last, near), full = all_of(motion);
  RC_ASSERT(spline.knots.size() == spline.points.size());
  RC_ASSERT(spline.knots[1] == static_cast<double>(first));
  RC_ASSERT(*(spline.knots.end() - 2) == static_cast<double>(last));
  for (std::size_t k = first; k < last; ++k) {
    for (const double share : {0.0, 0.2, 0.5, 0.8}) {
      const double t = static_cast<double>(k) + share;
      long double off = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto difference = [&](int derivative) {
          return std::abs(value_of(spline, axis, derivative, t) - value_of(full, axis, derivative, t));
        };
        off += difference(0) * difference(0);
        RC_ASSERT(difference(3) <= near.jerk_step[axis] * 1.001L);
      }
      RC_ASSERT(std::sqrt(off) <= near.tolerance * 1.02L + 1e-12L);
    }
  }
  for (const std::size_t end : {first, last}) {  // position and two derivatives
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int derivative = 0; derivative < 3; ++derivative) {
        const auto at = [&](const SparseSpline& of) {
          return value_of(of, axis, derivative, static_cast<double>(end));
        };
        RC_ASSERT(std::abs(at(spline) - at(full)) <=
                  1e-12L + 1e-14L * std::abs(value_of(full, axis, 0, static_cast<double>(end))));
      }
    }
  }
}

/// Jerk of the usual law from rest to rest: of its phases every knot is needed where they meet, and few between.
TEST(KnotRemoval, LeavesFewKnotsWhereJerkIsConstant) {
  std::vector<Vector<3>> jerk;
  for (const double phase : {1.0, -1.0, -1.0, 1.0}) jerk.insert(jerk.end(), 256, {phase * 1e-7, 0, 0});
  const TimeSpline<3> motion = motion_of(jerk);
  const SparseSpline spline = without_needless_knots(motion, 0, motion.intervals(), {1e-9, {1e-9, 1e-9, 1e-9}, 256});
  EXPECT_LT(spline.knots.size(), 80U);
  EXPECT_GT(spline.knots.size(), 4U);
}

/// No knot can go where jerk jumps at each.
TEST(KnotRemoval, LeavesKnotsThatAreNeeded) {
  std::vector<Vector<3>> jerk;
  for (int k = 0; k < 64; ++k) jerk.push_back({0, k % 2 == 0 ? 1e-6 : -1e-6, 0});
  const TimeSpline<3> motion = motion_of(jerk);
  const SparseSpline spline = without_needless_knots(motion, 0, motion.intervals(), {1e-3, {1e-8, 1e-8, 1e-8}, 256});
  ASSERT_EQ(spline.points.size(), motion.points.size());
  for (std::size_t k = 0; k < motion.points.size(); ++k)
    EXPECT_LE(size(between(spline.points[k], motion.points[k])), 1e-15);
}

}  // namespace test_knot_removal
}  // namespace leadscrew::toolpath::testing
