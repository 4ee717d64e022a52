#include <algorithm>
#include <leadscrew/report/followed_recording.hpp>

namespace leadscrew::report {

FollowedRecording::FollowedRecording(base::AxisSet axes)
    : axes_(axes), errors_(1 + static_cast<std::size_t>(axes.size())), contour_(1), ideal_(axes) {
  points_.reserve(most_points);
}

void FollowedRecording::observe(const base::AxisVector& commanded, const base::AxisVector& actual, double feed) {
  double* values = errors_.sample();
  *values++ = feed;
  for (const base::Axis axis : base::all_axes) {
    if (axes_.contains(axis)) *values++ = commanded[base::index(axis)] - actual[base::index(axis)];
  }
  errors_.take();
  ++words_;
}

void FollowedRecording::observe(const FollowedPoint& point, std::int64_t periods) {
  greatest_ = std::max(greatest_, point.distance);
  for (; periods > 0 && matched_ < words_; --periods, ++matched_) {
    *contour_.sample() = point.distance;
    contour_.take();
  }
  if (since_ == 0 || point.distance > worst_.distance) worst_ = point;
  if (++since_ < each_) return;
  since_ = 0;
  points_.push_back(worst_);
  if (points_.size() == most_points) thin_points();
}

void FollowedRecording::thin_points() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 1 < points_.size(); i += 2) {
    const FollowedPoint& second = points_[i + 1];
    points_[kept++] = second.distance > points_[i].distance ? second : points_[i];
  }
  points_.resize(kept);
  each_ *= 2;
}

std::span<const Extent> FollowedRecording::error(base::Axis axis) {
  std::size_t channel = 1;
  for (const base::Axis other : base::all_axes) {
    if (other == axis) break;
    if (axes_.contains(other)) ++channel;
  }
  return axes_.contains(axis) ? errors_.channel(channel) : std::span<const Extent>();
}

}  // namespace leadscrew::report
