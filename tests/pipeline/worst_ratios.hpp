#pragma once
// The largest ratio of any limit, from the plan and from the referee.

#include <algorithm>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/referee/referee.hpp>

namespace leadscrew::testing_support {

inline double worst_planned(const constraints::LimitRatios& plan) {
  return plan.greatest();
}

inline double worst_judged(const referee::Verdict& verdict) {
  double worst = 0;
  for (const auto& axis : verdict.axes) {
    worst = std::max({worst, axis.velocity_ratio, axis.acceleration_ratio, axis.jerk_ratio});
  }
  return worst;
}

}  // namespace leadscrew::testing_support
