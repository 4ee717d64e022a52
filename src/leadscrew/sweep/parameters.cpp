#include <array>
#include <leadscrew/sweep/parameters.hpp>

namespace leadscrew::sweep {

namespace {

using Combinations = std::vector<Parameters>;

/// Each of the combinations with each of the values.
template <class Value, class Take>
Combinations times(const Combinations& combinations, const std::vector<Value>& values, Take take) {
  if (values.empty()) return combinations;
  Combinations all;
  for (const Parameters& each : combinations) {
    for (const Value& value : values) {
      all.push_back(each);
      take(all.back(), value);
    }
  }
  return all;
}

double& limit_of(machine::AxisLimits& limits, ChangedLimit::Order order) {
  switch (order) {
    case ChangedLimit::Order::velocity:
      return limits.velocity;
    case ChangedLimit::Order::acceleration:
      return limits.acceleration;
    default:
      return limits.jerk;
  }
}

}  // namespace

std::string name(const ChangedLimit& limit) {
  constexpr std::array<const char*, 3> names = {"velocity ", "acceleration ", "jerk "};
  return names[static_cast<std::size_t>(limit.order)] + std::string(1, base::letter(limit.axis));
}

machine::Machine Parameters::applied_to(machine::Machine machine) const {
  if (period) machine.period = *period;
  for (auto& axis : machine.axes) {
    if (!axis) continue;
    axis->velocity *= velocity;
    axis->acceleration *= acceleration;
    axis->jerk *= jerk;
  }
  if (changed_limit) {
    auto& axis = machine.axes[base::index(changed_limit->axis)];
    if (axis) limit_of(*axis, changed_limit->order) *= changed_limit->factor;
  }
  return machine;
}

std::vector<json::Json::Member> members_of(const Parameters& parameters) {
  const auto period_us = [](base::Period period) { return static_cast<double>(period.nanoseconds) / 1e3; };
  std::vector<json::Json::Member> members = {
      {"tolerance_mm", parameters.tolerance},
      {"override", parameters.override_factor},
      {"period_us", parameters.period ? json::Json(period_us(*parameters.period)) : json::Json()},
      {"velocity", parameters.velocity},
      {"acceleration", parameters.acceleration},
      {"jerk", parameters.jerk}};
  if (parameters.changed_limit) {
    members.emplace_back("changed", name(*parameters.changed_limit));
    members.emplace_back("factor", parameters.changed_limit->factor);
  } else if (parameters.tolerance_factor != 1) {
    members.emplace_back("changed", "tolerance");
    members.emplace_back("factor", parameters.tolerance_factor);
  }
  return members;
}

std::vector<Parameters> Grid::combinations() const {
  Combinations all(1);
  all = times(all, tolerances, [](Parameters& of, double value) { of.tolerance = value; });
  all = times(all, overrides, [](Parameters& of, double value) { of.override_factor = value; });
  all = times(all, periods, [](Parameters& of, base::Period value) { of.period = value; });
  all = times(all, velocities, [](Parameters& of, double value) { of.velocity = value; });
  all = times(all, accelerations, [](Parameters& of, double value) { of.acceleration = value; });
  return times(all, jerks, [](Parameters& of, double value) { of.jerk = value; });
}

}  // namespace leadscrew::sweep
