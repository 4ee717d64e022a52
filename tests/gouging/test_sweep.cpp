// Tools on their ways: what they meet is found, and nothing else.

#include <gtest/gtest.h>

#include <leadscrew/gouging/distance.hpp>
#include <leadscrew/gouging/sweep.hpp>
#include <leadscrew/surfaces/frame.hpp>

#include "../surfaces/patches.hpp"
#include "bodies.hpp"
#include "long_seed.hpp"
#include "ways.hpp"

namespace leadscrew::gouging {
namespace test_sweep {

using surfaces::Surface;
using test::line;
using test::Random;
using test::way_of;
constexpr double tolerance = 0.01;

/// A flat wall or floor: from a corner along two vectors.
std::shared_ptr<const Surface> parallelogram(const Vector& corner, const Vector& along, const Vector& up) {
  surfaces::SurfaceForm form{{1, 1}, {surfaces::uniform_knots(2, 1), surfaces::uniform_knots(2, 1)}, {2, 2}, {}};
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < 2; ++i) {
      Vector place;
      for (std::size_t k = 0; k < 3; ++k)
        place[k] = corner[k] + static_cast<double>(i) * along[k] + static_cast<double>(j) * up[k];
      form.net.push_back({place, 1});
    }
  }
  return std::make_shared<Surface>(form);
}

surfaces::Machining machining(std::shared_ptr<const Surface> surface, const surfaces::Cutter& cutter) {
  surfaces::Machining how;
  how.surface = std::move(surface);
  how.cutter = cutter;
  how.scallop = 0.04;
  return how;
}

struct Found {
  double depth = -1e9;
  Part::Kind part = Part::Kind::cutter;
  SurfacePlace place;
  std::int64_t looks = 0;
};

/// All passes and links, refined where they reach deepest.
Found deepest_of(const surfaces::Machining& how, const Tool& tool, const Workpiece& workpiece) {
  Sweep sweep(workpiece, tolerance);
  sweep.hold(tool);
  surfaces::Passes passes(how);
  Found found;
  while (const auto pass = passes.next()) {
    const auto deepest = sweep.follow(way_of(*pass));
    if (!deepest || -deepest->hit.distance < found.depth) continue;
    const SurfacePlace place = workpiece.refined(deepest->part, deepest->pose, deepest->hit);
    if (-place.distance > found.depth) found = {-place.distance, deepest->part.kind, place, 0};
  }
  EXPECT_FALSE(passes.failure());
  found.looks = sweep.looks();
  return found;
}

const ToolForm ball_in_holder{{5, 5}, 0, 0, 40, 20, 50};

TEST(Sweep, FindsPatchAFreeOfGouging) {
  const auto surface = std::make_shared<Surface>(surfaces::test::patch_a());
  const Workpiece workpiece({surface}, tolerance / 4);
  const Found found = deepest_of(machining(surface, {5, 5}), Tool(ball_in_holder), workpiece);
  EXPECT_LT(found.depth, 1e-6);
  EXPECT_GT(found.depth, -1e-6);  // it touches
  EXPECT_LT(found.looks, 60000);
}

TEST(Sweep, FindsLeaningToolsFreeOfGouging) {
  const auto surface = std::make_shared<Surface>(surfaces::test::patch_a());
  const Workpiece workpiece({surface}, tolerance / 4);
  surfaces::Machining how = machining(surface, {5, 1});
  how.orientation = surfaces::Orientation::leaning(0.15, 0);
  const Found found = deepest_of(how, Tool({{5, 1}, 20, 4, 60, 20, 50}), workpiece);
  EXPECT_LT(found.depth, 1e-6);
  EXPECT_GT(found.depth, -1e-5);
}

TEST(Sweep, FindsTheHolderThatMeetsAWall) {
  const auto surface = std::make_shared<Surface>(surfaces::test::patch_a());
  // Beside the patch, 12 mm off the ball's way along y = 0, and up to the holder, whose radius is 20
  const auto wall = parallelogram({0, -12, 0}, {60, 0, 0}, {0, 0, 60});
  const Workpiece workpiece({surface, wall}, tolerance / 4);
  const Found found = deepest_of(machining(surface, {5, 5}), Tool(ball_in_holder), workpiece);
  EXPECT_EQ(found.part, Part::Kind::holder);
  EXPECT_EQ(found.place.surface, 1u);
  EXPECT_GT(found.depth, 7);
  EXPECT_LT(found.depth, 20 - 12 + 5 * 0.391);  // by the steepest normal
  // A longer tool passes it.
  ToolForm longer = ball_in_holder;
  longer.length = 65;
  EXPECT_LT(deepest_of(machining(surface, {5, 5}), Tool(longer), workpiece).depth, 1e-6);
}

TEST(Sweep, FindsWallsAndSlotsThatAreTooNarrow) {
  const auto floor = parallelogram({0, 0, 0}, {60, 0, 0}, {0, 10.02, 0});
  const auto slot = [&](double left, double right) {
    return Workpiece({floor, parallelogram({-10, left, -1}, {80, 0, 0}, {0, 0, 50}),
                      parallelogram({-10, right, -1}, {80, 0, 0}, {0, 0, 50})},
                     tolerance / 4);
  };
  // A ball of 10 mm along the middle of the slot
  const auto deepest = [&](const Workpiece& workpiece) {
    Sweep sweep(workpiece, tolerance);
    sweep.hold(Tool({{5, 5}, 0, 0, 0, 0, 0}));
    return sweep.follow(line({{0, 5.01, 0}}, {{60, 5.01, 0}}));
  };
  EXPECT_NEAR(deepest(slot(0, 10.02))->hit.distance, 0, 1e-9);  // 0.01 mm beside the walls: it touches the floor
  const auto narrow = deepest(slot(0.06, 10.02));
  EXPECT_NEAR(narrow->hit.distance, -0.05, 1e-9);
  EXPECT_NEAR(narrow->hit.place[1], 0.06, 1e-9);
}

TEST(Sweep, FindsTheSecondOfTwoBumps) {
  // Two bumps with a valley of a radius below 8 mm between
  surfaces::SurfaceForm form{{3, 2}, {surfaces::uniform_knots(9, 3), surfaces::uniform_knots(3, 2)}, {9, 3}, {}};
  const std::array<double, 9> heights = {0, 0, 4, 4, 0, 4, 4, 0, 0};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 9; ++i)
      form.net.push_back({{5.0 * static_cast<double>(i), 10.0 * static_cast<double>(j), heights[i]}, 1});
  }
  const auto surface = std::make_shared<Surface>(form);
  const Workpiece workpiece({surface}, tolerance / 4);
  surfaces::Machining how = machining(surface, {2, 2});
  how.step = 1, how.scallop = 0;
  EXPECT_LT(deepest_of(how, Tool({{2, 2}, 0, 0, 0, 0, 0}), workpiece).depth, 1e-6);
  how.cutter = {8, 8};
  how.allows_gouging = true;
  surfaces::Passes passes(how);
  while (passes.next()) {
  }
  ASSERT_TRUE(passes.least_clearance());
  EXPECT_LT(passes.least_clearance()->clearance, 0);
  const Found found = deepest_of(how, Tool({{8, 8}, 0, 0, 0, 0, 0}), workpiece);
  EXPECT_GT(found.depth, 0.2);
}

double greatest_concave_curvature(const Surface& surface) {
  double greatest = 0;
  for (int j = 0; j <= 100; ++j) {
    for (int i = 0; i <= 100; ++i) {
      const surfaces::SurfaceJet jet = surface.jet(i / 100.0, j / 100.0);
      const auto frame = surfaces::frame_of(jet, 1);
      const auto pair = surfaces::tangents_of(jet, *frame, surfaces::Direction::u);
      greatest = std::max(greatest, surfaces::curvature_of(jet, *frame, pair).principal()[0]);
    }
  }
  return greatest;
}

TEST(Sweep, TellsBallsThatFitRandomSurfacesFromThoseThatDoNot) {
  Random random(22);
  for (int round = 0; round < 6; ++round) {
    std::array<std::array<double, 4>, 4> heights{};
    for (auto& row : heights) {
      for (double& z : row) z = random.between(-6, 6);
    }
    const auto surface = std::make_shared<Surface>(surfaces::test::bicubic(heights));
    const double bend = greatest_concave_curvature(*surface);
    const Workpiece workpiece({surface}, tolerance / 4);
    for (const double share : {0.8, 1.6}) {
      const double R = share / bend;
      surfaces::Machining how = machining(surface, {R, R});
      how.step = 8, how.scallop = 0;
      how.allows_gouging = true;
      const Found found = deepest_of(how, Tool({{R, R}, 0, 0, 0, 0, 0}), workpiece);
      surfaces::Passes passes(how);
      while (passes.next()) {
      }
      const bool gouges = passes.least_clearance()->clearance < 0;
      if (share < 1) {
        EXPECT_FALSE(gouges);
        EXPECT_LT(found.depth, 1e-4) << round;
      } else if (gouges) {
        EXPECT_GT(found.depth, 1e-4) << round;
      }
    }
  }
}

/// At evenly spaced places.
double deepest_by_sampling(const Tool& tool, const Way& way, const Workpiece& workpiece, int count) {
  double least = 1e9;
  for (int k = 0; k <= count; ++k) {
    for (const Part& part : tool) {
      least = std::min(least, workpiece.nearest(part, way.at(static_cast<double>(k) / count), 1e9).distance);
    }
  }
  return -least;
}

void misses_nothing(unsigned seed, int rounds, int samples) {
  Random random(seed);
  const auto surface = std::make_shared<Surface>(surfaces::test::patch_a());
  const Workpiece workpiece({surface}, tolerance / 4);
  int meets = 0, clear = 0;
  for (int round = 0; round < rounds; ++round) {
    const double R = random.between(1, 6), r = round % 3 == 0 ? R : round % 3 == 1 ? 0 : R / 4;
    const Tool tool({{R, r}, 10, R / 2, 30, 15, 30});
    Sweep sweep(workpiece, tolerance);
    sweep.hold(tool);
    // Just above the surface at both ends, or in it
    Pose ends[2];
    for (Pose& pose : ends) {
      const Vector place = surface->at(random.between(0, 1), random.between(0, 1)), lean = random.direction();
      for (std::size_t k = 0; k < 3; ++k) pose.axis[k] = (k == 2) + (round % 2 == 0 ? 0 : 0.4 * lean[k]);
      pose.axis = kinematics::unit_vector(pose.axis);
      for (std::size_t k = 0; k < 3; ++k) pose.tip[k] = place[k] + random.between(-0.5, 8) * pose.axis[k];
    }
    const Way way = line(ends[0], ends[1]);
    const auto found = sweep.follow(way);
    const double expected = deepest_by_sampling(tool, way, workpiece, samples);
    if (expected > 0) {
      EXPECT_GE(-found->hit.distance, expected - 0.75 * tolerance);
      EXPECT_LE(-found->hit.distance, expected + 0.05);  // places that were not sampled
      ++meets;
    } else {
      EXPECT_LE(-found->hit.distance, 0.05);
      ++clear;
    }
  }
  EXPECT_GT(meets, rounds / 8);
  EXPECT_GT(clear, rounds / 12);
}
TEST(Sweep, MissesNothingOnRandomWays) {
  misses_nothing(21, 24, 800);
}
TEST(LongSweep, MissesNothingOnRandomWays) {
  misses_nothing(testing_support::long_seed(), 240, 1500);
}

}  // namespace test_sweep
}  // namespace leadscrew::gouging
