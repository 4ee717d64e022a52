#pragma once
// Random programs of tool vectors (G43.5), and what they ask for.

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/referee/pose.hpp>
#include <string>
#include <vector>

#include "five_axes.hpp"
#include "random_program.hpp"

namespace leadscrew::testing_support {

using kinematics::Vector;

inline Vector tip_of(const base::AxisVector& place) {
  return {place[0], place[1], place[2]};
}

/// The tool's direction: where the tip of a tool goes that is 1 mm shorter.
inline Vector direction_at(const referee::Pose& pose, const base::AxisVector& place) {
  return numeric::difference(tip_of(pose.tip_of(place, {0, 0, 0})), tip_of(pose.tip_of(place, {0, 0, 1})));
}

/// A line as it was written.
struct Programmed {
  std::int64_t line = 0;
  Vector from{}, to{}, direction_from{}, direction_to{};
  bool is_free = false;  ///< a rapid, between whose ends no direction is asked for
};

class VectorProgram {
 public:
  explicit VectorProgram(const machine::Machine& machine) : pose_(machine) {
    for (std::size_t k = 0; k < 2; ++k) rotary_[k] = base::index(machine.rotary_chain->axes[k].axis);
    direction_ = direction_at(pose_, {});
    if (any(0, 4) > 0) {
      tolerance = logarithmic(5e-3, 0.2);
      orientation_tolerance = logarithmic(5e-3, 1);
    }
    by_time_ = any(0, 5) == 0;
  }

  void make(int blocks) {
    add(std::string("G21 G90 G17 ") + (by_time_ ? "G93" : "G94 F1200"));
    char mode[80] = "G61";
    if (tolerance > 0) std::snprintf(mode, sizeof mode, "G64 P%.9f E%.9f", tolerance, orientation_tolerance);
    add(mode);
    if (any(0, 2) == 0) begin_turned();
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
    for (const std::size_t i : rotary_)
      angles_[i] = written(block, base::letter(base::all_axes[i]), between(-100, 100));
    add(block);
    direction_ = direction_at(pose_, angles_);
  }
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
        programmed.to[i] = at_[i] = written(block, static_cast<char>('X' + i), at_[i] + between(-most, most));
    }
    if (turn > 0) {
      for (const std::size_t i : rotary_) angles_[i] += between(-turn, turn);
      const Vector wanted = direction_at(pose_, angles_);
      const double length = logarithmic(0.1, 10);
      for (std::size_t i = 0; i < 3; ++i)
        programmed.direction_to[i] = written(block, static_cast<char>('I' + i), wanted[i] * length);
      programmed.direction_to = direction_ = kinematics::unit_vector(programmed.direction_to);
      programmed.is_free = is_rapid;
    }
    if (by_time_ && !is_rapid) written(block, 'F', logarithmic(5, 2000));
    add(block);
    lines.push_back(programmed);
  }
  void block() {
    switch (any(0, 12)) {
      case 0:
        return line("G0", 20, any(0, 2) * 40.0);
      case 1:
        return line("G1", 0, 40);  // the tip stands
      case 2:
        return line("G1", 10, 0);  // the tool keeps its direction
      case 3:
        return add("S1000 M8");
      case 4:
        return add("G4 P0.01");
      case 5:
        if (!by_time_) add("F" + std::to_string(any(100, 6000)));
        return;
      case 6:
      case 7:
        for (int k = any(3, 10); k > 0; --k) line("G1", 0.6, 1.2);
        return;
      default:
        return line("G1", 15, 30);
    }
  }

  referee::Pose pose_;
  std::array<std::size_t, 2> rotary_{};
  base::AxisVector angles_{};
  Vector at_{}, direction_{};
  std::int64_t count_ = 0;
  bool by_time_ = false;
};

}  // namespace leadscrew::testing_support
