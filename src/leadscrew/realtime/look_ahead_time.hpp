#pragma once
// How far ahead of the cycle motion is planned. What has been planned delays a change of the feed; what has not been
// makes a planner late. So it is far at first, and nearer where the planner has long been in time, or where what it took to plan
// the beginning, at rest, says that less is enough:
//
//   s ahead  ───┐                    ┌───┐        a drain: what the cycle began while a chunk was planned
//               └──┐                 │   └──┐
//                  └──┐  drain       │      └──
//                     └───────┘\/────┘ at once farther again

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace leadscrew::realtime {

class LookAheadTime {
 public:
  /// Between these, s. Begins with the greatest.
  LookAheadTime(double least, double greatest)
      : least_(std::min(least, greatest)), greatest_(greatest), ahead_(greatest) {}

  /// s of motion that is to be planned and not begun.
  double seconds() const { return ahead_; }

  /// While motion waits at rest to begin: a chunk that goes on in it took so many seconds to plan.
  void planned_at_rest(double seconds) {
    drains_[stretch_ % drains_.size()] = std::max(drains_[stretch_ % drains_.size()], seconds);
    knows_drain_ = true;
  }
  /// Motion begins with what was planned at rest. Where one was late not long ago it stays as far as it was.
  void begins() {
    if (std::exchange(knows_drain_, false) && since_ >= 0) ahead_ = std::clamp(enough(), least_, greatest_);
  }
  /// A chunk of so many seconds was accepted, that goes on in motion: so much was planned and not begun when it was
  /// asked for, and when it had been planned.
  void accepted(double duration, double ahead_before, double ahead_after) {
    double& drain = drains_[stretch_ % drains_.size()];
    drain = std::max(drain, ahead_before - ahead_after);
    if (ahead_after < nearly_drained * ahead_) ahead_ = std::min(2 * ahead_, greatest_);
    since_ += duration;
    if (since_ < stretch_duration) return;
    since_ = 0;
    ++stretch_;
    ahead_ = std::clamp(std::max(enough(), ahead_ / 2), least_, greatest_);
    drains_[stretch_ % drains_.size()] = 0;
  }
  /// One came too late: for the next while, twice as long each time, it is as far as can be.
  void late() {
    ahead_ = greatest_;
    since_ = -caution_;
    caution_ = std::min(2 * caution_, greatest_caution);
  }
  /// By so many seconds the cycle woke up late, once: it then begins as much at once.
  void cycle_was_late(double by) { lateness_ = std::max(lateness_, by); }

 private:
  static constexpr double stretch_duration = 0.5;  // s of motion
  static constexpr double nearly_drained = 0.25;
  static constexpr double drain_margin = 1.5, lateness_margin = 2, short_chunk = 0.01;  // s
  static constexpr double greatest_caution = 600;                                       // s of motion

  double enough() const {
    const double drain = *std::max_element(drains_.begin(), drains_.end());
    return std::max(least_, drain_margin * drain + short_chunk) + lateness_margin * lateness_;
  }

  double least_, greatest_, ahead_;
  std::array<double, 8> drains_{};  ///< the greatest of the last stretches, s
  std::size_t stretch_ = 0;
  double since_ = 0;          ///< s of motion in this stretch
  double caution_ = 10;       ///< s of motion
  bool knows_drain_ = false;  ///< of what was planned at rest
  double lateness_ = 0;       ///< s, the greatest
};

}  // namespace leadscrew::realtime
