#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/line.hpp>

namespace leadscrew::surfaces {

namespace {

/// With the greatest that Surface::jet takes as before the end.
Range span_in(const std::vector<double>& breaks, double parameter) {
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, parameter);
  const double low = *(above - 1), high = *above;
  return {low, above == breaks.end() - 1 ? high : std::nextafter(high, low)};
}

/// What lies farther out than rounding is left as it is.
double inside_of(const Range& range, double parameter) {
  const double least = 1e-9 * (range.to - range.from), inside = std::clamp(parameter, range.from, range.to);
  return std::abs(inside - parameter) <= least ? inside : parameter;
}

}  // namespace

LinePlace line_place(Direction along, double place, double direction, const numeric::Jet<3>& across) {
  const numeric::Jet<3> run{place, direction, 0, 0};
  const numeric::Jet<3> by{across.value, direction * across.first, across.second, direction * across.third};
  return along == Direction::u ? LinePlace{run, by} : LinePlace{by, run};
}

LinePlace Line::at(double distance) const {
  AcrossFunction::Memo none;
  return at_near(distance, none);
}

LinePlace Line::at_near(double distance, AcrossFunction::Memo& memo) const {
  const double sign = is_forward() ? 1 : -1;
  const double place = std::clamp(from + sign * distance, std::min(from, to), std::max(from, to));
  return line_place(along, place, sign, function == nullptr ? numeric::Jet<3>(across) : function->at_near(place, memo));
}

std::vector<double> Line::breaks(const Surface& surface) const {
  std::vector<double> places = {0, length()};
  const double low = std::min(from, to), high = std::max(from, to);
  const auto add = [&](double place) {
    if (place > low && place < high) places.push_back(std::abs(place - from));
  };
  for (const double place : surface.breaks(along)) add(place);
  if (function != nullptr) {
    for (const double place : function->breaks(low, high)) add(place);
  }
  std::sort(places.begin(), places.end());
  const double least = 1e-12 * length();
  const auto last = std::unique(places.begin(), places.end(), [&](double a, double b) { return b - a <= least; });
  places.erase(last, places.end());
  places.back() = length();
  return places;
}

LinePlace Span::inside(LinePlace place) const {
  place.u.value = inside_of(u, place.u.value);
  place.v.value = inside_of(v, place.v.value);
  return place;
}

Span span_of(const Surface& surface, const LinePlace& place) {
  return {span_in(surface.breaks(Direction::u), place.u.value), span_in(surface.breaks(Direction::v), place.v.value)};
}

}  // namespace leadscrew::surfaces
