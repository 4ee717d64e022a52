#include <leadscrew/toolpath/allowance.hpp>

namespace leadscrew::toolpath {

namespace {

constexpr double long_leg = 15;                                             // lengths of a span
constexpr double span_time = 0.005, shortest_span = 0.1, longest_span = 1;  // s, mm
constexpr double span_of_tolerance = 10, longest_of_tolerance = 3;          // mm

}  // namespace

double Allowance::span_length(const Leg& leg) const {
  return std::max(std::clamp(span_time * greatest_speed(leg), shortest_span, longest_span),
                  std::min(span_of_tolerance * tolerance, longest_of_tolerance));
}

bool Allowance::is_long(const Leg& leg) const {
  return length_of(leg) > long_leg * span_length(leg);
}

double greatest_speed(const Leg& leg) {
  const double rate = toolpath::rate(geometry::jets(leg.curve, 0), leg.feed_axes);
  return leg.feed / rate * millimetres_per_length(leg.curve);
}

double length_of(const Leg& leg) {
  return geometry::length(leg.curve) * millimetres_per_length(leg.curve);
}

}  // namespace leadscrew::toolpath
