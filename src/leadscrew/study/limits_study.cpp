#include <algorithm>
#include <leadscrew/study/optima.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

constexpr base::Period coarse{1'000'000}, fine{250'000};

/// What a limit may be passed by: the referee's own allowance.
constexpr double allowance = 0.001;

Rows ratio_rows(const std::string& who, const planner::AxisRatios& most) {
  const auto row = [&](const char* what, double ratio) {
    return limit_row(who + ": largest " + what + " over limit", {"", 4}, 1, ratio, allowance);
  };
  return {row("velocity", most.velocity), row("acceleration", most.acceleration), row("jerk", most.jerk)};
}

Rows deviation_rows(const referee::Verdict& verdict) {
  Row row = limit_row("deviation from the program", {"nm", 3}, 1, verdict.deviation_mm * 1e6);
  row.why = "words at 0.25 ms; the referee's allowance for rounding";
  return {row};
}

Rows effort_rows(const Planned& planned, const Host& host) {
  Rows rows;
  if (host.thread_cpu_seconds) {
    const double total = planned.cpu.path + planned.cpu.plan;
    rows.push_back(measured_row("planning over motion time", {"%", 3}, 100 * total / planned.seconds));
    rows.back().why = "processor time, moves to path included";
    rows.push_back(measured_row("longest call of the planner", {"ms", 3}, 1e3 * planned.cpu.longest_plan));
    rows.back().why = "processor time";
  } else {
    rows.push_back(not_run_row("planning over motion time", "no clock of processor time"));
  }
  if (!host.wall_seconds) {
    rows.push_back(not_run_row("cycle", "no steady clock"));
    return rows;
  }
  rows.push_back(measured_row("cycle, median", {"ns", 0}, planned.cycle.p50));
  rows.back().why = "two looks at the clock included";
  rows.push_back(measured_row("cycle, 99.9 %", {"ns", 0}, planned.cycle.p999));
  rows.push_back(measured_row("cycle, longest", {"ns", 0}, planned.cycle.max));
  rows.back().why = "whatever interrupted it included";
  return rows;
}

Rows rows_of(const OptimumPath& path, const Optimum& optimum, const Host& host) {
  const PartProgram program = path.program(optimum.feed);
  const machine::Machine machine = machine_with(optimum.limits, coarse);
  const auto planned = plan(program, machine, host);
  if (!planned) return {not_run_row("motion", planned.error().message)};
  const auto at_coarse = judge(program, machine);
  if (!at_coarse) return {not_run_row("words", at_coarse.error().message)};
  const auto at_fine = judge(program, machine_with(optimum.limits, fine));
  if (!at_fine) return {not_run_row("words", at_fine.error().message)};

  Rows rows = time_rows(optimum, planned->seconds, at_coarse->summary.bound_s);
  append(rows, ratio_rows("plan", largest(at_coarse->summary.plan)));
  append(rows, ratio_rows("words at 1 ms", largest(at_coarse->verdict.axes)));
  append(rows, ratio_rows("words at 0.25 ms", largest(at_fine->verdict.axes)));
  append(rows, deviation_rows(at_fine->verdict));
  append(rows, effort_rows(*planned, host));
  return rows;
}

}  // namespace

Rows limits_rows(const Host& host) {
  Rows rows;
  for (const OptimumPath* path : {&cubic_optima(), &circle_optima(), &butterfly_optima()}) {
    for (const Optimum& optimum : path->optima)
      append(rows, under(circumstances(*path, optimum), rows_of(*path, optimum, host)));
  }
  return rows;
}

}  // namespace leadscrew::study
