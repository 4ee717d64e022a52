// What spirals leave, measured by brute force, at the corners of their turns and in their middle.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "long_seed.hpp"
#include "patches.hpp"
#include "ridges.hpp"

namespace leadscrew::surfaces {
namespace test_spirals {

/// Places by both parameters, from 0 to 1, near the diagonals of the range, where corners are.
std::vector<std::array<double, 2>> near_corners(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::array<double, 2>> places;
  for (int k = 0; k < count; ++k) {
    const double u = unit(random);
    places.push_back({u, std::clamp((k % 2 == 0 ? u : 1 - u) + 0.04 * (unit(random) - 0.5), 0.0, 1.0)});
  }
  return places;
}

/// What all legs leave at the places: the greatest, of the height asked for.
double tallest_at(const Machining& machining, const std::vector<std::array<double, 2>>& places) {
  const std::vector<Pass> legs = test::passes_of(machining);
  const test::Ridges ridges(machining);
  double most = 0;
  for (const auto& [u, v] : places) most = std::max(most, ridges.left_at(legs, u, v) / machining.scallop);
  return most;
}

const Orientation forward = Orientation::leaning(0.2, 0), aside = Orientation::leaning(0.2, 0.1);

/// Tools lean as told; at the range's own corners as well, within a few steps.
void of_legs_that_lean(const std::vector<SurfaceForm>& forms, const std::vector<Orientation>& orientations, int count,
                       std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  for (const SurfaceForm& form : forms) {
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Orientation& orientation : orientations) {
        Machining machining = test::ball_on(form, 5, 0.04);
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = Pattern::spiral_in;
        std::vector<std::array<double, 2>> places = near_corners(count, random);
        for (int k = 0; k < count; ++k) {
          const double u = 0.03 * unit(random), v = 0.03 * unit(random);
          places.push_back({k % 2 == 0 ? u : 1 - u, k % 4 < 2 ? v : 1 - v});
        }
        const double most = tallest_at(machining, places);
        EXPECT_LE(most, 1 + 1e-3) << "axis by f, b: " << orientation.axis[0] << ", " << orientation.axis[1];
        EXPECT_GT(most, 0.6);
      }
    }
  }
}
TEST(Spirals, OfLegsThatLeanAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(40);
  of_legs_that_lean({test::saddle()}, {forward, aside}, 60, random);
}
TEST(LongSpirals, OfLegsThatLeanAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(testing_support::long_seed());
  const SurfaceForm one = test::random_form(random, 1), other = test::random_form(random, 1);
  of_legs_that_lean({test::patch_a(), test::saddle(), one, other}, {forward, aside}, 400, random);
}

std::vector<Orientation> leaned(const std::vector<std::array<double, 2>>& angles) {
  std::vector<Orientation> found;
  for (const auto& [lead, tilt] : angles) found.push_back(Orientation::leaning(lead, tilt));
  return found;
}
TEST(Spirals, OfLegsThatLeanBackOrAsideAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(41);
  of_legs_that_lean({test::patch_a()}, leaned({{-0.2, 0.1}, {0.05, -0.2}}), 60, random);
}
TEST(LongSpirals, OfLegsThatLeanBackOrAsideAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(testing_support::long_seed());
  const std::vector<Orientation> all =
      leaned({{-0.2, 0}, {-0.2, 0.1}, {0.2, -0.1}, {0.1, 0.2}, {0.05, -0.2}, {-0.05, 0.2}, {0, 0.2}});
  of_legs_that_lean({test::patch_a(), test::random_form(random, 1)}, all, 200, random);
}

/// At the range's own corners, where legs would have to begin and end outside the border.
TEST(Spirals, OfTiltedToolsAreNoHigherAtTheRangesCorners) {
  Machining machining = test::ball_on(test::patch_a(), 5, 0.04);
  machining.cutter = {5, 0};
  machining.pattern = Pattern::spiral_in;
  for (const Orientation& orientation : leaned({{-0.2, 0}, {0.1, 0.2}, {0.05, -0.2}, {-0.05, 0.2}})) {
    machining.orientation = orientation;
    std::vector<std::array<double, 2>> places = {{0, 0.015}, {0.99, 0.99}, {0.998, 0.996}, {0.006, 0.008}};
    for (const double corner_u : {0.0, 1.0}) {
      for (const double corner_v : {0.0, 1.0}) {
        for (int k = 0; k < 16; ++k)
          places.push_back({std::abs(corner_u - 0.006 * (k % 4)), std::abs(corner_v - 0.006 * (k / 4))});
      }
    }
    EXPECT_LE(tallest_at(machining, places), 1 + 1e-3) << orientation.axis[0] << ' ' << orientation.axis[1];
  }
}

/// Steps differ from leg to leg, and what one leg leaves reaches far along it: looked at where the range's own corners are as well.
void of_tools_that_keep_their_axis(const std::vector<SurfaceForm>& forms, int count, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  for (const SurfaceForm& form : forms) {
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Vector& axis : {Vector{0.5, 0.2, 0.842614}, Vector{-0.3, 0.45, 0.841130}}) {
        Machining machining = test::ball_on(form, 5, 0.04);
        machining.cutter = cutter;
        machining.orientation = {Orientation::Rule::fixed, axis};
        machining.pattern = Pattern::spiral_in;
        std::vector<std::array<double, 2>> places = near_corners(count, random);
        for (int k = 0; k < count; ++k) {
          const double u = 0.015 * unit(random), v = 0.015 * unit(random);
          places.push_back({k % 2 == 0 ? u : 1 - u, k % 4 < 2 ? v : 1 - v});
        }
        const double most = tallest_at(machining, places);
        EXPECT_LE(most, 1 + 1e-3);
        EXPECT_GT(most, 0.6);
      }
    }
  }
}
TEST(Spirals, OfToolsThatKeepTheirAxisAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(43);
  of_tools_that_keep_their_axis({test::patch_a()}, 60, random);
}
TEST(LongSpirals, OfToolsThatKeepTheirAxisAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(testing_support::long_seed());
  const SurfaceForm form = test::random_form(random, 1);
  of_tools_that_keep_their_axis({test::patch_a(), test::saddle(), form}, 200, random);
}

/// The last leg has the same side of the tool towards one of its neighbours as that has towards it: where tools are tilted, the lesser.
TEST(Spirals, OfTiltedToolsAreNoHigherInTheirMiddle) {
  for (const SurfaceForm& form : {test::patch_a(), test::plane()}) {
    Machining machining = test::ball_on(form, 5, 0.04);
    machining.cutter = {5, 0};
    machining.orientation = Orientation::leaning(0.05, -0.2);
    machining.pattern = Pattern::spiral_in;
    std::vector<std::array<double, 2>> places;
    for (const double u : {0.4625, 0.4665, 0.47, 0.49, 0.5, 0.52}) {
      for (const double v : {0.46, 0.48, 0.5, 0.52, 0.54}) places.push_back({u, v});
    }
    const double most = tallest_at(machining, places);
    EXPECT_LE(most, 1 + 1e-3);
    EXPECT_GT(most, 0.4);
  }
}

/// The last leg of all meets the first of its turn, where an edge behind has to go on beyond that.
TEST(Spirals, OfTiltedToolsAreNoHigherWhereTheyEnd) {
  std::mt19937 random(20787);
  Machining machining = test::ball_on(test::random_form(random, 1), 5, 0.04);
  machining.cutter = {5, 0};
  machining.orientation = Orientation::leaning(0.1, 0.2);
  machining.pattern = Pattern::spiral_in;
  std::vector<std::array<double, 2>> places;
  for (const double u : {0.485, 0.4883, 0.492}) {
    for (const double v : {0.456, 0.466, 0.4764, 0.486}) places.push_back({u, v});
  }
  const double most = tallest_at(machining, places);
  EXPECT_LE(most, 1 + 1e-3);
  EXPECT_GT(most, 0.4);
}

/// The reaches of a leg towards the next and of that one back to it begin at places apart, where the tool is tilted.
TEST(Spirals, OfTiltedToolsAreNoHigherWhereLegsBegin) {
  Machining machining = test::ball_on(test::patch_a(), 5, 0.04);
  machining.cutter = {5, 0};
  machining.orientation = aside;
  machining.pattern = Pattern::spiral_in;
  std::vector<std::array<double, 2>> places;
  for (int k = 0; k < 80; ++k) {
    for (const double aside_of : {-0.02, -0.01, 0.0, 0.01})
      places.push_back({0.06 + 0.005 * k, 0.06 + 0.005 * k + aside_of});
  }
  const double most = tallest_at(machining, places);
  EXPECT_LE(most, 1 + 1e-3);
  EXPECT_GT(most, 0.6);
}

/// Between a leg and the one inside it, one turn on.
TEST(Spirals, OfBallsAreNoHigherAtTheirCornersToo) {
  Machining machining = test::ball_on(test::plane());
  machining.pattern = Pattern::spiral_in;
  std::vector<Pass> legs;
  Passes made(machining);
  while (std::optional<Pass> pass = made.next()) legs.push_back(*pass);
  ASSERT_GT(legs.size(), 40u);
  // What is left of a plane at a place: the ball's height over the nearest leg.
  double most = 0;
  for (double x = 0; x <= 40; x += 0.05) {
    for (const double y : {0.3, 1.0, 5.0, 14.8, 15.0, 15.2, x * 0.75}) {
      double nearest = 1e300;
      for (const Pass& leg : legs) {
        const Vector a = test::at(leg, &PassNode::contact, 0),
                     b = test::at(leg, &PassNode::contact, leg.nodes.back().t);
        nearest = std::min(nearest, numeric::distance_to_segment(Vector{x, y, 0}, a, b));
      }
      most = std::max(most, 5 - std::sqrt(25 - nearest * nearest));
    }
  }
  EXPECT_LE(most, 0.01 * (1 + 1e-6));
  EXPECT_GT(most, 0.008);
}

}  // namespace test_spirals
}  // namespace leadscrew::surfaces
