#pragma once
// Part programs to pulses, and what came of them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <leadscrew/nc/pulse_program.hpp>
#include <string>
#include <vector>

namespace leadscrew::nc::testing {

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
  bool is_ordered = true;  ///< by ticks and axes, at most one step of an axis at each
  std::string problems;    ///< "3 pulse-rate; ": lines and codes
};

/// All steps of one tick.
struct TimedPulse {
  std::int64_t tick = 0;  ///< of the clock, from 1
  AxisPulse pulse;        ///< not empty
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
  std::array<steps::StepEvent, 256> room;
  for (auto steps = program.next(room); !steps.empty(); steps = program.next(room)) {
    for (std::size_t i = 0; i < steps.size();) {
      TimedPulse made{steps[i].tick(), {}};
      for (std::size_t before = i; i < steps.size() && steps[i].tick() == made.tick; ++i) {
        result.is_ordered &= i == before || steps[i - 1].axis() < steps[i].axis();
        made.pulse.step[base::index(steps[i].axis())] = static_cast<std::int8_t>(steps[i].direction());
        result.sum[base::index(steps[i].axis())] += steps[i].direction();
      }
      result.is_ordered &= made.tick > result.last;
      ++result.pulses;
      result.last = made.tick;
      each(made);
    }
  }
  result.ticks = program.ticks();
  result.commands = program.commands();
  return result;
}

inline Pulsed pulse(const std::string& text, const Conditions& conditions = {}) {
  return pulse(text, conditions, [](const TimedPulse&) {});
}

}  // namespace leadscrew::nc::testing
