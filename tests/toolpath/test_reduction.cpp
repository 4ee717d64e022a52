#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/reduction.hpp>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_reduction {

/// From vertex to vertex (mm, linear axes); line n leads to vertex n.
std::vector<Leg> legs_along(const Polyline& polyline) {
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const double length = line_length(polyline[i - 1], polyline[i]);
    if (!(length > 0)) continue;
    legs.push_back(
        {geometry::Line(polyline[i - 1], polyline[i], length), 10, base::Line{static_cast<std::int64_t>(i)}, {}, 0});
  }
  return legs;
}

std::vector<Leg> reduced(const std::vector<Leg>& legs) {
  Reduction reduction;
  std::vector<Leg> done;
  for (const Leg& leg : legs) {
    if (std::optional<Leg> grown = reduction.push(leg)) done.push_back(std::move(*grown));
  }
  if (std::optional<Leg> last = reduction.finish()) done.push_back(std::move(*last));
  EXPECT_FALSE(reduction.finish());
  return done;
}

/// All within one tolerance.
std::vector<Leg> reduced(std::vector<Leg> legs, double tolerance) {
  for (Leg& leg : legs) leg.allowance = {tolerance, tolerance};
  return reduced(legs);
}

/// The lines that a leg is made of, in order.
std::vector<base::Line> lines_of(const Leg& leg) {
  std::vector<base::Line> lines{leg.line};
  for (const LineMark& mark : leg.lines) lines.push_back(mark.line);
  return lines;
}

TEST(Reduction, MakesCollinearLinesOne) {
  Polyline straight;
  for (int k = 0; k <= 1000; ++k) straight.push_back({3.0 * k, 4.0 * k});
  const std::vector<Leg> legs = reduced(legs_along(straight), 0.01);
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_EQ(geometry::start(legs[0].curve), straight.front());
  EXPECT_EQ(geometry::end(legs[0].curve), straight.back());
  EXPECT_EQ(geometry::length(legs[0].curve), 5000);
  EXPECT_EQ(legs[0].spent, 0);
  EXPECT_EQ(legs[0].line, base::Line{1});
  ASSERT_EQ(legs[0].lines.size(), 999u);
  for (int k = 1; k < 1000; ++k) {
    EXPECT_EQ(legs[0].lines[static_cast<std::size_t>(k) - 1].line, base::Line{k + 1});
    EXPECT_DOUBLE_EQ(legs[0].lines[static_cast<std::size_t>(k) - 1].s, 5.0 * k);
  }
}

TEST(Reduction, MakesLinesOneThatTurnByRoundingOnly) {
  EXPECT_EQ(reduced(legs_along({{0, 0}, {1, 1e-7}, {2, 0}}), 0.01).size(), 1u);
  EXPECT_EQ(reduced(legs_along({{0, 0}, {1, 1e-6}, {2, 0}}), 0.01).size(), 2u);
}

TEST(Reduction, DoesNotAddUpWhatRoundingLeaves) {
  // A circle whose vertices are each within a tenth of a micrometre of their neighbours' chord, 4 µm off after twenty.
  Polyline circle;
  for (int k = 0; k <= 200; ++k) circle.push_back({20 * std::cos(1e-4 * k), 20 * std::sin(1e-4 * k)});
  for (const Leg& leg : reduced(legs_along(circle), 1e-3)) EXPECT_LE(geometry::length(leg.curve), 0.01);
}

TEST(Reduction, KeepsApartLinesThatTurnBack) {
  EXPECT_EQ(reduced(legs_along({{0, 0}, {2, 0}, {1, 0}}), 0.01).size(), 2u);
  EXPECT_EQ(reduced(legs_along({{0, 0}, {1, 0}, {-1, 0}}), 0.01).size(), 2u);
}

TEST(Reduction, KeepsApartStraightLinesOfDifferentFeeds) {
  std::vector<Leg> legs = legs_along({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  legs[1].feed = 20;
  const std::vector<Leg> made = reduced(legs, 0.01);
  ASSERT_EQ(made.size(), 3u);
  EXPECT_EQ(made[1].feed, 20);
}

TEST(Reduction, KeepsApartStraightLinesOfDifferentTolerances) {
  std::vector<Leg> legs = legs_along({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
  for (Leg& leg : legs) leg.allowance = {0.01, 0.01};
  legs[1].allowance = {0.1, 0.1};
  legs[3].allowance = {0.01, 0.001};
  const std::vector<Leg> made = reduced(legs);
  ASSERT_EQ(made.size(), 4u);
  for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(made[i].allowance, legs[i].allowance);
}

/// Sums of decimals leave lines that are no longer than rounding; a place of a path may have only one length.
TEST(Reduction, MakesALineOfRoundingOneWithItsNeighbour) {
  for (const double tiny : {1e-25, 4e-16, 1e-10}) {
    SCOPED_TRACE(tiny);
    for (const Polyline& corner :
         {Polyline{{0, 0}, {tiny, 0}, {tiny, 1}, {2, 3}}, Polyline{{0, 1}, {0, 0}, {tiny, 0}, {1, 2}},
          Polyline{{0, 1}, {0, 0}, {0, tiny}, {1, 2}}, Polyline{{1, 0}, {1, 1}, {0, 0}, {tiny, 0}}}) {
      std::vector<Leg> legs = legs_along(corner);
      ASSERT_EQ(legs.size(), 3u);
      for (Leg& leg : legs) {
        leg.allowance = {0.01, 0.01};
        if (geometry::length(leg.curve) > tiny) continue;
        leg.feed = 0.01;
        leg.allowance = {0.02, 0.02};
      }
      const std::vector<Leg> made = reduced(legs);
      ASSERT_EQ(made.size(), 2u);
      for (const Leg& leg : made) {
        EXPECT_GT(geometry::length(leg.curve), 0.9);
        EXPECT_EQ(leg.feed, 10);
        EXPECT_EQ(leg.allowance, (Allowance{0.01, 0.01}));
      }
      EXPECT_EQ(geometry::end(made[0].curve), geometry::start(made[1].curve));
      EXPECT_EQ(lines_of(made[0]).size() + lines_of(made[1]).size(), 3u);
    }
  }
}

TEST(Reduction, MakesACloudOneWithinTheLeastToleranceOfItsLines) {
  for (const double least : {0.01, 0.001}) {
    std::vector<Leg> legs = legs_along({{0, 0}, {0.001, 0}, {0, 0.001}, {0.001, 0.001}});
    for (Leg& leg : legs) leg.allowance = {0.1, 0.1};
    legs[1].allowance = {0.5, least};
    const std::vector<Leg> made = reduced(legs);
    EXPECT_EQ(made.size(), least < 0.004 ? 3u : 1u);
    EXPECT_EQ(made[0].allowance, made.size() == 1 ? (Allowance{0.1, least}) : legs[0].allowance);
  }
}

TEST(Reduction, KeepsApartLinesWhoseLengthIsToldInOtherAxes) {
  // Along X, then along U.
  EXPECT_EQ(reduced(legs_along({{0, 0}, {1, 0}, {1, 0, 0, 0, 0, 0, 1}}), 0.01).size(), 2u);
}

TEST(Reduction, KeepsArcsAndWhatFollowsThem) {
  std::vector<Leg> legs = legs_along({{0, 0}, {1, 0}});
  legs.push_back({geometry::Arc({1, 0}, {2, 1}, 0, 1, 1, 1, std::acos(0.0), std::acos(0.0)), 10, base::Line{2}, {}, 0});
  legs.push_back({geometry::Line({2, 1}, {2, 2}, 1), 10, base::Line{3}, {}, 0});
  EXPECT_EQ(reduced(legs, 0.01).size(), 3u);
}

TEST(Reduction, MakesACloudOfVerticesFewLines) {
  Polyline cloud{{50, 50, 50}};
  for (int k = 1; k <= 10000; ++k) {
    // The digits of two irrational numbers: somewhere in a cube of 1 µm.
    const double x = std::fmod(k * 0.6180339887, 1), y = std::fmod(k * 0.4142135623, 1),
                 z = std::fmod(k * 0.7320508, 1);
    cloud.push_back({50 + 1e-3 * x, 50 + 1e-3 * y, 50 + 1e-3 * z});
  }
  const std::vector<Leg> legs = reduced(legs_along(cloud), 0.01);
  EXPECT_LE(legs.size(), 3u);
  std::size_t lines = 0;
  for (const Leg& leg : legs) {
    lines += lines_of(leg).size();
    EXPECT_LE(leg.spent, 0.0025);
  }
  EXPECT_EQ(lines, 10000u);
}

TEST(Reduction, MarksItsLinesInOrderWhereTheyTurnBack) {
  // All within the ball that may be taken for its centre.
  const Leg leg = reduced(legs_along({{0, 0}, {0.002, 0}, {0.0005, 0}, {0.001, 0}}), 0.01).at(0);
  ASSERT_EQ(leg.lines.size(), 2u);
  EXPECT_LE(leg.lines[0].s, leg.lines[1].s);
  EXPECT_LE(leg.lines[1].s, geometry::length(leg.curve));
}

RC_GTEST_PROP(Reduction, SpendsWhatItSaysAndNamesEveryLine, ()) {
  const double tolerance = logarithmic(1e-3, 1);
  const double step = tolerance * logarithmic(1e-3, 1);
  Polyline walk{{uniform(-100, 100), uniform(-100, 100)}};
  const std::size_t axes = any<std::size_t>(1, 4);
  for (int count = any(1, 60); count > 0; --count) {
    Point next = walk.back();
    for (std::size_t i = 0; i < axes; ++i) next[i] += uniform(-step, step);
    if (any(0, 2) == 0) next[0] += step;
    walk.push_back(next);
  }
  std::vector<Leg> legs = legs_along(walk);
  std::size_t line = 1;
  const std::vector<Leg> made = reduced(legs, tolerance);
  for (std::size_t i = 0; i < made.size(); ++i) {
    const Leg& leg = made[i];
    const std::vector<base::Line> lines = lines_of(leg);
    Polyline original{walk[line - 1]};
    for (const base::Line name : lines) {
      RC_ASSERT(name == base::Line{static_cast<std::int64_t>(line)});
      original.push_back(walk[line++]);
    }
    RC_ASSERT(geometry::start(leg.curve) == original.front());
    RC_ASSERT(geometry::end(leg.curve) == original.back());
    RC_ASSERT(leg.spent <= 0.25 * tolerance);
    const Polyline chord{original.front(), original.back()};
    const double fine = tolerance / 100;
    RC_ASSERT(discrete_frechet(subdivided(original, fine), subdivided(chord, fine)) <= leg.spent + fine + 1e-12);
  }
  RC_ASSERT(line == walk.size());
}

}  // namespace test_reduction
}  // namespace leadscrew::toolpath::testing
