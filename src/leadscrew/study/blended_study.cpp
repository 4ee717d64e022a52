#include <leadscrew/study/blended_programs.hpp>
#include <leadscrew/study/motion_rows.hpp>

namespace leadscrew::study {

namespace {

constexpr base::Period period{1'000'000};

Rows time_rows(const BlendedProgram& program, double seconds, double stopping_seconds) {
  constexpr Scale scale = {"s", 4};
  Row time = at_most_row("time", scale, program.most.value_or(stopping_seconds), seconds);
  time.why = program.most ? "must be at most this" : "must be at most the time with a stop at each joint";
  if (!program.why.empty()) time.why += "; " + std::string(program.why);
  return {time, measured_row("time with a stop at each joint", scale, stopping_seconds)};
}

Rows deviation_rows(const BlendedProgram& program, const referee::Verdict& verdict) {
  Row row = limit_row("deviation from the program", {"µm", 4}, program.deviation * 1e3, verdict.deviation_mm * 1e3);
  row.why = program.deviation < program.tolerance ? "words at 1 ms; on one line nothing is to be blended"
                                                  : "words at 1 ms; the tolerance";
  return {row};
}

Rows objection_rows(const referee::Verdict& verdict) {
  Row row = limit_row("objections of the referee", {"", 0}, 0, static_cast<double>(verdict.violation_count));
  if (!verdict.violations.empty()) row.why = "first: " + verdict.violations.front().what;
  return {row};
}

Rows rows_of(const BlendedProgram& program, const Host& host) {
  const machine::Machine machine = machine_of(program, period);
  const PartProgram text = blended(program);
  const auto planned = plan(text, machine, host);
  if (!planned) return {not_run_row("motion", planned.error().message)};
  const auto stops = plan(stopping(program), machine, {});
  if (!stops) return {not_run_row("motion", stops.error().message)};
  const auto judged = judge(text, machine);
  if (!judged) return {not_run_row("words", judged.error().message)};

  Rows rows = time_rows(program, planned->seconds, stops->seconds);
  append(rows, ratio_rows("plan", largest(judged->summary.plan)));
  append(rows, ratio_rows("words at 1 ms", largest(judged->verdict.axes)));
  append(rows, deviation_rows(program, judged->verdict));
  append(rows, objection_rows(judged->verdict));
  append(rows, planning_rows(*planned, host));
  return rows;
}

}  // namespace

Rows blended_rows(const BlendedProgram& program, const Host& host) {
  return under(circumstances(program), rows_of(program, host));
}

}  // namespace leadscrew::study
