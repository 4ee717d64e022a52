#pragma once
// Random machines of five axes and programs for them, and how the referee finds what becomes of both.

#include <array>
#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <string>

#include "random_program.hpp"

namespace leadscrew::testing_support {

inline double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}

inline machine::Vector place() {
  return {between(-80, 80), between(-80, 80), between(-80, 80)};
}

/// A preset with its axes anywhere, or nutating; limits over two decades.
inline machine::Machine five_axes() {
  machine::Machine machine;
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = place();
    axis.sign = any(0, 2) == 0 ? 1 : -1;
  }
  if (any(0, 4) == 0) chain.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  chain.tool_zero = place();
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  const auto give = [&](base::Axis axis) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(10, 500), logarithmic(100, 1e4), logarithmic(2000, 1e6), 0.001};
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) give(axis);
  for (const machine::RotaryAxis& axis : chain.axes) give(axis.axis);
  machine.period = {1'000'000};
  return machine;
}

class FiveAxisProgram {
 public:
  explicit FiveAxisProgram(const machine::Machine& machine) {
    for (std::size_t k = 0; k < 2; ++k) letters_[k] = base::letter(machine.rotary_chain->axes[k].axis);
  }

  std::string make(int blocks) {
    text_ = "G21 G90 G94 G17 F1200\n";
    path_mode();
    begin();
    for (int k = 0; k < blocks; ++k) block();
    return text_ + "M2\n";
  }

 private:
  void word(char letter, double value) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.3f", letter, value);
    text_ += word;
  }
  void begin() { text_ += "G43.4 H1\n"; }
  void path_mode() {
    if (any(0, 5) == 0) {
      text_ += "G61\n";
      return;
    }
    text_ += "G64";
    word('P', logarithmic(2e-3, 0.2));
    if (any(0, 2) == 0) word('E', logarithmic(2e-3, 1));
    text_ += '\n';
  }
  void angles(double most) {
    for (std::size_t k = 0; k < 2; ++k) word(letters_[k], angle_[k] += between(-most, most));
  }
  void line(const char* code, double most, double turn) {
    text_ += code;
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], at_[i] += between(-most, most));
    if (any(0, 3) > 0) angles(turn);
    text_ += '\n';
  }
  void block() {
    switch (any(0, 12)) {
      case 0:
        return line("G0", 30, 40);
      case 1:
        text_ += "G1";
        angles(60);
        text_ += '\n';
        return;
      case 2:
        return arc();
      case 3:
        text_ += "F" + std::to_string(any(100, 6000)) + "\n";
        return;
      case 4:
        text_ += "G4 P0.01\n";
        return;
      case 5:
        return path_mode();
      case 6:
        text_ += any(0, 2) == 0 ? "G49\nG43.4 H2\n" : "G43.4 H1\n";
        return;
      case 7:
      case 8:
        for (int k = any(3, 10); k > 0; --k) line("G1", 0.6, 1.2);
        return;
      default:
        return line("G1", 15, 25);
    }
  }
  /// Half a circle in XY, with the rotary axes going along.
  void arc() {
    const double radius = between(0.3, 8);
    line("G1", 1, 1);
    text_ += any(0, 2) == 0 ? "G2" : "G3";
    word('X', at_[0] += 2 * radius);
    word('Y', at_[1]);
    word('I', radius);
    word('J', 0);
    if (any(0, 2) == 0) angles(20);
    text_ += '\n';
  }

  std::string text_;
  std::array<char, 2> letters_{};
  std::array<double, 2> angle_{};
  std::array<double, 3> at_{};
};

inline machine::ToolTable two_tools() {
  machine::Tool first, second;
  first.number = 1;
  first.offset[2] = 73.25;
  second.number = 2;
  second.offset = {1.5, -2, 41};
  return machine::ToolTable({first, second});
}

}  // namespace leadscrew::testing_support
