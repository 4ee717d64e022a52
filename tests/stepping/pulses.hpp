#pragma once
// Part programs to pulses, and what came of them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <leadscrew/stepping/pulse_program.hpp>
#include <string>
#include <vector>

namespace leadscrew::stepping::testing {

/// With all nine axes, ±2000 mm or degrees.
inline machine::Machine nine_axes(double blu = 0.001) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) axis = machine::AxisLimits{-2000, 2000, 200, 1000, 20000, blu};
  return machine;
}

inline std::string text_of(const std::string& example) {
  std::ifstream file(std::string(LEADSCREW_SOURCE_DIR) + "/examples/" + example);
  EXPECT_TRUE(file) << example;
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Conditions {
  machine::Machine machine = nine_axes();
  PulseOptions options;
  base::AxisVector start{};
  machine::ToolTable tools;

  gcode::ReaderOptions reading() const {
    gcode::ReaderOptions reading;
    reading.start = start;
    return reading;
  }
};

struct Pulsed {
  LatticeVector sum{};      ///< steps of each axis
  std::int64_t pulses = 0;  ///< clocks with a step
  std::int64_t last = 0;    ///< tick of the last one
  std::int64_t ticks = 0;   ///< of the whole program
  std::int64_t commands = 0;
  bool is_ordered = true;  ///< at most one pulse a clock, none empty, no step but one
  std::string problems;    ///< "3 pulse-rate; ": lines and codes
};

/// Calls `each` for every pulse.
template <typename Each>
Pulsed pulse(const std::string& text, const Conditions& conditions, const Each& each) {
  Pulsed result;
  PulseProgram program(gcode::text_source(text), conditions.machine, conditions.tools, conditions.reading(),
                       conditions.options, [&](const base::Diagnostic& d) {
                         if (d.severity != base::Severity::error) return;
                         result.problems += std::to_string(d.place.line) + " " + std::string(d.code) + "; ";
                       });
  TimedPulse made;
  while (program.next(made)) {
    result.is_ordered &= made.tick > result.last && made.pulse != AxisPulse{};
    for (std::size_t i = 0; i < made.pulse.step.size(); ++i) {
      result.is_ordered &= std::abs(made.pulse.step[i]) <= 1;
      result.sum[i] += made.pulse.step[i];
    }
    ++result.pulses;
    result.last = made.tick;
    each(made);
  }
  result.ticks = program.ticks();
  result.commands = program.commands();
  return result;
}

inline Pulsed pulse(const std::string& text, const Conditions& conditions = {}) {
  return pulse(text, conditions, [](const TimedPulse&) {});
}

}  // namespace leadscrew::stepping::testing
