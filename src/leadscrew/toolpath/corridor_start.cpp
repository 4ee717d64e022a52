#include <algorithm>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor_start.hpp>
#include <leadscrew/toolpath/tuning.hpp>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::corridor;

template <std::size_t D>
double least_of(const Vector<D>& a) {
  return *std::min_element(a.begin(), a.end());
}

template <std::size_t D>
class Start {
 public:
  Start(const Corridor<D>& corridor, double interval, const CorridorEnds<D>& ends)
      : corridor_(corridor),
        ends_(ends),
        interval_(interval),
        acceleration_(start_acceleration * least_of(corridor.limits.acceleration)) {
    borders_.push_back(0);
    for (const CorridorLeg<D>& leg : corridor.legs) borders_.push_back(borders_.back() + leg.length);
    begin_ = ends.begin;
    end_ = borders_[borders_.size() - 2] + ends.end;
  }

  TimeSpline<D> make() {
    find_speeds();
    accelerate();
    find_times();
    return walk();
  }

 private:
  struct Sample {
    double s = 0, speed = 0;  // mm, mm/s
    double time = 0;          // s
  };

  /// As fast as knots stay inside.
  double speed_along(const CorridorLeg<D>& leg) const {
    const double speed = std::min(leg.feed, least_of(corridor_.limits.velocity));
    return leg.is_arc ? std::min(speed, std::sqrt(4 * leg.margin * leg.radius) / interval_) : speed;
  }
  double speed_at(std::size_t joint) const {
    const CorridorLeg<D>&before = corridor_.legs[joint], &behind = corridor_.legs[joint + 1];
    const double turn = size(between(before.tangent(before.length), behind.tangent(0)));
    return std::min({speed_along(before), speed_along(behind),
                     start_step * corridor_.margin_at(joint) / (std::max(turn, 1e-9) * interval_)});
  }

  void find_speeds() {
    constexpr int parts = 8;
    for (std::size_t leg = 0; leg < corridor_.legs.size(); ++leg) {
      const double from = std::max(borders_[leg], begin_), to = std::min(borders_[leg + 1], end_);
      const double speed = speed_along(corridor_.legs[leg]);
      for (int k = leg == 0 ? 0 : 1; k < parts; ++k) samples_.push_back({from + (to - from) * k / parts, speed});
      joints_.push_back(samples_.size());
      samples_.push_back({to, leg + 1 < corridor_.legs.size() ? speed_at(leg) : speed});
    }
    joints_.pop_back();
    if (corridor_.begin == CorridorEnd::rest) samples_.front().speed = 0;
    if (corridor_.end == CorridorEnd::rest) samples_.back().speed = 0;
  }

  void accelerate() {
    const auto reached = [&](const Sample& from, const Sample& to) {
      return std::sqrt(from.speed * from.speed + 2 * acceleration_ * std::abs(to.s - from.s));
    };
    for (std::size_t i = 1; i < samples_.size(); ++i)
      samples_[i].speed = std::min(samples_[i].speed, reached(samples_[i - 1], samples_[i]));
    for (std::size_t i = samples_.size() - 1; i-- > 0;)
      samples_[i].speed = std::min(samples_[i].speed, reached(samples_[i + 1], samples_[i]));
  }

  /// Where it is slow at both ends it is faster between.
  void find_times() {
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      const double length = samples_[i].s - samples_[i - 1].s, between = 0.7 * std::sqrt(2 * acceleration_ * length);
      const double twice = std::max(samples_[i].speed + samples_[i - 1].speed, between);
      samples_[i].time = samples_[i - 1].time + (length > 0 ? 2 * length / twice : 0);
    }
  }

  /// s at a time, by constant acceleration from sample to sample, scaled to their distance.
  double place_at(double time) {
    while (next_ + 1 < samples_.size() && samples_[next_].time < time) ++next_;
    const Sample &from = samples_[next_ - 1], &to = samples_[next_];
    const double lasts = to.time - from.time, speeds = from.speed + to.speed;
    const double share = lasts > 0 ? std::clamp((time - from.time) / lasts, 0.0, 1.0) : 1;
    const double moved = speeds > 0 ? share * (2 * from.speed + (to.speed - from.speed) * share) / speeds : share;
    return from.s + (to.s - from.s) * moved;
  }

  /// At rest three control points are the same; the others are a step apart. At the beginning of a motion that goes on,
  /// the middle one of the given three is there at time 0, and so at its end.
  TimeSpline<D> walk() {
    constexpr double fewest = 8;
    const bool from_rest = corridor_.begin == CorridorEnd::rest, to_rest = corridor_.end == CorridorEnd::rest;
    const double total = samples_.back().time, steps = std::max(fewest, std::ceil(total / interval_));
    const double step = total / steps;
    TimeSpline<D> motion;
    if (from_rest) {
      motion.points.assign(3, position(begin_));
    } else {
      motion.points.assign(ends_.points_at_begin.begin(), ends_.points_at_begin.end());
    }
    const double last = steps - (to_rest ? 1 : 2);
    for (double k = from_rest ? 1 : 2; k <= last; ++k) motion.points.push_back(position(place_at(step * k)));
    if (to_rest) {
      motion.points.insert(motion.points.end(), 3, position(end_));
    } else {
      motion.points.insert(motion.points.end(), ends_.points_at_end.begin(), ends_.points_at_end.end());
    }
    // Control point p is where motion is about knot p − 1.
    for (const std::size_t joint : joints_) motion.passes.push_back(samples_[joint].time / step + (from_rest ? 1 : 0));
    motion.interval = least_interval(motion.points);
    return motion;
  }

  Vector<D> position(double s) const {
    const auto behind = std::upper_bound(borders_.begin() + 1, borders_.end() - 1, s);
    const auto leg = static_cast<std::size_t>(behind - borders_.begin()) - 1;
    return corridor_.legs[leg].at(s - borders_[leg]);
  }

  double least_interval(const std::vector<Vector<D>>& c) const {
    double slowest = unlimited, h = 0;
    for (const CorridorLeg<D>& leg : corridor_.legs) slowest = std::min(slowest, leg.feed);
    const CorridorLimits<D>& limits = corridor_.limits;
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      h = std::max(h, size(between(c[k], c[k + 1])) / slowest);
      for (std::size_t i = 0; i < D; ++i) {
        h = std::max(h, std::abs(c[k + 1][i] - c[k][i]) / limits.velocity[i]);
        if (k + 2 == c.size()) continue;
        h = std::max(h, std::sqrt(std::abs(c[k + 2][i] - 2 * c[k + 1][i] + c[k][i]) / limits.acceleration[i]));
        if (k + 3 == c.size()) continue;
        const double third = c[k + 3][i] - 3 * c[k + 2][i] + 3 * c[k + 1][i] - c[k][i];
        h = std::max(h, numeric::cbrt(std::abs(third) / limits.jerk[i]));
      }
    }
    return h;
  }

  const Corridor<D>& corridor_;
  const CorridorEnds<D>& ends_;
  double interval_, acceleration_;
  std::vector<double> borders_;  // s at the ends of legs
  double begin_ = 0, end_ = 0;
  std::vector<Sample> samples_;
  std::vector<std::size_t> joints_;  // samples there
  std::size_t next_ = 1;
};

}  // namespace

template <std::size_t D>
double seconds_by_feed(const Corridor<D>& corridor) {
  double seconds = 0;
  for (const CorridorLeg<D>& leg : corridor.legs)
    seconds += leg.length / std::min(leg.feed, least_of(corridor.limits.velocity));
  return seconds;
}

template <std::size_t D>
double suitable_interval(const Corridor<D>& corridor) {
  double margin = unlimited;
  for (const CorridorLeg<D>& leg : corridor.legs) margin = std::min(margin, leg.margin);
  const auto greatest = [](const Vector<D>& a) { return *std::max_element(a.begin(), a.end()); };
  const CorridorLimits<D>& limits = corridor.limits;
  return std::min(std::max(interval_of_corner * numeric::cbrt(margin / greatest(limits.jerk)),
                           seconds_by_feed(corridor) / many_intervals),
                  std::sqrt(interval_bulge * 32 * margin / greatest(limits.acceleration)));
}

template <std::size_t D>
TimeSpline<D> start_motion(const Corridor<D>& corridor, double interval, const CorridorEnds<D>& ends) {
  return Start<D>(corridor, interval, ends).make();
}

template double seconds_by_feed<3>(const Corridor<3>&);
template double suitable_interval<2>(const Corridor<2>&);
template double suitable_interval<3>(const Corridor<3>&);
template TimeSpline<2> start_motion<2>(const Corridor<2>&, double, const CorridorEnds<2>&);
template TimeSpline<3> start_motion<3>(const Corridor<3>&, double, const CorridorEnds<3>&);

}  // namespace leadscrew::toolpath
