#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/geometry/curve.hpp>
#include <numbers>

#include "nurbs_forms.hpp"

namespace leadscrew::geometry::testing {
namespace test_moved {

/// About Z, then Y, then X, radians, and a shift.
RigidMotion motion_by(const std::array<double, 3>& angles, const std::array<double, 3>& shift) {
  RigidMotion motion{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (const std::size_t about : {2u, 1u, 0u}) {
    const std::size_t i = (about + 1) % 3, j = (about + 2) % 3;
    // Quarter turns are exact.
    const double quarters = angles[about] / (std::numbers::pi / 2);
    const bool is_quarter = quarters == std::round(quarters);
    const double c = is_quarter ? std::round(std::cos(angles[about])) : std::cos(angles[about]);
    const double s = is_quarter ? std::round(std::sin(angles[about])) : std::sin(angles[about]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = motion.rotation[i][k], b = motion.rotation[j][k];
      motion.rotation[i][k] = c * a - s * b;
      motion.rotation[j][k] = s * a + c * b;
    }
  }
  motion.place = [rotation = motion.rotation, shift](const Point& point) {
    Point placed = point;
    for (std::size_t i = 0; i < 3; ++i) {
      placed[i] = shift[i];
      for (std::size_t k = 0; k < 3; ++k) placed[i] += rotation[i][k] * point[k];
    }
    return placed;
  };
  return motion;
}

double random_angle() {
  return *rc::gen::arbitrary<bool>() ? *rc::gen::inRange(-4, 5) * (std::numbers::pi / 2)
                                     : *rc::gen::inRange(-6000, 6001) / 1e3;
}
RigidMotion random_motion() {
  const std::array<double, 3> angles = {random_angle(), random_angle(), random_angle()};
  return motion_by(angles, {*rc::gen::inRange(-500, 501) / 1.0, *rc::gen::inRange(-500, 501) / 1.0, 20});
}

double squared(double x) {
  return x * x;
}

double cubed(double x) {
  return x * x * x;
}

/// Positions and derivatives, derivatives in their own sizes. Moved points are rounded where they lie, up to 1000 farther off:
/// differences of them lose the more, the shorter the intervals are over which they are taken.
void expect_same(const Curve& curve, const Curve& moved, const RigidMotion& motion, double size,
                 std::size_t intervals) {
  RC_ASSERT(length(moved) == length(curve));
  RC_ASSERT(start(moved) == motion.place(start(curve)));
  RC_ASSERT(end(moved) == motion.place(end(curve)));
  std::array<double, 4> largest{};
  const double rounding = 1e-13 * (size + 1000), interval = length(curve) / static_cast<double>(intervals);
  for (int k = 0; k <= 20; ++k) {
    for (const auto& q : jets(curve, length(curve) * k / 20)) {
      largest[1] = std::max(largest[1], std::abs(q.first));
      largest[2] = std::max(largest[2], std::abs(q.second));
      largest[3] = std::max(largest[3], std::abs(q.third));
    }
  }
  for (int k = 0; k <= 20; ++k) {
    const double s = length(curve) * k / 20;
    const PointJet before = jets(curve, s), after = jets(moved, s);
    const Point placed = motion.place(evaluate(curve, s)), position = evaluate(moved, s);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      RC_ASSERT(std::abs(position[i] - placed[i]) < 1e-14 * (size + 1000));
      std::array<double, 4> turned = {0, before[i].first, before[i].second, before[i].third};
      for (std::size_t j = 0; i < 3 && j < 3; ++j) {
        if (j == 0) turned = {};
        turned[1] += motion.rotation[i][j] * before[j].first;
        turned[2] += motion.rotation[i][j] * before[j].second;
        turned[3] += motion.rotation[i][j] * before[j].third;
      }
      RC_ASSERT(std::abs(after[i].first - turned[1]) <= 1e-12 * largest[1]);
      RC_ASSERT(std::abs(after[i].second - turned[2]) <= 1e-8 * largest[2] + rounding * (1 + 1 / squared(interval)));
      RC_ASSERT(std::abs(after[i].third - turned[3]) <= 1e-6 * largest[3] + rounding * (1 + 1 / cubed(interval)));
    }
  }
  RC_ASSERT(std::ranges::equal(breaks(moved), breaks(curve)));
}

RC_GTEST_PROP(MovedCurves, OfNurbsAreTurnedEverywhere, ()) {
  const NurbsForm form = random_form();
  const RigidMotion motion = random_motion();
  double size = 0;
  for (const Point& point : form.points) {
    for (const double x : point) size = std::max(size, std::abs(x));
  }
  for (const Nurbs& piece : smooth_pieces(form)) {
    const auto moved_piece = moved(piece, motion);
    RC_ASSERT(moved_piece.has_value());
    expect_same(piece, *moved_piece, motion, size, form.points.size());
    // A part of what was moved is what was moved of a part.
    const double from = piece.length() / 3, to = piece.length() * 0.9;
    const Point expected = motion.place(evaluate(part(piece, from, to), 0));
    const Point found = evaluate(part(*moved_piece, from, to), 0);
    for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(std::abs(found[i] - expected[i]) < 1e-14 * (size + 1000));
  }
}

RC_GTEST_PROP(MovedCurves, OfLinesAreLines, ()) {
  Point begin{}, end{};
  for (std::size_t i = 0; i < 9; ++i) {
    begin[i] = *rc::gen::inRange(-100, 101);
    end[i] = *rc::gen::inRange(-100, 101) + 0.5;
  }
  const RigidMotion motion = random_motion();
  const Line line(begin, end, 100);
  const auto moved_line = moved(line, motion);
  RC_ASSERT(moved_line && std::holds_alternative<Line>(*moved_line));
  expect_same(line, *moved_line, motion, 100, 1);
}

/// Every plane, helices too, by quarter turns about all axes and any turn about the normal.
RC_GTEST_PROP(MovedCurves, OfArcsAreArcsInThePlanesOfAxes, ()) {
  const std::size_t first = *rc::gen::inRange<std::size_t>(0, 3);
  const std::size_t second = (first + *rc::gen::inRange<std::size_t>(1, 3)) % 3, normal = 3 - first - second;
  const double radius = *rc::gen::inRange(1, 100), begin = *rc::gen::inRange(-300, 300) / 100.0;
  const double sweep = *rc::gen::inRange(1, 900) * (*rc::gen::arbitrary<bool>() ? 0.01 : -0.01);
  Point start{}, end{};
  start[normal] = 3;
  end[normal] = *rc::gen::element(3, 9);
  end[6] = 4;
  start[first] = 5 + radius * std::cos(begin);
  start[second] = -7 + radius * std::sin(begin);
  end[first] = 5 + radius * std::cos(begin + sweep);
  end[second] = -7 + radius * std::sin(begin + sweep);
  const Arc arc(start, end, first, second, 5, -7, sweep, Arc::helix_length(radius, sweep, end[normal] - 3));

  std::array<double, 3> angles{};
  for (double& angle : angles) angle = *rc::gen::inRange(-4, 5) * (std::numbers::pi / 2);
  const bool about_normal = *rc::gen::arbitrary<bool>();
  if (about_normal) {
    angles = {};
    angles[normal] = random_angle();
  }
  const RigidMotion motion = motion_by(angles, {10, -200, 3});
  const auto moved_arc = moved(arc, motion);
  RC_ASSERT(moved_arc && std::holds_alternative<Arc>(*moved_arc));
  expect_same(arc, *moved_arc, motion, 200, 1);
}

TEST(MovedCurves, AreNoneOfAnArcThatLiesAskew) {
  const Arc arc({1, 0, 0}, {0, 1, 0}, 0, 1, 0, 0, std::numbers::pi / 2, std::numbers::pi / 2);
  EXPECT_FALSE(moved(arc, motion_by({0.3, 0, 0}, {})));
  EXPECT_TRUE(moved(arc, motion_by({0, 0, 0.3}, {})));
  // Its plane is of other axes: they go on as they were.
  Point start{}, end{};
  start[3] = end[4] = 1;
  EXPECT_TRUE(
      moved(Arc(start, end, 3, 4, 0, 0, std::numbers::pi / 2, std::numbers::pi / 2), motion_by({0.3, 0, 0}, {})));
}

}  // namespace test_moved
}  // namespace leadscrew::geometry::testing
