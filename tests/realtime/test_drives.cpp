#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/realtime/drives.hpp>
#include <limits>
#include <vector>

#include "differences.hpp"

namespace {

using namespace leadscrew;
using testing_support::worst_ratio;

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
