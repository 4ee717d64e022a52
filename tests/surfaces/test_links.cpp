// Links between passes: clear of the surface, smooth, short.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/surfaces/tool_clearance.hpp>
#include <random>

#include "patches.hpp"
#include "ridges.hpp"

namespace leadscrew::surfaces {
namespace test_links {

std::vector<Pass> links_of(const Machining& machining) {
  std::vector<Pass> links;
  Passes passes(machining);
  while (std::optional<Pass> pass = passes.next()) {
    if (pass->is_link) links.push_back(*pass);
  }
  EXPECT_FALSE(passes.failure());
  return links;
}

Machining on_patch_a(const Cutter& cutter, const Orientation& orientation, Pattern pattern) {
  Machining machining;
  machining.surface = std::make_shared<Surface>(test::patch_a());
  machining.cutter = cutter;
  machining.orientation = orientation;
  machining.pattern = pattern;
  machining.scallop = 0.1;
  return machining;
}

const Orientation leaned = Orientation::leaning(0.3, 0.1);

/// The least distance of many points of the surface from the tool, at many places of the link.
double deepest(const Machining& machining, const Pass& link, const std::vector<Vector>& points) {
  double least = 1e300;
  for (int i = 0; i <= 60; ++i) {
    const double share = i < 20 ? 0.005 * i : i < 40 ? 0.1 + 0.04 * (i - 20) : 0.9 + 0.005 * (i - 40);
    const double t = share * link.nodes.back().t;
    const Vector tip = test::at(link, &PassNode::tip, t),
                 axis = kinematics::unit_vector(test::at(link, &PassNode::axis, t));
    for (const Vector& point : points) least = std::min(least, test::from_tool(machining.cutter, tip, axis, point));
  }
  return least;
}

TEST(Links, KeepOffTheWholeSurfaceWithinTheRangeAndBeyond) {
  for (const Pattern pattern : {Pattern::zigzag, Pattern::zig, Pattern::spiral_in}) {
    for (const Cutter& cutter : {Cutter{5, 5}, Cutter{5, 1}, Cutter{5, 0}}) {
      Machining machining = on_patch_a(cutter, leaned, pattern);
      machining.u = {0.2, 0.7};
      machining.v = {0.3, 0.8};
      std::vector<Vector> points;
      for (int i = 0; i <= 90; ++i) {
        for (int j = 0; j <= 90; ++j) points.push_back(machining.surface->at(i / 90.0, j / 90.0));
      }
      const std::vector<Pass> links = links_of(machining);
      ASSERT_GT(links.size(), 2u);
      for (std::size_t k = 0; k < links.size(); k += 5) EXPECT_GT(deepest(machining, links[k], points), -1e-6);
    }
  }
}

TEST(Links, AxesStayUnitVectorsAndTurnNoFartherThanFromEndToEnd) {
  for (const Pattern pattern : {Pattern::zigzag, Pattern::zig}) {
    const Machining machining = on_patch_a({5, 1}, leaned, pattern);
    for (const Pass& link : links_of(machining)) {
      const Vector from = test::at(link, &PassNode::axis, 0), to = test::at(link, &PassNode::axis, link.nodes.back().t);
      for (int i = 0; i <= 50; ++i) {
        const Vector axis = test::at(link, &PassNode::axis, link.nodes.back().t * i / 50);
        EXPECT_NEAR(numeric::norm(axis), 1, 1e-7);
        EXPECT_LE(kinematics::angle_between(from, axis), 1.3 * kinematics::angle_between(from, to) + 0.1);
      }
    }
  }
}

TEST(Links, NeverStandStill) {
  for (const Pattern pattern : {Pattern::zigzag, Pattern::zig}) {
    for (const Orientation& orientation : {Orientation{}, leaned}) {
      for (const Pass& link : links_of(on_patch_a({5, 5}, orientation, pattern))) {
        const double length = link.nodes.back().t, h = 1e-4 * length;
        for (int i = 1; i < 200; ++i) {
          const Vector a = test::at(link, &PassNode::tip, length * i / 200 - h),
                       b = test::at(link, &PassNode::tip, length * i / 200 + h);
          EXPECT_GT(numeric::distance(a, b) / (2 * h), 0.05) << "at " << i;
        }
      }
    }
  }
}

TEST(Links, OfNeighbouringPassesAreAFewStepsLong) {
  Machining machining = on_patch_a({5, 5}, {}, Pattern::zigzag);
  machining.scallop = 0.01;
  for (const Pass& link : links_of(machining)) {
    const Vector from = test::at(link, &PassNode::tip, 0), to = test::at(link, &PassNode::tip, link.nodes.back().t);
    EXPECT_LT(link.nodes.back().t, 6 * numeric::distance(from, to));
  }
}

/// Where the ball is nearly as round as the surface, the path of its centre is bent much more than the surface is.
TEST(Links, StayNearWhereTheBallIsNearlyAsRoundAsTheSurface) {
  for (const double radius : {20.0, 40.0, 45.0, 45.4, 45.44}) {
    for (const Pattern pattern : {Pattern::zigzag, Pattern::zig}) {
      for (const Direction along : {Direction::u, Direction::v}) {
        Machining machining = on_patch_a({radius, radius}, {}, pattern);
        machining.along = along;
        machining.scallop = 0;
        machining.step = 6;
        for (const Pass& link : links_of(machining)) {
          const double length = link.nodes.back().t;
          const Vector from = test::at(link, &PassNode::tip, 0), to = test::at(link, &PassNode::tip, length);
          double farthest = 0;
          for (int i = 1; i < 200; ++i) {
            const Vector tip = test::at(link, &PassNode::tip, length * i / 200);
            farthest = std::max(farthest, std::min(numeric::distance(tip, from), numeric::distance(tip, to)));
            const Vector next = test::at(link, &PassNode::tip, length * (i + 0.01) / 200);
            EXPECT_GT(numeric::distance(tip, next), 0.05 * 0.01 * length / 200);
          }
          EXPECT_LT(farthest, radius + numeric::distance(from, to));
        }
      }
    }
  }
}

/// Brute force over a fine grid of a patch.
TEST(ToolClearance, IsTheLeastDistanceOfTheSurfaceFromTheTool) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const Surface surface(test::patch_a());
  std::vector<Vector> points;
  constexpr int n = 400;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) points.push_back(surface.at(static_cast<double>(i) / n, static_cast<double>(j) / n));
  }
  for (int round = 0; round < 30; ++round) {
    const double R = 2 + 6 * unit(random);
    const Cutter cutter{R, round % 3 == 0 ? R : round % 3 == 1 ? 0 : R * unit(random)};
    const ToolClearance clearance(surface, cutter);
    const ToolPose pose = {{60 * unit(random), 60 * unit(random), 4 + 6 * unit(random)},
                           kinematics::unit_vector({unit(random) - 0.5, unit(random) - 0.5, 1})};
    double least = 1e300;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double distance = test::from_tool(cutter, pose.tip, pose.axis, points[k]);
      least = std::min(least, distance);
      if (k % 997 == 0) {
        EXPECT_NEAR(distance, distance_from_tool(cutter, pose, points[k]), 1e-12);
      }
    }
    const double found = clearance.least(pose, {0, 0.5, 0.5}, 1e300).distance;
    // Deep in the tool, where its sides and bottom are as near, the distance has a fold along which no method goes down.
    EXPECT_LE(found, least < -0.05 ? 0.5 * least : least + 1e-9);
    EXPECT_GE(found, least - 0.05);  // between points of the grid
  }
}

}  // namespace test_links
}  // namespace leadscrew::surfaces
