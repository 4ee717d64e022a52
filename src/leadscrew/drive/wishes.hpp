#pragma once
// What is wanted of a machine that moves, by keys on a terminal or from a page: the thread that drives has it.

#include <algorithm>
#include <cmath>
#include <leadscrew/base/word.hpp>
#include <leadscrew/drive/pause.hpp>
#include <leadscrew/realtime/runner.hpp>

namespace leadscrew::drive {

struct Wishes {
  static constexpr double least_factor = 0.1, greatest_factor = 2;

  Pause pause;        ///< the planner's thread asks it
  double factor = 1;  ///< of the feed, when it is not held
  bool held = false;

  /// least_factor … greatest_factor, in steps of 10 %.
  void change_factor(int steps) { set_factor(std::round(factor * 10 + steps) / 10); }
  void set_factor(double wanted) { factor = std::clamp(wanted, least_factor, greatest_factor); }
  void tell(realtime::Runner& runner) const { runner.override_feed(held ? 0 : factor); }

  /// Does motion stand at M0, M1 or M60? Not where it rests for a moment on its way there.
  bool stand_at_pause(const realtime::Counters& counters, const base::Word& last) const {
    return pause.line() && counters.seconds_ahead <= 0 && last.state == base::MotionState::rest;
  }
};

}  // namespace leadscrew::drive
