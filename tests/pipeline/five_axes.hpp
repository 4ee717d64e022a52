#pragma once
// What the referee says of programs on machines of five axes.

#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/pose.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>

#include "random_programs.hpp"

namespace leadscrew::testing_support {

using campaign::two_tools;

inline kinematics::Vector tip_of(const base::AxisVector& place) {
  return {place[0], place[1], place[2]};
}

/// The tool's direction: where the tip of a tool goes that is 1 mm shorter.
inline kinematics::Vector direction_at(const referee::Pose& pose, const base::AxisVector& place) {
  return numeric::difference(tip_of(pose.tip_of(place, {0, 0, 0})), tip_of(pose.tip_of(place, {0, 0, 1})));
}

struct Judged {
  pipeline::Summary summary;
  referee::Verdict verdict;
  int errors = 0;
};

inline Judged judge(const std::string& text, const machine::Machine& machine) {
  Judged outcome;
  const machine::ToolTable tools = two_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error) ++outcome.errors;
  });
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  outcome.summary = program.summary();
  outcome.verdict = referee.conclude();
  return outcome;
}

}  // namespace leadscrew::testing_support
