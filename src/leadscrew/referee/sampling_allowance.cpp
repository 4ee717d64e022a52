#include <leadscrew/referee/sampling_allowance.hpp>

namespace leadscrew::referee {

namespace {

/// Of X, Y and Z.
double distance_of_tips(const base::AxisVector& a, const base::AxisVector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

/// What each rotary axis moves the tip by is added, as if all pulled the same way.
double TipAllowance::of(const base::AxisVector& before, const base::AxisVector& last, const base::AxisVector& word,
                        const Metric& space, const std::array<double, 3>& tool) const {
  // Of how much farther than in the middle a way that turns evenly is off elsewhere.
  constexpr double beside_middle = 1.25;
  constexpr double least_turn = 1e-6;  // degrees, whose effect is no rounding
  const base::AxisVector off_axes =
      metric_.position(departures(metric_, period_, metric_.point(before), metric_.point(last), metric_.point(word)));
  base::AxisVector middle{}, between{};
  const base::AxisVector from = pose_.tip_of(last, tool), to = pose_.tip_of(word, tool);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    middle[i] = (last[i] + word[i]) / 2;
    between[i] = (from[i] + to[i]) / 2;
  }
  const base::AxisVector tip = pose_.tip_of(middle, tool);
  double off = std::hypot(off_axes[0], off_axes[1], off_axes[2]) + beside_middle * distance_of_tips(tip, between);
  double turned = 0;
  for (std::size_t i = 3; i < middle.size(); ++i) {
    if (!(off_axes[i] > 0)) continue;
    base::AxisVector aside = middle;
    aside[i] += std::max(off_axes[i], least_turn);
    off += distance_of_tips(pose_.tip_of(aside, tool), tip);
    turned = std::hypot(turned, off_axes[i] * space.per_degree());
  }
  return std::hypot(off, turned);
}

}  // namespace leadscrew::referee
