// Adaptive control of simulated cuts: how soon the force is back at its limit, that it stays there, and what happens
// when the sensor fails.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <random_numbers.hpp>

#include "adaptive_cut.hpp"

namespace leadscrew::servo::testing {
namespace test_adaptive_feed {

using testing_support::any;
using testing_support::logarithmic;

CutOptions any_cut() {
  CutOptions options;
  options.teeth = any(1, 7);
  const int quarter = static_cast<int>(logarithmic(0.3, 60)), tooth = quarter > 0 ? 4 * quarter : any(1, 4);
  options.turn = tooth * options.teeth;
  options.lag = logarithmic(0.002, 0.04);
  options.edge_share = any(0, 16) / 100.0;
  options.noise = any(1, 11) / 100.0;
  options.seed = any<std::uint64_t>(1, 1u << 30);
  return options;
}

/// Mean force over a turn, above 1.25 × limit, for at most 2 turns or 150 ms.
RC_GTEST_PROP(AdaptiveFeed, BringsTheForceBackWhenTheDepthDoubles, ()) {
  const CutOptions options = any_cut();
  AdaptiveCut cut(options);
  cut.run(500 + 10 * options.turn + any(0, 1000));
  RC_ASSERT(std::fabs(cut.mean_force() / AdaptiveCut::limit - 1) < 0.15);
  cut.engagement.depth *= 2;
  int above = 0;
  for (int k = 0; k < 500 + 10 * options.turn; ++k) {
    cut.run(1);
    above += cut.mean_force() > 1.25 * AdaptiveCut::limit ? 1 : 0;
  }
  RC_ASSERT(cut.adaptive().failure() == SensorFailure::none);
  RC_ASSERT(above <= std::max(2 * options.turn, 150));
  RC_ASSERT(std::fabs(cut.mean_force() / AdaptiveCut::limit - 1) < 0.15);
}

/// Without noise nothing moves any more; half a depth, a new width and back included.
RC_GTEST_PROP(AdaptiveFeed, ComesToRestWithoutALimitCycle, ()) {
  CutOptions options = any_cut();
  options.noise = 1e-9;
  options.edge_share = any(0, 41) / 100.0;
  AdaptiveCut cut(options);
  for (const Engagement& engagement : {Engagement{2, 4}, Engagement{3, 4}, Engagement{1.5, 6}, Engagement{1.2, 4}}) {
    cut.engagement = engagement;
    cut.run(1500 + 60 * options.turn);
    const auto settled = std::minmax_element(cut.overrides.end() - 10 * options.turn, cut.overrides.end());
    RC_ASSERT(cut.adaptive().failure() == SensorFailure::none);
    RC_ASSERT(*settled.second - *settled.first < 1e-4 * *settled.second);
  }
}

/// Into air the override rises no faster than it may, to its greatest; back in the work the force is soon at its limit.
TEST(AdaptiveFeed, ComesBackFromAir) {
  AdaptiveCut cut({.turn = 20, .teeth = 4, .lag = 0.02});
  cut.run(1000);
  cut.engagement.depth = 0;
  const double before = cut.overrides.back();
  cut.run(100);
  EXPECT_LE(cut.overrides.back(), before + 0.4 + 1e-9);
  cut.run(1000);
  EXPECT_NEAR(cut.overrides.back(), 2, 1e-9);
  cut.engagement.depth = 2;
  int above = 0;
  for (int k = 0; k < 2000; ++k) {
    cut.run(1);
    above += cut.mean_force() > 1.25 * AdaptiveCut::limit ? 1 : 0;
  }
  EXPECT_GT(above, 0);
  EXPECT_LE(above, 150);
  EXPECT_NEAR(cut.mean_force(), AdaptiveCut::limit, 0.1 * AdaptiveCut::limit);
}

/// Edges alone rub with more than the limit: the least override, and it is said.
TEST(AdaptiveFeed, SaysThatALimitCannotBeHeld) {
  AdaptiveCut cut({.edge_share = 0.5});
  cut.run(1000);
  EXPECT_FALSE(cut.adaptive().above_limit_at_least());
  cut.engagement.depth = 5;
  cut.run(2000);
  EXPECT_EQ(cut.overrides.back(), 0.05);
  EXPECT_TRUE(cut.adaptive().above_limit_at_least());
}

/// A greater stiffness at the next change, a lesser one by its share.
TEST(AdaptiveFeed, BelievesMoreForceAtOnceAndLessByAndBy) {
  AdaptiveFeed adaptive = AdaptiveFeed::create({.limit = 400, .samples = 10, .share = 0.1, .rise = 1000}).value();
  const auto change = [&](double force) {
    for (int k = 0; k < 10; ++k) adaptive.sample(force + (k % 2 == 0 ? 1e-6 : -1e-6), 1);
    return adaptive.feed_override();
  };
  EXPECT_NEAR(change(400), 1, 1e-6);
  EXPECT_NEAR(change(800), 0.5, 1e-6);
  EXPECT_NEAR(change(400), 400.0 / 760, 1e-6);
  EXPECT_NEAR(change(400), 400.0 / (760 - 36), 1e-6);
}

/// Braking to rest, a little force in the wrong moment is not believed to be a heavier cut; nor is it a lighter one.
TEST(AdaptiveFeed, LearnsNoGreaterStiffnessOfNextToNoForce) {
  AdaptiveFeed adaptive = AdaptiveFeed::create({.limit = 400, .samples = 4, .rise = 1000}).value();
  const auto change = [&](double force, double feed_share) {
    for (int k = 0; k < 4; ++k) adaptive.sample(force + 0.001 * k, feed_share);
    return adaptive.feed_override();
  };
  EXPECT_NEAR(change(500, 1), 0.8, 1e-5);
  EXPECT_NEAR(change(19, 0.02), 0.8, 1e-5);  // 950 N at the programmed feed
  EXPECT_NEAR(change(21, 0.02), 400.0 / 1050, 1e-4);
  EXPECT_NEAR(change(19, 0.02), 400.0 / 1000, 1e-4);  // half the way down to 950
}

/// One tooth that cuts for a fifth of a slow turn: between its passings no force says anything, and the override waits.
TEST(AdaptiveFeed, DoesNotFallOnBetweenTeeth) {
  AdaptiveCut cut({.turn = 240, .teeth = 1, .lag = 0.01, .noise = 1e-9});
  cut.run(5000);
  const double before = cut.overrides.back();
  cut.engagement.depth *= 2;
  cut.run(5000);
  EXPECT_NEAR(cut.overrides.back(), before / 2, 0.01);
  EXPECT_GT(*std::min_element(cut.overrides.end() - 5000, cut.overrides.end()), 0.45 * before);
}

/// While the operator holds the feed, or next to, nothing is learnt and nothing forgotten.
TEST(AdaptiveFeed, KeepsItsOverrideWhileTheFeedIsHeld) {
  AdaptiveFeed adaptive = AdaptiveFeed::create({.limit = 400, .samples = 4}).value();
  for (int k = 0; k < 100; ++k) adaptive.sample(500 + 0.01 * (k % 7), 1);
  EXPECT_NEAR(adaptive.feed_override(), 0.8, 1e-3);
  for (int k = 0; k < 4; ++k) adaptive.sample(10 + 0.01 * (k % 7), 0);  // the rest of the samples that were begun
  const double held = adaptive.feed_override();
  for (int k = 0; k < 1000; ++k) adaptive.sample(30 + 0.01 * (k % 7), k < 500 ? 0 : 0.005);
  EXPECT_NEAR(adaptive.feed_override(), held, 1e-12);
  EXPECT_EQ(adaptive.failure(), SensorFailure::none);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Failing {
  SensorFailure failure;
  std::optional<double> says;
};

/// 20 ms without a sample that can be believed, or 20 samples alike; not before.
TEST(AdaptiveFeed, FallsBackWhenTheSensorFailsAndSaysHow) {
  for (const Failing& failing : {Failing{SensorFailure::not_a_number, nan}, Failing{SensorFailure::silent, {}},
                                 Failing{SensorFailure::out_of_range, 1e5},
                                 Failing{SensorFailure::out_of_range, -std::numeric_limits<double>::infinity()},
                                 Failing{SensorFailure::stuck, 400}}) {
    AdaptiveCut cut({});
    cut.run(500);
    cut.engagement.depth = 3;  // the override is far from that of a failure
    cut.run(500);
    const double before = cut.overrides.back();
    EXPECT_GT(std::fabs(before - 0.5), 0.1);
    const auto fail = [&](double) { return failing.says; };
    for (int k = 0; k < 19; ++k) cut.step(fail);
    EXPECT_EQ(cut.adaptive().failure(), SensorFailure::none) << name(failing.failure);
    EXPECT_NEAR(cut.overrides.back(), before, 0.1);
    cut.step(fail);
    EXPECT_EQ(cut.adaptive().failure(), failing.failure) << name(failing.failure);
    EXPECT_EQ(cut.overrides.back(), 0.5);
    cut.run(1000);  // alive again, but not believed
    EXPECT_EQ(cut.adaptive().failure(), failing.failure);
    EXPECT_EQ(cut.overrides.back(), 0.5);
    cut.adaptive().restart();
    cut.run(1000);
    EXPECT_EQ(cut.adaptive().failure(), SensorFailure::none);
    EXPECT_NEAR(cut.mean_force(), AdaptiveCut::limit, 0.1 * AdaptiveCut::limit);
  }
}

/// A lost sample now and then is none of a failure.
TEST(AdaptiveFeed, BridgesShortGaps) {
  AdaptiveCut cut({});
  for (int k = 0; k < 3000; ++k) {
    cut.step([&](double force) { return k % 40 < 19 ? std::optional<double>() : std::optional(force); });
  }
  EXPECT_EQ(cut.adaptive().failure(), SensorFailure::none);
}

/// An ideal sensor says the same for as long as nothing changes.
TEST(AdaptiveFeed, TakesNothingForStuckThatHasNoNoise) {
  AdaptiveFeed ideal = AdaptiveFeed::create({.limit = 400, .stuck_after = 0}).value();
  AdaptiveFeed real = AdaptiveFeed::create({.limit = 400}).value();
  for (int k = 0; k < 1000; ++k) {
    ideal.sample(500, 1);
    real.sample(500, 1);
  }
  EXPECT_EQ(ideal.failure(), SensorFailure::none);
  EXPECT_NEAR(ideal.feed_override(), 0.8, 1e-12);
  EXPECT_EQ(real.failure(), SensorFailure::stuck);
}

std::string refusal(const AdaptiveFeedOptions& options) {
  const auto adaptive = AdaptiveFeed::create(options);
  return adaptive ? "" : std::string(adaptive.error().code) + ": " + adaptive.error().message;
}

TEST(AdaptiveFeed, SaysWhichOptionIsWrong) {
  EXPECT_EQ(refusal({.limit = 400}), "");
  EXPECT_EQ(refusal({.limit = 0}), "servo-adaptive-feed: the limit of the force is 0");
  EXPECT_EQ(refusal({.limit = 400, .samples = 0}), "servo-adaptive-feed: the number of samples is 0");
  EXPECT_EQ(refusal({.limit = 400, .window = 17}), "servo-adaptive-feed: the window is 17");
  EXPECT_EQ(refusal({.limit = 400, .share = 0}), "servo-adaptive-feed: the share of a new stiffness is 0");
  EXPECT_EQ(refusal({.limit = 400, .least = 0}), "servo-adaptive-feed: the least override is 0");
  EXPECT_EQ(refusal({.limit = 400, .most = 2.5}), "servo-adaptive-feed: the greatest override is 2.5");
  EXPECT_EQ(refusal({.limit = 400, .safe = -1}), "servo-adaptive-feed: the safe override is -1");
  EXPECT_EQ(refusal({.limit = 400, .sensor_range = 300}),
            "servo-adaptive-feed: the sensor's range less the limit is -100");
  EXPECT_EQ(refusal({.limit = 400, .silent_after = 0}), "servo-adaptive-feed: the time of silence is 0");
  EXPECT_EQ(refusal({.limit = 400, .stuck_after = 1}), "servo-adaptive-feed: the number of samples alike is 1");
}

}  // namespace test_adaptive_feed
}  // namespace leadscrew::servo::testing
