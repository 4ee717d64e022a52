#include <algorithm>
#include <leadscrew/report/followed_recording.hpp>

namespace leadscrew::report {

namespace {

constexpr std::array values_of_axis = {&FollowedAxis::error, &FollowedAxis::velocity, &FollowedAxis::control,
                                       &FollowedAxis::current};

}  // namespace

FollowedRecording::FollowedRecording(base::AxisSet axes)
    : axes_(axes),
      axes_of_words_(1 + values_of_axis.size() * static_cast<std::size_t>(axes.size())),
      contour_(1),
      ideal_(axes) {
  points_.reserve(most_points);
}

void FollowedRecording::observe(const std::array<FollowedAxis, base::axis_count>& axes, double feed) {
  double* values = axes_of_words_.sample();
  *values++ = feed;
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    for (const auto value : values_of_axis) *values++ = axes[base::index(axis)].*value;
  }
  axes_of_words_.take();
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

std::span<const Extent> FollowedRecording::axis(base::Axis axis, double FollowedAxis::* value) {
  if (!axes_.contains(axis)) return {};
  std::size_t channel = 1;
  for (const base::Axis other : base::all_axes) {
    if (other == axis) break;
    if (axes_.contains(other)) channel += values_of_axis.size();
  }
  return axes_of_words_.channel(
      channel + static_cast<std::size_t>(std::ranges::find(values_of_axis, value) - values_of_axis.begin()));
}

}  // namespace leadscrew::report
