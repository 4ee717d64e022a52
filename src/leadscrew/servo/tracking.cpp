#include <algorithm>
#include <cmath>
#include <leadscrew/servo/tracking.hpp>

namespace leadscrew::servo {

namespace {

base::AxisSet linear_axes(base::AxisSet axes) {
  base::AxisSet linear;
  for (const base::Axis axis : base::all_axes) {
    if (axes.contains(axis) && !base::is_rotary(axis)) linear.insert(axis);
  }
  return linear;
}

}  // namespace

Tracking::Tracking(base::AxisSet axes, base::Period period)
    : axes_(axes), feed_axes_(linear_axes(axes).empty() ? axes : linear_axes(axes)), period_(period.seconds()) {}

void Tracking::observe(const Followed& followed, const std::optional<TipMotion>& tip) {
  double squares = 0, steps = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    const std::size_t k = base::index(axis);
    const double commanded = followed.word.position[k], error = commanded - followed.position[k];
    OfAxis& of_axis = of_axis_[k];
    of_axis.greatest = std::max(of_axis.greatest, std::fabs(error));
    of_axis.squares += error * error;
    const double step = before_ ? commanded - (*before_)[k] : 0;
    if (step != 0) {
      of_axis.direction = step > 0 ? 1 : -1;
    } else {
      of_axis.overshoot = std::max(of_axis.overshoot, -error * of_axis.direction);
    }
    if (!feed_axes_.contains(axis)) continue;
    squares += followed.velocity[k] * followed.velocity[k];
    steps += step * step;
  }
  measured_ = tip ? tip->speed : std::sqrt(squares);
  double commanded = followed.word.feed;
  // A word does not say what its feed is counted by: rotary axes alone may be fed where a machine has others, too.
  if (axes_ != feed_axes_) commanded = std::min(commanded, (tip ? tip->travel : std::sqrt(steps)) / period_);
  feed_.measured_max = std::max(feed_.measured_max, measured_);
  feed_.commanded_max = std::max(feed_.commanded_max, commanded);
  if (followed.word.state != base::MotionState::rest) {
    measured_sum_ += measured_;
    ++moving_;
  }
  before_ = followed.word.position;
  ++periods_;
}

AxisTracking Tracking::axis(base::Axis axis) const {
  const OfAxis& of_axis = of_axis_[base::index(axis)];
  const double count = std::max(1.0, static_cast<double>(periods_));
  return {of_axis.greatest, std::sqrt(of_axis.squares / count), of_axis.overshoot};
}

FeedTracking Tracking::feed() const {
  FeedTracking feed = feed_;
  feed.measured_mean = moving_ > 0 ? measured_sum_ / static_cast<double>(moving_) : 0;
  return feed;
}

}  // namespace leadscrew::servo
