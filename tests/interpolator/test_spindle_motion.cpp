// A simulated spindle that is braked to stand at a place.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/interpolator/spindle_motion.hpp>
#include <numbers>

namespace test_spindle_motion {

using namespace leadscrew;
using interpolator::SpindleMotion;

double between(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 10'001) / 10'000;
}

/// Wherever it is in its ramp, either way: it stands there, having taken up speed and lost it by no more than is asked for.
RC_GTEST_PROP(SpindleMotion, StandsWhereItIsToldTo, ()) {
  const machine::Spindle spindle{.acceleration = between(1'000, 20'000),
                                 .wander = between(0, 0.05),
                                 .wander_period = between(2, 20),
                                 .seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000))};
  SpindleMotion motion(spindle);
  const double own = spindle.acceleration / 60, period = between(1e-3, 2e-3);
  const double way = *rc::gen::arbitrary<bool>() ? 1 : -1, speed = between(8, 30), before = between(-30, 30);
  const double ramp = own * between(0.3, 2), braking = own * between(0.3, 2);
  motion.turn(60 * before, 0);
  const double begin = between(0, 3);
  motion.turn(60 * way * speed, begin, ramp);
  // Far enough from where it is: what it is faster now it takes to stand, too.
  const double fastest = std::max(speed, std::abs(before)), slowest = std::min({ramp, braking, own});
  const double place = motion.revolutions(begin) + way * (fastest * fastest / slowest + between(0, 5));
  RC_LOG() << "S " << 60 * way * speed << " place " << place << " braking " << braking << '\n';
  double last = motion.revolutions(begin), last_speed = motion.speed(begin), t = begin;
  const double most =
      own * std::pow(1 + spindle.wander, 2) + 2 * 3.2 * spindle.wander / spindle.wander_period * fastest * 3;
  while (!motion.stands(t)) {
    motion.stand_at(place, t, t + period, braking);
    t += period;
    const double turned = motion.revolutions(t), now = motion.speed(t);
    RC_ASSERT(std::abs(turned - last - (now + last_speed) / 2 * period) <= most * period * period);
    RC_ASSERT(std::abs(now - last_speed) <= most * period * (1 + 1e-9));
    RC_ASSERT(way * (place - turned) >= -1e-9);
    last = turned;
    last_speed = now;
  }
  RC_ASSERT(std::abs(last - place) <= 1e-9 * std::max(1.0, std::abs(place)));
  RC_ASSERT(last_speed == 0);
  motion.stand_at(place + way, t, t + period, braking);
  RC_ASSERT(motion.stands(t + period));
}

/// Told too late it brakes at once, and stands n²/2a behind.
TEST(SpindleMotion, ThatIsToldTooLateStandsAsSoonAsItCan) {
  SpindleMotion motion({.acceleration = 600});
  motion.turn(600, 0);
  EXPECT_DOUBLE_EQ(motion.revolutions(2), 15);
  motion.stand_at(15, 2, 2.001, 10);
  EXPECT_NEAR(motion.revolutions(5), 20, 1e-9);
  EXPECT_TRUE(motion.stands(5));
}

}  // namespace test_spindle_motion
