// Cuts, places that were not reached, and how readings of a trace hang together.

#include <gtest/gtest.h>

#include <cmath>

#include "../surfaces/patches.hpp"
#include "hand_passes.hpp"

namespace leadscrew::measuring {
namespace test_cuts {

using surfaces::Direction;
using surfaces::Surface;

Target target_of(const Surface& surface) {
  Target target{
      surface.form(), surface.range(Direction::u), surface.range(Direction::v), 1, Target::Across::v, 0.6, 0.01};
  target.most_places = 1 << 14;
  return target;
}

TEST(Cuts, AreAsDeepAsTheToolIsTooLow) {
  const Surface surface(surfaces::test::patch_a());
  Measurement measurement(target_of(surface));
  const Findings& found = test::measured(measurement, {&surface, {5, 5}, {}, test::even(10), 300}, -0.02);
  // Along the axis; along n it is less where the surface slopes, and all of it where it is level.
  EXPECT_LE(found.cut.height, -0.0199);
  EXPECT_GE(found.cut.height, -0.02 - 1e-5);
  EXPECT_GE(found.cut.word.number, 0);
}

/// One word that goes down into the middle of a plane.
TEST(Cuts, AreFoundBetweenThePlacesOfTheGridWithTheirWord) {
  const Surface surface(surfaces::test::plane());
  for (const ToolBody& body : {ToolBody{3, 3}, ToolBody{3, 1}, ToolBody{3, 0}}) {
    Measurement measurement(target_of(surface));
    do {
      for (std::int64_t word = 0; word < 100; ++word) {
        const double depth = word == 57 ? 0.125 : -0.5;
        measurement.add({{17.1234, 11.0321, -depth}, {0, 0, 1}}, body, {word}, word != 57 && word != 58);
      }
    } while (measurement.end_reading());
    const Findings& found = measurement.findings();
    EXPECT_NEAR(found.cut.height, -0.125, 1e-9);
    EXPECT_EQ(found.cut.word.number, 57);
    const double off = std::hypot(found.cut.place[0] - 17.1234, found.cut.place[1] - 11.0321);
    EXPECT_LT(off, body.radius - body.corner_radius + 1e-3);
    EXPECT_GT(found.not_reached, 1200 - 3.2 * 3.2 * 3.1416) << "the rest";
  }
}

TEST(Cuts, OfToolsBehindTheSurfaceAreNone) {
  const Surface surface(surfaces::test::plane());
  Measurement measurement(target_of(surface));
  do {
    // As long as the ball alone: all of it lies below.
    for (std::int64_t word = 0; word < 100; ++word)
      measurement.add({{0.4 * static_cast<double>(word), 15, -8}, {0, 0, 1}}, {3, 3, 6}, {word}, word > 0);
  } while (measurement.end_reading());
  EXPECT_NEAR(measurement.findings().not_reached, 1200, 1e-3);
  EXPECT_EQ(measurement.findings().cut.word.number, -1);
}

TEST(Cuts, OfAFlankAreSeenAsWellAsThoseOfATip) {
  // A wall, x = 0, tools on the side of +x; the tool stands upright and is 0.03 too near.
  surfaces::SurfaceForm form = surfaces::test::plane();
  for (surfaces::NetPoint& point : form.net) point.position = {0, point.position[0], point.position[1]};
  const Surface surface(form);
  Target target = target_of(surface);
  const SurfacePlace middle = Net(form, 1).at(0.5, 0.5);
  target.side = middle.n[0] > 0 ? 1 : -1;
  Measurement measurement(target);
  do {
    for (std::int64_t word = 0; word < 100; ++word)
      measurement.add({{2.97, 0.4 * static_cast<double>(word), -1}, {0, 0, 1}}, {3, 0, 20}, {word}, word > 0);
  } while (measurement.end_reading());
  const Findings& found = measurement.findings();
  EXPECT_NEAR(found.cut.height, -0.03, 1e-9);
  // Of the wall's 40 by 30 mm the tool reaches 19 up, and 39.6 along.
  EXPECT_NEAR(found.not_reached, 1200 - 19 * 40, 40);
}

TEST(Unreached, IsWhatNoPassCameTo) {
  const Surface surface(surfaces::test::plane());
  Target target = target_of(surface);
  target.reach = 0.5;
  Measurement measurement(target);
  std::vector<double> lines;
  for (int k = 0; k <= 25; ++k) lines.push_back(0.02 * k);
  const Findings& found = test::measured(measurement, {&surface, {5, 5}, {}, lines, 200});
  // Beyond the last pass at y = 15: as far as a ball leaves 0.5 mm, √(R² − (R − 0.5)²).
  const double beyond = std::sqrt(25 - 4.5 * 4.5);
  EXPECT_NEAR(found.not_reached, 40 * (15 - beyond), 2);
  EXPECT_NEAR(found.ridge.height, 0.5, 0.05) << "the place where reach ends is the tallest there is";
}

TEST(Crossings, AreWhereTwoParabolasMeet) {
  std::vector<double> heights;
  const double at = 10.3, radius = 80, crest = 0.25;
  // |x − at| from a ridge between two arcs whose lowest places are 2·√… apart.
  const double half = std::sqrt(2 * radius * crest);
  for (int k = 0; k <= 20; ++k) {
    const double x = half - std::abs(k - at);
    heights.push_back(x * x / (2 * radius));
  }
  const std::vector<Crossing> found = crossings_of(heights, 1);
  ASSERT_GE(found.size(), 1);
  const auto ridge = std::find_if(found.begin(), found.end(), [](const Crossing& c) { return c.place == 10; });
  ASSERT_NE(ridge, found.end());
  EXPECT_NEAR(ridge->height, crest, 1e-9);
  EXPECT_TRUE(crossings_of(heights, 0.1).empty() || crossings_of(heights, 0.1).front().height < 0.1);
}

}  // namespace test_cuts
}  // namespace leadscrew::measuring
