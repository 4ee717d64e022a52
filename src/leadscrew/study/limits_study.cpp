#include <leadscrew/study/blended_programs.hpp>
#include <leadscrew/study/motion_rows.hpp>
#include <leadscrew/study/optima.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

constexpr base::Period coarse{1'000'000}, fine{250'000};

Rows deviation_rows(const referee::Verdict& verdict) {
  Row row = limit_row("deviation from the program", {"nm", 3}, 1, verdict.deviation_mm * 1e6);
  row.why = "words at 0.25 ms; the referee's allowance for rounding";
  return {row};
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
  append(rows, planning_rows(*planned, host));
  append(rows, cycle_rows(*planned, host));
  return rows;
}

}  // namespace

Rows curve_rows(const Host& host) {
  Rows rows;
  for (const OptimumPath* path : {&cubic_optima(), &circle_optima(), &butterfly_optima()}) {
    for (const Optimum& optimum : path->optima)
      append(rows, under(circumstances(*path, optimum), rows_of(*path, optimum, host)));
  }
  return rows;
}

Rows limits_rows(const Host& host) {
  Rows rows = curve_rows(host);
  for (const BlendedProgram& program : blended_programs()) append(rows, blended_rows(program, host));
  return rows;
}

}  // namespace leadscrew::study
