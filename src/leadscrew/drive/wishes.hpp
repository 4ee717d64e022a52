#pragma once
// What is wanted of a machine that moves, by keys on a terminal or from a page: the thread that drives has it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <leadscrew/base/word.hpp>
#include <leadscrew/drive/pause.hpp>
#include <leadscrew/realtime/runner.hpp>

namespace leadscrew::drive {

/// What comes of the wish that motion is held.
enum class HoldState : std::uint8_t {
  none,     ///< nobody wishes it
  obeyed,   ///< motion brakes, or stands
  waits,    ///< motion is in step with the spindle: it is held where that ends
  refused,  ///< the program has forbidden it (M53 P0)
};

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

  /// Is motion in step with the spindle, where no override counts? Where it is held behind a thread, its end has not been told yet.
  static bool is_in_step(const realtime::Counters& counters, const base::Word& last) {
    return counters.allowed_overrides.in_step && last.state != base::MotionState::rest;
  }

  HoldState hold_state(const realtime::Counters& counters, const base::Word& last) const {
    if (!held) return HoldState::none;
    if (is_in_step(counters, last)) return HoldState::waits;
    return counters.allowed_overrides.hold ? HoldState::obeyed : HoldState::refused;
  }
};

}  // namespace leadscrew::drive
