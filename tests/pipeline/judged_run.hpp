#pragma once
// A program that is moved and judged at once.

#include <rapidcheck/gtest.h>

#include <functional>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>

#include "worst_ratios.hpp"

namespace leadscrew::testing_support {

/// Of a property: moves a program, which must have no problem, tells its events and words, and has the referee, with a reading
/// of its own, find every limit kept to 1.001 and the motion at the program's end.
inline pipeline::Summary judged_run(const std::string& text, const machine::Machine& machine, pipeline::EventSink event,
                                    const std::function<void(const base::Word&)>& see) {
  const machine::ToolTable tools;
  std::string problems;
  const auto tell = [&](const base::Diagnostic& problem) { problems += std::string(problem.code) + ' '; };
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, tell);
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, tell);
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  program.on_event(std::move(event));
  while (program.prepare()) {
    const base::Word word = program.cycle();
    see(word);
    referee.observe(word.position);
  }
  const referee::Verdict verdict = referee.conclude();
  RC_LOG() << problems << '\n';
  for (const referee::Violation& each : verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << "\n";
  RC_ASSERT(problems.empty());
  RC_ASSERT(verdict.violation_count == 0);
  RC_ASSERT(worst_judged(verdict) <= 1.001);
  RC_ASSERT(verdict.end_error_mm <= 1e-9);
  return program.summary();
}

}  // namespace leadscrew::testing_support
