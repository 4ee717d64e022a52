#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/sweep/bar_chart.hpp>
#include <leadscrew/sweep/sensitivity.hpp>
#include <set>

namespace leadscrew::sweep {

namespace {

std::string text_at(const json::Json& row, std::string_view key) {
  const json::Json* const value = row.find(key);
  return value == nullptr || value->text() == nullptr ? std::string() : *value->text();
}

}  // namespace

std::vector<Parameters> with_changes(const std::vector<Parameters>& parameters,
                                     const std::vector<NamedMachine>& machines) {
  using enum ChangedLimit::Order;
  std::set<base::Axis> axes;
  for (const NamedMachine& machine : machines) {
    for (const base::Axis axis : base::all_axes) {
      if (machine.machine.has(axis)) axes.insert(axis);
    }
  }
  std::vector<Parameters> all;
  for (const Parameters& unchanged : parameters) {
    all.push_back(unchanged);
    for (const double factor : {1 - changed_by, 1 + changed_by}) {
      for (const base::Axis axis : axes) {
        for (const ChangedLimit::Order order : {velocity, acceleration, jerk}) {
          all.push_back(unchanged);
          all.back().changed_limit = ChangedLimit{axis, order, factor};
        }
      }
      all.push_back(unchanged);
      all.back().tolerance_factor = factor;
    }
  }
  return all;
}

void Sensitivities::observe(const json::Json& row) {
  const json::Json* const time = row.find("time_s");
  std::string parameters;
  for (const char* const key : {"tolerance_mm", "override", "period_us", "velocity", "acceleration", "jerk"}) {
    const json::Json* const value = row.find(key);
    parameters += value == nullptr ? " " : value->written_in_line() + " ";
  }
  const json::Json* const factor = row.find("factor");
  Times& times = programs_[{text_at(row, "program"), text_at(row, "machine"), parameters}][text_at(row, "changed")];
  times.by_factor[factor == nullptr ? 1 : factor->number().value_or(1)] =
      time == nullptr ? std::nan("") : time->number().value_or(std::nan(""));
}

std::vector<Sensitivity> Sensitivities::found() const {
  std::map<std::pair<std::string, std::string>, Sensitivity> sums;
  for (const auto& [place, limits] : programs_) {
    const auto unchanged = limits.find("");
    if (unchanged == limits.end()) continue;
    const double time = unchanged->second.by_factor.begin()->second;
    for (const auto& [limit, times] : limits) {
      if (limit.empty() || times.by_factor.size() != 2) continue;
      const double less = times.by_factor.begin()->second, more = times.by_factor.rbegin()->second;
      if (!std::isfinite(time + less + more)) continue;
      Sensitivity& sum = sums[{place.machine, limit}];
      sum.machine = place.machine;
      sum.limit = limit;
      sum.time_s += time;
      sum.time_less_s += less;
      sum.time_more_s += more;
    }
  }
  std::vector<Sensitivity> all;
  for (auto& [place, sum] : sums) {
    if (sum.time_s > 0) all.push_back(std::move(sum));
  }
  std::ranges::stable_sort(all, {}, &Sensitivity::elasticity);
  return all;
}

json::Json json_of(const Sensitivity& sensitivity) {
  return json::Json::object({{"machine", sensitivity.machine},
                             {"limit", sensitivity.limit},
                             {"time_s", sensitivity.time_s},
                             {"time_less_s", sensitivity.time_less_s},
                             {"time_more_s", sensitivity.time_more_s},
                             {"elasticity", sensitivity.elasticity()}});
}

std::string sensitivity_picture(const std::vector<Sensitivity>& found) {
  std::set<std::string> machines;
  for (const Sensitivity& each : found) machines.insert(each.machine);
  std::vector<Bar> bars;
  for (const Sensitivity& each : found) {
    const std::string name = machines.size() > 1 ? each.machine + ", " + each.limit : each.limit;
    const double saved = each.time_s - each.time_more_s;
    bars.push_back({name, std::max(0.0, -each.elasticity()),
                    fmt::format("{:.3f} %, {:.2f} s by 5 % more", -each.elasticity(), saved)});
  }
  return bar_chart("Time saved, in per cent, by one per cent more of each limit", bars);
}

}  // namespace leadscrew::sweep
