#pragma once
// Following error and overshoot of each axis, and the measured feed.
//
// Following error: position commanded at a word's tick, less the slide's. Overshoot: how far a slide went past a
// commanded stop, in the direction it came from; a stop is where words of this axis stand, be it alone at a corner or
// with all others at the end. Measured feed: the norm of the linear axes' velocities, as tachogenerators show them; of
// the rotary axes' where a machine has no others; of the tool's tip where feed is counted by that. Commanded feed is that of
// the words where it is counted by the same: where rotary axes alone are fed, in degrees/s, there is none.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/servo/servo.hpp>
#include <optional>

namespace leadscrew::servo {

/// mm; degrees for a rotary axis.
struct AxisTracking {
  double greatest = 0;   ///< of |following error|
  double rms = 0;        ///< of the following error
  double overshoot = 0;  ///< greatest of all stops
};

/// What a period brought the tool's tip.
struct TipMotion {
  double travel = 0;  ///< that words led it since the last, mm
  double speed = 0;   ///< by the tachogenerators, mm/s
};

/// mm/s; degrees/s where only rotary axes are.
struct FeedTracking {
  double commanded_max = 0;
  double measured_max = 0;
  double measured_mean = 0;  ///< while words ask for motion
};

class Tracking {
 public:
  Tracking(base::AxisSet axes, base::Period period);

  /// In the order of time, one a period. `tip`: where feed is counted by it.
  void observe(const Followed& followed, const std::optional<TipMotion>& tip = std::nullopt);

  AxisTracking axis(base::Axis axis) const;
  FeedTracking feed() const;
  /// By the tachogenerators, now.
  double measured_feed() const { return measured_; }

 private:
  struct OfAxis {
    double greatest = 0, squares = 0, overshoot = 0;
    double direction = 0;  // of its last words that moved: +1 or −1; 0 before the first
  };

  base::AxisSet axes_, feed_axes_;
  double period_;  ///< s
  std::array<OfAxis, base::axis_count> of_axis_{};
  std::optional<base::AxisVector> before_;
  std::int64_t periods_ = 0, moving_ = 0;
  double measured_ = 0, measured_sum_ = 0;
  FeedTracking feed_;
};

}  // namespace leadscrew::servo
