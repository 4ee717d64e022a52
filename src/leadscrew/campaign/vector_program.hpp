#pragma once
// Programs of tool vectors (G43.5), and what they ask for. Draws as in random_program.hpp.

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <string>
#include <vector>

namespace leadscrew::campaign {

using kinematics::Vector;

/// A line as it was written.
struct Programmed {
  std::int64_t line = 0;
  Vector from{}, to{}, direction_from{}, direction_to{};
  bool is_free = false;  ///< a rapid, between whose ends no direction is asked for
};

template <class Draws>
class VectorProgram {
 public:
  VectorProgram(Draws& draws, const machine::Machine& machine)
      : draws_(draws), chain_(kinematics::chain_of(machine)), direction_(direction()) {
    if (draws_.any(0, 4) > 0) {
      tolerance = draws_.logarithmic(5e-3, 0.2);
      orientation_tolerance = draws_.logarithmic(5e-3, 1);
    }
    by_time_ = draws_.any(0, 5) == 0;
  }

  /// Of so many blocks, ≥ 1; some stand for several.
  void make(int blocks) {
    add(std::string("G21 G90 G17 ") + (by_time_ ? "G93" : "G94 F1200"));
    char mode[80] = "G61";
    if (tolerance > 0) std::snprintf(mode, sizeof mode, "G64 P%.9f E%.9f", tolerance, orientation_tolerance);
    add(mode);
    if (draws_.any(0, 2) == 0) begin_turned();
    add("G43.5 H1");
    lines.push_back({count_ + 1, {}, {}, direction_, direction_, false});
    add(by_time_ ? "G0 X0 Y0 Z0" : "G1 X0 Y0 Z0 F3000");
    for (int k = 0; k < blocks; ++k) block();
    add("M2");
  }

  std::string text;
  std::vector<Programmed> lines;
  double tolerance = 0, orientation_tolerance = 0;  ///< of G64; 0 of G61

 private:
  void add(const std::string& line) {
    text += line + '\n';
    ++count_;
  }
  /// Somewhere with the axes turned, so that runs begin away from poles as well.
  void begin_turned() {
    std::string block = "G0";
    for (std::size_t k = 0; k < 2; ++k)
      angles_[k] = written(block, base::letter(chain_.turns()[k].axis), draws_.between(-100, 100));
    add(block);
    direction_ = direction();
  }
  Vector direction() const { return kinematics::direction_of(chain_, kinematics::Angles<double>(angles_)); }
  /// The value as it is read.
  static double written(std::string& block, char letter, double value) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.9f", letter, value);
    block += word;
    return std::strtod(word + 2, nullptr);
  }
  void line(const char* code, double most, double turn) {
    const bool is_rapid = code[1] == '0';
    Programmed programmed{count_ + 1, at_, at_, direction_, direction_, false};
    std::string block = code;
    if (most > 0) {
      for (std::size_t i = 0; i < 3; ++i)
        programmed.to[i] = at_[i] = written(block, static_cast<char>('X' + i), at_[i] + draws_.between(-most, most));
    }
    if (turn > 0) {
      for (double& angle : angles_) angle += draws_.between(-turn, turn);
      const Vector wanted = direction();
      const double length = draws_.logarithmic(0.1, 10);
      for (std::size_t i = 0; i < 3; ++i)
        programmed.direction_to[i] = written(block, static_cast<char>('I' + i), wanted[i] * length);
      programmed.direction_to = direction_ = kinematics::unit_vector(programmed.direction_to);
      programmed.is_free = is_rapid;
    }
    if (by_time_ && !is_rapid) written(block, 'F', draws_.logarithmic(5, 2000));
    add(block);
    lines.push_back(programmed);
  }
  void block() {
    switch (draws_.any(0, 12)) {
      case 0:
        return line("G0", 20, draws_.any(0, 2) * 40.0);
      case 1:
        return line("G1", 0, 40);  // the tip stands
      case 2:
        return line("G1", 10, 0);  // the tool keeps its direction
      case 3:
        return add("S1000 M8");
      case 4:
        return add("G4 P0.01");
      case 5:
        if (!by_time_) add("F" + std::to_string(draws_.any(100, 6000)));
        return;
      case 6:
      case 7:
        for (int k = draws_.any(3, 10); k > 0; --k) line("G1", 0.6, 1.2);
        return;
      default:
        return line("G1", 15, 30);
    }
  }

  Draws& draws_;
  kinematics::Chain chain_;
  std::array<double, 2> angles_{};
  Vector at_{}, direction_{};
  std::int64_t count_ = 0;
  bool by_time_ = false;
};

}  // namespace leadscrew::campaign
