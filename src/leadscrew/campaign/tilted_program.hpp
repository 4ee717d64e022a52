#pragma once
// Programs in tilted working planes (G68.2, G53.1), and where they lead. Draws as in random_program.hpp.

#include <cmath>
#include <cstdio>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace leadscrew::campaign {

using machine::Vector;

inline Vector about(std::size_t axis, double degrees, Vector v) {
  const double angle = degrees * std::numbers::pi / 180, c = numeric::cos(angle), s = numeric::sin(angle);
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Vector before = v;
  v[i] = c * before[i] - s * before[j];
  v[j] = s * before[i] + c * before[j];
  return v;
}

/// Where a move ends, and what it is told of, in the workpiece.
struct Target {
  Vector end{}, tool{};
  bool is_arc = false;
  Vector center{}, normal{};
  double radius = 0;
};

/// A program, and where it leads, in the workpiece.
template <class Draws>
class TiltedProgram {
 public:
  explicit TiltedProgram(Draws& draws) : draws_(draws) {}

  /// Of so many blocks, ≥ 1; some stand for several.
  std::string make(int blocks) {
    text_ = "G21 G90 G94 G17 F1200\n";
    if (draws_.any(0, 3) == 0) text_ += "G61\n";
    offsets();
    if (draws_.any(0, 2) == 0) tool();
    plane();
    if (draws_.any(0, 3) == 0) line("G0", 30);  // before the tool is along the normal
    text_ += draws_.any(0, 2) == 0 ? "G53.1\n" : "G53.1 P1\n";
    if (draws_.any(0, 3) == 0) tool();
    line("G0", 30);
    for (int k = 0; k < blocks; ++k) block();
    return text_ + "M2\n";
  }

  /// Of the moves that move the tip against the machine.
  const std::vector<Target>& targets() const { return targets_; }

 private:
  /// With three decimals, as it is written.
  double written(double least, double greatest) { return std::round(draws_.between(least, greatest) * 1000) / 1000; }
  void word(char letter, double value) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.3f", letter, value);
    text_ += word;
  }
  void offsets() {
    text_ += "G10 L2 P1";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], origin_[i] = written(-50, 50));
    word('R', rotation_ = draws_.any(0, 2) == 0 ? 0 : written(-180, 180));
    text_ += "\n";
    if (draws_.any(0, 3) > 0) return;
    text_ += "G52";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], shift_[i] = written(-20, 20));
    text_ += "\n";
  }
  void tool() {
    const bool second = draws_.any(0, 2) == 0;
    text_ += second ? "G43 H2\n" : "G43 H1\n";
    tool_ = second ? Vector{1.5, -2, 41} : Vector{0, 0, 73.25};
  }
  void plane() {
    text_ += "G68.2";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], plane_[i] = written(-50, 50));
    by_euler_ = draws_.any(0, 2) == 0;
    if (by_euler_) {
      degrees_ = {written(-180, 180), written(-80, 80), written(-180, 180)};
    } else {
      degrees_ = {written(-40, 40), written(-40, 40), written(-40, 40)};
      const char* const orders[] = {"123", "132", "213", "231", "312", "321"};
      order_ = orders[draws_.any(0, 6)];
      text_ += std::string(" P1 Q") + order_;
    }
    for (std::size_t i = 0; i < 3; ++i) word("IJK"[i], degrees_[i]);
    text_ += "\n";
  }
  Vector in_workpiece(Vector v) const {
    if (by_euler_) {
      v = about(2, degrees_[2], v);
      v = about(0, degrees_[1], v);
      v = about(2, degrees_[0], v);
    } else {
      for (const char each : order_) {
        const auto axis = static_cast<std::size_t>(each - '1');
        v = about(axis, degrees_[axis], v);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) v[i] += plane_[i] + shift_[i];
    v = about(2, rotation_, v);
    for (std::size_t i = 0; i < 3; ++i) v[i] += origin_[i];
    return v;
  }
  void ends_at(const Vector& program, const Vector* center = nullptr, double radius = 0) {
    Target target{in_workpiece(program), tool_};
    if (center) {
      const Vector above = in_workpiece({(*center)[0], (*center)[1], (*center)[2] + 1});
      target.is_arc = true;
      target.center = in_workpiece(*center);
      for (std::size_t i = 0; i < 3; ++i) target.normal[i] = above[i] - target.center[i];
      target.radius = radius;
    }
    if (center || !stands_ || program != at_) targets_.push_back(target);
    at_ = program;
    stands_ = true;
  }
  void line(const char* code, double most) {
    text_ += code;
    Vector to = at_;
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], to[i] = written(-most, most));
    text_ += "\n";
    ends_at(to);
  }
  void arc() {
    const double radius = written(0.5, 8);
    const bool whole = draws_.any(0, 3) == 0;
    text_ += draws_.any(0, 2) == 0 ? "G2" : "G3";
    const Vector center = {at_[0] + radius, at_[1], at_[2]};
    Vector to = at_;
    if (!whole) word('X', to[0] += 2 * radius);
    if (draws_.any(0, 2) == 0) word('Z', to[2] += written(-3, 3));
    word('I', radius);
    text_ += "\n";
    ends_at(to, &center, radius);
  }
  void drill() {
    const double x = written(-20, 20), y = written(-20, 20), top = written(1, 3), bottom = written(-9, 0);
    text_ += "G0 Z9\nG99 G81";
    ends_at({at_[0], at_[1], 9});
    word('X', x), word('Y', y), word('Z', bottom), word('R', top);
    text_ += "\nG80\n";
    for (const double z : {9.0, top, bottom, top}) ends_at({x, y, z});
  }
  void block() {
    switch (draws_.any(0, 8)) {
      case 0:
        return line("G0", 30);
      case 1:
      case 2:
        return arc();
      case 3:
        return drill();
      default:
        return line("G1", 20);
    }
  }

  Draws& draws_;
  std::string text_;
  std::string order_;
  Vector origin_{}, shift_{}, plane_{}, degrees_{}, tool_{};
  double rotation_ = 0;
  bool by_euler_ = true;
  Vector at_{};
  bool stands_ = false;  // at at_
  std::vector<Target> targets_;
};

}  // namespace leadscrew::campaign
