#include <cmath>
#include <leadscrew/toolpath/leg.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::spans;

double tolerance_of(const Leg& leg) {
  return is_long(leg) ? leg.allowance.tolerance : leg.allowance.fitted();
}

}  // namespace

double millimetres_per_length(const geometry::Curve& curve, const ToleranceSpace& space) {
  if (std::holds_alternative<geometry::Nurbs>(curve)) return 1;
  return norm(space.derivative(geometry::jets(curve, 0), &numeric::Jet<>::first));
}

double greatest_speed(const Leg& leg) {
  const double rate = toolpath::rate(geometry::jets(leg.curve, 0), leg.feed_axes);
  return leg.feed / rate * millimetres_per_length(leg.curve, leg.space);
}

double length_of(const Leg& leg) {
  return geometry::length(leg.curve) * millimetres_per_length(leg.curve, leg.space);
}

double span_length(const Leg& leg) {
  return std::max(std::clamp(span_time * greatest_speed(leg), shortest_span, longest_span),
                  std::min(span_of_tolerance * leg.allowance.tolerance, longest_of_tolerance));
}

bool is_long(const Leg& leg) {
  return length_of(leg) > long_leg * span_length(leg);
}

bool may_be_fitted(const Leg& leg) {
  return leg.allowance.cam_tolerance >= least_tolerance || is_long(leg);
}

double sagitta(const Leg& leg) {
  return tuning::spans::arc_sagitta * tolerance_of(leg);
}

double spent_by(const Leg& leg) {
  return leg.spent + (is_line(leg.curve) ? 0 : sagitta(leg));
}

double margin_about(const Leg& leg) {
  return margin_about(leg, kept_share);
}

double margin_about(const Leg& leg, double share) {
  return std::min(share * tolerance_of(leg), share * leg.allowance.tolerance - leg.kept) - spent_by(leg);
}

double margin_of_words(const Leg& leg) {
  return kept_share * leg.allowance.tolerance - spent_by(leg);
}

double margin_beside(double tolerance, double spent) {
  return kept_share * tolerance - std::min(spent, most_spent * tolerance);
}

bool costs_time(const Leg& before, const Leg& behind, double tolerance) {
  const auto feed_share = [](const Leg& leg) {
    return rate(geometry::jets(leg.curve, 0), leg.feed_axes) / millimetres_per_length(leg.curve, leg.space);
  };
  const double seconds_per_mm = std::abs(1 / before.feed - 1 / behind.feed);
  return tolerance * std::abs(feed_share(before) - feed_share(behind)) * seconds_per_mm > tuning::allowed_time;
}

double chord_end(const geometry::Curve& curve, double s, double to, double sagitta, const ToleranceSpace& space) {
  constexpr int most_halvings = 20;
  constexpr double fewest_chords = 4, nearly_all = 0.75;
  const auto longest_at = [&](double place) {
    const double bend = norm(space.derivative(geometry::jets(curve, place), &numeric::Jet<>::second));
    return std::sqrt(8 * sagitta / std::max(bend, 1e-12));
  };
  double step = std::min(longest_at(s), geometry::length(curve) / fewest_chords);
  // Looked at inside too: a bulge need not show at the ends.
  const auto is_too_long = [&] {
    if (geometry::borders(curve, s, std::min(s + step, to)) > 1) return true;
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      if (longest_at(std::min(s + share * step, to)) < nearly_all * step) return true;
    }
    return false;
  };
  // A part as short as that is within the sagitta of its chord, whatever its shape.
  const double shortest = sagitta / millimetres_per_length(curve, space);
  for (int k = 0; k < most_halvings && step > shortest && is_too_long(); ++k) step /= 2;
  step = std::max(step, shortest);
  return s + step < to && s + step > s ? s + step : to;
}

bool goes_on(const geometry::Curve& first, const geometry::Curve& second, const ToleranceSpace& space) {
  constexpr double same_direction = 1e-9;
  const geometry::PointJet a = geometry::jets(first, geometry::length(first)), b = geometry::jets(second, 0);
  const double ra = norm(space.derivative(a, &numeric::Jet<>::first));
  const double rb = norm(space.derivative(b, &numeric::Jet<>::first));
  for (std::size_t i = 0; i < a.size(); ++i) {
    // Where a curve ends in a cusp they are no numbers.
    if (!(std::abs(a[i].first / ra - b[i].first / rb) <= same_direction)) return false;
    if (!(std::abs(a[i].second / (ra * ra) - b[i].second / (rb * rb)) <= same_direction)) return false;
  }
  return true;
}

}  // namespace leadscrew::toolpath
