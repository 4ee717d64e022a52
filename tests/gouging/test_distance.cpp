// Parts of tools against triangles: facets, edges, vertices; beside a distance field.

#include <gtest/gtest.h>

#include <leadscrew/gouging/distance.hpp>

#include "bodies.hpp"

namespace leadscrew::gouging {
namespace test_distance {

using test::field;
using test::Random;
using Triangle = std::array<Vector, 3>;

TEST(SignedDistance, IsThatFromTheOutline) {
  Random random(1);
  for (int round = 0; round < 30000; ++round) {
    const Part part = random.cutter(round);
    const double rho = random.between(0, 15), z = random.between(-10, 30);
    EXPECT_NEAR(signed_distance(part, rho, z).value, field(part, rho, z), 1e-12);
  }
}

TEST(SignedDistance, HasTheSlopesOfDifferences) {
  Random random(2);
  for (int round = 0; round < 3000; ++round) {
    const Part part = random.cutter(round);
    const double rho = random.between(0.1, 15), z = random.between(-10, 30), h = 1e-6;
    const SignedDistance at = signed_distance(part, rho, z);
    const double by_rho = (field(part, rho + h, z) - field(part, rho - h, z)) / (2 * h);
    const double by_z = (field(part, rho, z + h) - field(part, rho, z - h)) / (2 * h);
    if (std::abs(std::hypot(by_rho, by_z) - 1) > 1e-6) continue;  // a bend of the field
    EXPECT_NEAR(at.by_rho, by_rho, 1e-4);
    EXPECT_NEAR(at.by_z, by_z, 1e-4);
  }
}

double brute_force(const Part& part, const Triangle& triangle) {
  return test::least_on_triangle([&](double s, double t) {
    Vector place;
    for (std::size_t k = 0; k < 3; ++k)
      place[k] = triangle[0][k] + s * (triangle[1][k] - triangle[0][k]) + t * (triangle[2][k] - triangle[0][k]);
    return field(part, std::hypot(place[0], place[1]), place[2]);
  });
}

/// Of all kinds: anywhere, level, upright, needles, and around the tool so that the plane is touched within.
Triangle random_triangle(Random& random, int kind) {
  const double size = random.between(0.5, 20);
  const Vector middle = random.place(8);
  Triangle triangle;
  for (Vector& vertex : triangle) {
    const Vector to = random.place(size);
    for (std::size_t k = 0; k < 3; ++k) vertex[k] = middle[k] + to[k];
  }
  if (kind == 1) triangle[1][2] = triangle[2][2] = triangle[0][2];
  if (kind == 2) triangle[1][0] = triangle[2][0] = triangle[0][0];
  if (kind == 3) {
    for (std::size_t k = 0; k < 3; ++k) triangle[2][k] = (triangle[0][k] + triangle[1][k]) / 2;
    triangle[2][0] += 1e-13;
  }
  return triangle;
}

TEST(NearestOfTriangle, IsThatOfADistanceField) {
  Random random(3);
  int inside = 0;
  for (int round = 0; round < 3000; ++round) {
    const Part part = random.cutter(round);
    const Triangle triangle = random_triangle(random, round / 3 % 5);
    const Nearest found = nearest_of_triangle(part, triangle, 1e9);
    const double expected = brute_force(part, triangle);
    EXPECT_NEAR(found.distance, expected, 2e-8) << round << ' ' << part.radius << ' ' << part.corner;
    EXPECT_NEAR(field(part, std::hypot(found.place[0], found.place[1]), found.place[2]), found.distance, 1e-9);
    inside += found.distance < 0;
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, 2500);
}

TEST(NearestOfTriangle, IsFoundWheneverItIsBelowTheBound) {
  Random random(4);
  for (int round = 0; round < 3000; ++round) {
    const Part part = random.cutter(round);
    const Triangle triangle = random_triangle(random, round / 3 % 5);
    const double distance = nearest_of_triangle(part, triangle, 1e9).distance;
    EXPECT_NEAR(nearest_of_triangle(part, triangle, distance + 0.001).distance, distance, 1e-8);
    EXPECT_GE(nearest_of_triangle(part, triangle, distance - 0.001).distance, distance - 0.001);
  }
}

TEST(NearestOfTriangle, TakesWhatLiesBelowTheTop) {
  Random random(5);
  int cut = 0;
  for (int round = 0; round < 2000; ++round) {
    Part part = random.cutter(round);
    part.top = part.bottom + random.between(1, 6);
    const Triangle triangle = random_triangle(random, round / 3 % 5);
    const double found = nearest_of_triangle(part, triangle, 1e9).distance;
    double expected = 1e9;  // of a grid
    const int n = 60;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        Vector place;
        for (std::size_t k = 0; k < 3; ++k)
          place[k] =
              triangle[0][k] + (i * (triangle[1][k] - triangle[0][k]) + j * (triangle[2][k] - triangle[0][k])) / n;
        if (place[2] <= part.top) expected = std::min(expected, field(part, std::hypot(place[0], place[1]), place[2]));
      }
    }
    cut += expected < 0;
    if (expected < 0) {
      EXPECT_LE(found, expected + 1e-9);
    }
    if (found < 0) {
      EXPECT_GE(found, expected - 2.0);
    }  // steps of the grid
    // Beside a part without a top: never deeper
    Part endless = part;
    endless.top = std::numeric_limits<double>::infinity();
    EXPECT_GE(found, std::min(nearest_of_triangle(endless, triangle, 1e9).distance, expected) - 1e-9);
  }
  EXPECT_GT(cut, 200);
}

TEST(ToolFrame, GoesThereAndBack) {
  Random random(6);
  for (int round = 0; round < 1000; ++round) {
    const Pose pose{random.place(50), random.direction()};
    const ToolFrame frame(pose);
    const Vector place = random.place(50), in_tool = frame.to_tool(place), back = frame.from_tool(in_tool);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], place[k], 1e-12);
    double z = 0;
    for (std::size_t k = 0; k < 3; ++k) z += (place[k] - pose.tip[k]) * pose.axis[k];
    EXPECT_NEAR(in_tool[2], z, 1e-12);
  }
}

}  // namespace test_distance
}  // namespace leadscrew::gouging
