// Passes across the knots of a surface: smooth where the surface is, cut where it has a corner.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <random>

#include "pass_curves.hpp"
#include "patches.hpp"

namespace leadscrew::surfaces {
namespace test_pass_joints {

/// Bicubic over 60 by 60 mm, inner knots at the quarters, each so often.
SurfaceForm with_knots(std::size_t repeated, unsigned seed) {
  std::vector<double> knots(4, 0.0);
  for (const double knot : {0.25, 0.5, 0.75}) knots.insert(knots.end(), repeated, knot);
  knots.insert(knots.end(), 4, 1.0);
  const std::size_t n = knots.size() - 4;
  SurfaceForm form{{3, 3}, {knots, knots}, {n, n}, {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(0, 3);
  const double spacing = 60 / static_cast<double>(n - 1);
  for (std::size_t k = 0; k < n * n; ++k) {
    form.net.push_back(
        {{spacing * static_cast<double>(k % n), spacing * static_cast<double>(k / n), height(random)}, 1});
  }
  return form;
}

struct Told {
  std::vector<Pass> passes;
  std::size_t corners = 0;
  bool is_whole = false;
};
Told told(const Machining& machining) {
  Told all;
  Passes passes(machining);
  bool after_pass = false;
  while (std::optional<Pass> pass = passes.next()) {
    if (!pass->is_link) all.passes.push_back(*pass);
    all.corners += after_pass && !pass->is_link ? 1 : 0;
    after_pass = !pass->is_link;
  }
  all.is_whole = !passes.failure();
  return all;
}

/// The farthest that the ball's centre is from the surface's offset, by the surface's own jets at the contact.
double farthest(const Machining& machining, const std::vector<Pass>& passes) {
  double worst = 0;
  for (std::size_t k = 0; k < passes.size(); k += 5) {
    for (int i = 0; i <= 200; ++i) {
      const double t = passes[k].nodes.back().t * i / 200;
      Vector centre = test::at(passes[k], &PassNode::tip, t);
      centre[2] += machining.cutter.radius;
      // The nearest place of the surface, by Newton's method from the contact.
      const Vector contact = test::at(passes[k], &PassNode::contact, t);
      double u = contact[0] / 60, v = contact[1] / 60;
      for (int round = 0; round < 40; ++round) {
        const SurfaceJet jet = machining.surface->jet(u, v);
        const Vector off = numeric::difference(centre, jet.s);
        const double a = numeric::dot(jet.u, jet.u) - numeric::dot(off, jet.uu),
                     b = numeric::dot(jet.u, jet.v) - numeric::dot(off, jet.uv),
                     c = numeric::dot(jet.v, jet.v) - numeric::dot(off, jet.vv), p = numeric::dot(off, jet.u),
                     q = numeric::dot(off, jet.v);
        u = std::clamp(u + (c * p - b * q) / (a * c - b * b), 0.0, 1.0);
        v = std::clamp(v + (a * q - b * p) / (a * c - b * b), 0.0, 1.0);
      }
      worst =
          std::max(worst, std::abs(numeric::distance(centre, machining.surface->at(u, v)) - machining.cutter.radius));
    }
  }
  return worst;
}

TEST(PassJoints, AreSmoothAtSimpleKnotsWithinAMicronsThousandth) {
  for (const unsigned seed : {1u, 2u}) {
    const Machining machining = test::ball_on(with_knots(1, seed), 2, 0.05);
    const Told all = told(machining);
    EXPECT_TRUE(all.is_whole);
    EXPECT_EQ(all.corners, 0u);
    EXPECT_LT(farthest(machining, all.passes), 1.1 * knot_tolerance);
  }
}

TEST(PassJoints, AreCornersWhereTheSurfaceBendsByAStep) {
  const Machining machining = test::ball_on(with_knots(2, 1), 2, 0.05);
  const Told all = told(machining);
  EXPECT_TRUE(all.is_whole);
  EXPECT_GT(all.corners, 2 * all.passes.size() / 4);
  for (std::size_t k = 0; k + 1 < all.passes.size(); ++k) {
    if (all.passes[k].number != all.passes[k + 1].number) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(all.passes[k].nodes.back().tip[i][0], all.passes[k + 1].nodes.front().tip[i][0], 1e-9);
    }
  }
  EXPECT_LT(farthest(machining, all.passes), 2e-10);
}

/// Two quarters of a circle as one rational quadratic: the parameter has a step in its rate, the circle none.
TEST(PassJoints, OfArcsInOneCircleAreNone) {
  SurfaceForm form{{1, 2}, {uniform_knots(2, 1), {0, 0, 0, 0.5, 0.5, 1, 1, 1}}, {2, 5}, {}};
  const std::array<std::pair<double, double>, 5> round = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
  for (std::size_t j = 0; j < 5; ++j) {
    for (const double x : {0.0, 40.0}) {
      form.net.push_back({{x, 20 * round[j].first, 20 * round[j].second}, j % 2 == 1 ? std::sqrt(0.5) : 1});
    }
  }
  Machining machining = test::ball_on(form, 2, 0.05);
  machining.side = -1;
  machining.along = Direction::v;
  machining.orientation = Orientation::leaning(0.2, 0);
  const Told all = told(machining);
  EXPECT_TRUE(all.is_whole);
  EXPECT_EQ(all.corners, 0u);
  for (const Pass& pass : all.passes) {
    // n leans back from the axis by 0.2: the tip goes round on a circle too.
    const double out = 20 + 2 - 2 * std::cos(0.2), aside = 2 * std::sin(0.2), radius = std::hypot(out, aside);
    EXPECT_NEAR(pass.nodes.back().t, radius * 3.14159265358979, 1e-9);
    for (int i = 0; i <= 100; ++i) {
      const Vector tip = test::at(pass, &PassNode::tip, pass.nodes.back().t * i / 100);
      EXPECT_NEAR(std::hypot(tip[1], tip[2]), radius, 1.1e-10);
    }
  }
}

TEST(PassJoints, LongPassesAreToldInPartsThatGoOnSmoothly) {
  SurfaceForm form{{3, 1}, {uniform_knots(1600, 3), uniform_knots(2, 1)}, {1600, 2}, {}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> height(0, 0.01);
  for (std::size_t k = 0; k < 3200; ++k) {
    form.net.push_back({{static_cast<double>(k % 1600), k < 1600 ? 0.0 : 1.0, height(random)}, 1});
  }
  Machining machining = test::ball_on(form, 2, 0.05);
  machining.scallop = 0;
  machining.step = 1;
  const Told all = told(machining);
  ASSERT_TRUE(all.is_whole);
  EXPECT_GT(all.passes.size(), 2u);
  for (std::size_t k = 0; k + 1 < all.passes.size(); ++k) {
    const Pass &a = all.passes[k], &b = all.passes[k + 1];
    EXPECT_LE(a.nodes.size(), most_nodes);
    if (a.number != b.number) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t order = 0; order <= 2; ++order)
        EXPECT_EQ(a.nodes.back().tip[i][order], b.nodes.front().tip[i][order]);
    }
  }
}

}  // namespace test_pass_joints
}  // namespace leadscrew::surfaces
