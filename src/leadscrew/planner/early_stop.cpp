#include <algorithm>
#include <leadscrew/planner/early_stop.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <span>
#include <utility>
#include <vector>

namespace leadscrew::planner {

namespace {

using namespace tuning::early_stop;

constexpr double none_near = -1, none = -2;  // in the place of a stop's duration

class EarlyStop {
 public:
  EarlyStop(Window& window, std::size_t after, const Section& section, const constraints::Constraints& constraints,
            double feed_factor)
      : window_(window), after_(after), section_(section), constraints_(constraints), feed_factor_(feed_factor) {
    window.stops.resize(window.segments.size());
    places_.reserve(window.segments.size());
    for (const Segment& segment : window.segments) places_.push_back(segment.s0.value());
  }

  Tail find() {
    const PathState here = state(after_);
    if (!(here.speed > 0)) return rest_of_window();
    const double near = std::min(here.s + greatest_wanted(here), window_.end);
    if (const std::size_t known = first_known(); known < count() && end_of(cubic(known)) <= near) return along(known);
    if (const std::size_t found = search(near, none_near); found < count()) return along(found);
    if (near == window_.end) return rest_of_window();
    if (std::optional<Tail> tail = brake_soon()) return *std::move(tail);
    const std::size_t found = search(window_.end, none);
    return found < count() ? along(found) : rest_of_window();
  }

 private:
  std::size_t count() const { return window_.segments.size(); }
  PathState state(std::size_t k) const { return evaluate(window_.segments[k], 0); }
  double time_at(std::size_t k) const { return (window_.segments[k].begin - window_.segments[after_].begin).value(); }

  static double end_of(const Segment& stop) { return evaluate(stop, stop.duration.value()).s; }

  /// What a stop takes along the tangent from the greatest speed that is programmed, units: no tail need be shorter.
  double greatest_wanted(const PathState& here) const {
    const geometry::PointJet jet = section_.jets(here.s, Side::right);
    const double speed =
        constraints_.greatest_speed({jet, feed_factor_ * section_.greatest_speed(here.s, Side::right, jet)});
    return speed * stop_time(speed, tangent_limits(jet, constraints_)) / 2;
  }

  /// Where feed has just been lowered, motion is still faster: it must not become more so.
  double factor_from(const PathState& from) const {
    constexpr double rounding = 1 + 1e-9;
    const geometry::PointJet jet = section_.jets(from.s, Side::right);
    return std::max(feed_factor_, rounding * from.speed / section_.greatest_speed(from.s, Side::right, jet));
  }

  /// The stop that is known from there.
  Segment cubic(std::size_t k) const {
    Segment stop = stop_within(state(k), window_.stops[k]);
    stop.begin = window_.segments[k].begin;
    return stop;
  }
  /// The earliest segment from which a stop is known; count() if there is none.
  std::size_t first_known() const {
    const auto begin = window_.stops.begin() + static_cast<std::ptrdiff_t>(after_);
    const auto known = std::find_if(begin, window_.stops.end(), [](double duration) { return duration > 0; });
    return static_cast<std::size_t>(known - window_.stops.begin());
  }

  /// Looks for stops from here and from a few later places. The segment from which the earliest begins that is known
  /// and ends no farther than that; count() if there is none. Where none is found, `mark` tells not to look again.
  std::size_t search(double farthest, double mark) {
    double wait = 0;
    for (std::size_t k = after_; k < count() && places_[k] < farthest; ++k) {
      double& stop = window_.stops[k];
      if (stop > 0 && end_of(cubic(k)) <= farthest) return k;
      if (time_at(k) < wait) continue;
      wait = wait > 0 ? wait * later : first_wait;
      const PathState from = state(k);
      if (stop != 0 && stop <= mark) continue;
      if (!(from.speed > 0) || stop > 0) continue;
      const double duration = stop_duration(k, from, farthest);
      stop = duration > 0 ? duration : mark;
      if (duration > 0) return k;
    }
    return count();
  }

  /// Of a stop that ends no farther than that, s; none where none is found.
  double stop_duration(std::size_t k, const PathState& from, double farthest) const {
    const double feed_factor = factor_from(from);
    double t = shortest_stop(from, tangent_limits(section_.jets(from.s, Side::right), constraints_));
    for (int attempt = 0; attempt < attempts; ++attempt, t *= longer) {
      const Segment stop = stop_within(from, t);
      if (end_of(stop) > farthest || !(3 * from.speed + from.acceleration * t >= 0)) break;
      if (is_seen_to_fail(stop, section_, constraints_, feed_factor)) continue;
      if (keeps_limits(k, stop, feed_factor)) return t;
    }
    return none;
  }

  /// Proven between the window's knots as closely as the window is.
  bool keeps_limits(std::size_t k, const Segment& stop, double feed_factor) const {
    for (const Segment& part : cut_at(stop, std::span(places_).subspan(k + 1))) {
      const auto next = std::upper_bound(places_.begin(), places_.end(), part.s0.value());
      const bool sparse = window_.intervals[static_cast<std::size_t>(next - places_.begin()) - 1] + sparse_knots >
                          window_.profile.intervals();
      const int looks = sparse ? close_looks : usual_looks;
      if (!(greatest_ratios(part, section_, constraints_, feed_factor, looks).worst() <= 1)) return false;
    }
    return true;
  }

  /// From here, or where limits leave too little room for it, from a little later.
  std::optional<Tail> brake_soon() const {
    std::size_t k = after_;
    for (double wait = 0; wait <= last_brake; wait += first_wait) {
      while (k < count() && time_at(k) < wait) ++k;
      if (k == count()) break;
      std::optional<Tail> tail = brake(window_, k, window_.end, section_, constraints_, factor_from(state(k)));
      if (!tail) continue;
      const auto from = window_.segments.begin();
      tail->segments.insert(tail->segments.begin(), from + static_cast<std::ptrdiff_t>(after_),
                            from + static_cast<std::ptrdiff_t>(k));
      return tail;
    }
    return std::nullopt;
  }

  /// The window's motion up to segment k, then its stop.
  Tail along(std::size_t k) const {
    const auto from = window_.segments.begin();
    Tail tail{{from + static_cast<std::ptrdiff_t>(after_), from + static_cast<std::ptrdiff_t>(k)}, 0};
    tail.segments.push_back(cubic(k));
    tail.end = end_of(tail.segments.back());
    return tail;
  }
  Tail rest_of_window() const {
    return {{window_.segments.begin() + static_cast<std::ptrdiff_t>(after_), window_.segments.end()}, window_.end};
  }

  Window& window_;
  std::size_t after_;
  const Section& section_;
  const constraints::Constraints& constraints_;
  double feed_factor_;
  std::vector<double> places_;  ///< where segments begin
};

}  // namespace

Tail tail_of(Window& window, std::size_t after, const Section& section, const constraints::Constraints& constraints,
             double feed_factor) {
  if (after == window.segments.size()) return {{}, window.end};
  return EarlyStop(window, after, section, constraints, feed_factor).find();
}

}  // namespace leadscrew::planner
