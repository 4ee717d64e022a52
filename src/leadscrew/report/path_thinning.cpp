#include <leadscrew/report/path_thinning.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace leadscrew::report {

PathThinner::PathThinner(base::AxisSet axes, ThinningTolerance tolerance) : tolerance_(tolerance) {
  for (const base::Axis axis : base::all_axes) {
    if (axes.contains(axis)) coordinates_[count_++] = base::index(axis);
  }
}

void PathThinner::begin(const PathPoint& point) {
  anchor_ = point;
  last_ = point;
  open_bands();
}

void PathThinner::open_bands() {
  constexpr Band open{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  position_bands_.fill(open);
  feed_band_ = open;
  distance_ = 0;
}

bool PathThinner::within_bands(const PathPoint& point) const {
  const double per_distance = 1 / distance_;
  const auto within = [&](Band band, double rise) {
    const double slope = rise * per_distance;
    return band.least <= slope && slope <= band.greatest;
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t axis = coordinates_[i];
    if (!within(position_bands_[i], point.position[axis] - anchor_.position[axis])) return false;
  }
  return within(feed_band_, point.feed - anchor_.feed);
}

void PathThinner::narrow_bands(const PathPoint& point) {
  const double per_distance = 1 / distance_;
  const auto narrow = [&](Band& band, double rise, double tolerance) {
    band.least = std::max(band.least, (rise - tolerance) * per_distance);
    band.greatest = std::min(band.greatest, (rise + tolerance) * per_distance);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t axis = coordinates_[i];
    narrow(position_bands_[i], point.position[axis] - anchor_.position[axis], tolerance_.position);
  }
  narrow(feed_band_, point.feed - anchor_.feed, tolerance_.feed);
}

bool PathThinner::offer(const PathPoint& point) {
  double step = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t axis = coordinates_[i];
    step += std::fabs(point.position[axis] - last_.position[axis]);
  }
  if (step == 0) return false;  // standing still
  const bool changes = distance_ > 0 && point.is_rapid != last_.is_rapid;
  distance_ += step;
  const bool keeps = changes || !within_bands(point);
  if (keeps) {
    anchor_ = last_;
    open_bands();
    distance_ = step;
  }
  last_ = point;
  narrow_bands(point);
  return keeps;
}

void thin(std::vector<PathPoint>& points, base::AxisSet axes, ThinningTolerance tolerance) {
  if (points.size() < 3) return;
  PathThinner thinner(axes, tolerance);
  const PathPoint last = points.back();
  std::size_t kept = 1;
  thinner.begin(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (thinner.offer(points[i])) points[kept++] = thinner.anchor();
  }
  points[kept++] = last;
  points.resize(kept);
}

std::vector<PathPoint> thinned_to(std::span<const PathPoint> points, base::AxisSet axes, std::size_t most,
                                  ThinningTolerance finest) {
  std::vector<PathPoint> kept(points.begin(), points.end());
  constexpr int doublings = 64;
  for (int n = 0; kept.size() > most && n < doublings; ++n) {
    kept.assign(points.begin(), points.end());
    thin(kept, axes, {std::ldexp(finest.position, n), std::ldexp(finest.feed, n)});
  }
  kept.resize(std::min(kept.size(), most));
  return kept;
}

}  // namespace leadscrew::report
