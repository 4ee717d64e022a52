#include <leadscrew/study/motion_rows.hpp>

namespace leadscrew::study {

Rows ratio_rows(const std::string& who, const machine::Derivatives& most) {
  constexpr double allowance = 0.001;
  const auto row = [&](const char* what, double ratio) {
    return limit_row(who + ": largest " + what + " over limit", {"", 4}, 1, ratio, allowance);
  };
  return {row("velocity", most.velocity), row("acceleration", most.acceleration), row("jerk", most.jerk)};
}

Rows planning_rows(const Planned& planned, const Host& host) {
  if (!host.thread_cpu_seconds) return {not_run_row("planning over motion time", "no clock of processor time")};
  const double total = planned.cpu.path + planned.cpu.plan;
  Row share = measured_row("planning over motion time", {"%", 3}, 100 * total / planned.seconds);
  share.why = "processor time, moves to path included";
  Row longest = measured_row("longest call of the planner", {"ms", 3}, 1e3 * planned.cpu.longest_plan);
  longest.why = "processor time";
  return {share, longest};
}

Rows cycle_rows(const Planned& planned, const Host& host) {
  if (!host.wall_seconds) return {not_run_row("cycle", "no steady clock")};
  Row median = measured_row("cycle, median", {"ns", 0}, planned.cycle.p50);
  median.why = "two looks at the clock included";
  Row longest = measured_row("cycle, longest", {"ns", 0}, planned.cycle.max);
  longest.why = "whatever interrupted it included";
  return {median, measured_row("cycle, 99.9 %", {"ns", 0}, planned.cycle.p999), longest};
}

}  // namespace leadscrew::study
