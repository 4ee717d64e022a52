#pragma once
// Random part programs, as text, on random machines.

#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/machine/machine.hpp>
#include <string>

namespace leadscrew::testing_support {

inline double logarithmic(double low, double high) {
  return low * std::pow(high / low, *rc::gen::inRange(0, 1000001) / 1e6);
}

/// Limits over three decades; travel wide enough for every random program.
inline machine::Machine random_machine() {
  machine::Machine machine;
  machine.name = "random";
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A}) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(5, 500), logarithmic(30, 3e4), logarithmic(500, 3e6), 0.001};
  }
  return machine;
}

/// Writes a program block by block, keeping count of where it is.
class RandomProgram {
 public:
  static std::string make() {
    RandomProgram program;
    program.text_ = "G21 G90 G94 G17 F600\n";
    const int blocks = *rc::gen::inRange(1, 25);
    for (int k = 0; k < blocks; ++k) program.block();
    program.text_ += "M2\n";
    return program.text_;
  }

 private:
  void block() {
    switch (*rc::gen::inRange(0, 10)) {
      case 0:
        return line("G0");
      case 1:
        return dwell();
      case 2:
        return feed();
      case 3:
        return plane();
      case 4:
      case 5:
      case 6:
        return arc();
      case 7:
        return inverse_time();
      default:
        return line("G1");
    }
  }

  double size() { return *rc::gen::element(0.0, 0.002, 0.1, 3.0, 30.0, 200.0); }
  double rounded(double value) { return std::round(value * 1000) / 1000; }
  double moved(double from) { return rounded(from + size() * *rc::gen::inRange(-1000, 1001) / 1000.0); }

  void word(char letter, double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, " %c%.3f", letter, value);
    text_ += buffer;
  }

  void line(const char* code) {
    text_ += code;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      if (*rc::gen::inRange(0, 3) == 0) continue;
      at_[axis] = moved(at_[axis]);
      word("XYZA"[axis], at_[axis]);
    }
    text_ += '\n';
  }

  void dwell() {
    text_ += "G4";
    word('P', *rc::gen::inRange(0, 200) / 1000.0);
    text_ += '\n';
  }

  void feed() { text_ += 'F' + std::to_string(*rc::gen::inRange(30, 12000)) + '\n'; }

  void plane() {
    plane_ = *rc::gen::inRange<std::size_t>(0, 3);
    text_ += "G" + std::to_string(17 + plane_) + '\n';
  }

  void inverse_time() {
    text_ += "G93 G1";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at_[axis] = rounded(at_[axis] + 1 + size());
      word("XYZ"[axis], at_[axis]);
    }
    text_ += " F" + std::to_string(*rc::gen::inRange(5, 200)) + "\nG94 F" +
             std::to_string(*rc::gen::inRange(60, 9000)) + '\n';
  }

  /// An arc from here through some angle about a centre not far away, its end rounded as a CAM rounds it.
  void arc() {
    const std::size_t first = std::array<std::size_t, 3>{0, 2, 1}[plane_],
                      second = std::array<std::size_t, 3>{1, 0, 2}[plane_];
    const std::size_t normal = 3 - first - second;
    const bool is_flat = *rc::gen::inRange(0, 6) == 0;
    const double radius = is_flat ? logarithmic(300, 9e4) : std::max(0.02, size());
    const double from = *rc::gen::inRange(0, 6283) / 1000.0;
    const double i = rounded(radius * std::cos(from)), j = rounded(radius * std::sin(from));
    const bool clockwise = *rc::gen::arbitrary<bool>(), whole = !is_flat && *rc::gen::inRange(0, 5) == 0;
    const double sweep =
        is_flat ? *rc::gen::inRange(300, 6000) / 100.0 / radius : *rc::gen::inRange(300, 6000) / 1000.0;
    text_ += clockwise ? "G2" : "G3";
    if (!whole) {
      const double begin = std::atan2(-j, -i), angle = begin + (clockwise ? -sweep : sweep), r = std::hypot(i, j);
      at_[first] = rounded(at_[first] + i + r * std::cos(angle));
      at_[second] = rounded(at_[second] + j + r * std::sin(angle));
      word("XYZ"[first], at_[first]);
      word("XYZ"[second], at_[second]);
    }
    if (*rc::gen::inRange(0, 2) == 0) {
      at_[normal] = moved(at_[normal]);
      word("XYZ"[normal], at_[normal]);
    }
    if (*rc::gen::inRange(0, 4) == 0) {
      at_[3] = moved(at_[3]);
      word('A', at_[3]);
    }
    word("IJK"[first], i);
    word("IJK"[second], j);
    if (!is_flat && *rc::gen::inRange(0, 4) == 0) text_ += " P" + std::to_string(*rc::gen::inRange(1, 4));
    text_ += '\n';
  }

  std::string text_;
  std::array<double, 4> at_{};
  std::size_t plane_ = 0;
};

}  // namespace leadscrew::testing_support
