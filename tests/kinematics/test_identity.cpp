#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "machines.hpp"

// To the axes and back is the identity: 1e-10 mm for the tip, 1e-12 rad for the tool's direction; from angles to a direction
// and back one of the two solutions is what it was.

namespace leadscrew::kinematics::testing {
namespace test_identity {

struct Worst {
  double tip = 0, direction = 0;  ///< mm, radians
  double angle = 0;               ///< degrees: of the nearer solution
};

double turned_apart(double a, double b) {
  return std::abs(std::remainder(a - b, 360));
}

Vector drawn_vector(Draw& draw, double greatest) {
  return {draw(-greatest, greatest), draw(-greatest, greatest), draw(-greatest, greatest)};
}

void go_round(const Chain& chain, Draw& draw, Worst& worst) {
  const Angles<double> angles = {draw(-180, 180), draw(-180, 180)};
  const Vector tool = {draw(-20, 20), draw(-20, 20), draw(0, 300)};
  const Vector tip = drawn_vector(draw, 500);
  const Vector3<double> direction = direction_of(chain, angles);
  const double size = std::exp(draw(-5, 5));  // directions need not be of length 1
  const auto found = solutions(chain, Vector3<double>{size * direction[0], size * direction[1], size * direction[2]});
  ASSERT_EQ(found.count, 2u);
  double nearest = 1e9;
  for (const Angles<double>& each : found.angles) {
    const Coordinates<double> pose = coordinates(chain, tip, each);
    const Coordinates<double> back = pose_of(chain, machine_of(chain, pose, tool), tool);
    for (std::size_t i = 0; i < 3; ++i) worst.tip = std::max(worst.tip, std::abs(back[i] - tip[i]));
    worst.direction = std::max(worst.direction, angle_between(direction_of(chain, each), direction));
    nearest = std::min(nearest, std::max(turned_apart(each[0], angles[0]), turned_apart(each[1], angles[1])));
  }
  // An angle about a pole is as sure as the direction, over its distance from there; so is one at the end of reach.
  const double sureness = std::abs(std::sin(degree * std::remainder(found.angles[0][1] - found.angles[1][1], 360) / 2));
  worst.angle = std::max(worst.angle, nearest * std::min(1.0, sureness));
}

void expect_identity(const NamedChain& named, std::uint64_t seed, int poses) {
  Draw draw(seed);
  Worst worst;
  for (int k = 0; k < poses && !::testing::Test::HasFatalFailure(); ++k) go_round(named.chain, draw, worst);
  EXPECT_LE(worst.tip, 1e-10) << named.name;
  EXPECT_LE(worst.direction, 1e-12) << named.name;
  EXPECT_LE(worst.angle, 1e-12) << named.name;
  EXPECT_GT(worst.tip + worst.direction, 0) << "nothing was rounded?";
}

TEST(Poses, ComeBackFromTheAxes) {
  for (const NamedChain& named : all_chains()) expect_identity(named, 1980, 3000);
}

/// A million poses a machine in the night.
RC_GTEST_PROP(LongRandomPoses, ComeBackFromTheAxes, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const NamedChain& named : all_chains()) expect_identity(named, seed, 10'000);
  RC_ASSERT(!::testing::Test::HasFailure());
}

/// Tools so near a pole, on either side of the ways there: the direction is held to 1e-12 rad, and the angle about the pole is
/// that of the direction, as exactly as the direction itself tells it.
void expect_identity_near_poles(const NamedChain& named, std::uint64_t seed, int poses) {
  Draw draw(seed);
  double worst = 0, worst_tip = 0, worst_azimuth = 0;
  const Cones& cones = named.chain.cones();
  const Turn& first = named.chain.turns()[0];
  for (int k = 0; k < poses; ++k) {
    const bool is_behind = cones.sum_cosine == 0 && (cones.difference_sine != 0 || draw(0, 1) < 0.5);
    if (cones.sum_cosine != 0 && cones.difference_sine != 0) return;  // this machine holds no tool along its first turn
    const double h = std::pow(10, draw(-13, -1)), azimuth = draw(-std::numbers::pi, std::numbers::pi);
    Vector3<double> direction;
    for (std::size_t i = 0; i < 3; ++i) {
      direction[i] = h * (std::cos(azimuth) * cones.across[i] + std::sin(azimuth) * cones.normal[i]) +
                     (is_behind ? -1 : 1) * std::sqrt(1 - h * h) * first.direction[i];
    }
    const auto found = solutions(named.chain, direction);
    ASSERT_EQ(found.count, 2u) << named.name << " at " << h;
    const Vector tip = drawn_vector(draw, 500), tool = {0, 0, draw(0, 300)};
    for (const Angles<double>& each : found.angles) {
      const Vector3<double> held = direction_of(named.chain, each);
      worst = std::max(worst, angle_between(held, direction));
      if (first.principal < 3 && named.chain.turns()[1].principal < 3) {
        Vector3<double> held_off = held, off = direction;
        held_off[first.principal] = off[first.principal] = 0;
        worst_azimuth = std::max(worst_azimuth, angle_between(held_off, off));
      }
      const Coordinates<double> pose = coordinates(named.chain, tip, each);
      const Coordinates<double> back = pose_of(named.chain, machine_of(named.chain, pose, tool), tool);
      for (std::size_t i = 0; i < 3; ++i) worst_tip = std::max(worst_tip, std::abs(back[i] - tip[i]));
    }
  }
  EXPECT_LE(worst, 1e-12) << named.name;
  EXPECT_LE(worst_tip, 1e-10) << named.name;
  EXPECT_LE(worst_azimuth, 1e-12) << named.name;
}

TEST(Poses, NearPolesComeBackFromTheAxes) {
  for (const NamedChain& named : all_chains()) expect_identity_near_poles(named, 1980, 3000);
}

RC_GTEST_PROP(LongRandomPoses, NearPolesComeBackFromTheAxes, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const NamedChain& named : all_chains()) expect_identity_near_poles(named, seed, 10'000);
  RC_ASSERT(!::testing::Test::HasFailure());
}

/// With nothing turned, the axes are the tip and the tool, whatever the geometry: as without kinematics.
TEST(Poses, WithoutTurnsAreThoseOfCartesianMachines) {
  Draw draw(3);
  for (const NamedChain& named : all_chains()) {
    for (int k = 0; k < 100; ++k) {
      const Vector tip = drawn_vector(draw, 500), tool = drawn_vector(draw, 100);
      Coordinates<double> pose = coordinates(named.chain, tip, {0, 0});
      pose[base::index(base::Axis::U)] = 17;
      const Coordinates<double> axes = machine_of(named.chain, pose, tool);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(axes[i], tip[i] + tool[i], 1e-12) << named.name;
      EXPECT_EQ(axes[base::index(base::Axis::U)], 17);
    }
  }
}

/// What is asked of a nutating head at 45° is up to 90° from the tool's own direction; beyond, it is out of reach by the rest.
TEST(Reach, OfANutatingHeadEndsAtRightAngles) {
  machine::RotaryChain data = *machine::preset_chain("head-head-bc");
  data.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  const Chain chain = Chain::of(data).value();
  for (double tilt = 0.5; tilt < 180; tilt += 1) {
    for (double azimuth = -170; azimuth < 180; azimuth += 35) {
      const Vector3<double> direction = {std::sin(tilt * degree) * std::cos(azimuth * degree),
                                         std::sin(tilt * degree) * std::sin(azimuth * degree), std::cos(tilt * degree)};
      const auto found = solutions(chain, direction);
      if (tilt < 90) {
        ASSERT_EQ(found.count, 2u) << tilt;
        EXPECT_EQ(found.miss, 0);
      } else {
        ASSERT_EQ(found.count, 0u) << tilt;
        EXPECT_NEAR(found.miss, tilt - 90, 1e-9);
      }
    }
  }
  // At the very end both solutions are one, and rounding does not take it out of reach.
  for (const double off : {0.0, 1e-9, 5e-7}) {
    const auto end = solutions(chain, Vector3<double>{1, 0, -off});
    ASSERT_EQ(end.count, 2u) << off;
    EXPECT_NEAR(std::abs(end.angles[0][1]), 180, 0.1);
    EXPECT_LE(angle_between(direction_of(chain, end.angles[0]), {1, 0, -off}), 1e-6);
  }
  EXPECT_EQ(solutions(chain, Vector3<double>{1, 0, -2e-6}).count, 0u);
}

TEST(Poles, LeaveTheFirstAngleFree) {
  const Chain table = Chain::of(*machine::preset_chain("table-table-ac")).value();
  EXPECT_EQ(table.turns()[0].axis, base::Axis::C);
  for (const double off : {0.0, 1e-15, 4e-14}) {
    const auto up = solutions(table, Vector3<double>{off, 0, 2});
    EXPECT_TRUE(up.is_pole);
    ASSERT_EQ(up.count, 1u);
    EXPECT_EQ(up.angles[0], (Angles<double>{0, 0}));
    const auto down = solutions(table, Vector3<double>{0, off, -2});
    EXPECT_TRUE(down.is_pole);
    ASSERT_EQ(down.count, 1u);
    EXPECT_EQ(down.angles[0], (Angles<double>{0, 180}));
  }
  EXPECT_FALSE(solutions(table, Vector3<double>{1e-13, 0, 1}).is_pole);
  EXPECT_NEAR(angle_from_pole(table, {0.1, 0, -1}), std::atan(0.1) / degree, 1e-12);
}

}  // namespace test_identity
}  // namespace leadscrew::kinematics::testing
