#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <leadscrew/referee/feed_check.hpp>
#include <leadscrew/referee/tuning.hpp>

namespace leadscrew::referee {

namespace {

/// (θ/2)/sin(θ/2), by its series where that is exact to rounding.
double arc_over_chord(double turn) {
  if (turn > tuning::travel::widest_turn) return 1;
  const double half = turn / 2;
  if (turn < 1e-2) return 1 + half * half / 6 * (1 + half * half * 7 / 60);
  return half / std::sin(half);
}

}  // namespace

double FeedCheck::travel(const base::AxisVector& position, const Passage& passage) const {
  double in_plane = 0, across = 0;
  for (const base::Axis axis : axes_of(passage.feed.axes)) {
    const double step = position[base::index(axis)] - last_[base::index(axis)];
    const bool of_plane = passage.arc != nullptr &&
                          (axis == metric_.axis(passage.arc->first) || axis == metric_.axis(passage.arc->second));
    (of_plane ? in_plane : across) += step * step;
  }
  if (passage.arc == nullptr) return passage.stretch * std::sqrt(across);
  const double longer = arc_over_chord(passage.turn);
  return std::sqrt(in_plane * longer * longer + across);
}

void FeedCheck::observe(const base::AxisVector& position, const Passage& passage, double t, ViolationLog& log) {
  const double largest_before = largest_;
  for (const double coordinate : position) largest_ = std::max(largest_, std::abs(coordinate));
  if (largest_ > largest_before || first_) rounding_ = rounding_of(largest_);
  if (!first_ && passage.feed.value < std::numeric_limits<double>::infinity()) {
    const double length = std::max(0.0, travel(position, passage) - rounding_);
    if (length > 0) {
      const double speed = length / period_;
      const double ratio = speed / passage.feed.value;
      greatest_ratio_ = std::max(greatest_ratio_, ratio);
      if (ratio > objectionable_ratio) log.add(t, passage.line, "feed", speed, passage.feed.value);
    }
  }
  first_ = false;
  last_ = position;
}

}  // namespace leadscrew::referee
