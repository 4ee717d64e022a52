// The ridges between passes, measured by brute force: as high as was asked for, and no higher.

#include <gtest/gtest.h>

#include <algorithm>
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
  const std::vector<Pass> passes = test::passes_of(machining);
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

const Orientation forward = Orientation::leaning(0.2, 0), aside = Orientation::leaning(0.2, 0.1);

void as_asked_for(const Effort& effort) {
  const Orientation normal{Orientation::Rule::normal, {}};
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
  for (const SurfaceForm& form : {test::patch_a(), test::saddle()}) {
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

void on_random_patches(const Effort& effort, unsigned seed) {
  std::mt19937 random(seed);
  for (int round = 0; round < 6; ++round) {
    Machining machining = test::ball_on(test::random_form(random));
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
  for (const SurfaceForm& form : {test::patch_a(), test::saddle(), test::random_form(random)}) {
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
  for (const SurfaceForm& form : {test::patch_a(), test::saddle(), test::random_form(random, 1)}) {
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
  const std::vector<Pass> passes = test::passes_of(machining);
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
    const SurfaceForm form = test::random_form(random, 1);
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
  const SurfaceForm form = test::random_form(random, 1);
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
  for (const SurfaceForm& form : {test::patch_a(), test::saddle(), test::random_form(random)}) {
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

}  // namespace test_ridges
}  // namespace leadscrew::surfaces
