// The simulated probe before surfaces: where it trips, by other formulas and by search.

#include <cmath>
#include <leadscrew/gcode/patch_meeting.hpp>
#include <leadscrew/gcode/probe_contact.hpp>
#include <leadscrew/surfaces/bezier_nets.hpp>
#include <random>

#include "probe_programs.hpp"

namespace leadscrew::gcode {
namespace test_probe_patches {

using machine::Probe;
using machine::ProbePatch;
using machine::Vector;
using surfaces::SurfaceForm;
using Random = std::mt19937_64;

double draw(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

std::vector<ProbePatch> patches_of(const SurfaceForm& form) {
  std::vector<ProbePatch> patches;
  for (auto& net : surfaces::bezier_nets(form)) patches.push_back({form.degree, std::move(net)});
  return patches;
}

/// Over x and y from 0 to `side`, where x and y are the parameters times that: control points stand at means of knots.
SurfaceForm height_field(Random& random, double side, double height) {
  SurfaceForm form;
  for (std::size_t d = 0; d < 2; ++d) {
    form.degree[d] = 1 + static_cast<int>(random() % 5);
    form.count[d] = static_cast<std::size_t>(form.degree[d]) + 1 + random() % 5;
    form.knots[d] = surfaces::uniform_knots(form.count[d], form.degree[d]);
  }
  const auto mean = [&](std::size_t d, std::size_t k) {
    double sum = 0;
    for (int i = 1; i <= form.degree[d]; ++i) sum += form.knots[d][k + static_cast<std::size_t>(i)];
    return sum / form.degree[d];
  };
  for (std::size_t j = 0; j < form.count[1]; ++j) {
    for (std::size_t i = 0; i < form.count[0]; ++i)
      form.net.push_back({{side * mean(0, i), side * mean(1, j), draw(random, -height, height)}, 1});
  }
  return form;
}

Vector between(const Vector& a, const Vector& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

TEST(BezierNets, AreTheSurface) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    SurfaceForm form = height_field(random, 60, 15);
    for (surfaces::NetPoint& point : form.net) point.weight = draw(random, 0.5, 2);
    ASSERT_FALSE(surfaces::fault_of(form));
    const surfaces::Surface surface(form);
    const auto nets = surfaces::bezier_nets(form);
    const auto& us = surface.breaks(surfaces::Direction::u);
    const auto& vs = surface.breaks(surfaces::Direction::v);
    ASSERT_EQ(nets.size(), (us.size() - 1) * (vs.size() - 1));
    for (std::size_t k = 0; k < nets.size(); ++k) {
      const std::size_t i = k % (us.size() - 1), j = k / (us.size() - 1);
      const auto p = static_cast<std::size_t>(form.degree[0]), q = static_cast<std::size_t>(form.degree[1]);
      ASSERT_EQ(nets[k].size(), (p + 1) * (q + 1));
      // The four corners, and the middle by Bernstein's polynomials.
      std::array<double, 4> middle{};
      const auto choose = [](std::size_t n, std::size_t m) {
        return std::tgamma(static_cast<double>(n + 1)) / std::tgamma(static_cast<double>(m + 1)) /
               std::tgamma(static_cast<double>(n - m + 1));
      };
      for (std::size_t b = 0; b <= q; ++b) {
        for (std::size_t a = 0; a <= p; ++a) {
          const auto& point = nets[k][a + b * (p + 1)];
          const double share = choose(p, a) * choose(q, b) * std::ldexp(point[3], -static_cast<int>(p + q));
          for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += share * point[axis];
          middle[3] += share;
        }
      }
      const Vector there = surface.at((us[i] + us[i + 1]) / 2, (vs[j] + vs[j + 1]) / 2);
      const Vector corner = surface.at(us[i], vs[j]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(middle[axis] / middle[3], there[axis], 1e-12 * 60);
        EXPECT_NEAR(nets[k].front()[axis], corner[axis], 1e-12 * 60);
      }
    }
  }
}

/// The first place where z of the line less z of the surface changes its sign, by steps and halving; NaN where none.
double searched(const surfaces::Surface& surface, double side, const Vector& from, const Vector& to) {
  const auto above = [&](double share) {
    const Vector p = between(from, to, share);
    const bool is_beside = p[0] < 0 || p[0] > side || p[1] < 0 || p[1] > side;
    return is_beside ? NAN : p[2] - surface.at(p[0] / side, p[1] / side)[2];
  };
  constexpr int steps = 4000;
  double before = above(0);
  for (int k = 1; k <= steps; ++k) {
    const double now = above(static_cast<double>(k) / steps);
    if ((before < 0 && now >= 0) || (before > 0 && now <= 0)) {
      double low = static_cast<double>(k - 1) / steps, high = static_cast<double>(k) / steps;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((above(middle) < 0) == (before < 0) ? low : high) = middle;
      }
      return (low + high) / 2;
    }
    before = now;
  }
  return NAN;
}

TEST(ProbePatches, OfHeightsAreMetWhereASearchFindsIt) {
  Random random(11);
  constexpr double side = 60;
  int met = 0, passed = 0, grazed = 0;
  for (int round = 0; round < 60; ++round) {
    const SurfaceForm form = height_field(random, side, 15);
    const surfaces::Surface surface(form);
    const std::vector<ProbePatch> patches = patches_of(form);
    for (int k = 0; k < 25; ++k) {
      const Vector from = {draw(random, -10, 70), draw(random, -10, 70), draw(random, 16, 30)};
      const Vector to = {draw(random, -10, 70), draw(random, -10, 70), draw(random, -30, 16)};
      const double share = searched(surface, side, from, to);
      const auto found = first_meeting(patches, from, to);
      ++(std::isnan(share) ? passed : met);
      if (found && (std::isnan(share) || *found < share - 1e-3)) {
        // Two crossings inside one step, or at the border: then the place must be on the surface.
        const Vector p = between(from, to, *found);
        EXPECT_NEAR(surface.at(p[0] / side, p[1] / side)[2], p[2], 3e-9) << round << " " << k;
        ++grazed;
        continue;
      }
      ASSERT_EQ(found.has_value(), !std::isnan(share)) << round << " " << k;
      if (!found) continue;
      const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      const Vector p = between(from, to, *found);
      const double slip = std::abs(surface.at(p[0] / side, p[1] / side)[2] - p[2]);
      EXPECT_LT(slip, 1e-8) << round << " " << k;
      EXPECT_NEAR(*found * length, share * length, 1e-6) << round << " " << k;
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(passed, 200);
  EXPECT_LT(grazed, 20);
}

/// A quarter of a cylinder of radius 10 about Y, 30 long: rational, against the circle.
std::vector<ProbePatch> quarter() {
  const double w = std::sqrt(0.5);
  return {{{2, 1}, {{10, 0, 0, 1}, {10, 0, 10, w}, {0, 0, 10, 1}, {10, 30, 0, 1}, {10, 30, 10, w}, {0, 30, 10, 1}}}};
}

TEST(ProbePatches, OfACylinderAreMetOnTheCircle) {
  Random random(5);
  const std::vector<ProbePatch> patches = quarter();
  int met = 0;
  for (int k = 0; k < 3000; ++k) {
    const double angle = draw(random, 0.01, 1.56), y = draw(random, 0.01, 29.99);
    const Vector on = {10 * std::cos(angle), y, 10 * std::sin(angle)};
    const Vector from = {on[0] + draw(random, 0, 20), y + draw(random, -5, 5), on[2] + draw(random, 0.5, 20)};
    const Vector to = between(from, on, draw(random, 1.0001, 2));
    const auto found = first_meeting(patches, from, to);
    ASSERT_TRUE(found) << k;
    const Vector p = between(from, to, *found);
    EXPECT_NEAR(std::hypot(p[0], p[2]), 10, 1e-9) << k;
    EXPECT_LE(*found, std::hypot(on[0] - from[0], on[1] - from[1], on[2] - from[2]) /
                              std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]) +
                          1e-9);
    ++met;
    EXPECT_FALSE(first_meeting(patches, from, between(from, to, *found - 1e-8))) << k;
  }
  EXPECT_EQ(met, 3000);
}

/// At z = −3, over x and y from 0 to 50.
Probe level() {
  Probe probe;
  probe.patches = {{{1, 1}, {{0, 0, -3, 1}, {50, 0, -3, 1}, {0, 50, -3, 1}, {50, 50, -3, 1}}}};
  return probe;
}

TEST(ProbePatches, TripTheProbeOfAProgram) {
  EXPECT_EQ(told("G0 X10 Y10 Z5\nG38.2 Z-10" + tell, level()), "10.000 10.000 -3.000 1;");
  EXPECT_EQ(told("G0 X10 Y10 Z-20\nG38.2 Z10" + tell, level()), "10.000 10.000 -3.000 1;");  // from either side
  EXPECT_EQ(told("G0 X-10 Y10 Z5\nG38.3 Z-10" + tell, level()), "-10.000 10.000 -10.000 0;");
  EXPECT_EQ(told("G0 X-10 Y10 Z5\nG38.2 Z-10\n", level()), "3:1 probe-failed; ");
  EXPECT_EQ(told("G0 X10 Y10 Z5\nG38.2 Z-10\nG38.2 Z-12\n", level()), "4:1 probe-state; ");
  EXPECT_EQ(told("G0 X10 Y10 Z5\nG38.2 Z-10\nG38.4 Z5" + tell, level()), "10.000 10.000 -3.000 1;");
  EXPECT_EQ(told("G0 X10 Y10 Z5\nG38.2 Z-10\nG0 Z5\nG38.2 X40 Z-11" + tell, level()), "25.000 10.000 -3.000 1;");
  EXPECT_EQ(told("G43.1 Z50\nG0 X10 Y10 Z5\nG38.2 Z-10" + tell, level()), "10.000 10.000 -3.000 1;");
}

/// Of either side the next contact is met only on the way back.
TEST(ProbePatches, AreFreeOnTheSideToWhichContactWasLost) {
  const std::string on = "10.000 10.000 -3.000 1;", begin = "G0 X10 Y10 Z5\nG38.2 Z-10\nG38.4 Z5" + tell;
  EXPECT_EQ(told(begin + "G38.3 Z5" + tell, level()), on + "10.000 10.000 5.000 0;");
  EXPECT_EQ(told(begin + "G38.3 X14 Y3 Z5" + tell, level()), on + "14.000 3.000 5.000 0;");
  EXPECT_EQ(told(begin + "G38.3 X40" + tell, level()), on + "40.000 10.000 -3.000 0;");
  EXPECT_EQ(told(begin + "G38.2 Z-10" + tell, level()), on + on);
  EXPECT_EQ(told(begin + "G38.2 X40 Z-5" + tell, level()), on + on);
  EXPECT_EQ(told(begin + "G38.5 X12" + tell + "G38.3 Z5" + tell, level()), on + on + "10.000 10.000 5.000 0;");
  const std::string through = "G0 X10 Y10 Z5\nG38.2 Z-10\nG38.4 Z-10" + tell;  // it has no thickness
  EXPECT_EQ(told(through + "G38.3 Z-10" + tell, level()), on + "10.000 10.000 -10.000 0;");
  EXPECT_EQ(told(through + "G38.2 Z5" + tell, level()), on + on);
  // A second one above.
  Probe two = level();
  two.patches.push_back({{1, 1}, {{0, 0, 4, 1}, {50, 0, 4, 1}, {0, 50, 4, 1}, {50, 50, 4, 1}}});
  EXPECT_EQ(told("G0 X10 Y10 Z1\nG38.2 Z-10\nG38.4 Z3" + tell + "G38.2 Z9" + tell, two), on + "10.000 10.000 4.000 1;");
}

TEST(ProbePatches, AreCutOutByPockets) {
  Probe probe = level();
  probe.bodies = {{machine::ProbeBody::Kind::pocket, {20, 20, -10}, {30, 30, 10}}};
  EXPECT_EQ(told("G0 X25 Y25 Z15\nG38.3 Z-20" + tell, probe), "25.000 25.000 -20.000 0;");
  EXPECT_EQ(told("G0 X25 Y5 Z15\nG38.3 Z-20" + tell, probe), "25.000 5.000 -3.000 1;");
  probe.bodies.push_back({machine::ProbeBody::Kind::box, {0, 0, -1}, {10, 10, 0}});
  EXPECT_EQ(told("G0 X5 Y5 Z15\nG38.3 Z-20" + tell, probe), "5.000 5.000 0.000 1;");
}

/// A line beside a plane patch, and along one that bends away, is decided in bounded work.
TEST(ProbePatches, ArePassedCloseBy) {
  const std::vector<ProbePatch> plane = level().patches;
  for (const double height : {1e-9, 1e-7, 1e-3})
    EXPECT_FALSE(first_meeting(plane, {-10, 20, -3 + height}, {60, 25, -3 + height})) << height;
  EXPECT_TRUE(first_meeting(plane, {-10, 20, -3}, {60, 25, -3}));
  EXPECT_TRUE(first_meeting(plane, {-10, 20, -3 + 1e-3}, {60, 25, -3 - 1e-3}));
  const std::vector<ProbePatch> round = quarter();
  for (const double height : {1e-3, 1e-6})
    EXPECT_FALSE(first_meeting(round, {-5, 10, 10 + height}, {5, 12, 10 + height})) << height;
  EXPECT_TRUE(first_meeting(round, {5, 10, 10}, {-5, 12, 9.9999}));
}

}  // namespace test_probe_patches
}  // namespace leadscrew::gcode
