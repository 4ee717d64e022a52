#include <algorithm>
#include <leadscrew/toolpath/corridor_check.hpp>
#include <leadscrew/toolpath/corridor_optimum.hpp>
#include <leadscrew/toolpath/corridor_plan.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::corridor;

/// The coordinates that move, two at least.
std::vector<std::size_t> moving_axes(const Corridor<3>& corridor, const CorridorEnds<3>& ends) {
  std::vector<std::size_t> moving, still;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double first = corridor.legs.front().from[axis];
    const auto moves = [&](const CorridorLeg<3>& leg) {
      return leg.from[axis] != first || leg.to[axis] != first ||
             (leg.is_arc && (leg.first == axis || leg.second == axis));
    };
    const auto is_off = [&](const Vector<3>& point) { return point[axis] != first; };
    const bool is_moving = std::any_of(corridor.legs.begin(), corridor.legs.end(), moves) ||
                           (corridor.begin == CorridorEnd::moving &&
                            std::any_of(ends.points_at_begin.begin(), ends.points_at_begin.end(), is_off));
    (is_moving ? moving : still).push_back(axis);
  }
  while (moving.size() < 2) {
    moving.push_back(still.front());
    still.erase(still.begin());
  }
  std::sort(moving.begin(), moving.end());
  return moving;
}

template <std::size_t D>
Vector<D> projected(const Vector<3>& a, const std::vector<std::size_t>& axes) {
  Vector<D> b;
  for (std::size_t i = 0; i < D; ++i) b[i] = a[axes[i]];
  return b;
}

template <std::size_t D>
CorridorLeg<D> projected(const CorridorLeg<3>& leg, const std::vector<std::size_t>& axes) {
  const Vector<D> from = projected<D>(leg.from, axes), to = projected<D>(leg.to, axes);
  if (!leg.is_arc) return line_leg<D>(from, to, leg.margin, leg.feed);
  const auto at = [&](std::size_t axis) {
    return static_cast<std::size_t>(std::find(axes.begin(), axes.end(), axis) - axes.begin());
  };
  return arc_leg<D>(from, to, at(leg.first), at(leg.second), projected<D>(leg.center, axes), leg.turn, leg.margin,
                    leg.feed);
}

/// In so many coordinates.
template <std::size_t D>
class InAxes {
 public:
  InAxes(const Corridor<3>& corridor, std::vector<std::size_t> axes)
      : axes_(std::move(axes)), still_(corridor.legs.front().from) {
    for (const CorridorLeg<3>& leg : corridor.legs) full_.legs.push_back(projected<D>(leg, axes_));
    full_.limits = {projected<D>(corridor.limits.velocity, axes_), projected<D>(corridor.limits.acceleration, axes_),
                    projected<D>(corridor.limits.jerk, axes_)};
    full_.begin = corridor.begin;
    full_.end = corridor.end;
  }

  std::optional<TimeSpline<3>> motion(const CorridorEnds<3>& ends3, double interval) const {
    CorridorEnds<D> ends{ends3.begin, ends3.end, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      ends.points_at_begin[k] = projected<D>(ends3.points_at_begin[k], axes_);
      ends.points_at_end[k] = projected<D>(ends3.points_at_end[k], axes_);
    }
    std::vector<double> shares(full_.legs.size(), planned_share);
    for (int k = 0; k < most_plans; ++k) {
      Corridor<D> planned = full_;
      for (std::size_t i = 0; i < shares.size(); ++i) planned.legs[i].margin *= shares[i];
      const std::optional<TimeSpline<D>> found = least_time(planned, start_motion(planned, interval, ends));
      if (!found) return std::nullopt;
      const std::vector<double> reached = shares_of_margins(full_, *found);
      if (*std::max_element(reached.begin(), reached.end()) <= 1) return with_all(*found);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        if (reached[i] > 1) shares[i] *= less_than_reached / reached[i];
      }
    }
    return std::nullopt;
  }

 private:
  TimeSpline<3> with_all(const TimeSpline<D>& found) const {
    TimeSpline<3> motion{{}, found.passes, found.interval};
    motion.points.assign(found.points.size(), still_);
    for (std::size_t k = 0; k < found.points.size(); ++k) {
      for (std::size_t i = 0; i < D; ++i) motion.points[k][axes_[i]] = found.points[k][i];
    }
    return motion;
  }

  std::vector<std::size_t> axes_;
  Vector<3> still_;  // all other coordinates
  Corridor<D> full_;
};

}  // namespace

std::optional<TimeSpline<3>> plan_in(const Corridor<3>& corridor, const CorridorEnds<3>& ends, double interval) {
  std::vector<std::size_t> axes = moving_axes(corridor, ends);
  if (axes.size() == 2) return InAxes<2>(corridor, std::move(axes)).motion(ends, interval);
  return InAxes<3>(corridor, std::move(axes)).motion(ends, interval);
}

}  // namespace leadscrew::toolpath
