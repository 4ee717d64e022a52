#pragma once
// A path in memory that does not grow with it.

#include <algorithm>
#include <leadscrew/report/path_thinning.hpp>
#include <span>
#include <vector>

namespace leadscrew::report {

/// The path as it comes, thinned to a tolerance that doubles whenever the points run out.
class BoundedPath {
 public:
  static constexpr std::size_t most_points = 20000;

  explicit BoundedPath(base::AxisSet axes) : axes_(axes), thinner_(axes, tolerance()) { points_.reserve(most_points); }

  void observe(const PathPoint& point) {
    if (points_.empty()) {
      points_.push_back(point);
      thinner_.begin(point);
      return;
    }
    if (point.feed > greatest_feed_) {
      greatest_feed_ = point.feed;
      thinner_.tolerate(tolerance());
    }
    if (ends_with_last_) {
      points_.pop_back();
      ends_with_last_ = false;
    }
    if (!thinner_.offer(point)) return;
    points_.push_back(thinner_.anchor());
    if (points_.size() == most_points) coarsen();
  }

  /// Up to the point observed last.
  std::span<const PathPoint> points() {
    if (!points_.empty() && thinner_.has_moved() && !ends_with_last_) {
      points_.push_back(thinner_.last());  // there is room: coarsen() sees to it
      ends_with_last_ = true;
    }
    return points_;
  }

 private:
  ThinningTolerance tolerance() const { return {finest_position * scale_, finest_feed * greatest_feed_ * scale_}; }

  void coarsen() {
    for (int tries = 0; points_.size() > most_points / 2 && tries < 64; ++tries) {
      scale_ *= 2;
      thin(points_, axes_, tolerance());
    }
    if (points_.size() > most_points / 2) points_.resize(most_points / 2);
    thinner_.tolerate(tolerance());
  }

  static constexpr double finest_position = 0.0005;  // mm or degrees
  static constexpr double finest_feed = 0.005;       // of the greatest feed

  base::AxisSet axes_;
  double scale_ = 1;
  double greatest_feed_ = 0;
  PathThinner thinner_;
  std::vector<PathPoint> points_;
  bool ends_with_last_ = false;  ///< whether a point that is not kept yet stands at the end
};

}  // namespace leadscrew::report
