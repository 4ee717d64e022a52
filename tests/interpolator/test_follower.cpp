// Lines in step with a simulated spindle whose speed wanders: limits, the place behind the run-in, the end.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/interpolator/follower.hpp>
#include <leadscrew/interpolator/spindle_motion.hpp>
#include <limits>
#include <type_traits>
#include <vector>

namespace test_follower {

using namespace leadscrew;
using interpolator::Follower;
using interpolator::SpindleMotion;

static_assert(std::is_trivially_copyable_v<Follower> && std::is_trivially_copyable_v<SpindleMotion>);

constexpr double everywhere = std::numeric_limits<double>::infinity();
constexpr double tolerance = 0.01;  // mm

double between(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 10'001) / 10'000;
}

/// A thread on a machine, as random as they are.
struct Thread {
  machine::Derivatives limits;
  double period = 0, lead = 0, speed = 0, end = 0;  ///< s, mm, revolutions per minute, mm
  machine::Spindle spindle;

  static Thread any() {
    Thread thread;
    thread.limits.velocity = between(20, 500);
    thread.limits.acceleration = thread.limits.velocity * between(2, 20);
    thread.limits.jerk = thread.limits.acceleration * between(10, 100);
    thread.period = *rc::gen::element(1e-4, 5e-4, 1e-3, 2e-3);
    thread.lead = between(0.2, 6);
    const double most = std::min(thread.limits.velocity * 0.9 / thread.lead, 100.0);  // revolutions per s
    thread.speed = 60 * most * between(0.02, 1);
    thread.spindle = {.acceleration = between(100, 20'000),
                      .wander = 0.05,
                      .wander_period = between(2, 20),
                      .seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000))};
    // Long enough to be in step for a while.
    const double v = thread.lead * thread.speed / 60;
    const double rise = 2 * std::sqrt(v / thread.limits.jerk) + v / thread.limits.acceleration;
    thread.end = v * (between(0.5, 3) + 12 * rise + 100 * thread.period) + 2;
    RC_LOG() << "v " << thread.limits.velocity << " a " << thread.limits.acceleration << " j " << thread.limits.jerk
             << " T " << thread.period << " lead " << thread.lead << " S " << thread.speed << " end " << thread.end
             << " spindle " << thread.spindle.acceleration << " " << thread.spindle.wander_period << " "
             << thread.spindle.seed << '\n';
    return thread;
  }

  Follower follower() const { return Follower(limits, period, tolerance); }
};

/// The greatest share of a limit that differences of these places show.
double worst(const Thread& thread, const std::vector<double>& places) {
  double most = 0;
  const double t = thread.period;
  for (std::size_t i = 3; i < places.size(); ++i) {
    const double p = places[i], q = places[i - 1], r = places[i - 2], s = places[i - 3];
    most = std::max({most, std::abs(p - q) / t / thread.limits.velocity,
                     std::abs(p - 2 * q + r) / (t * t) / thread.limits.acceleration,
                     std::abs(p - 3 * q + 3 * r - s) / (t * t * t) / thread.limits.jerk});
  }
  return most;
}

struct Travelled {
  std::vector<double> places = std::vector<double>(4, 0.0);  ///< of the line
  std::vector<double> errors = std::vector<double>(4, 0.0);  ///< |place − lead × revolutions|
};

/// From the spindle's index, `since` s behind the command that starts it, until it rests; at most 100 s.
Travelled along(const Thread& thread, Follower& follower, double since) {
  SpindleMotion spindle(thread.spindle);
  spindle.turn(thread.speed, 0);
  const double index = std::ceil(spindle.revolutions(since));
  auto n = static_cast<std::int64_t>(since / thread.period);
  while (spindle.revolutions(static_cast<double>(n) * thread.period) < index) ++n;
  Travelled travelled;
  const auto last = n + static_cast<std::int64_t>(100 / thread.period);
  for (; n < last; ++n) {
    const double t = static_cast<double>(n) * thread.period;
    follower.follow(thread.lead * (spindle.revolutions(t) - index), thread.end);
    travelled.places.push_back(follower.s());
    travelled.errors.push_back(std::abs(follower.s() - thread.lead * (spindle.revolutions(t + thread.period) - index)));
    if (follower.rests()) break;
  }
  travelled.places.insert(travelled.places.end(), 4, follower.s());
  return travelled;
}

/// Where a thread begins its end: what a stop from the spindle's speed takes, and something more.
double begin_of_end(const Thread& thread) {
  const double v = 1.05 * thread.lead * thread.speed / 60;
  const double t = 2 * std::sqrt(v / thread.limits.jerk) + v / thread.limits.acceleration;
  return thread.end - v * t - 0.01 * thread.end;
}

RC_GTEST_PROP(Follower, IsInStepBehindItsRunInAndEndsAtTheEnd, ()) {
  const Thread thread = Thread::any();
  Follower follower = thread.follower();
  const Travelled travelled = along(thread, follower, 60 * thread.speed / thread.spindle.acceleration / 60 + 0.1);
  RC_ASSERT(follower.rests());
  RC_ASSERT(follower.s() == thread.end);
  RC_ASSERT(worst(thread, travelled.places) <= 1.001);
  // Told, and no longer than it takes from rest, with what is lost meanwhile.
  const double v = thread.lead * thread.speed / 60;
  const double rise = 2 * std::sqrt(v / thread.limits.jerk) + v / thread.limits.acceleration;
  RC_LOG() << "run-in " << follower.run_in() << " of " << v * rise << '\n';
  double run_in = 0;
  for (std::size_t i = 0; i < travelled.errors.size(); ++i) {
    const double s = travelled.places[i];
    if (travelled.errors[i] > tolerance && s < begin_of_end(thread)) run_in = std::max(run_in, s);
  }
  RC_LOG() << "measured " << run_in << '\n';
  RC_ASSERT(std::abs(follower.run_in() - run_in) <= 1e-9);
  RC_ASSERT(run_in < begin_of_end(thread));
  RC_ASSERT(run_in <= 8 * v * rise + 100 * v * thread.period);
}

/// Whatever the spindle does, and however late it reaches its speed or stops.
RC_GTEST_PROP(Follower, KeepsLimitsUnderAnySpindle, ()) {
  const Thread thread = Thread::any();
  Follower follower = thread.follower();
  SpindleMotion spindle(thread.spindle);
  std::vector<double> places(4, 0.0);
  const int commands = *rc::gen::inRange(1, 6);
  std::int64_t n = 0;
  for (int k = 0; k < commands; ++k) {
    spindle.turn(between(-2, 3) * thread.speed, static_cast<double>(n) * thread.period);
    const auto until = n + *rc::gen::inRange(1, 2'000);
    for (; n < until; ++n) {
      follower.follow(thread.lead * spindle.revolutions(static_cast<double>(n) * thread.period), thread.end);
      places.push_back(follower.s());
      RC_ASSERT(follower.s() <= thread.end * (1 + 1e-12));
      if (follower.rests()) break;
    }
  }
  for (int k = 0; k < 1'000'000 && !follower.rests(); ++k) {
    follower.stop();
    places.push_back(follower.s());
  }
  RC_ASSERT(follower.rests());
  places.insert(places.end(), 4, follower.s());
  RC_ASSERT(worst(thread, places) <= 1.001);
}

/// Behind stop() it stays, whatever is asked; from motion go() comes to rest, and goes from there.
RC_GTEST_PROP(Follower, StaysWhereItWasStoppedAndGoesFromMotion, ()) {
  const Thread thread = Thread::any();
  Follower follower = thread.follower();
  SpindleMotion spindle(thread.spindle);
  spindle.turn(thread.speed, 0);
  std::vector<double> places(4, 0.0);
  std::int64_t n = 0;
  const auto follow = [&](std::int64_t periods) {
    for (const std::int64_t until = n + periods; n < until && !follower.rests(); ++n) {
      follower.follow(thread.lead * spindle.revolutions(static_cast<double>(n) * thread.period), thread.end);
      places.push_back(follower.s());
    }
  };
  follower.follow(0, thread.end);
  follow(*rc::gen::inRange(1, 2'000));
  if (*rc::gen::inRange(0, 2) == 0) {
    if (!follower.rests()) follower.stop();
    places.push_back(follower.s());
    follow(1'000'000);
    RC_ASSERT(follower.rests());
    const double there = follower.s();
    for (int k = 0; k < 100; ++k) follower.follow(thread.end, thread.end);
    RC_ASSERT(follower.s() == there);
  } else {
    const double end = thread.end * between(0, 1);
    int left = 1'000'000;
    do {
      follower.go(end);
      places.push_back(follower.s());
    } while (!follower.rests() && --left > 0);
    RC_ASSERT(follower.s() == end);
    RC_ASSERT(follower.velocity() == 0);
  }
  places.insert(places.end(), 4, follower.s());
  RC_ASSERT(worst(thread, places) <= 1.001);
}

/// In, back with the spindle that is reversed at the bottom, to rest beyond, and to where it began.
RC_GTEST_PROP(Follower, TapsAndComesBack, ()) {
  Thread thread = Thread::any();
  thread.end = everywhere;
  Follower follower = thread.follower();
  SpindleMotion spindle(thread.spindle);
  const double depth = thread.lead * thread.speed / 60 * between(0.2, 1);
  std::vector<double> places(4, 0.0);
  bool is_back = false;
  spindle.turn(thread.speed, 0);
  std::int64_t n = 0;
  const auto last = static_cast<std::int64_t>(400 / thread.period);
  for (; n < last && !(is_back && follower.s() <= 0); ++n) {
    const double t = static_cast<double>(n) * thread.period;
    if (!is_back && follower.s() >= depth) {
      spindle.turn(-thread.speed, t);
      is_back = true;
    }
    follower.follow(thread.lead * spindle.revolutions(t), everywhere);
    places.push_back(follower.s());
  }
  RC_ASSERT(n < last);
  for (int k = 0; k < 1'000'000 && !follower.rests(); ++k) {
    follower.stop();
    places.push_back(follower.s());
  }
  RC_ASSERT(follower.s() < 0);
  do {
    follower.go(0);
    places.push_back(follower.s());
  } while (!follower.rests());
  RC_ASSERT(follower.s() == 0);
  places.insert(places.end(), 4, 0.0);
  RC_ASSERT(worst(thread, places) <= 1.001);
}

TEST(SpindleMotion, TakesUpItsSpeedByItsAccelerationAndStops) {
  SpindleMotion spindle(machine::Spindle{.acceleration = 600});
  EXPECT_EQ(spindle.revolutions(1), 0);
  spindle.turn(300, 1);  // 5 revolutions per s, by 10 per s²
  EXPECT_NEAR(spindle.speed(1.25), 2.5, 1e-12);
  EXPECT_NEAR(spindle.revolutions(1.5), 1.25, 1e-12);
  EXPECT_NEAR(spindle.revolutions(2.5), 6.25, 1e-12);
  spindle.turn(-300, 3);
  EXPECT_NEAR(spindle.revolutions(3.5), 8.75 + 1.25, 1e-12);
  EXPECT_NEAR(spindle.revolutions(4), 8.75, 1e-12);
  EXPECT_NEAR(spindle.speed(4.5), -5, 1e-12);
  spindle.turn(0, 5);
  EXPECT_EQ(spindle.speed(6), 0);
  EXPECT_EQ(spindle.revolutions(7), spindle.revolutions(6));
}

RC_GTEST_PROP(SpindleMotion, WandersByNoMoreThanItIsTold, ()) {
  const machine::Spindle told{.acceleration = 1000,
                              .wander = between(0, 0.2),
                              .wander_period = between(0.1, 10),
                              .seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000))};
  SpindleMotion spindle(told);
  spindle.turn(1200, 0);
  double least = 20, most = 20;
  for (double t = 2; t < 12; t += 1e-3) {
    const double speed = spindle.speed(t);
    RC_ASSERT(std::abs(speed - 20) <= 20 * told.wander + 1e-9);
    RC_ASSERT(std::abs((spindle.revolutions(t + 5e-5) - spindle.revolutions(t - 5e-5)) * 1e4 - speed) < 1e-3);
    least = std::min(least, speed);
    most = std::max(most, speed);
  }
  if (told.wander_period < 5) RC_ASSERT(most - least >= 20 * told.wander);
}

}  // namespace test_follower
