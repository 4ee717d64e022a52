// The solid of a tool, and where lines enter it, against points tried one by one; surfaces against those of the passes.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <numbers>
#include <random>

#include "../surfaces/patches.hpp"
#include "hand_passes.hpp"

namespace leadscrew::measuring {
namespace test_swept_tool {

std::mt19937 numbers(24);
double between(double least, double greatest) {
  return std::uniform_real_distribution<double>(least, greatest)(numbers);
}

Vector unit() {
  while (true) {
    Vector v = {between(-1, 1), between(-1, 1), between(-1, 1)};
    const double length = numeric::norm(v);
    if (length < 0.1 || length > 1) continue;
    for (double& c : v) c /= length;
    return v;
  }
}

/// Is a point in the tool, by its definition: within r of the cylinder?
bool is_inside(const ToolBody& body, const ToolPose& pose, const Vector& point) {
  const Vector q = numeric::difference(point, pose.tip);
  const double z = numeric::dot(q, pose.axis);
  if (z > body.length) return false;
  const double radial = numeric::norm(numeric::sum(q, -z, pose.axis)), flat = body.radius - body.corner_radius;
  const double up = std::max(0.0, body.corner_radius - z), out = std::max(0.0, radial - flat);
  if (body.corner_radius == 0) return z >= 0 && radial <= flat;
  return out * out + up * up <= body.corner_radius * body.corner_radius;
}

TEST(SweptTool, IsEnteredWherePointsOfTheLineFirstAreInside) {
  int entered = 0, cuts = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double radius = between(0.5, 6), shape = between(0, 3);
    const ToolBody body{radius,
                        shape < 1   ? 0
                        : shape < 2 ? radius
                                    : between(0.1, 0.9) * radius,
                        trial % 2 == 0 ? 30 : 1e300};
    const ToolPose from{{0, 0, 0}, unit()};
    const Vector travel = unit(), turn = unit();
    const double far = between(0, 0.1), turned = trial % 3 == 0 ? between(0, 0.002) : 0;
    ToolPose to{numeric::sum(from.tip, far, travel), numeric::sum(from.axis, turned, turn)};
    const double length = numeric::norm(to.axis);
    for (double& c : to.axis) c /= length;
    // A line near the tool's surface, from outside more often than not.
    const Vector n = unit();
    Vector s = numeric::sum(numeric::sum(from.tip, between(0, radius), from.axis), between(0.8, 1.3) * radius, unit());
    const SweptTool tool(body, from, to);
    const double above = 1, found = tool.entry(s, n, deepest_of(body), above);

    // By brute force: the first inside among many points of many poses.
    const int poses = 40, points = 2000;
    double least = above;
    int holding = 0;  // poses in which the tool holds s
    for (int k = 0; k <= poses; ++k) {
      const double w = static_cast<double>(k) / poses;
      ToolPose pose{numeric::sum(from.tip, w * far, travel), numeric::sum(from.axis, w * turned, turn)};
      const double size = numeric::norm(pose.axis);
      for (double& c : pose.axis) c /= size;
      const bool here = is_inside(body, pose, s);
      holding += here;
      const double start = here ? deepest_of(body) : 0;
      for (int i = 0; i <= points; ++i) {
        const double t = start + (least - start) * i / points;
        if (t >= least || !is_inside(body, pose, numeric::sum(s, t, n))) continue;
        least = t;
        break;
      }
    }
    if (holding > 0 && holding <= poses) continue;  // it comes over s on its way: somewhere between cut and not
    const double coarse = (1 - deepest_of(body)) / points + 1e-4;
    EXPECT_LE(found, least + 1e-6) << trial;
    EXPECT_GE(found, least - coarse) << trial;
    entered += found < above, cuts += found < 0;
    if (found < above && found > deepest_of(body)) {
      EXPECT_TRUE(tool.may_enter(s, n, above)) << trial;
    }
  }
  EXPECT_GT(entered, 75);
  EXPECT_GT(cuts, 25);
}

TEST(SweptTool, HasADistanceThatIsConvexAndItsGradient) {
  for (int trial = 0; trial < 300; ++trial) {
    const double radius = between(0.5, 6);
    const ToolBody body{radius, trial % 3 == 0 ? radius : trial % 3 == 1 ? 0 : radius / 3, trial % 2 == 0 ? 12 : 1e300};
    const ToolPose pose{{1, 2, 3}, unit()};
    const Vector a = numeric::sum(pose.tip, between(0, 15), unit()), b = numeric::sum(pose.tip, between(0, 15), unit());
    const Distance at_a = distance_to(body, pose, a), at_b = distance_to(body, pose, b);
    const Distance middle = distance_to(body, pose, numeric::sum(a, 0.5, numeric::difference(b, a)));
    EXPECT_LE(middle.value, (at_a.value + at_b.value) / 2 + 1e-12);
    EXPECT_GE(at_b.value, at_a.value + numeric::dot(at_a.gradient, numeric::difference(b, a)) - 1e-12) << trial;
    EXPECT_EQ(at_a.value <= 0, is_inside(body, pose, a)) << trial;
  }
}

TEST(Net, IsTheSurfaceThatPassesAreMadeOn) {
  for (const surfaces::SurfaceForm& form :
       {surfaces::test::patch_a(), surfaces::test::sphere(50), surfaces::test::cylinder(8, 30)}) {
    const surfaces::Surface surface(form);
    for (int trial = 0; trial < 100; ++trial) {
      const double u = trial == 0 ? 0 : trial == 1 ? 1 : between(0, 1), v = trial == 2 ? 1 : between(0, 1);
      const surfaces::SurfaceJet jet = surface.jet(u, v);
      const surfaces::Frame frame = *surfaces::frame_of(jet, 1);
      const SurfacePlace place = Net(form, 1).at(u, v), other = Net(form, -1).at(u, v);
      EXPECT_LT(numeric::distance(place.s, jet.s), 1e-12);
      EXPECT_LT(numeric::distance(place.n, frame.n), 1e-12);
      EXPECT_LT(numeric::norm(numeric::sum(place.n, 1, other.n)), 1e-15);
      EXPECT_NEAR(place.area, std::sqrt(frame.E * frame.G - frame.F * frame.F), 1e-9 * place.area);
    }
  }
}

TEST(Net, IsRightAcrossKnotsOfAnyMultiplicity) {
  surfaces::SurfaceForm form{{3, 2}, {}, {7, 5}, {}};
  form.knots[0] = {0, 0, 0, 0, 0.2, 0.5, 0.5, 1, 1, 1, 1};
  form.knots[1] = {0, 0, 0, 0.3, 0.3, 1, 1, 1};
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 7; ++i)
      form.net.push_back(
          {{10.0 * static_cast<double>(i), 10.0 * static_cast<double>(j), between(-3, 3)}, between(0.5, 2)});
  }
  const surfaces::Surface surface(form);
  for (const double u : {0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0}) {
    for (const double v : {0.0, 0.15, 0.3, 0.8, 1.0})
      EXPECT_LT(numeric::distance(Net(form, 1).at(u, v).s, surface.at(u, v)), 1e-12);
  }
}

TEST(WordPath, FollowsACircleBetweenItsWords) {
  // 60 words a turn at a radius of 20 mm: chords of 2.1 mm, 27 µm off.
  double chord = 0, off = 0;
  std::size_t steps = 0;
  const WordPath::Sink sink = [&](const WordStep& step) {
    ++steps;
    chord = std::max(chord, step.chord);
    const Vector& tip = step.tool.from().tip;
    off = std::max(off, std::abs(std::hypot(tip[0], tip[1]) - 20));
  };
  WordPath path;
  for (int k = 0; k <= 60; ++k) {
    const double angle = 2 * std::numbers::pi * k / 60;
    path.add({{20 * std::cos(angle), 20 * std::sin(angle), 0}, {0, 0, 1}}, {1, 1}, {k}, k > 0, sink);
  }
  path.end(sink);
  EXPECT_LT(off, 1e-4) << "chords alone would be 0.027 off";
  EXPECT_GT(steps, 600);
  EXPECT_LT(steps, 1000);
  EXPECT_GT(chord, 1e-5) << "the first way and the last have one neighbour only";
}

TEST(WordPath, GoesStraightAtACornerAndNotAcrossABreak) {
  double longest = 0;
  std::size_t steps = 0;
  const WordPath::Sink sink = [&](const WordStep& step) {
    ++steps;
    longest = std::max(longest, step.tool.least_distance({0, 0, 0}).value);
  };
  WordPath path;
  const std::vector<Vector> tips = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}};
  for (std::size_t k = 0; k < tips.size(); ++k)
    path.add({tips[k], {0, 0, 1}}, {1, 1}, {static_cast<std::int64_t>(k)}, k != 3, sink);
  path.end(sink);
  EXPECT_EQ(steps, 5) << "two words where something begins, and three ways";
}

}  // namespace test_swept_tool
}  // namespace leadscrew::measuring
