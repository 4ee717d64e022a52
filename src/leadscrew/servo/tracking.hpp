#pragma once
// What following words came to, axis by axis.
//
// Following error: where an axis was to be at a word's tick, less where its slide was. Overshoot: how far a slide went
// past a place at which its axis was to stop, in the direction it came from; an axis that is to stand stops, be it
// alone at a corner or with all others at the end. Measured feed: of what tachogenerators tell of the linear axes, the
// length; of rotary axes where a machine has no others.

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
    double way = 0;  // last direction of its words: +1 or −1; 0 before the first
  };

  base::AxisSet axes_, feed_axes_;
  std::array<OfAxis, base::axis_count> of_axis_{};
  std::optional<base::AxisVector> before_;
  std::int64_t periods_ = 0, moving_ = 0;
  double measured_ = 0, measured_sum_ = 0;
  FeedTracking feed_;
};

}  // namespace leadscrew::servo
