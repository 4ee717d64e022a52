// Does a tool gouge where it touches? What curvature tensors say beside a distance field about the contact.

#include <gtest/gtest.h>

#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/passes.hpp>

#include "../surfaces/patches.hpp"
#include "bodies.hpp"

namespace leadscrew::gouging {
namespace test_local {

using surfaces::Cutter;
using surfaces::Surface;
using surfaces::Tensor;
using test::field;
using test::Random;

/// A tool that touches z = (K_ff x² + 2 K_fb x y + K_bb y²)/2 at 0 from above.
struct Contact {
  Part part;
  Pose pose;
  Tensor surface;
  double clearance = 0;  // what the tensors say
  double lean = 0;
};

Contact random_contact(Random& random, int kind) {
  const double R = random.between(1, 10);
  const Cutter cutter{R, kind == 0 ? R : kind == 1 ? 0 : R * random.between(0.1, 0.9)};
  const double lean = random.between(0.05, 1.2), azimuth = random.between(-3.1, 3.1);
  const Vector n = {0, 0, 1};
  const Vector axis = {std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth), std::cos(lean)};
  const surfaces::TangentPair pair{{1, 0, 0}, {0, 1, 0}};
  const Tensor tool = surfaces::curvature_of(cutter, n, axis, pair);
  // The surface's principal curvatures about those of the tool
  const double sine = std::sin(lean), r = cutter.corner_radius;
  const double across = cutter.is_ball() ? 1 / R : sine / (R - r + r * sine), along = r > 0 ? 1 / r : 1 / R;
  const double a = across * random.between(-2, 2), b = random.between(0, 1) < 0.5 ? along * random.between(-2, 2) : a;
  const double turn = random.between(0, 3.1), c = std::cos(turn), s = std::sin(turn);
  Contact contact;
  contact.surface = {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
  contact.part = {Part::Kind::cutter, R, r, 0};
  contact.pose = {surfaces::tip_of(cutter, Vector{0, 0, 0}, n, axis, Vector{1, 0, 0}), axis};
  contact.clearance = surfaces::local_clearance(tool, contact.surface);
  contact.lean = lean;
  return contact;
}

/// The least distance of the surface about the contact from the tool, over half the distance squared. Under a flat tool's edge
/// lie those places across the lean whose other coordinate is as their square.
double clearance_by_field(const Contact& contact) {
  const auto& [part, pose, K, clearance, lean] = contact;
  const double greatest =
      std::max({std::abs(K.ff), std::abs(K.bb), 1 / part.radius, part.corner > 0 ? 1 / part.corner : 0});
  const double size = 1e-3 * std::sin(lean) / greatest;
  const double mx = pose.axis[0] / std::sin(lean), my = pose.axis[1] / std::sin(lean);
  double least = 1e9;
  const auto see = [&](double along, double across) {
    const double x = along * mx - across * my, y = along * my + across * mx;
    const double z = (K.ff * x * x + 2 * K.fb * x * y + K.bb * y * y) / 2;
    least = std::min(least, field(part, pose, {x, y, z}) / ((x * x + y * y) / 2));
  };
  for (int k = 0; k < 720; ++k) {
    const double angle = 2 * std::numbers::pi * k / 720;
    see(size * std::cos(angle), size * std::sin(angle));
  }
  for (int k = -400; k <= 400; ++k) {
    for (const double side : {-1.0, 1.0}) see(k / 100.0 / (part.radius * std::cos(lean)) * size * size, side * size);
  }
  return least;
}

TEST(LocalClearance, IsTheVerdictOfADistanceField) {
  Random random(31);
  int gouging = 0;
  for (int count = 0; count < 400;) {
    const Contact contact = random_contact(random, count % 3);
    if (std::abs(contact.clearance) < 0.02 / contact.part.radius * std::sin(contact.lean)) continue;  // nearly alike
    ++count;
    const double found = clearance_by_field(contact);
    EXPECT_EQ(found < 0, contact.clearance < 0)
        << count << ": " << found << ' ' << contact.clearance << " R " << contact.part.radius << " r "
        << contact.part.corner << " lean " << contact.lean;
    if (contact.part.corner > 0) {
      EXPECT_NEAR(found, contact.clearance, 0.02 * (std::abs(contact.clearance) + 1 / contact.part.corner));
    }
    gouging += contact.clearance < 0;
  }
  EXPECT_GT(gouging, 100);
  EXPECT_LT(gouging, 300);
}

double least_on_passes(double radius) {
  surfaces::Machining how;
  how.surface = std::make_shared<Surface>(surfaces::test::patch_a());
  how.cutter = {radius, radius};
  how.step = 1;
  how.allows_gouging = true;
  surfaces::Passes passes(how);
  while (passes.next()) {
  }
  return passes.least_clearance()->clearance;
}

TEST(LocalClearance, OfPatchAIsBelow0ForBallsAboveItsRadiusOfCurvature) {
  EXPECT_GT(least_on_passes(45.4), 0);
  EXPECT_LT(least_on_passes(45.5), 0);
}

}  // namespace test_local
}  // namespace leadscrew::gouging
