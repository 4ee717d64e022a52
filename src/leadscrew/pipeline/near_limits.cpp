#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/pipeline/near_limits.hpp>
#include <utility>

namespace leadscrew::pipeline {

namespace {

/// A limit is at work where motion comes so near to it, as a ratio.
constexpr double at_work_from = 0.97;

using Limits = std::array<std::pair<double, Cause>, 4>;

/// In the order in which the first at work counts.
Limits in_order(const NearLimits& limits) {
  return {{{limits.acceleration.value, {Cause::Kind::acceleration, limits.acceleration.axis}},
           {limits.jerk.value, {Cause::Kind::jerk, limits.jerk.axis}},
           {limits.velocity.value, {Cause::Kind::velocity, limits.velocity.axis}},
           {limits.chord, {Cause::Kind::chord_error, base::Axis::X}}}};
}

}  // namespace

std::string name(const Cause& cause) {
  const std::string axis = std::string(" ") + base::letter(cause.axis);
  switch (cause.kind) {
    case Cause::Kind::velocity:
      return "velocity" + axis;
    case Cause::Kind::acceleration:
      return "acceleration" + axis;
    case Cause::Kind::jerk:
      return "jerk" + axis;
    case Cause::Kind::chord_error:
      return "chord";
    case Cause::Kind::stop:
      return "stop";
    case Cause::Kind::dwell:
      return "dwell";
  }
  return "";
}

std::optional<Cause> NearLimits::at_work() const {
  for (const auto& [ratio, cause] : in_order(*this)) {
    if (ratio >= at_work_from) return cause;
  }
  return std::nullopt;
}

Cause NearLimits::nearest() const {
  if (const auto working = at_work()) return *working;
  const Limits limits = in_order(*this);
  return std::max_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

NearLimits near_limits(const machine::Machine& machine, const base::AxisVector& velocity,
                       const base::AxisVector& acceleration, const base::AxisVector& jerk) {
  NearLimits near;
  double bend = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const std::size_t i = base::index(axis);
    near.velocity.raise(std::abs(velocity[i]) / limits.velocity, axis);
    near.acceleration.raise(std::abs(acceleration[i]) / limits.acceleration, axis);
    near.jerk.raise(std::abs(jerk[i]) / limits.jerk, axis);
    if (!base::is_rotary(axis)) bend += acceleration[i] * acceleration[i];
  }
  const double period = machine.period.seconds();
  near.chord = std::sqrt(bend) * period * period / 8 / machine.chord_error;
  return near;
}

Hold hold_of(const NearLimits& limits, double feed, double feed_asked) {
  if (const auto cause = limits.at_work()) {
    switch (cause->kind) {
      case Cause::Kind::velocity:
        return {Hold::Kind::velocity, cause->axis};
      case Cause::Kind::acceleration:
        return {Hold::Kind::acceleration, cause->axis};
      case Cause::Kind::jerk:
        return {Hold::Kind::jerk, cause->axis};
      default:
        return {Hold::Kind::chord_error, base::Axis::X};
    }
  }
  return {feed >= at_work_from * feed_asked ? Hold::Kind::feed : Hold::Kind::what_comes, base::Axis::X};
}

}  // namespace leadscrew::pipeline
