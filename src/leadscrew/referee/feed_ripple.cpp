#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <leadscrew/referee/feed_ripple.hpp>

namespace leadscrew::referee {

namespace {

constexpr double same_feed = 1e-12;  // relative: written with 17 digits, and read back

double norm_of(const std::array<double, 3>& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace

void FeedRipple::observe(const base::AxisVector& position, std::optional<double> planned,
                         const ProgrammedFeed& programmed) {
  if (planned && !greatest_) greatest_ = 0;
  const bool goes_on = planned && std::abs(*planned - feed_) <= same_feed * feed_ && *planned > 0 &&
                       std::isfinite(programmed.value) && programmed.axes == step_.programmed.axes;
  words_of_feed_ = goes_on ? std::min(words_of_feed_ + 1, 4) : 1;
  if (!goes_on) feed_ = planned.value_or(0);
  Step step{.programmed = programmed};
  if (words_of_feed_ > 1) {
    std::size_t i = 0;
    for (const base::Axis axis : axes_of(programmed.axes))
      step.along[i++] = position[base::index(axis)] - position_[base::index(axis)];
    step.length = norm_of(step.along);
  }
  if (words_of_feed_ > 2) step.bend = curvature_of(step_, step);
  note(position);
  if (words_of_feed_ > 3) account(step_, step.bend);
  step_ = step;
  position_ = position;
}

void FeedRipple::note(const base::AxisVector& position) {
  double largest = largest_;
  for (const double coordinate : position) largest = std::max(largest, std::abs(coordinate));
  if (largest == largest_) return;
  largest_ = largest;
  rounding_ = rounding_of(largest);
}

/// Of the circle through the ends of two steps; 0 where one of them is none.
double FeedRipple::curvature_of(const Step& first, const Step& second) {
  const Vector &a = first.along, &b = second.along;
  const Vector across = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double sides = first.length * second.length * norm_of({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
  return sides > 0 ? 2 * norm_of(across) / sides : 0;
}

void FeedRipple::account(const Step& step, double bend_behind) {
  const double x = std::min((step.bend + bend_behind) / 2 * step.length / 2, 1.0);
  const double travel = x > 1e-9 ? step.length * std::asin(x) / x : step.length;
  const double planned = feed_ * period_;
  greatest_ = std::max(*greatest_, (std::abs(travel - planned) - rounding_) / planned);
}

}  // namespace leadscrew::referee
