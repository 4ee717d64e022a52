#pragma once
// Random machines of five axes, and what the referee says of programs on them.

#include <array>
#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <random_numbers.hpp>
#include <string>

namespace leadscrew::testing_support {

inline double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}

inline machine::Vector random_place() {
  return {between(-80, 80), between(-80, 80), between(-80, 80)};
}

/// A preset with its axes anywhere, or nutating; limits over three decades each.
inline machine::Machine five_axes() {
  machine::Machine machine;
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = random_place();
    axis.sign = any(0, 2) == 0 ? 1 : -1;
  }
  if (any(0, 4) == 0) chain.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  chain.tool_zero = random_place();
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  const auto give = [&](base::Axis axis) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(10, 1e4), logarithmic(100, 1e5), logarithmic(2000, 2e6), 0.001};
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) give(axis);
  for (const machine::RotaryAxis& axis : chain.axes) give(axis.axis);
  machine.period = {1'000'000};
  return machine;
}

inline machine::ToolTable two_tools() {
  machine::Tool first, second;
  first.number = 1;
  first.offset[2] = 73.25;
  second.number = 2;
  second.offset = {1.5, -2, 41};
  return machine::ToolTable({first, second});
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
