#pragma once
// Following error and overshoot of each axis, and the measured feed.
//
// Following error: position commanded at a word's tick, less the slide's. Overshoot: how far a slide went past a
// commanded stop, in the direction it came from; a stop is where words of this axis stand, be it alone at a corner or
// with all others at the end. Measured feed: the norm of the linear axes' velocities, as tachogenerators show them; of
// the rotary axes' where a machine has no others.

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

/// mm/s; degrees/s where only rotary axes are.
struct FeedTracking {
  double commanded_max = 0;
  double measured_max = 0;
  double measured_mean = 0;  ///< while words ask for motion
};

class Tracking {
 public:
  explicit Tracking(base::AxisSet axes);

  /// In the order of time, one a period.
  void observe(const Followed& followed);

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
  std::array<OfAxis, base::axis_count> of_axis_{};
  std::optional<base::AxisVector> before_;
  std::int64_t periods_ = 0, moving_ = 0;
  double measured_ = 0, measured_sum_ = 0;
  FeedTracking feed_;
};

}  // namespace leadscrew::servo
