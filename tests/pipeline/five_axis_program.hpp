#pragma once
// Random programs of tool centre point control.

#include <array>
#include <cstdio>
#include <leadscrew/machine/machine.hpp>
#include <string>

#include "five_axes.hpp"
#include "random_program.hpp"

namespace leadscrew::testing_support {

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

}  // namespace leadscrew::testing_support
