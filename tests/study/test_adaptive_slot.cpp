// Adaptive control of whole machines: the planner's words through the loops of a machine, and the NC program's steps
// through a pulse-driven axis.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/servo/cutting_force.hpp>
#include <leadscrew/study/adaptive_slot.hpp>
#include <limits>

namespace test_adaptive_slot {

using namespace leadscrew;
using study::MilledSlot, study::Overridden, study::SlotPeriod;

constexpr Overridden both[] = {Overridden::planner, Overridden::nc_program};

std::string_view name(Overridden overridden) {
  return overridden == Overridden::planner ? "planner" : "NC program";
}

constexpr double width = 4, diameter = 10;  // mm

/// The limit is the force of 2 mm at the programmed feed.
servo::AdaptiveCutOptions options_of(int teeth, double spindle_speed, double noise) {
  servo::AdaptiveCutOptions options;
  options.milling.teeth = teeth;
  options.milling.diameter = diameter;
  options.milling.spindle_speed = spindle_speed;
  options.milling.cutting_coefficient = 2000;
  options.width = width;
  options.limit = servo::MillingForce::create(options.milling).value().mean(study::slot_feed, {2, width});
  options.milling.noise = noise * options.limit;
  return options;
}

MilledSlot milled(Overridden overridden, double length, const servo::AdaptiveCutOptions& options) {
  const auto slot = study::mill_slot(overridden, length, options);
  EXPECT_TRUE(slot.has_value()) << slot.error().message;
  return slot.value_or(MilledSlot{});
}

struct Swing {
  double share = 0;  ///< standard deviation of the override over its mean
  double time = 0;   ///< s, that it was taken over
};

Swing swing(const MilledSlot& slot, double from, double to) {
  double sum = 0, squares = 0, count = 0;
  for (const SlotPeriod& at : slot.periods) {
    if (at.position < from || at.position > to) continue;
    sum += at.factor;
    squares += at.factor * at.factor;
    ++count;
  }
  const double mean = sum / count;
  return {std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean, count * study::slot_period};
}

struct Spindle {
  int teeth = 0;
  double speed = 0;   ///< 1/s
  bool whole = true;  ///< Does a tooth pass in whole milliseconds?
};

/// As tests/servo/test_adaptive_swing.cpp derives: noise/√N, of the 32 forces or more of a passing of a tooth. Where
/// its passing is no whole number of samples, the window is off from whole passings by 2 %; in that part of it the
/// force is anything from 0 to its greatest, sin φe or 1, over the mean (1 − cos φe)·z/2π: the deviation of what lies
/// in a range is at most half the range. 0.1 % for the periods of the planner's words. What is seen of n passings
/// strays by 1/√2n of itself; thrice that is let pass.
double explained_swing(const Spindle& spindle, double noise, double time) {
  constexpr double turn = 6.283185307179586;
  const double cosine = 1 - 2 * width / diameter, greatest = std::sqrt(1 - cosine * cosine);
  const double ripple = spindle.whole ? 0 : 0.02 * greatest / ((1 - cosine) * spindle.teeth / turn) / 2;
  const double passings = time * spindle.teeth * spindle.speed;
  return noise / std::sqrt(32 * 0.98) * (1 + 3 / std::sqrt(2 * passings)) + ripple + 0.001;
}

/// Override of 50, 160 and 80 % in turn, each once it is settled.
TEST(AdaptiveSlot, HasNoLimitCycleAtAnyDepthAndSpeed) {
  for (const Spindle& spindle :
       {Spindle{4, 50}, Spindle{2, 100}, Spindle{4, 25}, Spindle{1, 62.5}, Spindle{3, 71, false}}) {
    for (const double noise : {0.0, 0.1}) {
      servo::AdaptiveCutOptions options = options_of(spindle.teeth, spindle.speed, noise);
      options.depths = {{0, 4}, {30, 1.25}, {100, 2.5}};
      for (const Overridden overridden : both) {
        const MilledSlot slot = milled(overridden, 150, options);
        for (const auto& [from, to] : {std::pair{6.0, 30.0}, {46.0, 100.0}, {108.0, 149.0}}) {
          const Swing seen = swing(slot, from, to);
          EXPECT_LE(seen.share, explained_swing(spindle, noise, seen.time))
              << name(overridden) << ", " << spindle.teeth << " teeth, " << spindle.speed << "/s, noise " << noise
              << ", from " << from;
        }
        EXPECT_TRUE(slot.cut.held(1 / spindle.speed));
      }
    }
  }
}

/// To 200 % where the force allows four times the feed, not beyond, and down again as soon as the cut is deep.
TEST(AdaptiveSlot, UsesTheWholeRangeAndHoldsTheForceAfterIt) {
  servo::AdaptiveCutOptions options = options_of(4, 50, 0.05);
  options.depths = {{0, 0.5}, {40, 2}};
  for (const Overridden overridden : both) {
    const MilledSlot slot = milled(overridden, 60, options);
    double greatest_feed = 0;
    for (const SlotPeriod& at : slot.periods) {
      EXPECT_LE(at.factor, 2);
      if (at.position > 30 && at.position < 40) {
        EXPECT_EQ(at.factor, 2);
      }
      if (at.position > 50 && at.position < 59) {
        EXPECT_NEAR(at.mean_force, options.limit, 0.1 * options.limit);
      }
      greatest_feed = std::max(greatest_feed, at.feed);
    }
    EXPECT_NEAR(greatest_feed, 20, 0.5);
    EXPECT_GT(slot.cut.greatest_mean, 1.25 * options.limit);  // the depth does rise
    EXPECT_TRUE(slot.cut.held(0.02)) << slot.cut.longest_excess;
    EXPECT_LT(slot.time(), study::slot_time(overridden, 60, 0.5).value());
  }
}

/// A sensor fails in a steady cut. Within 20 ms it is not believed, and the override is the safe one, to the last bit,
/// to the end. Till then what it said last may have raised the override, by 4 a second, 0.08 in all: from 50 % that is
/// 16 % more force, below the 25 % that are allowed. After that the force is that of the safe feed.
void expect_safe(servo::SensorFailure kind) {
  constexpr double safe = 0.4;
  for (const Overridden overridden : both) {
    for (const double depth : {4.0, 1.25}) {
      for (const double at : {1.2, 1.201, 1.202, 1.203, 1.204}) {  // through the passing of a tooth
        servo::AdaptiveCutOptions options = options_of(4, 50, 0.05);
        options.depths = {{0, depth}};
        options.safe = safe;
        options.fault = servo::SensorFault{kind, at};
        const MilledSlot slot = milled(overridden, 20, options);
        EXPECT_EQ(slot.failure, kind);
        ASSERT_TRUE(slot.cut.failed_at.has_value());
        EXPECT_LE(*slot.cut.failed_at, at + 0.02 + 1e-9);
        EXPECT_GE(*slot.cut.failed_at, at + 0.015);
        for (std::size_t k = 0; k < slot.periods.size(); ++k) {
          const double time = static_cast<double>(k + 1) * study::slot_period;
          const SlotPeriod& period = slot.periods[k];
          if (time > at - 0.1 && time < at) {
            EXPECT_NEAR(period.factor, 2 / depth, 0.1 * 2 / depth);
          }
          if (time >= at) {
            EXPECT_LE(period.mean_force, 1.25 * options.limit) << name(overridden) << ' ' << time;
          }
          if (time >= at + 0.02) {
            EXPECT_EQ(period.factor, safe) << name(overridden) << ' ' << time;
          }
          if (time > at + 0.25 && period.position < 19) {
            EXPECT_NEAR(period.mean_force, safe * depth / 2 * options.limit, 0.05 * options.limit);
          }
        }
      }
    }
  }
}

TEST(AdaptiveSlot, IsSafe20MsAfterASensorSaysNoNumber) {
  expect_safe(servo::SensorFailure::not_a_number);
}

TEST(AdaptiveSlot, IsSafe20MsAfterASensorIsStuck) {
  expect_safe(servo::SensorFailure::stuck);
}

TEST(AdaptiveSlot, IsSafe20MsAfterASensorIsSilent) {
  expect_safe(servo::SensorFailure::silent);
}

/// In air an ideal sensor says 0 for as long as there is no work, and is believed; one with noise does not.
TEST(AdaptiveSlot, BelievesAnIdealSensorInAir) {
  servo::AdaptiveCutOptions options = options_of(4, 50, 0);
  options.depths = {{0, 2}, {10, 0}, {30, 2}};
  for (const Overridden overridden : both) {
    const MilledSlot slot = milled(overridden, 45, options);
    EXPECT_EQ(slot.failure, servo::SensorFailure::none);
    EXPECT_EQ(slot.cut.greatest_override, 2);
    EXPECT_NEAR(slot.periods[slot.periods.size() - 200].mean_force, options.limit, 0.02 * options.limit);
  }
}

TEST(AdaptiveSlot, SaysWhatIsWrongWithItsCut) {
  servo::AdaptiveCutOptions options = options_of(4, 50, 0.05);
  options.safe = 0;
  const auto slot = study::mill_slot(Overridden::planner, 10, options);
  ASSERT_FALSE(slot.has_value());
  EXPECT_EQ(slot.error().code, "servo-cut");
}

}  // namespace test_adaptive_slot
