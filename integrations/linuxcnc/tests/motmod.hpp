/* SPDX-License-Identifier: GPL-2.0-only */
#pragma once
// What LinuxCNC's motmod does for the functions of a trajectory planner, without LinuxCNC: a machine of 200 mm/s and 1000 mm/s²
// in X, Y and Z and of 90 °/s in A, a spindle, and a record of all words. Functions are called through a table, in which one that
// the environment names (LEADSCREW_BROKEN=tpPause) does nothing: then its test must fail.

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// Of these headers one is for C++ too, one for C alone.
#include "posemath.h"
extern "C" {
#include "tcq.h"
}
#include "motion.h"
#include "motion_types.h"
extern "C" {
#include "tp.h"

int rtapi_app_main(void);
void rtapi_app_exit(void);
}

/// Those that motmod.so takes from a planner (nm -D).
// clang-format off
#define LEADSCREW_TP_FUNCTIONS(DO) \
  DO(tcqFull) DO(tpAbort) DO(tpActiveDepth) DO(tpAddCircle) DO(tpAddLine) \
  DO(tpAddRigidTap) DO(tpClear) DO(tpCreate) DO(tpGetExecId) DO(tpGetExecTag) \
  DO(tpGetMotionType) DO(tpGetPos) DO(tpIsDone) DO(tpMotData) DO(tpMotFunctions) \
  DO(tpPause) DO(tpQueueDepth) DO(tpResume) DO(tpRunCycle) DO(tpSetAmax) \
  DO(tpSetAout) DO(tpSetCycleTime) DO(tpSetDout) DO(tpSetId) DO(tpSetPos) \
  DO(tpSetRunDir) DO(tpSetSpindleSync) DO(tpSetTermCond) DO(tpSetVlimit) DO(tpSetVmax)
// clang-format on

struct Functions {
  Functions() {
    const char* asked = std::getenv("LEADSCREW_BROKEN");
    const std::string broken = asked ? asked : "";
#define LEADSCREW_BREAK(function) \
  if (broken == #function) do_nothing(function);
    LEADSCREW_TP_FUNCTIONS(LEADSCREW_BREAK)
#undef LEADSCREW_BREAK
  }
#define LEADSCREW_MEMBER(function) decltype(&::function) function = ::function;
  LEADSCREW_TP_FUNCTIONS(LEADSCREW_MEMBER)
#undef LEADSCREW_MEMBER

 private:
  template <class Value, class... Arguments>
  static void do_nothing(Value (*&function)(Arguments...)) {
    function = [](Arguments...) -> Value { return Value(); };
  }
};

class Motmod {
 public:
  Motmod();
  ~Motmod() { rtapi_app_exit(); }
  Motmod(const Motmod&) = delete;
  Motmod& operator=(const Motmod&) = delete;

  int line(double x, double y, double z = 0, double speed = 100);
  /// Once around (x, 0, 0), counterclockwise, to where it begins.
  int circle(double x, PmCartesian normal = {0, 0, 1});
  /// A period; it takes its time, for another thread plans.
  void cycle();
  /// False where it does not come to that.
  bool cycle_until(const std::function<bool()>& holds, int most = 6000);
  bool ends() {
    return cycle_until([this] { return functions.tpIsDone(&tp) != 0; });
  }
  /// Along the path, in the last period, mm/s.
  double speed() const;
  /// The greatest of an axis' differences, mm/s^order.
  double difference(int order) const;

  Functions functions;
  emcmot_status_t status{};
  emcmot_config_t config{};
  TP_STRUCT tp{};
  EmcPose pose{};
  struct state_tag_t tag{};
  std::vector<std::array<double, 3>> places;
  double turns_per_second = 0;  ///< of the spindle; it follows spindle_status[0].speed where that is set
  int joints_unlocked = 0;
  std::vector<std::pair<int, int>> digital;
  std::vector<std::pair<int, double>> analog;
  double seconds = 0.001;  ///< a period
  double velocity = 200;   ///< mm/s, of X, Y and Z

  static Motmod* current;
  static std::map<std::string, volatile double*> pins;  ///< of numbers, by their names
};
