#pragma once
// Whole part programs whose pulses are timed, and their operations counted: text in, steps out, by every method.

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <leadscrew/nc/pulse_program.hpp>
#include <string>

namespace leadscrew::bench {

struct PulsedProgram {
  const char* name;
  std::string text;
  nc::Shape shape = nc::Shape::constant;
};

/// Lines of this length, mm, one after another in changing directions, in so many axes.
inline std::string lines_of(double length, int axes, int count) {
  std::string text = "G61 F9000\n";
  for (int i = 1; i <= count; ++i) {
    text += "G1";
    for (int axis = 0; axis < axes; ++axis) {
      char word[32];
      const int turn = (i + axis) % 2 == 0 ? 1 : -1;
      std::snprintf(word, sizeof word, " %c%.4f", "XYZAB"[axis], turn * length / 2 * (1 - 0.13 * ((i + 2 * axis) % 7)));
      text += word;
    }
    text += '\n';
  }
  return text + "M2\n";
}

/// Quarters and three quarters of circles of this radius, mm; with a travel of Z beside them helices.
inline std::string arcs_of(double radius, double height, int count) {
  char block[128];
  std::snprintf(block, sizeof block, "G61 F6000\nG0 X%.4f Y0\nG90.1\n", radius);
  std::string text = block;
  for (int i = 0; i < count; ++i) {
    std::snprintf(block, sizeof block, "G3 X0 Y%.4f Z%.4f I0 J0\nG2 X%.4f Y0 Z0 I0 J0\n", radius, height, radius);
    text += block;
  }
  return text + "M2\n";
}

/// An example's text.
inline std::string example(const std::string& name) {
  std::ifstream file(std::string(LEADSCREW_SOURCE_DIR) + "/examples/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::array<PulsedProgram, 9> pulsed_programs() {
  using nc::Shape;
  return {{{"lines/2-axes", lines_of(100, 2, 10)},
           {"lines/3-axes", lines_of(100, 3, 10)},
           {"lines/5-axes", lines_of(100, 5, 10)},
           {"lines/1-mm", lines_of(1.5, 2, 800)},
           {"arcs", arcs_of(20, 0, 8)},
           {"arcs/1-mm", arcs_of(1, 0, 150)},
           {"helices", arcs_of(20, 7, 8)},
           {"plate", example("01-plate.ngc")},
           {"plate/accelerated", example("01-plate.ngc"), Shape::accelerate}}};
}

inline std::string name(const PulsedProgram& program, nc::PulseMethod method) {
  return program.name + ("/" + std::string(nc::name(method)));
}

/// Axes of 1 µm a step and 200 mm/s, three of them and two rotary ones.
inline machine::Machine stepped_machine() {
  machine::Machine machine = machine::mill3();
  for (std::size_t axis = 0; axis < 5; ++axis) {
    machine.axes[axis] = machine::AxisLimits{-2000, 2000, 200, 1000, 20000, 0.001};
  }
  return machine;
}

struct Stepped {
  std::int64_t pulses = 0;  ///< clocks with a step
  std::int64_t steps = 0;
  std::int64_t sum = 0;  ///< of what the steps are, so that they have to be made
  std::int64_t errors = 0;
};

/// From the first byte to the last step.
inline Stepped run(const PulsedProgram& program, nc::PulseMethod method) {
  const machine::Machine machine = stepped_machine();
  const machine::ToolTable tools({{1}, {2}});
  nc::PulseOptions options;
  options.method = method;
  options.interpolation.places = 16;
  options.shape = program.shape;
  nc::PulseProgram pulses(gcode::text_source(program.text), machine, tools, {}, options,
                          [](const base::Diagnostic&) {});
  Stepped stepped;
  std::array<steps::StepEvent, 1024> room;
  std::int64_t last = 0;
  for (auto steps = pulses.next(room); !steps.empty(); steps = pulses.next(room)) {
    stepped.steps += static_cast<std::int64_t>(steps.size());
    for (const steps::StepEvent step : steps) {
      stepped.pulses += step.tick() != last;
      last = step.tick();
      stepped.sum += last * step.direction();
    }
  }
  stepped.errors = pulses.errors();
  return stepped;
}

}  // namespace leadscrew::bench
