// What passes leave, against the closed forms of the scallop.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "../surfaces/patches.hpp"
#include "hand_passes.hpp"

namespace leadscrew::measuring {
namespace test_scallops {

using surfaces::Cutter;
using surfaces::Orientation;
using surfaces::Surface;

constexpr double degree = std::numbers::pi / 180;

Target target_of(const Surface& surface, double step) {
  return {surface.form(),
          surface.range(surfaces::Direction::u),
          surface.range(surfaces::Direction::v),
          1,
          Target::Across::v,
          step};
}

TEST(Scallops, OfABallOnAPlaneAreTheClosedForm) {
  const Surface surface(surfaces::test::plane());
  for (const double radius : {0.5, 3.0, 5.0}) {
    const int lines = 50;
    const double step = 30.0 / lines;
    Measurement measurement(target_of(surface, step));
    const Findings& found = test::measured(measurement, {&surface, {radius, radius}, {}, test::even(lines)});
    EXPECT_NEAR(found.ridge.height, surfaces::scallop_height(radius, 0, step), 1e-6 * step) << radius;
    EXPECT_NEAR(found.mean_ridge, found.ridge.height, 2e-3 * found.ridge.height);
    EXPECT_NEAR(found.area, 1200, 1e-4);
    EXPECT_EQ(found.not_reached, 0);
    EXPECT_NEAR(found.cut.height, 0, 1e-9);
  }
}

}  // namespace test_scallops
}  // namespace leadscrew::measuring
