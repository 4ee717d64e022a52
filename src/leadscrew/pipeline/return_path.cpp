#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/pipeline/return_path.hpp>

namespace leadscrew::pipeline {

namespace {

using Places = std::vector<base::PathPlace>;

constexpr double least_step = 1.01, most_step = 1e6;  // from one attempt to the next, longer one
constexpr std::size_t least_periods = 4, fewest_periods = 100;
constexpr std::size_t rests = 3;    // periods between two hops, so that no difference reaches across
constexpr double shortest = 1e-10;  // hop, of the path

/// From one place of the stretch back to another.
struct Hop {
  double from = 0, to = 0;  ///< from > to
};

Places places_along(const PathStretch& stretch, const Hop& hop, std::size_t periods) {
  Places places;
  places.reserve(periods);
  for (std::size_t n = 1; n < periods; ++n) {
    const double u = static_cast<double>(n) / static_cast<double>(periods);
    places.push_back(stretch.at(hop.from - (hop.from - hop.to) * (u * u * u * (10 + u * (6 * u - 15)))));
  }
  places.push_back(stretch.at(hop.to));
  return places;
}

/// How many times longer it must take at least, by differences of the first, second and third order, with rest before
/// and behind.
double stretch_by_limits(const Places& places, const base::AxisVector& begin, const machine::Machine& machine) {
  const double T = machine.period.seconds();
  const auto size = static_cast<std::ptrdiff_t>(places.size());
  const auto at = [&](std::ptrdiff_t n, std::size_t axis) {
    return n < 0 ? begin[axis] : places[static_cast<std::size_t>(std::min(n, size - 1))].position[axis];
  };
  double factor = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const std::size_t i = base::index(axis);
    double velocity = 0, acceleration = 0, jerk = 0;
    for (std::ptrdiff_t n = 0; n < size + 2; ++n) {
      const double a = at(n, i), b = at(n - 1, i), c = at(n - 2, i), d = at(n - 3, i);
      velocity = std::max(velocity, std::abs(a - b));
      acceleration = std::max(acceleration, std::abs(a - 2 * b + c));
      jerk = std::max(jerk, std::abs(a - 3 * b + 3 * c - d));
    }
    factor =
        std::max({factor, velocity / (limits.velocity * T), std::sqrt(acceleration / (limits.acceleration * T * T)),
                  numeric::cbrt(jerk / (limits.jerk * T * T * T))});
  }
  return factor;
}

double stretch_by_feed(const Places& places, const PathStretch& stretch, double from, double T) {
  double factor = 0, last = from;
  for (const base::PathPlace& place : places) {
    const double speed = std::min(stretch.greatest_speed(last), stretch.greatest_speed(place.path_length));
    factor = std::max(factor, (last - place.path_length) / (speed * T));
    last = place.path_length;
  }
  return factor;
}

/// Nothing if it takes more periods.
std::optional<Places> places_of(const PathStretch& stretch, const Hop& hop, const machine::Machine& machine,
                                std::size_t most_periods) {
  const base::AxisVector begin = stretch.at(hop.from).position;
  for (std::size_t periods = least_periods; periods <= most_periods;) {
    Places places = places_along(stretch, hop, periods);
    const double factor = std::max(stretch_by_feed(places, stretch, hop.from, machine.period.seconds()),
                                   stretch_by_limits(places, begin, machine));
    if (factor <= 1) return places;
    if (!std::isfinite(factor)) break;
    periods =
        static_cast<std::size_t>(std::ceil(static_cast<double>(periods) * std::clamp(factor, least_step, most_step)));
  }
  return std::nullopt;
}

}  // namespace

void PathStretch::push(const toolpath::Element& element) {
  const auto* piece = std::get_if<toolpath::Piece>(&element);
  if (piece == nullptr || is_whole()) return;
  const double begin = length_;
  length_ += piece->axes().length();
  if (length_ >= from_ - rounded) parts_.push_back({*piece, begin});
}

const PathStretch::Part& PathStretch::part_at(double s) const {
  const auto behind =
      std::upper_bound(parts_.begin(), parts_.end(), s, [](double at, const Part& part) { return at < part.begin; });
  return behind == parts_.begin() ? *behind : *std::prev(behind);
}

base::PathPlace PathStretch::at(double s) const {
  const Part& part = part_at(s);
  return {part.piece.axes().position(s - part.begin), s};
}

double PathStretch::greatest_speed(double s) const {
  const Part& part = part_at(s);
  const double on_piece = std::clamp(s - part.begin, 0.0, part.piece.axes().length());
  return part.piece.greatest_speed(on_piece, part.piece.axes().jets(on_piece));
}

std::optional<Places> plan_return(const PathStretch& stretch, const machine::Machine& machine, double longest_hop) {
  const std::size_t most_periods =
      std::max(fewest_periods, static_cast<std::size_t>(longest_hop / machine.period.seconds()));
  Places return_path;
  std::vector<Hop> hops;  // the next one last
  if (stretch.from() < stretch.to()) hops.push_back({stretch.to(), stretch.from()});
  while (!hops.empty()) {
    const Hop hop = hops.back();
    hops.pop_back();
    if (const auto places = places_of(stretch, hop, machine, most_periods)) {
      if (!return_path.empty()) return_path.insert(return_path.end(), rests, return_path.back());
      return_path.insert(return_path.end(), places->begin(), places->end());
      continue;
    }
    const double middle = (hop.from + hop.to) / 2;
    if (!(hop.from - hop.to > shortest) || !(hop.to < middle && middle < hop.from)) return std::nullopt;
    hops.push_back({middle, hop.to});
    hops.push_back({hop.from, middle});
  }
  return return_path;
}

}  // namespace leadscrew::pipeline
