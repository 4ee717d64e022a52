#pragma once
// A program under G64, judged by the referee, and beside it the same with a stop at every joint.

#include <gtest/gtest.h>

#include <cstdio>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>

#include "worst_ratios.hpp"

namespace leadscrew::testing_support {

/// mill3 with room for long programs, and rotary axes.
inline machine::Machine wide_mill() {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->travel_min = -1e5, axis->travel_max = 1e5;
  }
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::U}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e5, 1e5, 200, 1000, 20000, 0.001};
  }
  return machine;
}

struct Outcome {
  pipeline::Summary summary;
  referee::Verdict verdict;
};

inline Outcome run_on(const machine::Machine& machine, const std::string& text, gcode::ReaderOptions options = {}) {
  const machine::ToolTable tools;
  std::int64_t errors = 0;
  const auto count = [&](const base::Diagnostic& problem) { errors += problem.severity == base::Severity::error; };
  pipeline::Program program(gcode::text_source(text), machine, tools, options, count);
  gcode::Reader judged(gcode::text_source(text), machine, tools, options, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  EXPECT_EQ(errors, 0);
  return {program.summary(), referee.conclude()};
}

inline Outcome run(const std::string& text, gcode::ReaderOptions options = {}, base::Period period = {1'000'000}) {
  machine::Machine machine = wide_mill();
  machine.period = period;
  return run_on(machine, text, options);
}

inline Outcome run_with_stops(const std::string& text, base::Period period = {1'000'000}) {
  gcode::ReaderOptions options;
  options.path_mode = gcode::PathMode::exact_stop;
  return run(text, options, period);
}

inline std::string word(char letter, double value, int decimals) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, " %c%.*f", letter, decimals, value);
  return buffer;
}

inline bool keeps_promises(const Outcome& outcome) {
  const referee::Verdict& verdict = outcome.verdict;
  return verdict.violation_count == 0 && worst_judged(verdict) <= 1.001 && verdict.feed_max_ratio <= 1.001 &&
         worst_planned(outcome.summary.plan) <= 1 + 1e-9 && verdict.deviation_mm <= verdict.tolerance_mm + 1e-6 &&
         verdict.start_error_mm == 0 && verdict.end_error_mm <= 1e-9;
}

inline const std::string head = "G21 G90 G17 G94 F6000 G64 P0.01\n";

/// and no slower.
inline void expect_better_than_stops(const std::string& text) {
  SCOPED_TRACE(text.substr(0, 300));
  const Outcome outcome = run(text), stopping = run_with_stops(text);
  EXPECT_TRUE(keeps_promises(outcome)) << outcome.verdict.deviation_mm << ' ' << worst_judged(outcome.verdict) << ' '
                                       << worst_planned(outcome.summary.plan);
  EXPECT_LE(outcome.summary.time_s, stopping.summary.time_s + 0.001);
}

}  // namespace leadscrew::testing_support
