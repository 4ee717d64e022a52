#include <algorithm>
#include <leadscrew/planner/early_stop.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <span>

namespace leadscrew::planner {

namespace {

using namespace tuning::early_stop;

constexpr double none = -1;

/// The largest ratio, looked at between these places as closely as a window is between its knots.
double worst_between(const Segment& stop, std::span<const double> places, const Section& section,
                     const constraints::Constraints& constraints, double feed_factor) {
  double worst = 0;
  for (const Segment& part : cut_at(stop, places)) {
    worst = std::max(worst, greatest_ratios(part, section, constraints, feed_factor, close_looks).worst());
    if (worst > 1) break;
  }
  return worst;
}

/// The duration of a stop from there, s; none where none is found that is over before `longest`. places: where
/// knots lie ahead.
double stop_duration(const PathState& from, std::span<const double> places, double distance_left, double longest,
                     const Section& section, const constraints::Constraints& constraints, double feed_factor) {
  const geometry::PointJet jet = section.jets(from.s, Side::right);
  const machine::Derivatives limits = tangent_limits(jet, constraints);
  // Where feed has just been lowered, motion is still faster: it must not become more so.
  constexpr double rounding = 1 + 1e-9;
  feed_factor = std::max(feed_factor, rounding * from.speed / section.greatest_speed(from.s, Side::right, jet));
  double t = shortest_stop(from, limits);
  for (int attempt = 0; attempt < attempts; ++attempt, t *= longer) {
    const Segment stop = stop_within(from, t);
    if (t >= longest || evaluate(stop, t).s - from.s > distance_left || !(3 * from.speed + from.acceleration * t >= 0))
      break;
    if (greatest_ratios(stop, section, constraints, feed_factor, first_looks).worst() > 1) continue;
    if (worst_between(stop, places, section, constraints, feed_factor) <= 1) return t;
  }
  return none;
}

/// The earliest of these segments from which a stop is known; their number if there is none.
std::size_t first_known(std::span<const double> stops) {
  const auto known = std::find_if(stops.begin(), stops.end(), [](double duration) { return duration > 0; });
  return static_cast<std::size_t>(known - stops.begin());
}

}  // namespace

Tail tail_of(Window& window, std::size_t after, const Section& section, const constraints::Constraints& constraints,
             double feed_factor) {
  const std::span<const Segment> segments(window.segments.begin() + static_cast<std::ptrdiff_t>(after),
                                          window.segments.end());
  Tail tail{{segments.begin(), segments.end()}, window.end};
  if (segments.empty()) return tail;
  window.stops.resize(window.segments.size());
  const std::span<double> stops(window.stops.begin() + static_cast<std::ptrdiff_t>(after), window.stops.end());
  const auto time_at = [&](std::size_t k) { return (segments[k].begin - segments[0].begin).value(); };
  const double duration = time_at(segments.size() - 1) + segments.back().duration.value();
  std::vector<double> places;
  for (const Segment& segment : segments) places.push_back(segment.s0.value());
  std::size_t best = first_known(stops);
  double wait = 0;
  for (std::size_t k = 0; k < best; ++k) {
    if (time_at(k) < wait) continue;
    wait = wait > 0 ? wait * later : first_wait;
    const PathState from = evaluate(segments[k], 0);
    if (stops[k] < 0 || !(from.speed > 0)) continue;
    stops[k] = stop_duration(from, std::span(places).subspan(k + 1), window.end - from.s, duration - time_at(k),
                             section, constraints, feed_factor);
    if (stops[k] > 0) best = k;
  }
  if (best == segments.size()) return tail;
  Segment stop = stop_within(evaluate(segments[best], 0), stops[best]);
  stop.begin = segments[best].begin;
  tail.segments.resize(best);
  tail.segments.push_back(stop);
  tail.end = evaluate(stop, stops[best]).s;
  return tail;
}

}  // namespace leadscrew::planner
