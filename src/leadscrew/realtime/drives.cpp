#include <algorithm>
#include <cmath>
#include <leadscrew/realtime/drives.hpp>

namespace leadscrew::realtime {

Drives::Drives(const machine::Machine& machine, base::Period period, const base::AxisVector& position)
    : period_(period.seconds()), axes_(machine.axis_set()), position_(position) {
  const double T = period_;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    machine::AxisLimits& limits = limits_[base::index(axis)] = machine.limits(axis);
    limits.velocity *= T;
    limits.acceleration *= T * T;
    limits.jerk *= T * T * T;
  }
}

void Drives::move(const base::AxisVector& step) {
  rests_ = true;
  for (std::size_t i = 0; i < step.size(); ++i) {
    change_[i] = step[i] - step_[i];
    step_[i] = step[i];
    position_[i] += step[i];
    if (step_[i] != 0 || change_[i] != 0) rests_ = false;
  }
}

void Drives::follow(const base::AxisVector& word) {
  tick_ = 0;
  rests_ = true;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const double step = word[i] - position_[i];
    change_[i] = step - step_[i];
    step_[i] = step;
    if (step_[i] != 0 || change_[i] != 0) rests_ = false;
  }
  position_ = word;
}

/// With d the step and c its change: c falls to 0 in M periods, c(n) = c(1 − n/M), its third difference is c/M. Then d
/// falls by d(1 − u)²(1 + 2u), u = n/N, whose differences are below 1.5 d/N and 6 d/N².
void Drives::plan_to_brake() {
  double release = 1, fall = 1;
  for (const base::Axis axis : base::all_axes) {
    if (axes_.contains(axis))
      release = std::max(release, std::abs(change_[base::index(axis)]) / limits_[base::index(axis)].jerk);
  }
  release = std::ceil(release);
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    const std::size_t i = base::index(axis);
    way_[i] = step_[i] + change_[i] * (release - 1) / 2;
    const double step = std::abs(way_[i]);
    fall = std::max({fall, 1.5 * step / limits_[i].acceleration, std::sqrt(6 * step / limits_[i].jerk)});
  }
  release_ = static_cast<std::int64_t>(release);
  fall_ = static_cast<std::int64_t>(std::ceil(fall));
  from_ = change_;
}

void Drives::brake() {
  if (rests_) return;
  if (tick_ == 0) plan_to_brake();
  ++tick_;
  base::AxisVector step{};
  const double n = static_cast<double>(tick_), M = static_cast<double>(release_), N = static_cast<double>(fall_);
  const double u = std::min(1.0, (n - M) / N), share = (1 - u) * (1 - u) * (1 + 2 * u);
  for (std::size_t i = 0; i < step.size(); ++i) {
    step[i] = tick_ <= release_ ? step_[i] + from_[i] * (1 - n / M) : way_[i] * share;
  }
  move(step);
}

/// Way u³(10 − 15u + 6u²), whose derivatives are at most 1.875, 10/√3 and 60.
void Drives::plan_to_approach(const base::AxisVector& target, double feed) {
  double periods = 1, linear = 0, rotary = 0;  // squares of the ways
  from_ = position_;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    way_[i] = target[i] - from_[i];
    (base::is_rotary(axis) ? rotary : linear) += way_[i] * way_[i];
    if (!axes_.contains(axis)) continue;
    const double way = std::abs(way_[i]);
    periods = std::max({periods, 1.875 * way / limits_[i].velocity, std::sqrt(5.7736 * way / limits_[i].acceleration),
                        std::cbrt(60 * way / limits_[i].jerk)});
  }
  periods = std::max(periods, 1.875 * std::sqrt(linear > 0 ? linear : rotary) / (feed * period_));
  fall_ = static_cast<std::int64_t>(std::ceil(periods));
}

bool Drives::approach(const base::AxisVector& target, double feed) {
  if (called_off_) {
    brake();
    called_off_ = !rests_;
    return rests_;
  }
  if (tick_ == 0) plan_to_approach(target, feed);
  if (position_ == target && rests_) return true;
  const double u = static_cast<double>(std::min(++tick_, fall_)) / static_cast<double>(fall_);
  const double share = u * u * u * (10 + u * (6 * u - 15));
  base::AxisVector next = target;
  if (tick_ < fall_) {
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = from_[i] + way_[i] * share;
  }
  const std::int64_t tick = tick_;
  follow(next);
  tick_ = rests_ && position_ == target ? 0 : tick;
  return rests_ && position_ == target;
}

/// In its first half braking is over before the target: from the middle on, at 1.875 way/N, it takes 0.457 of the way
/// where acceleration binds, 0.406 where jerk does, of the half that is left.
void Drives::call_off() {
  if (called_off_ || tick_ == 0 || 2 * tick_ >= fall_) return;
  called_off_ = true;
  tick_ = 0;
}

}  // namespace leadscrew::realtime
