#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
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
std::atomic<bool> is_out_of_memory{false};  // for all threads but this
thread_local bool is_spared = false;

}  // namespace

// What `new` gets, so that it can be had to fail.
void* operator new(std::size_t size) {
  void* memory = is_out_of_memory && !is_spared ? nullptr : std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

void report(const char* message) {
  reported = message;
}

class Servo {
 public:
  Servo() {
    const leadscrew_tp_options options{0.01, 0.1, nullptr, 0.04};
    reported.clear();
    reported.reserve(400);  // none is to be had where it is told that there is none
    is_spared = true;
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
    std::fill_n(limits.jerk, 9, jerk);
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

  leadscrew_tp_wishes wishes{1, 1000, 0, 0};
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

/// Along the path, in the last period, mm/s.
double speed_of(const Servo& servo) {
  const auto &now = servo.places.back(), &before = servo.places.at(servo.places.size() - 2);
  return std::hypot(now[0] - before[0], now[1] - before[1], now[2] - before[2]) / period;
}

/// Does motion come to this speed, mm/s, and keep it for a quarter of a second? The thread of planning has no priority.
bool comes_to(Servo& servo, double speed) {
  int kept = 0;
  return servo.cycle_until([&] {
    kept = std::abs(speed_of(servo) - speed) < 0.1 ? kept + 1 : 0;
    return kept == 250;
  });
}

TEST(Planning, GreatestSpeedHoldsForMovesUnderWay) {
  Servo servo;
  servo.line(60, 0);
  servo.line(60, 60);
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.position[0] > 15; }));
  EXPECT_GT(speed_of(servo), 90);
  servo.wishes.top_speed = 30;
  EXPECT_TRUE(comes_to(servo, 30));
  servo.wishes.top_speed = 0;
  EXPECT_TRUE(comes_to(servo, 0));
  EXPECT_LT(servo.word.position[1], 60);
  servo.wishes.top_speed = 1000;
  EXPECT_TRUE(servo.ends());
  EXPECT_EQ(servo.places.back(), (std::array<double, 3>{60, 60, 0}));
  servo.expect_within_limits();
}

TEST(Planning, SlowsDownBeforeAMoveThatWouldBeTooFast) {
  Servo servo;
  servo.wishes.top_speed = 50;
  for (int n = 1; n <= 20; ++n) {
    leadscrew_tp_move move{};
    move.end[0] = 3 * n;
    move.speed = n % 2 == 0 ? 120 : 20;
    servo.push(move);
  }
  double fastest = 0;
  EXPECT_TRUE(servo.cycle_until([&] {
    if (servo.places.size() > 1) fastest = std::max(fastest, speed_of(servo));
    return servo.word.finished == 20;
  }));
  EXPECT_LE(fastest, 50.01);
  servo.expect_within_limits();
}

TEST(Planning, IsSetDownMoreOftenThanThereIsRoomToSay) {
  Servo servo;
  for (int n = 0; n < 30000; ++n) servo.set_down({double(n), 0, 0});
  servo.places.clear();
  EXPECT_TRUE(servo.cycle_until([&] {
    leadscrew_tp_move move{};
    move.number = 1;
    move.end[0] = 30003;
    move.speed = 100;
    return leadscrew_tp_push(servo.tp(), &move) == 0;
  }));
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.finished == 1; }));
  EXPECT_EQ(servo.places.front()[0], 29999);
  EXPECT_EQ(servo.places.back()[0], 30003);
  servo.expect_within_limits();
}

TEST(Planning, WhatIsThrownThereEndsMotionAndIsTold) {
  Servo servo;
  square(servo);
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.position[0] > 5; }));
  is_out_of_memory = true;
  const bool has_failed = servo.cycle_until([&] { return servo.word.has_failed != 0; });
  is_out_of_memory = false;
  EXPECT_TRUE(has_failed);
  EXPECT_NE(reported.find("planning has failed"), std::string::npos) << reported;
  servo.wishes.abort = 1;
  EXPECT_TRUE(servo.cycle_until([&] { return servo.word.is_aborted != 0; }));
  EXPECT_NEAR(speed_of(servo), 0, 20000 * 1e-3 * 1e-3);  // the last period of a stop, by its jerk
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
