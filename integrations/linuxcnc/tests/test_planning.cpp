#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "forbidden_calls.hpp"
#include "planning.h"

// The servo thread's side without LinuxCNC: what it calls takes no memory, waits for nothing and reads no clock, and words
// are within limits whatever is asked.

namespace {

using leadscrew::testing_support::told;
using leadscrew::testing_support::watch;

constexpr double velocity = 200, acceleration = 1000, jerk = 20000, period = 1e-3;

std::string reported;

void report(const char* message) {
  reported = message;
}

class Servo {
 public:
  Servo() {
    leadscrew_tp_options options{{}, 0.01, 0.1, 0.04};
    std::fill(std::begin(options.jerk), std::end(options.jerk), jerk);
    reported.clear();
    tp_ = leadscrew_tp_create(&options, report);
    set_down({});
  }
  ~Servo() { leadscrew_tp_destroy(tp_); }
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  void set_down(const std::array<double, 9>& position) {
    leadscrew_tp_limits limits{};
    std::fill_n(limits.velocity, 3, velocity);
    std::fill_n(limits.acceleration, 3, acceleration);
    armed([&] { leadscrew_tp_set_down(tp_, position.data(), &limits, 1'000'000); });
    added_ = 0;
    wishes.passed = 0;
    wishes.abort = 0;
  }

  void line(double x, double y, int group = 0) {
    leadscrew_tp_move move{};
    move.end[0] = x;
    move.end[1] = y;
    move.group = group;
    push(move);
  }
  void push(leadscrew_tp_move move) {
    move.number = ++added_;
    if (move.speed == 0) move.speed = 100;
    move.top_speed = 2 * move.speed;
    move.join = leadscrew_tp_blend;
    armed([&] { EXPECT_EQ(leadscrew_tp_push(tp_, &move), 0); });
  }

  /// A period; what stands at the gate may begin.
  void cycle() {
    armed([&] { leadscrew_tp_cycle(tp_, &wishes, &word); });
    if (word.gate > wishes.passed && lets) wishes.passed = word.gate;
    places.push_back({word.position[0], word.position[1], word.position[2]});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  /// False where it does not come to that.
  bool cycle_until(const std::function<bool()>& holds) {
    for (int n = 0; n < 20000; ++n) {
      cycle();
      if (holds()) return true;
    }
    return false;
  }
  bool ends() {
    return cycle_until([this] { return word.finished == added_; });
  }
  leadscrew_tp* tp() { return tp_; }

  void expect_within_limits() const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t n = 3; n < places.size(); ++n) {
        const auto at = [&](std::size_t back) { return places[n - back][axis]; };
        EXPECT_LE(std::abs(at(0) - at(1)), 1.001 * velocity * period) << n;
        EXPECT_LE(std::abs(at(0) - 2 * at(1) + at(2)), 1.001 * acceleration * period * period) << n;
        EXPECT_LE(std::abs(at(0) - 3 * at(1) + 3 * at(2) - at(3)), 1.001 * jerk * period * period * period) << n;
      }
    }
    EXPECT_EQ(watch().calls, 0) << told(watch());
  }

  leadscrew_tp_wishes wishes{1, 0, 0};
  leadscrew_tp_word word{};
  bool lets = true;
  std::vector<std::array<double, 3>> places;

 private:
  template <class Call>
  void armed(Call call) {
    watch().armed = true;
    call();
    watch().armed = false;
  }

  leadscrew_tp* tp_ = nullptr;
  std::uint32_t added_ = 0;
};

void square(Servo& servo) {
  servo.line(10, 0);
  servo.line(10, 10);
  servo.line(0, 10);
  servo.line(0, 0);
}

TEST(Planning, ForbiddenCallsAreSeen) {
  EXPECT_TRUE(leadscrew::testing_support::counts_each_function());
}

TEST(Planning, KeepsLimitsUnderEveryWishAndEndsExactly) {
  Servo servo;
  square(servo);
  servo.line(30, 5, 1);
  int n = 0;
  EXPECT_TRUE(servo.cycle_until([&] {
    constexpr std::array factors{1.0, 0.3, 0.0, 1.5, 0.7};
    servo.wishes.factor = factors.at(static_cast<std::size_t>(n++ / 150) % factors.size());
    return servo.word.finished == 5;
  }));
  EXPECT_EQ(servo.places.back(), (std::array<double, 3>{30, 5, 0}));
  servo.expect_within_limits();
}

TEST(Planning, AbortedMotionRestsAndBeginsAnewFromThere) {
  Servo servo;
  square(servo);
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.position[0] > 5; }));
  servo.wishes.abort = 1;
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.is_aborted != 0; }));
  std::array<double, 9> at{};
  std::copy_n(servo.word.position, 9, at.begin());
  servo.set_down(at);
  servo.line(1, 2);
  EXPECT_TRUE(servo.ends());
  EXPECT_EQ(servo.places.back(), (std::array<double, 3>{1, 2, 0}));
  servo.expect_within_limits();
}

TEST(Planning, NothingPassesTheGateUnasked) {
  Servo servo;
  servo.lets = false;
  servo.line(3, 0);
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.gate == 1; }));
  for (int n = 0; n < 200; ++n) servo.cycle();
  EXPECT_EQ(servo.places.back()[0], 0);
  servo.lets = true;
  EXPECT_TRUE(servo.ends());
  EXPECT_EQ(servo.places.back()[0], 3);
}

TEST(Planning, GoesOnBehindAMoveThatTheServoThreadMakes) {
  Servo servo;
  servo.line(3, 0);
  leadscrew_tp_move followed{};
  followed.end[0] = 3;
  followed.end[2] = -4;
  followed.is_followed = 1;
  servo.push(followed);
  leadscrew_tp_move after{};
  after.end[0] = 8;
  after.end[2] = -4;
  servo.push(after);
  servo.lets = false;
  EXPECT_TRUE(servo.cycle_until([&] {
    if (servo.word.gate == 1) servo.wishes.passed = 1;
    return servo.word.gate == 2;
  }));
  leadscrew_tp_followed(servo.tp(), 2, followed.end);
  servo.wishes.passed = 2;
  servo.lets = true;
  EXPECT_TRUE(servo.ends());
  EXPECT_EQ(servo.places.back(), (std::array<double, 3>{8, 0, -4}));
}

TEST(Planning, SaysWhyAMoveCannotBeMade) {
  Servo servo;
  leadscrew_tp_move arc{};
  arc.is_arc = 1;
  arc.end[0] = 10;
  arc.center[0] = 1;
  arc.turns = 1;
  servo.push(arc);
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.has_failed != 0; }));
  EXPECT_NE(reported.find("arc-radius"), std::string::npos) << reported;
  servo.wishes.abort = 1;
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.is_aborted != 0; }));
}

}  // namespace
