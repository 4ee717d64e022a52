// Passes over surfaces: how many, how long, and how near to the true path of the tip.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <leadscrew/surfaces/quintic_spline.hpp>
#include <numbers>

#include "pass_curves.hpp"
#include "patches.hpp"

namespace leadscrew::surfaces {
namespace test_passes {

struct Told {
  std::vector<Pass> passes, links;
  std::optional<PassFailure> failure;
};
Told told(const Machining& machining) {
  Told all;
  Passes passes(machining);
  while (std::optional<Pass> pass = passes.next()) (pass->is_link ? all.links : all.passes).push_back(*pass);
  all.failure = passes.failure();
  return all;
}

TEST(Passes, AreThoseOfTheStudy) {
  Machining machining = test::ball_on(test::patch_a());
  const Told all = told(machining);
  EXPECT_FALSE(all.failure);
  EXPECT_EQ(all.passes.size(), 100u);
  EXPECT_EQ(all.links.size(), 99u);
  double of_tip = 0, of_contact = 0;
  for (const Pass& pass : all.passes) {
    of_tip += pass.nodes.back().t;
    Vector last = test::at(pass, &PassNode::contact, 0);
    for (int k = 1; k <= 500; ++k) {
      const Vector next = test::at(pass, &PassNode::contact, pass.nodes.back().t * k / 500);
      of_contact += numeric::distance(last, next);
      last = next;
    }
  }
  EXPECT_NEAR(of_contact, 6061.9, 0.1);
  EXPECT_NEAR(of_tip, 6210.5, 0.1);
  machining.equal_steps = true;
  EXPECT_EQ(told(machining).passes.size(), 104u);
}

/// As passes of a draft told so many, and then made by its lines.
Told told_behind_draft(const Machining& machining, std::size_t most) {
  Machining rough = machining;
  rough.is_draft = true;
  Passes draft(rough);
  for (std::size_t k = 0; k < most && draft.next(); ++k) {
  }
  Told all;
  Passes passes(machining, draft.found_lines());
  while (std::optional<Pass> pass = passes.next()) (pass->is_link ? all.links : all.passes).push_back(*pass);
  all.failure = passes.failure();
  return all;
}

void expect_same(const std::vector<Pass>& a, const std::vector<Pass>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].number, b[k].number);
    ASSERT_EQ(a[k].nodes.size(), b[k].nodes.size());
    for (std::size_t i = 0; i < a[k].nodes.size(); ++i) {
      EXPECT_EQ(a[k].nodes[i].tip, b[k].nodes[i].tip);
      EXPECT_EQ(a[k].nodes[i].axis, b[k].nodes[i].axis);
    }
  }
}

TEST(Passes, ByTheLinesOfADraftAreThoseMadeAlone) {
  for (const Pattern pattern :
       {Pattern::zig, Pattern::zigzag, Pattern::spiral_in, Pattern::iso_scallop, Pattern::planar}) {
    Machining machining = test::ball_on(test::patch_a(), 5, 0.2);
    machining.cutter = {5, 1};
    machining.orientation = Orientation::leaning(0.2, 0.1);
    machining.pattern = pattern;
    const Told alone = told(machining);
    EXPECT_FALSE(alone.failure);
    EXPECT_GT(alone.passes.size(), 5u);
    for (const std::size_t most : {std::size_t{3}, std::size_t{100'000}}) {  // not to the end, and to the end
      const Told behind = told_behind_draft(machining, most);
      EXPECT_FALSE(behind.failure);
      expect_same(alone.passes, behind.passes);
      expect_same(alone.links, behind.links);
    }
  }
}

TEST(Passes, BeginAtTheirCorner) {
  for (int corner = 1; corner <= 4; ++corner) {
    for (const Direction along : {Direction::u, Direction::v}) {
      Machining machining = test::ball_on(test::patch_a());
      machining.start_corner = corner;
      machining.along = along;
      machining.u = {0.1, 0.6};
      machining.v = {0.3, 0.9};
      const Told all = told(machining);
      const PassNode &begin = all.passes.front().nodes.front(), &turn = all.passes.front().nodes.back();
      EXPECT_DOUBLE_EQ(begin.u, corner == 1 || corner == 4 ? 0.1 : 0.6);
      EXPECT_DOUBLE_EQ(begin.v, corner <= 2 ? 0.3 : 0.9);
      EXPECT_DOUBLE_EQ(along == Direction::u ? turn.v : turn.u, along == Direction::u ? begin.v : begin.u);
      EXPECT_DOUBLE_EQ(std::abs(along == Direction::u ? turn.u - begin.u : turn.v - begin.v),
                       along == Direction::u ? 0.5 : 0.6);
    }
  }
}

/// A plane whose far border is least, by this much below the pass in the plane y = 20 steps, between two places where passes are looked at.
Machining narrowest_at(double depth) {
  SurfaceForm form{{2, 1}, {uniform_knots(3, 2), uniform_knots(2, 1)}, {3, 2}, {}};
  for (const std::array<double, 3>& border : {std::array{0.0, 0.0, 0.0}, std::array{32.0, 28.0, 33.0}}) {
    for (std::size_t i = 0; i < 3; ++i) form.net.push_back({{20.0 * static_cast<double>(i), border[i], 0}, 1});
  }
  Machining machining = test::ball_on(form);
  machining.pattern = Pattern::planar;
  machining.scallop = 0;
  machining.step = (32 - 16.0 / 9 + depth) / 20;
  return machining;
}

TEST(Passes, InPlanesEndAtTheBorderWhereThatIsNarrowestToo) {
  for (const double depth : {1e-2, 1e-5, 1e-8, 1e-12, -1e-12}) {
    const Machining machining = narrowest_at(depth);
    const Told all = told(machining);
    EXPECT_FALSE(all.failure);
    std::size_t parts = 0;
    for (const Pass& pass : all.passes) {
      if (pass.number != 20) continue;
      ++parts;
      for (int i = 0; i <= 200; ++i) {
        const double y = test::at(pass, &PassNode::contact, pass.nodes.back().t * i / 200)[1];
        EXPECT_NEAR(y, 20 * machining.step, 1e-9) << depth;
      }
    }
    EXPECT_EQ(parts, depth > 1e-11 ? 2u : 1u) << depth;
  }
}

/// The tip of the ball at u, by the surface itself.
Vector true_tip(const Surface& surface, double u, double v, double radius) {
  const SurfaceJet jet = surface.jet(u, v);
  const Frame frame = *frame_of(jet, 1);
  return {jet.s[0] + radius * frame.n[0], jet.s[1] + radius * frame.n[1], jet.s[2] + radius * frame.n[2] - radius};
}

TEST(Passes, AreTheTipsPathToATenthOfANanometre) {
  const Machining machining = test::ball_on(test::patch_a());
  const Told all = told(machining);
  double worst = 0;
  for (std::size_t k = 0; k < all.passes.size(); k += 9) {
    const Pass& pass = all.passes[k];
    for (int i = 0; i <= 300; ++i) {
      const Vector found = test::at(pass, &PassNode::tip, pass.nodes.back().t * i / 300);
      // The nearest place of the true path by Newton's method on the distance, differences for derivatives.
      double u = test::at(pass, &PassNode::contact, pass.nodes.back().t * i / 300)[0] / 60;
      for (int round = 0; round < 30; ++round) {
        const double h = 1e-5;
        const Vector low = true_tip(*machining.surface, u - h, pass.across, 5),
                     high = true_tip(*machining.surface, u + h, pass.across, 5),
                     here = true_tip(*machining.surface, u, pass.across, 5);
        const Vector along = numeric::difference(high, low), off = numeric::difference(found, here);
        u = std::clamp(u + numeric::dot(off, along) / numeric::dot(along, along) * 2 * h, 0.0, 1.0);
      }
      worst = std::max(worst, numeric::distance(found, true_tip(*machining.surface, u, pass.across, 5)));
    }
  }
  EXPECT_LT(worst, 1.2e-10);
}

TEST(Passes, GoOnIntoTheirLinksWithDirectionAndCurvature) {
  Machining machining = test::ball_on(test::patch_a());
  machining.cutter = {5, 1};
  machining.orientation = Orientation::leaning(0.1, 0.05);
  for (const Pattern pattern : {Pattern::zigzag, Pattern::zig}) {
    machining.pattern = pattern;
    Passes passes(machining);
    std::optional<Pass> last = passes.next();
    ASSERT_TRUE(last);
    std::size_t joints = 0;
    while (std::optional<Pass> pass = passes.next()) {
      EXPECT_NE(pass->is_link, last->is_link);
      const PassNode &a = last->nodes.back(), &b = pass->nodes.front();
      EXPECT_EQ(b.t, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t order = 0; order <= 2; ++order) {
          EXPECT_DOUBLE_EQ(a.tip[k][order], b.tip[k][order]);
          EXPECT_DOUBLE_EQ(a.axis[k][order], b.axis[k][order]);
        }
      }
      last = pass;
      ++joints;
    }
    EXPECT_FALSE(last->is_link);
    EXPECT_GT(joints, 50u);
    EXPECT_FALSE(passes.failure());
  }
}

TEST(QuinticSpline, IsTheQuinticsBetweenItsNodes) {
  const Told all = told(test::ball_on(test::patch_a()));
  const Pass& pass = all.passes[37];
  std::vector<double> t;
  std::vector<std::array<numeric::Jet<2>, 3>> jets;
  for (const PassNode& node : pass.nodes) {
    t.push_back(node.t);
    jets.push_back(node.tip);
  }
  const QuinticSpline<3> spline = quintic_spline<3>(t, jets);
  ASSERT_EQ(spline.points.size(), 3 * t.size());
  ASSERT_EQ(spline.knots.size(), spline.points.size() + 6);
  for (int i = 0; i <= 777; ++i) {
    const double at = t.back() * i / 777;
    const Vector by_knots = test::de_boor(spline, at), by_nodes = test::at(pass, &PassNode::tip, at);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(by_knots[k], by_nodes[k], 1e-12);
  }
}

}  // namespace test_passes
}  // namespace leadscrew::surfaces
