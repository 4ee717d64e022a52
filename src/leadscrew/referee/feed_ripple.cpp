#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <leadscrew/referee/feed_ripple.hpp>

namespace leadscrew::referee {

namespace {

constexpr double same_feed = 1e-12;  // relative: written with 17 digits, and read back

using Vector = std::array<double, 3>;

Vector step_between(const base::AxisVector& from, const base::AxisVector& to, FeedAxes axes) {
  Vector step{};
  std::size_t i = 0;
  for (const base::Axis axis : axes_of(axes)) step[i++] = to[base::index(axis)] - from[base::index(axis)];
  return step;
}

double length_of(const Vector& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Of the circle through the ends of two steps; 0 where one of them is none.
double curvature_of(const Vector& first, const Vector& second) {
  const Vector across = {first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
                         first[0] * second[1] - first[1] * second[0]};
  const Vector both = {first[0] + second[0], first[1] + second[1], first[2] + second[2]};
  const double sides = length_of(first) * length_of(second) * length_of(both);
  return sides > 0 ? 2 * length_of(across) / sides : 0;
}

}  // namespace

void FeedRipple::observe(const base::AxisVector& position, std::optional<double> planned,
                         const ProgrammedFeed& programmed) {
  std::rotate(steps_.begin(), steps_.begin() + 1, steps_.end());
  steps_.back() = {position, planned, programmed};
  for (const double coordinate : position) largest_ = std::max(largest_, std::abs(coordinate));
  if (planned && !greatest_) greatest_ = 0;
  if (++count_ < 4) return;
  count_ = 4;
  account();
}

/// Of the period between the second and the third word.
void FeedRipple::account() {
  const ProgrammedFeed& programmed = steps_[2].programmed;
  const double feed = steps_[2].planned.value_or(0);
  if (!(feed > 0) || !std::isfinite(programmed.value)) return;
  for (const Step& step : steps_) {
    if (!step.planned || std::abs(*step.planned - feed) > same_feed * feed) return;
  }
  std::array<Vector, 3> between;
  for (std::size_t i = 0; i < between.size(); ++i)
    between[i] = step_between(steps_[i].position, steps_[i + 1].position, programmed.axes);
  const double chord = length_of(between[1]);
  const double curvature = (curvature_of(between[0], between[1]) + curvature_of(between[1], between[2])) / 2;
  const double x = std::min(curvature * chord / 2, 1.0);
  const double travel = x > 1e-9 ? chord * std::asin(x) / x : chord;
  const double departure = std::abs(travel - feed * period_) - rounding_of(largest_);
  greatest_ = std::max(*greatest_, departure / (feed * period_));
}

}  // namespace leadscrew::referee
