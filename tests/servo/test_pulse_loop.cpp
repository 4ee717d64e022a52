// The pulse-driven loop beside closed forms and small steps of integration, and that no pulse is ever lost.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <leadscrew/servo/contour.hpp>
#include <random>
#include <random_numbers.hpp>
#include <vector>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_pulse_loop {

using testing_support::any;
using testing_support::logarithmic;

TEST(PulseLoop, GainIsTheProductOfItsParts) {
  const PulseLoopOptions options{.converter = 0.1, .amplifier = 5, .motor = 0.2, .holes = 200, .time_constant = 0.02};
  EXPECT_DOUBLE_EQ(options.gain(), 20);
}

TEST(PulseLoop, LetsAsManyPulsesPassAsTheDownCounterHolds) {
  PulseLoop loop = made(options_with(20, 0.02));
  EXPECT_FALSE(loop.pulse(1));
  loop.load(3);
  int passed = 0;
  for (int k = 0; k < 10; ++k) passed += loop.pulse(k % 2 == 0 ? 1 : -1) ? 1 : 0;
  EXPECT_EQ(passed, 3);
  EXPECT_EQ(loop.to_come(), 0);
  EXPECT_EQ(loop.following_error(), 1);  // + − +
  EXPECT_EQ(loop.commanded(), 1);
}

/// One pulse: v = Kv(1 − e^(−t/τ)), x = Kv(t − τ(1 − e^(−t/τ))) reaches 1 at the time that is returned; then coasting.
TEST(PulseLoop, FindsTheEncoderPulseWhereTheMotionHasIt) {
  const double kv = 8, lag = 0.05;
  PulseLoop loop = made(options_with(kv, lag));
  loop.load(1);
  loop.pulse(1);
  const auto passed = loop.run(10);
  ASSERT_EQ(passed.encoder_pulse, 1);
  EXPECT_NEAR(kv * (passed.seconds - lag * (1 - std::exp(-passed.seconds / lag))), 1, 4e-16 * kv);
  EXPECT_NEAR(loop.velocity(), kv * (1 - std::exp(-passed.seconds / lag)), 1e-14);
  EXPECT_EQ(loop.following_error(), 0);
  EXPECT_TRUE(loop.comes_to_rest());
  const double rest = 1 + loop.velocity() * lag;
  EXPECT_EQ(loop.run(10).encoder_pulse, 0);
  EXPECT_NEAR(loop.position(), rest, 1e-12);
}

/// Sent on and back before it has counted a pulse: it turns, and passes the edge that it began on.
TEST(PulseLoop, FindsTheEncoderPulseBehindATurn) {
  const double kv = 8, lag = 0.05, first = 0.1;
  PulseLoop loop = made(options_with(kv, lag));
  loop.load(3);
  loop.pulse(1);
  ASSERT_EQ(loop.run(first).encoder_pulse, 0);
  const double x = loop.position(), v = loop.velocity();
  EXPECT_GT(v, 0);
  loop.pulse(-1);
  loop.pulse(-1);
  const auto passed = loop.run(10);
  ASSERT_EQ(passed.encoder_pulse, -1);
  EXPECT_EQ(loop.encoder_count(), -1);
  EXPECT_EQ(loop.following_error(), 0);
  const double t = passed.seconds;
  EXPECT_GT(t, lag * std::log1p(v / kv));  // when it turned
  EXPECT_NEAR(x - kv * t + lag * (v + kv) * (1 - std::exp(-t / lag)), 0, 1e-14);
}

RC_GTEST_PROP(PulseLoop, KnowsWhetherAnotherEncoderPulseComes, ()) {
  const double kv = logarithmic(1, 100), lag = logarithmic(0.1, 8) / kv;
  PulseLoop loop = made(options_with(kv, lag));
  loop.load(10);
  for (int k = 0; k < 10; ++k) {
    loop.pulse(1);
    loop.run_through(logarithmic(0.1, 3) / kv);
  }
  int stayed = 0, went_on = 0;
  for (int k = 0; k < 3000; ++k) {
    if (loop.following_error() == 0) {
      PulseLoop left_alone = loop;
      const bool comes = left_alone.run(60 * lag).encoder_pulse != 0;
      RC_ASSERT(comes == !loop.comes_to_rest());
      (comes ? went_on : stayed) += 1;
    } else {
      RC_ASSERT(!loop.comes_to_rest());
    }
    loop.run(0.1 / kv);
  }
  RC_ASSERT(stayed > 0);
  if (kv * lag > 6) RC_ASSERT(went_on > 0);
}

/// The same loop by Runge and Kutta's method in small steps; the encoder is floor(θ).
class SmallStepLoop {
 public:
  SmallStepLoop(double kv, double lag, double start) : kv_(kv), lag_(lag), position_(start) {}

  void pulse(int direction) { difference_ += direction; }

  template <class OnPulse>
  void step(long double step, OnPulse&& on_pulse) {
    const auto slope = [&](long double v) { return (kv_ * static_cast<long double>(difference_) - v) / lag_; };
    const long double v1 = velocity_, a1 = slope(v1), v2 = v1 + step / 2 * a1, a2 = slope(v2);
    const long double v3 = v1 + step / 2 * a2, a3 = slope(v3), v4 = v1 + step * a3, a4 = slope(v4);
    position_ += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    velocity_ += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    const auto count = static_cast<std::int64_t>(std::floor(position_));
    if (count != count_) on_pulse(static_cast<int>(count - count_));
    difference_ -= count - count_;
    count_ = count;
  }

 private:
  long double kv_, lag_, position_, velocity_ = 0;
  std::int64_t difference_ = 0, count_ = 0;
};

/// Beside τv′ = Kv(commanded − x) − v, which counts nothing: an encoder whose edges are half a pulse off rounds, and
/// what it rounds by, half a pulse at most, is one more input of that loop.
RC_GTEST_PROP(PulseLoop, StaysWithinHalfAPulseTimesTheGreatestGainOfTheLoopWithoutCounts, ()) {
  const double kv = logarithmic(1, 100), lag = logarithmic(0.02, 2) / kv, step = std::min(lag, 1 / kv) / 100;
  PulseLoopOptions options = options_with(kv, lag);
  options.start = 0.5;
  PulseLoop loop = made(options);
  loop.load(1 << 30);
  double x = 0, v = 0, farthest = 0;
  std::mt19937 random(any(0u, 1u << 31));
  const double rate = logarithmic(0.005, 0.1);  // pulses a step
  for (int k = 0; k < 4000; ++k) {
    const double drawn = static_cast<double>(random()) / std::mt19937::max();
    if (drawn < rate) loop.pulse(drawn < rate / 3 ? -1 : 1);
    const auto pull = [&](double at, double w) {
      return (kv * (static_cast<double>(loop.commanded()) - at) - w) / lag;
    };
    const double v1 = v, a1 = pull(x, v1), v2 = v1 + step / 2 * a1, a2 = pull(x + step / 2 * v1, v2);
    const double v3 = v1 + step / 2 * a2, a3 = pull(x + step / 2 * v2, v3), v4 = v1 + step * a3;
    const double a4 = pull(x + step * v3, v4);
    x += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    loop.run_through(step);
    farthest = std::max(farthest, std::fabs(loop.position() - 0.5 - x));
  }
  RC_ASSERT(farthest <= 0.5 * greatest_gain({kv, lag}) + 1e-6);
  RC_ASSERT(farthest > 0.001);  // it does count
}

struct EncoderPulse {
  double time;
  int direction;
};

/// Pulses in one direction, as many back, with pauses that let some of the motion run out.
TEST(PulseLoop, AgreesWithSmallStepsPulseByPulse) {
  constexpr int ticks = 1200000;  // of 1 µs
  constexpr double tick = 1e-6;
  for (const double lag : {0.004, 0.02, 0.06}) {
    PulseLoopOptions options = options_with(30, lag);
    options.start = 0.37;
    PulseLoop loop = made(options);
    loop.load(1000);
    SmallStepLoop reference(30, lag, 0.37);
    std::vector<EncoderPulse> ours, theirs;
    double time = 0;
    for (int k = 0; k < ticks; ++k) {
      if (k % 3001 == 3000) {
        const int direction = k < ticks * 2 / 5 ? 1 : -1;
        for (const double due = k * tick; time < due;) {
          const auto passed = loop.run(due - time);
          time = passed.encoder_pulse == 0 ? due : time + passed.seconds;
          if (passed.encoder_pulse != 0) ours.push_back({time, passed.encoder_pulse});
        }
        loop.pulse(direction);
        reference.pulse(direction);
      }
      reference.step(tick, [&](int direction) { theirs.push_back({(k + 1) * tick, direction}); });
    }
    ASSERT_GT(ours.size(), 200u);
    ASSERT_GE(theirs.size(), ours.size());
    for (std::size_t k = 0; k < ours.size(); ++k) {
      ASSERT_EQ(ours[k].direction, theirs[k].direction) << k << " lag " << lag;
      ASSERT_NEAR(ours[k].time, theirs[k].time, 2e-5) << k << " lag " << lag;
    }
  }
}

void settle(PulseLoop& loop, double seconds) {
  for (int k = 0; k < 100 && !loop.comes_to_rest(); ++k) loop.run_through(seconds / 100);
}

RC_GTEST_PROP(PulseLoop, EndsWhereItWasSentWhateverThePulses, ()) {
  const double kv = logarithmic(1, 100), lag = logarithmic(0.01, 4) / kv;
  PulseLoopOptions options = options_with(kv, lag);
  options.start = any(0, 1000) / 1000.0;
  PulseLoop loop = made(options);
  const int pulses = any(1, 2000);
  loop.load(pulses);
  const double interval = logarithmic(0.01, 10) / kv;
  int sent = 0, direction = 1;
  for (int k = 0; k < pulses; ++k) {
    loop.run_through(interval * any(0, 1000) / 500.0);
    if (any(0, 50) == 0) direction = -direction;
    RC_ASSERT(loop.pulse(direction));
    sent += direction;
    RC_ASSERT(loop.commanded() == sent);
    RC_ASSERT(loop.encoder_count() + loop.following_error() == sent);
    RC_ASSERT(std::floor(loop.position()) == static_cast<double>(loop.encoder_count()));
  }
  settle(loop, 100 / kv + 100 * lag);
  RC_ASSERT(loop.comes_to_rest());
  RC_ASSERT(loop.following_error() == 0);
  RC_ASSERT(loop.encoder_count() == sent);
  RC_ASSERT(loop.overflows() == 0);
}

/// Kv·τ ≤ 1/4: the loop does not overshoot, so that UDC stays below what the greatest rate needs, and a pulse on either
/// side.
RC_GTEST_PROP(PulseLoop, KeepsItsCounterBoundedByTheRate, ()) {
  const double kv = logarithmic(1, 100), lag = logarithmic(0.001, 0.25) / kv;
  PulseLoop loop = made(options_with(kv, lag));
  loop.load(1 << 20);
  const double greatest = logarithmic(0.1, 100) * kv;
  for (int k = 0; k < 2000; ++k) {
    loop.run_through((1 + any(0, 3)) / greatest);
    loop.pulse(1);
    RC_ASSERT(std::fabs(static_cast<double>(loop.following_error())) <= greatest / kv + 2);
  }
}

/// Four bits hold −8 … 7.
TEST(PulseLoop, ReportsEveryPulseItsCounterHasNoRoomFor) {
  for (const int direction : {1, -1}) {
    PulseLoop loop = made(options_with(20, 0.02, 4));
    loop.load(100);
    const int room = direction > 0 ? 7 : 8;
    for (int k = 0; k < 20; ++k) loop.pulse(direction);
    EXPECT_EQ(loop.following_error(), direction * room);
    EXPECT_EQ(loop.overflows(), 20 - room);
    EXPECT_EQ(loop.lost(), direction * (20 - room));
    loop.run_through(10);
    EXPECT_EQ(loop.encoder_count(), direction * room);
    EXPECT_EQ(loop.commanded(), direction * 20);
    EXPECT_EQ(loop.commanded_gross(), 20);
    EXPECT_EQ(loop.encoder_gross(), room);
  }
}

/// Ten million pulses, each with an interval and now and then a direction of its own, at 100 … 20000 a second.
TEST(LongPulseLoop, LosesNoneOfTenMillionPulses) {
  PulseLoop loop = made(options_with(40, 0.005, 12));
  constexpr std::int64_t pulses = 10'000'000;
  loop.load(pulses);
  std::uint64_t state = 1980;
  const auto random = [&] { return (state = state * 6364136223846793005u + 1442695040888963407u) >> 33; };
  std::int64_t sent = 0, greatest = 0;
  int direction = 1;
  double rate = 1000;
  for (std::int64_t k = 0; k < pulses; ++k) {
    if (random() % 10000 == 0) direction = -direction;
    if (random() % 5000 == 0) rate = 100 * std::pow(200, static_cast<double>(random()) / 2147483648.0);
    loop.run_through(static_cast<double>(random() % 2001) / 1000 / rate);
    loop.pulse(direction);
    sent += direction;
    greatest = std::max(greatest, std::abs(loop.following_error()));
  }
  settle(loop, 5);
  EXPECT_EQ(loop.to_come(), 0);
  EXPECT_EQ(loop.commanded(), sent);
  EXPECT_EQ(loop.encoder_count(), sent);
  EXPECT_TRUE(loop.comes_to_rest());
  EXPECT_EQ(loop.overflows(), 0);
  EXPECT_GT(greatest, 400);
  EXPECT_LT(greatest, 600);  // 20000/40 and what random intervals add
}

std::string refusal(const PulseLoopOptions& options) {
  const auto loop = PulseLoop::create(options);
  return loop ? "" : std::string(loop.error().code) + ": " + loop.error().message;
}

TEST(PulseLoop, SaysWhichOptionIsWrong) {
  const PulseLoopOptions sound = options_with(20, 0.02);
  EXPECT_EQ(refusal(sound), "");
  PulseLoopOptions options = sound;
  options.converter = 0;
  EXPECT_EQ(refusal(options), "servo-pulse-loop: the gain of the converter is 0");
  options = sound;
  options.time_constant = -1;
  EXPECT_EQ(refusal(options), "servo-pulse-loop: the time constant is -1");
  options = sound;
  options.counter_bits = 33;
  EXPECT_EQ(refusal(options), "servo-pulse-loop: the number of bits of the up-down counter is 33");
  options = sound;
  options.start = 1.5;
  EXPECT_EQ(refusal(options), "servo-pulse-loop: the start is 1.5");
}

}  // namespace test_pulse_loop
}  // namespace leadscrew::servo::testing
