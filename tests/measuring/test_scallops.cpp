// What passes leave, against the closed forms of the scallop.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../surfaces/patches.hpp"
#include "hand_passes.hpp"

namespace leadscrew::measuring {
namespace test_scallops {

using surfaces::Direction;
using surfaces::Orientation;
using surfaces::Surface;

constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t few_places = 1 << 14, more_places = 1 << 16;

Target target_of(const Surface& surface, double step, double expected) {
  Target target{surface.form(), surface.range(Direction::u), surface.range(Direction::v), 1, Target::Across::v, step,
                expected};
  target.most_places = few_places;
  return target;
}

TEST(Scallops, OfABallOnAPlaneAreTheClosedForm) {
  const Surface surface(surfaces::test::plane());
  for (const double radius : {0.5, 3.0, 5.0}) {
    const double step = 0.6, height = surfaces::scallop_height(radius, 0, step);
    Target target = target_of(surface, step, height);
    if (radius < 1) target.most_places = more_places;
    Measurement measurement(target);
    const Findings& found = test::measured(measurement, {&surface, {radius, radius}, {}, test::even(50), 100});
    EXPECT_NEAR(found.ridge.height, height, 1e-6 * height) << radius;
    EXPECT_NEAR(found.mean_ridge, height, (radius < 1 ? 6e-3 : 2e-3) * height) << "crests by parabolas";
    // The mean over y of R − √(R² − y²), |y| ≤ g/2.
    const double s = step / 2,
                 arc = (s * std::sqrt(radius * radius - s * s) + radius * radius * std::asin(s / radius)) / 2;
    EXPECT_NEAR(found.mean_height, radius - arc / s, 5e-3 * height);
    EXPECT_NEAR(found.area, 1200, 1e-3);
    EXPECT_EQ(found.not_reached, 0);
    EXPECT_NEAR(found.cut.height, 0, 1e-9);
    EXPECT_NEAR(std::remainder(found.ridge.place[1] + step / 2, step), 0, 1e-4) << "between two passes";
  }
}

/// Passes along the cylinder of radius ρ, so many over the quarter turn.
TEST(Scallops, OfABallRoundACylinderAreTheClosedForm) {
  const double radius = 5, rho = 50;
  const Surface surface(surfaces::test::cylinder(rho, 20));
  const int passes = 65;
  std::vector<double> lines;
  for (int k = 0; k <= passes; ++k) {
    // v of the angle: the quarter as a rational quadratic is (1 − v² …)/…: tan(φ/2) = v √2/(√2 + 2 v (1 − … )) by bisection
    const double angle = std::numbers::pi / 2 * k / passes;
    double from = 0, to = 1;
    for (int step = 0; step < 60; ++step) {
      const double middle = (from + to) / 2;
      const Vector s = surface.at(0, middle);
      (std::atan2(s[2], s[1]) < angle ? from : to) = middle;
    }
    lines.push_back(k == 0 ? 0 : k == passes ? 1 : from);
  }
  const double step = rho * std::numbers::pi / 2 / passes;
  for (const int side : {1, -1}) {
    // Su × Sv points outwards where v goes from +y over +z and u along x: convex; from inside it is concave.
    Target target = target_of(surface, step, 0.01);
    const SurfacePlace middle = Net(target.form, side).at(0.5, 0.5);
    const double outwards = middle.n[1] > 0 ? 1 : -1;
    target.side = side;
    Measurement measurement(target);
    std::int64_t word = 0;
    do {
      for (const double v : lines) {
        for (int k = 0; k <= 200; ++k) {
          const SurfacePlace at = Net(target.form, side).at(k / 200.0, v);
          ToolPose pose{{}, at.n};
          pose.tip = at.s;
          measurement.add(pose, {radius, radius}, {word++}, k > 0);
        }
      }
    } while (measurement.end_reading());
    const double height = surfaces::scallop_height(radius, -outwards / rho, step);
    EXPECT_NEAR(measurement.findings().ridge.height, height, 1e-5 * height) << side;
    EXPECT_NEAR(measurement.findings().cut.height, 0, 1e-9);
  }
}

TEST(Scallops, OfABallOnASphereAreTheClosedForm) {
  const double radius = 5, rho = 50;
  const Surface surface(surfaces::test::sphere(rho));
  // Meridians' places at even latitudes: passes along u are circles of latitude.
  std::vector<double> lines;
  const int passes = 40;
  for (int k = 0; k <= passes; ++k) {
    const double latitude = std::numbers::pi / 2 * (static_cast<double>(k) / passes - 0.5);
    double from = 0, to = 1;
    for (int step = 0; step < 60; ++step) {
      const double middle = (from + to) / 2;
      (std::asin(surface.at(0, middle)[2] / rho) < latitude ? from : to) = middle;
    }
    lines.push_back(k == 0 ? 0 : k == passes ? 1 : from);
  }
  const double step = rho * std::numbers::pi / 2 / passes;
  Measurement measurement(target_of(surface, step, 0.04));
  const Findings& found =
      test::measured(measurement, {&surface, {radius, radius}, {Orientation::Rule::normal}, lines, 400});
  const double height = surfaces::scallop_height(radius, -1 / rho, step);
  EXPECT_NEAR(found.ridge.height, height, 1e-4 * height);
  EXPECT_LE(found.ridge.height, height * (1 + 1e-6));
  EXPECT_NEAR(found.area, std::numbers::pi / 2 * rho * rho * std::numbers::sqrt2, 1);
}

/// Half the width of what a leaning bull nose sweeps, at a height above its lowest line: the circle of its edge, seen along the pass,
/// is an ellipse, and the edge is all within r of it.
double swept_height(double flat, double corner, double lead, double aside) {
  double from = 0, to = 1, height = 0;
  for (int step = 0; step < 60; ++step) {
    const double middle = (from + to) / 2, across = flat * std::cos(middle),
                 up = flat * std::sin(lead) * std::sin(middle);
    const double length = std::hypot(across, up);
    height = flat * std::sin(lead) * (1 - std::cos(middle)) + corner * (1 - across / length);
    (flat * std::sin(middle) + corner * up / length < aside ? from : to) = middle;
  }
  return height;
}

TEST(Scallops, OfALeaningBullNoseAreWhatItsEdgeSweeps) {
  const Surface surface(surfaces::test::plane());
  const double radius = 5, corner = 1, lead = 5 * degree, step = 1.2;
  const double height = swept_height(radius - corner, corner, lead, step / 2);
  Target target = target_of(surface, step, height);
  target.u = {0.1, 0.9};  // what the tool leaves beside its contact, it leaves somewhat before or behind it
  Measurement measurement(target);
  const Orientation leaned = Orientation::leaning(lead, 0);
  const Findings& found = test::measured(measurement, {&surface, {radius, corner}, leaned, test::even(25)});
  EXPECT_NEAR(found.ridge.height, height, 1e-6 * height);
  EXPECT_NEAR(found.cut.height, 0, 1e-9);
  // The effective radius tells it to the second order.
  const double effective = (radius - corner) / std::sin(lead) + corner;
  EXPECT_NEAR(surfaces::scallop_height(effective, 0, step), height, 0.01 * height);
}

TEST(Scallops, OfAFlatToolOnAPlaneAreNone) {
  const Surface surface(surfaces::test::plane());
  Target target = target_of(surface, 6, 0);
  target.u = {0.25, 1};  // it touches with its edge behind: its middle is 5 mm ahead
  Measurement measurement(target);
  const Findings& found = test::measured(measurement, {&surface, {5, 0}, {}, test::even(5)});
  EXPECT_NEAR(found.ridge.height, 0, 1e-9);
  EXPECT_EQ(found.ridges, 0);
  EXPECT_EQ(found.not_reached, 0);
}

TEST(Scallops, OfGreedyPassesOnTheStudysPatchAreTheHeightAskedFor) {
  const Surface surface(surfaces::test::patch_a());
  EXPECT_EQ(test::greedy(surface, 5, 0.01).size(), 100);
  const double height = 0.04;
  Target target = target_of(surface, 1.2, height);
  target.most_places = more_places;
  Measurement measurement(target);
  const Findings& found = test::measured(measurement, {&surface, {5, 5}, {}, test::greedy(surface, 5, height), 1000});
  EXPECT_NEAR(found.ridge.height, height, 1e-3 * height);
  EXPECT_NEAR(found.area, 3673.206807, 0.05);
  EXPECT_GT(found.mean_ridge, 0.9 * height);
  EXPECT_NEAR(found.cut.height, 0, 1e-5) << "chords of the convex parts";
}

}  // namespace test_scallops
}  // namespace leadscrew::measuring
