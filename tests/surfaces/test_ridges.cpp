// The ridges between passes, measured by brute force: as high as was asked for, and no higher.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "long_seed.hpp"
#include "patches.hpp"
#include "ridges.hpp"

namespace leadscrew::surfaces {
namespace test_ridges {

struct Measured {
  double most = 0, mean = 0;  // of the height asked for
  std::size_t passes = 0;
};

/// How much is looked at: the long suite has passes half as far apart and looks at more places of more of them.
struct Effort {
  double scallop;  // mm
  std::size_t passes;
  int places;
  double mean_in_planes;  ///< of the scallop, at least: the fewer passes, the more of them lie at the range's edges
};
constexpr Effort brief{0.04, 3, 3, 0.65}, full{0.01, 10, 7, 0.7};

/// Does the pass after k go through the whole range, not cut by the border?
bool is_next_whole(const Machining& machining, const std::vector<Pass>& passes, std::size_t k) {
  const Pass& next = passes[k + 1];
  const bool is_u = machining.along == Direction::u;
  const PassNode &begin = next.nodes.front(), &end = next.nodes.back();
  const Range& run = is_u ? machining.u : machining.v;
  const double length = std::abs(is_u ? end.u - begin.u : end.v - begin.v);
  return next.number == passes[k].number + 1 && length > (run.to - run.from) * (1 - 1e-9);
}

/// At some places of some passes, the ridge to the next.
Measured measured(Machining machining, const Effort& effort) {
  machining.scallop = effort.scallop;
  std::vector<Pass> passes;
  Passes made(machining);
  while (std::optional<Pass> pass = made.next()) {
    if (!pass->is_link) passes.push_back(*pass);
  }
  EXPECT_FALSE(made.failure()) << static_cast<int>(made.failure()->kind);
  const test::Ridges ridges(machining);
  Measured result{0, 0, passes.size()};
  double count = 0;
  for (std::size_t k = 0; k + 2 < passes.size(); k += 1 + passes.size() / effort.passes) {
    // What is left to the border is no more than a step, and less on the mean.
    const bool is_cut = !machining.cutter.is_ball() && machining.pattern == Pattern::iso_scallop &&
                        !is_next_whole(machining, passes, k);
    for (int i = 1; i <= effort.places; ++i) {
      const double height = ridges.height(passes, k, passes[k].nodes.back().t * i / (effort.places + 1));
      if (!std::isfinite(height)) continue;
      result.most = std::max(result.most, height / machining.scallop);
      if (is_cut) continue;
      result.mean += height / machining.scallop;
      ++count;
    }
  }
  result.mean /= count;
  return result;
}

SurfaceForm saddle() {
  return test::bicubic({{{0, 4, 8, 12}, {4, 4, 4, 4}, {4, 4, 4, 4}, {12, 8, 4, 0}}});
}

const Orientation forward{Orientation::Rule::leaned, {}, 0.2, 0}, aside{Orientation::Rule::leaned, {}, 0.2, 0.1};

void as_asked_for(const Effort& effort) {
  const Orientation normal{Orientation::Rule::normal, {}, 0, 0};
  Machining plane = test::ball_on(test::plane()), outside = test::ball_on(test::cylinder(20, 50)),
            sphere = test::ball_on(test::sphere(25));
  outside.side = -1;
  outside.orientation = sphere.orientation = normal;
  Machining inside = outside, round = outside;
  inside.side = 1;
  round.along = Direction::v;
  for (const Machining* machining : {&plane, &outside, &inside, &round, &sphere}) {
    const Measured ridges = measured(*machining, effort);
    EXPECT_LE(ridges.most, 1 + 1e-5);
    EXPECT_GT(ridges.mean, 0.999);
  }
}
TEST(Ridges, AreAsAskedForOnPlaneCylinderAndSphere) {
  as_asked_for(brief);
}
TEST(LongRidges, AreAsAskedForOnPlaneCylinderAndSphere) {
  as_asked_for(full);
}

void of_tools_that_lean(const Effort& effort) {
  for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}, Cutter{5, 5}}) {
    for (const Orientation& orientation : {forward, aside}) {
      for (const Pattern pattern : {Pattern::zigzag, Pattern::zig}) {
        Machining machining = test::ball_on(test::plane());
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = pattern;
        const Measured ridges = measured(machining, effort);
        EXPECT_LE(ridges.most, 1 + 1e-5);
        EXPECT_GT(ridges.mean, 0.999);
      }
    }
  }
}
TEST(Ridges, OfToolsThatLeanAreAsAskedForOnAPlane) {
  of_tools_that_lean(brief);
}
TEST(LongRidges, OfToolsThatLeanAreAsAskedForOnAPlane) {
  of_tools_that_lean(full);
}

void on_curved_patches(const Effort& effort) {
  for (const SurfaceForm& form : {test::patch_a(), saddle()}) {
    for (const Cutter& cutter : {Cutter{5, 5}, Cutter{5, 1}, Cutter{5, 0}}) {
      for (const Orientation& orientation : {forward, aside}) {
        Machining machining = test::ball_on(form);
        machining.cutter = cutter;
        machining.orientation = orientation;
        const Measured ridges = measured(machining, effort);
        EXPECT_LE(ridges.most, 1 + 1e-3);
        EXPECT_GT(ridges.mean, 0.75);
      }
    }
  }
}
TEST(Ridges, AreNoHigherOnCurvedPatches) {
  on_curved_patches(brief);
}
TEST(LongRidges, AreNoHigherOnCurvedPatches) {
  on_curved_patches(full);
}

/// A wavy net with inner knots, steep by no more than the tool can follow.
SurfaceForm random_form(std::mt19937& random, double height = 3) {
  std::uniform_real_distribution<double> unit(0, 1);
  const std::array<int, 2> degrees = {3 + static_cast<int>(2 * unit(random)), 3 + static_cast<int>(2 * unit(random))};
  SurfaceForm form{degrees, {}, {6, 7}, {}};
  for (std::size_t d = 0; d < 2; ++d) form.knots[d] = uniform_knots(form.count[d], degrees[d]);
  for (std::size_t k = 0; k < 42; ++k) {
    const double x = static_cast<double>(k % 6), y = static_cast<double>(k / 6);
    form.net.push_back(
        {{10 * x + unit(random), 9 * y + unit(random), height * unit(random)}, 0.8 + 0.4 * unit(random)});
  }
  return form;
}

void on_random_patches(const Effort& effort, unsigned seed) {
  std::mt19937 random(seed);
  for (int round = 0; round < 6; ++round) {
    Machining machining = test::ball_on(random_form(random));
    machining.cutter = round % 3 == 2 ? Cutter{2, 0.7} : Cutter{2, 2};
    if (round % 3 > 0) machining.orientation = forward;
    machining.along = round % 2 == 0 ? Direction::u : Direction::v;
    const Measured ridges = measured(machining, effort);
    EXPECT_LE(ridges.most, 1 + 1e-3) << "round " << round;
    EXPECT_GT(ridges.mean, 0.5);
  }
}
TEST(Ridges, AreNoHigherOnRandomPatches) {
  on_random_patches(brief, 11);
}
TEST(LongRidges, AreNoHigherOnRandomPatches) {
  on_random_patches(full, testing_support::long_seed());
}

void of_iso_scallop_passes(const Effort& effort) {
  std::mt19937 random(12);
  for (const SurfaceForm& form : {test::patch_a(), saddle(), random_form(random)}) {
    Machining machining = test::ball_on(form);
    machining.cutter = {2, 2};
    machining.pattern = Pattern::iso_scallop;
    const Measured ridges = measured(machining, effort);
    EXPECT_LE(ridges.most, 1 + 1e-3);
    EXPECT_GT(ridges.mean, 0.9);
  }
}
TEST(Ridges, OfIsoScallopPassesAreEverywhereAsHigh) {
  of_iso_scallop_passes(brief);
}
TEST(LongRidges, OfIsoScallopPassesAreEverywhereAsHigh) {
  of_iso_scallop_passes(full);
}

void of_iso_scallop_passes_that_lean(const Effort& effort) {
  std::mt19937 random(14);
  for (const SurfaceForm& form : {test::patch_a(), saddle(), random_form(random, 1)}) {
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Orientation& orientation : {forward, aside}) {
        Machining machining = test::ball_on(form);
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = Pattern::iso_scallop;
        const Measured ridges = measured(machining, effort);
        EXPECT_LE(ridges.most, 1 + 1e-3);
        EXPECT_GT(ridges.mean, 0.9);
      }
    }
  }
}
TEST(Ridges, OfIsoScallopPassesThatLeanAreEverywhereAsHigh) {
  of_iso_scallop_passes_that_lean(brief);
}
TEST(LongRidges, OfIsoScallopPassesThatLeanAreEverywhereAsHigh) {
  of_iso_scallop_passes_that_lean(full);
}

/// The greatest ridge, of the height asked for, between passes whose next one is cut by the border, or goes along it, and those
/// after them.
double tallest_at_border(const Machining& machining, int places) {
  std::vector<Pass> passes;
  Passes made(machining);
  while (std::optional<Pass> pass = made.next()) {
    if (!pass->is_link) passes.push_back(*pass);
  }
  EXPECT_FALSE(made.failure());
  const test::Ridges ridges(machining);
  double most = 0;
  for (std::size_t k = 0; k + 1 < passes.size(); ++k) {
    if (k + 2 < passes.size() && is_next_whole(machining, passes, k)) continue;
    for (int i = 1; i <= places; ++i) {
      const double height = ridges.height(passes, k, passes[k].nodes.back().t * i / (places + 1));
      if (std::isfinite(height)) most = std::max(most, height / machining.scallop);
    }
  }
  return most;
}

/// The neighbour there is the pass along the border, which may be gone the same way: then it has the other side of the tool towards them.
void of_passes_cut_by_the_border(const Effort& effort, const std::vector<unsigned>& seeds) {
  for (const unsigned seed : seeds) {
    std::mt19937 random(seed);
    const SurfaceForm form = random_form(random, 1);
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Orientation& orientation : {forward, aside}) {
        Machining machining = test::ball_on(form, 5, 0.04);
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = Pattern::iso_scallop;
        EXPECT_LE(tallest_at_border(machining, 5 * effort.places), 1 + 1e-3) << "seed " << seed;
      }
    }
  }
}
TEST(Ridges, OfPassesThatTheBorderCutsAreNoHigher) {
  of_passes_cut_by_the_border(brief, {17, 22});
}
TEST(LongRidges, OfPassesThatTheBorderCutsAreNoHigher) {
  const unsigned seed = testing_support::long_seed();
  of_passes_cut_by_the_border(full, {seed, seed + 1, seed + 2, seed + 3});
}

void of_patterns_that_lean_on_random_patches(const Effort& effort, unsigned seed) {
  std::mt19937 random(seed);
  const SurfaceForm form = random_form(random, 1);
  for (const Pattern pattern : {Pattern::zigzag, Pattern::zig, Pattern::iso_scallop, Pattern::planar}) {
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Orientation& orientation : {forward, aside}) {
        Machining machining = test::ball_on(form);
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = pattern;
        const Measured ridges = measured(machining, effort);
        EXPECT_LE(ridges.most, 1 + 1e-3) << "seed " << seed << ", pattern " << static_cast<int>(pattern);
        EXPECT_GT(ridges.mean, pattern == Pattern::iso_scallop ? 0.9 : 0.6);
      }
    }
  }
}
TEST(Ridges, OfAllPatternsThatLeanAreNoHigher) {
  of_patterns_that_lean_on_random_patches(brief, 20);
  of_patterns_that_lean_on_random_patches(brief, 30);
}
TEST(LongRidges, OfAllPatternsThatLeanAreNoHigher) {
  const unsigned seed = testing_support::long_seed();
  for (unsigned k = 0; k < 4; ++k) of_patterns_that_lean_on_random_patches(full, seed + k);
}

void of_passes_in_planes(const Effort& effort) {
  std::mt19937 random(13);
  for (const SurfaceForm& form : {test::patch_a(), saddle(), random_form(random)}) {
    for (const Direction along : {Direction::u, Direction::v}) {
      Machining machining = test::ball_on(form);
      machining.cutter = {2, 2};
      machining.pattern = Pattern::planar;
      machining.along = along;
      const Measured ridges = measured(machining, effort);
      EXPECT_LE(ridges.most, 1 + 1e-3);
      EXPECT_GT(ridges.mean, effort.mean_in_planes);
    }
  }
}
TEST(Ridges, OfPassesInPlanesAreNoHigher) {
  of_passes_in_planes(brief);
}
TEST(LongRidges, OfPassesInPlanesAreNoHigher) {
  of_passes_in_planes(full);
}

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
  std::vector<Pass> legs;
  Passes made(machining);
  while (std::optional<Pass> leg = made.next()) {
    if (!leg->is_link) legs.push_back(*leg);
  }
  EXPECT_FALSE(made.failure());
  const test::Ridges ridges(machining);
  double most = 0;
  for (const auto& [u, v] : places) most = std::max(most, ridges.left_at(legs, u, v) / machining.scallop);
  return most;
}

void of_legs_that_lean(const std::vector<SurfaceForm>& forms, int places, std::mt19937& random) {
  for (const SurfaceForm& form : forms) {
    for (const Cutter& cutter : {Cutter{5, 0}, Cutter{5, 1}}) {
      for (const Orientation& orientation : {forward, aside}) {
        Machining machining = test::ball_on(form, 5, 0.04);
        machining.cutter = cutter;
        machining.orientation = orientation;
        machining.pattern = Pattern::spiral_in;
        const double most = tallest_at(machining, near_corners(places, random));
        EXPECT_LE(most, 1 + 1e-3);
        EXPECT_GT(most, 0.6);
      }
    }
  }
}
TEST(Ridges, OfLegsThatLeanAreNoHigherAtTheirCornersToo) {
  std::mt19937 random(40);
  of_legs_that_lean({saddle()}, 60, random);
}
TEST(LongRidges, OfLegsThatLeanAreNoHigherAtTheirCornersToo) {
  const unsigned seed = testing_support::long_seed();
  std::mt19937 random(seed);
  of_legs_that_lean({test::patch_a(), saddle(), random_form(random, 1), random_form(random, 1)}, 400, random);
}

/// The reaches of a leg towards the next and of that one back to it begin at places apart, where the tool is tilted.
TEST(Ridges, BetweenLegsThatLeanAreNoHigherWhereLegsBegin) {
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
TEST(Ridges, OfPassesRoundTheRangeAreNoHigherAtTheirCornersToo) {
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

}  // namespace test_ridges
}  // namespace leadscrew::surfaces
