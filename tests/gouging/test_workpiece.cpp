// Surfaces as triangles, and the places where tools are nearest to them, beside dense sampling.

#include <gtest/gtest.h>

#include <leadscrew/gouging/distance.hpp>
#include <leadscrew/gouging/workpiece.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/frame.hpp>

#include "../surfaces/patches.hpp"
#include "bodies.hpp"
#include "long_seed.hpp"

namespace leadscrew::gouging {
namespace test_workpiece {

using surfaces::Surface;
using test::field;
using test::Random;

std::shared_ptr<const Surface> random_surface(Random& random, int round) {
  if (round % 4 == 0) return std::make_shared<Surface>(surfaces::test::sphere(random.between(5, 40)));
  std::array<std::array<double, 4>, 4> heights{};
  for (auto& row : heights) {
    for (double& z : row) z = random.between(-15, 15);
  }
  surfaces::SurfaceForm form = surfaces::test::bicubic(heights);
  if (round % 4 == 1) {
    for (auto& point : form.net) point.weight = random.between(0.3, 3);
  }
  return std::make_shared<Surface>(form);
}

Vector in_triangle(const Cell& cell, std::size_t triangle, double s, double t) {
  Vector place;
  for (std::size_t k = 0; k < 3; ++k) {
    const double o = cell.corners[0][k];
    place[k] = o + s * (cell.corners[triangle + 1][k] - o) + t * (cell.corners[triangle + 2][k] - o);
  }
  return place;
}

/// From the surface's tangent plane at the parameters that belong to the place: to second order the distance.
TEST(Mesh, LiesWithinTheSag) {
  Random random(11);
  for (int round = 0; round < 12; ++round) {
    const auto surface = random_surface(random, round);
    const double sag = random.between(0.001, 0.02);
    std::vector<Cell> cells;
    ASSERT_EQ(tessellate(*surface, 0, sag, 1 << 20, cells), 1);
    double worst = 0, area = 0;
    for (const Cell& cell : cells) {
      area += (cell.u.to - cell.u.from) * (cell.v.to - cell.v.from);
      for (const auto& [s, t] : {std::pair{0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}, {0.33, 0.33}, {0.2, 0.6}}) {
        for (std::size_t triangle = 0; triangle < 2; ++triangle) {
          const Vector place = in_triangle(cell, triangle, s, t);
          auto [u, v] = parameters_in(cell, place);
          const auto frame = surfaces::frame_of(surface->jet(u, v), 1);
          ASSERT_TRUE(frame);
          worst = std::max(worst, std::abs(numeric::dot(numeric::difference(place, surface->at(u, v)), frame->n)));
        }
      }
    }
    EXPECT_NEAR(area, 1, 1e-12);
    EXPECT_LE(worst, sag) << round;
    EXPECT_GE(worst, sag / 8) << round;  // and no finer than it must be
  }
}

TEST(Mesh, TellsTheParametersOfAPlace) {
  const Surface surface(surfaces::test::plane());
  std::vector<Cell> cells;
  ASSERT_EQ(tessellate(surface, 0, 0.01, 100, cells), 1);
  ASSERT_EQ(cells.size(), 4u);
  for (const Cell& cell : cells) {
    const double u = (2 * cell.u.from + cell.u.to) / 3, v = (cell.v.from + 3 * cell.v.to) / 4;
    const auto found = parameters_in(cell, surface.at(u, v));
    EXPECT_NEAR(found[0], u, 1e-14);
    EXPECT_NEAR(found[1], v, 1e-14);
  }
}

TEST(Workpiece, FindsTheNearestOfAllTriangles) {
  Random random(12);
  for (int round = 0; round < 16; ++round) {
    std::vector<std::shared_ptr<const Surface>> all = {random_surface(random, round),
                                                       random_surface(random, round + 1)};
    const double sag = 0.05;
    const Workpiece workpiece(all, sag);
    ASSERT_TRUE(workpiece.fits());
    EXPECT_EQ(workpiece.sag(), sag);
    std::vector<Cell> cells;
    for (std::uint32_t k = 0; k < 2; ++k) tessellate(*all[k], k, sag, 1 << 20, cells);
    EXPECT_EQ(workpiece.triangles(), 2 * cells.size());
    std::uint32_t near = Hit::no_cell;
    for (int trial = 0; trial < 12; ++trial) {
      Part part = random.cutter(trial);
      if (trial % 2 == 0) part.top = part.bottom + random.between(2, 30);
      const Pose pose{{random.between(-20, 80), random.between(-20, 80), random.between(-30, 40)}, random.direction()};
      const ToolFrame frame(pose);
      double expected = 1e9;
      for (const Cell& cell : cells) {
        for (std::size_t k = 1; k < 3; ++k) {
          const std::array<Vector, 3> triangle = {frame.to_tool(cell.corners[0]), frame.to_tool(cell.corners[k]),
                                                  frame.to_tool(cell.corners[k + 1])};
          expected = std::min(expected, nearest_of_triangle(part, triangle, 1e9).distance);
        }
      }
      const Hit hit = workpiece.nearest(part, pose, 1e9, near);
      EXPECT_NEAR(hit.distance, expected, 2e-8);
      if (hit.distance < 0) {
        EXPECT_NEAR(field(part, pose, hit.place), hit.distance, 2e-6);
      }
      near = hit.cell;
    }
  }
}

/// All of a surface, then again and again about its best place.
double least_by_sampling(const Surface& surface, const Part& part, const Pose& pose) {
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1, best = 1e9;
  int n = 120;
  for (int zoom = 0; zoom < 12; ++zoom, n = 24) {
    double at_u = 0, at_v = 0, least = 1e9;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const double u = u0 + (u1 - u0) * i / n, v = v0 + (v1 - v0) * j / n,
                     value = field(part, pose, surface.at(u, v));
        if (value < least) least = value, at_u = u, at_v = v;
      }
    }
    best = std::min(best, least);
    const double h = 4 * (u1 - u0) / n, k = 4 * (v1 - v0) / n;
    u0 = std::max(at_u - h, 0.0), u1 = std::min(at_u + h, 1.0), v0 = std::max(at_v - k, 0.0),
    v1 = std::min(at_v + k, 1.0);
  }
  return best;
}

void refines_on_the_surface(unsigned seed, int rounds) {
  Random random(seed);
  int inside = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto surface = random_surface(random, round);
    const Workpiece workpiece({surface}, 0.002);
    const Part part = random.cutter(round / 4);
    // Somewhere about the surface, leaning up to 60° from its normal
    const auto frame = surfaces::frame_of(surface->jet(random.between(0, 1), random.between(0, 1)), 1);
    const Vector place = surface->at(random.between(0, 1), random.between(0, 1)), lean = random.direction();
    Pose pose;
    for (std::size_t k = 0; k < 3; ++k) pose.axis[k] = frame->n[k] + 0.8 * lean[k];
    pose.axis = kinematics::unit_vector(pose.axis);
    for (std::size_t k = 0; k < 3; ++k) pose.tip[k] = place[k] + random.between(-1, 1) - part.bottom * pose.axis[k];
    const Hit hit = workpiece.nearest(part, pose, 1e9);
    const SurfacePlace refined = workpiece.refined(part, pose, hit);
    const double expected = least_by_sampling(*surface, part, pose);
    EXPECT_LE(refined.distance, expected + 1e-6) << round << ' ' << part.radius << ' ' << part.corner;
    EXPECT_NEAR(hit.distance, refined.distance, 0.0021);
    EXPECT_NEAR(field(part, pose, surface->at(refined.u, refined.v)), refined.distance, 1e-8);
    inside += refined.distance < 0;
  }
  EXPECT_GT(inside, 5 * rounds / 12);
}
TEST(Workpiece, RefinesOnTheSurface) {
  refines_on_the_surface(13, 16);
}
TEST(LongWorkpiece, RefinesOnTheSurface) {
  refines_on_the_surface(testing_support::long_seed(), 230);
}

TEST(Workpiece, IsMadeCoarserWhereThereWouldBeTooManyTriangles) {
  const auto surface = std::make_shared<Surface>(surfaces::test::patch_a());
  const Workpiece fine({surface}, 0.0025), coarse({surface}, 1e-6, 2000);
  EXPECT_EQ(fine.sag(), 0.0025);
  EXPECT_GT(fine.triangles(), 5000u);
  EXPECT_TRUE(coarse.fits());
  EXPECT_LE(coarse.triangles(), 2000u);
  EXPECT_GT(coarse.triangles(), 200u);
  EXPECT_GT(coarse.sag(), 1e-4);
  const Workpiece none({surface, surface}, 0.01, 12);
  EXPECT_FALSE(none.fits());
  EXPECT_EQ(none.triangles(), 0u);
}

}  // namespace test_workpiece
}  // namespace leadscrew::gouging
