/* SPDX-License-Identifier: GPL-2.0-only */
#include "motmod.hpp"

#include <gtest/gtest.h>

#include <cstdarg>
#include <cstdio>

#include "forbidden_calls.hpp"

extern "C" {
#include "hal.h"
#include "rtapi.h"
extern void* rtapi_info_address_jerk;
}

using leadscrew::testing_support::watch;

namespace {

/// What a call in the servo thread may not call is seen.
class InTheServoThread {
 public:
  InTheServoThread() { watch().armed = true; }
  ~InTheServoThread() {
    watch().armed = false;
    EXPECT_EQ(watch().calls, 0) << told(watch());
    watch().calls = 0;
  }
  InTheServoThread(const InTheServoThread&) = delete;
  InTheServoThread& operator=(const InTheServoThread&) = delete;
};

/// What LinuxCNC does for the module there is not the module's.
class OutsideOfTheModule {
 public:
  OutsideOfTheModule() { watch().armed = false; }
  ~OutsideOfTheModule() { watch().armed = was_armed_; }
  OutsideOfTheModule(const OutsideOfTheModule&) = delete;
  OutsideOfTheModule& operator=(const OutsideOfTheModule&) = delete;

 private:
  const bool was_armed_ = watch().armed;
};

}  // namespace

Motmod* Motmod::current = nullptr;
std::map<std::string, volatile double*> Motmod::pins;

extern "C" {

// What rtapi and HAL do for a module, as far as this one asks.
int hal_init(const char*) {
  return 1;
}
int hal_exit(int) {
  return 0;
}
int hal_ready(int) {
  return 0;
}
void* hal_malloc(long size) {
  static std::array<std::array<double, 64>, 64> blocks;  // pins live as long as HAL
  static std::size_t used = 0;
  return size <= long(sizeof blocks[0]) ? blocks.at(used++ % blocks.size()).data() : nullptr;
}
int hal_pin_float_newf(hal_pin_dir_t, hal_float_t** pin, int, const char* format, ...) {
  std::array<char, 80> name{};
  va_list words;
  va_start(words, format);
  std::vsnprintf(name.data(), name.size(), format, words);
  va_end(words);
  *pin = static_cast<hal_float_t*>(hal_malloc(sizeof **pin));
  Motmod::pins[name.data()] = *pin;
  return 0;
}
int hal_pin_s32_newf(hal_pin_dir_t, hal_s32_t** pin, int, const char*, ...) {
  *pin = static_cast<hal_s32_t*>(hal_malloc(sizeof **pin));
  return 0;
}
void rtapi_print_msg(msg_level_t, const char* format, ...) {
  const OutsideOfTheModule outside;
  va_list words;
  va_start(words, format);
  std::vprintf(format, words);
  va_end(words);
}
}

namespace {

char jerk[] = "20000";

void write_digital(int index, char on) {
  const OutsideOfTheModule outside;
  Motmod::current->digital.emplace_back(index, on);
}
void write_analog(int index, double value) {
  const OutsideOfTheModule outside;
  Motmod::current->analog.emplace_back(index, value);
}
void unlock(int joint, int on) {
  Motmod::current->joints_unlocked = on << joint;
}
int is_unlocked(int joint) {
  return Motmod::current->joints_unlocked >> joint & 1;
}
double velocity(int axis) {
  return axis < 3 ? Motmod::current->velocity : axis == 3 ? 90 : 0;
}
double acceleration(int axis) {
  return axis < 3 ? 1000 : axis == 3 ? 500 : 0;
}
double no_limit(int) {
  return 0;
}

emcmot_status_t other_status{};
emcmot_config_t other_config{};

}  // namespace

Motmod::Motmod() {
  current = this;
  *static_cast<char**>(rtapi_info_address_jerk) = jerk;
  // So that what is broken fails rather than crashes.
  ::tpMotFunctions(write_digital, write_analog, unlock, is_unlocked, no_limit, no_limit);
  ::tpMotData(&other_status, &other_config);
  config.numDIO = config.numAIO = 4;
  config.numSpindles = 1;
  config.maxFeedScale = 1.5;
  status.net_feed_scale = 1;
  status.spindle_status[0].at_speed = 1;
  status.spindle_status[0].direction = 1;
  rtapi_app_main();
  functions.tpMotFunctions(write_digital, write_analog, unlock, is_unlocked, ::velocity, acceleration);
  functions.tpMotData(&status, &config);
  tp.cycleTime = seconds;
  functions.tpCreate(&tp, 32, 0);
  functions.tpSetCycleTime(&tp, seconds);
  functions.tpSetPos(&tp, &pose);
  functions.tpSetVlimit(&tp, 400);
  functions.tpSetId(&tp, 1);
}

int Motmod::line(double x, double y, double z, double speed) {
  EmcPose end = pose;
  end.tran = {x, y, z};
  const InTheServoThread here;
  return functions.tpAddLine(&tp, end, EMC_MOTION_TYPE_FEED, speed, 400, 1000, 0, 0, -1, tag);
}

int Motmod::circle(double x, PmCartesian normal) {
  const InTheServoThread here;
  return functions.tpAddCircle(&tp, tp.goalPos, {x, 0, 0}, normal, 0, EMC_MOTION_TYPE_ARC, 50, 400, 1000, 0, 0, tag);
}

void Motmod::cycle() {
  spindle_status_t& spindle = status.spindle_status[0];
  const double wanted = spindle.speed / 60, step = 20 * seconds;
  turns_per_second += std::fmin(std::fmax(wanted - turns_per_second, -step), step);
  spindle.spindleRevs += turns_per_second * seconds;
  spindle.spindleSpeedIn = turns_per_second;
  // Its index comes at once, and counts revolutions from there.
  if (spindle.spindle_index_enable && turns_per_second != 0) {
    spindle.spindle_index_enable = 0;
    spindle.spindleRevs = 0;
  }
  {
    const InTheServoThread here;
    functions.tpRunCycle(&tp, std::lround(seconds * 1e9));
    functions.tpGetPos(&tp, &pose);
  }
  places.push_back({pose.tran.x, pose.tran.y, pose.tran.z});
  std::this_thread::sleep_for(std::chrono::microseconds(500));
}

bool Motmod::cycle_until(const std::function<bool()>& holds, int most) {
  for (int n = 0; n < most; ++n) {
    cycle();
    if (holds()) return true;
  }
  return false;
}

double Motmod::speed() const {
  if (places.size() < 2) return 0;
  const auto &now = places.back(), &before = places[places.size() - 2];
  return std::hypot(now[0] - before[0], now[1] - before[1], now[2] - before[2]) / seconds;
}

double Motmod::difference(int order) const {
  double worst = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const auto& place : places) values.push_back(place[axis]);
    if (values.size() <= static_cast<std::size_t>(order)) return 0;
    for (int n = 0; n < order; ++n) {
      for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = (values[i + 1] - values[i]) / seconds;
      values.pop_back();
    }
    for (const double value : values) worst = std::fmax(worst, std::fabs(value));
  }
  return worst;
}
