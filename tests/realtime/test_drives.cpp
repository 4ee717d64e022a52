#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/realtime/drives.hpp>
#include <limits>
#include <vector>

#include "live.hpp"

namespace {

using namespace leadscrew;
using testing_support::words_of;

/// The largest difference of the positions over a limit, of the first, second and third order, from `from` on.
double worst_ratio(const std::vector<base::AxisVector>& q, const machine::Machine& machine, std::size_t from) {
  const double T = machine.period.seconds();
  double worst = 0;
  for (std::size_t k = from; k < q.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const machine::AxisLimits& limits = *machine.axes[i];
      const double a = q[k][i], b = q[k - 1][i], c = q[k - 2][i], d = q[k - 3][i];
      worst =
          std::max({worst, std::abs(a - b) / T / limits.velocity, std::abs(a - 2 * b + c) / T / T / limits.acceleration,
                    std::abs(a - 3 * b + 3 * c - d) / T / T / T / limits.jerk});
    }
  }
  return worst;
}

class WhenWordsCease : public testing::TestWithParam<const char*> {};

TEST_P(WhenWordsCease, DrivesComeToRestWithinTheLimitsOfEveryAxis) {
  const machine::Machine machine = machine::mill3();
  const std::vector<base::Word> words = words_of(GetParam(), machine);
  for (std::size_t last = 10; last < words.size(); last += 7) {
    realtime::Drives drives(machine, machine.period, words[0].position);
    std::vector<base::AxisVector> q(3, words[0].position);
    for (std::size_t k = 0; k <= last; ++k) {
      drives.follow(words[k].position);
      q.push_back(drives.position());
    }
    const std::size_t words_until = q.size();
    for (int tick = 0; tick < 2000 && !drives.at_rest(); ++tick) {
      drives.brake();
      q.push_back(drives.position());
    }
    EXPECT_TRUE(drives.at_rest());
    for (int tick = 0; tick < 3; ++tick) q.push_back(drives.position());
    // Rounding of three differences at T = 1 ms is 1e-4 of the limit.
    ASSERT_LE(worst_ratio(q, machine, words_until), 1.001) << last;
  }
}

TEST_P(WhenWordsCease, DrivesStayOnALine) {
  const machine::Machine machine = machine::mill3();
  const std::vector<base::Word> words = words_of("G21 G90 G94\nG1 X60 Y20 Z-5 F6000\nM2\n", machine);
  for (std::size_t last = 10; last < words.size(); last += 31) {
    realtime::Drives drives(machine, machine.period, words[0].position);
    for (std::size_t k = 0; k <= last; ++k) drives.follow(words[k].position);
    while (!drives.at_rest()) drives.brake();
    EXPECT_NEAR(drives.position()[1], drives.position()[0] / 3, 1e-9);
    EXPECT_NEAR(drives.position()[2], drives.position()[0] / -12, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, WhenWordsCease,
                         testing::Values("G21 G90 G94\nG1 X60 Y20 Z-5 F6000\nM2\n",
                                         "G21 G90 G94 G17\nG2 X0 Y0 I20 J0 F6000\nM2\n"));

constexpr double no_feed = std::numeric_limits<double>::infinity();

TEST(Drives, ApproachWithinTheLimitsOfEveryAxis) {
  const machine::Machine machine = machine::mill3();
  realtime::Drives drives(machine, machine.period, {1, 2, 3});
  std::vector<base::AxisVector> q(3, drives.position());
  const base::AxisVector target = {7, -30, 3.001};
  for (int tick = 0; tick < 5000 && !drives.approach(target, no_feed); ++tick) q.push_back(drives.position());
  for (int tick = 0; tick < 3; ++tick) q.push_back(drives.position());
  EXPECT_EQ(drives.position(), target);
  EXPECT_LE(worst_ratio(q, machine, 3), 1.001);
}

TEST(Drives, ApproachNoFasterThanTheFeed) {
  const machine::Machine machine = machine::mill3();
  realtime::Drives drives(machine, machine.period, {});
  const base::AxisVector target = {30, -40, 0};
  double fastest = 0;
  base::AxisVector last = drives.position();
  while (!drives.approach(target, 20)) {
    const base::AxisVector& here = drives.position();
    fastest = std::max(fastest, std::hypot(here[0] - last[0], here[1] - last[1]) / machine.period.seconds());
    last = here;
  }
  EXPECT_EQ(drives.position(), target);
  EXPECT_LE(fastest, 20 * (1 + 1e-9));
  EXPECT_GE(fastest, 19.9);
}

/// Wherever that is, on its line, within the limits, and never behind the target: that may lie where travel ends.
TEST(Drives, ComeToRestOnTheWayWhenAnApproachIsCalledOff) {
  const machine::Machine machine = machine::mill3();
  for (const double way : {0.01, 1.0, 50.0, 400.0}) {
    for (const double feed : {no_feed, 15.0}) {
      const base::AxisVector target = {way, -way / 2, 0};
      int whole = 0;
      for (realtime::Drives drives(machine, machine.period, {}); !drives.approach(target, feed);) ++whole;
      for (int part = 0; part <= 20; ++part) {
        realtime::Drives drives(machine, machine.period, {});
        std::vector<base::AxisVector> q(3, drives.position());
        for (int tick = 0; tick <= 2 * whole; ++tick) {
          if (20 * tick >= part * whole) drives.call_off();
          const bool stands = drives.approach(target, feed);
          q.push_back(drives.position());
          ASSERT_NEAR(drives.position()[1], drives.position()[0] / -2, 1e-9);
          ASSERT_LE(drives.position()[0], way * (1 + 1e-12)) << part;
          if (stands) break;
        }
        EXPECT_TRUE(drives.at_rest());
        for (int tick = 0; tick < 3; ++tick) q.push_back(drives.position());
        ASSERT_LE(worst_ratio(q, machine, 3), 1.001) << way << " " << feed << " " << part;
      }
    }
  }
}

}  // namespace
