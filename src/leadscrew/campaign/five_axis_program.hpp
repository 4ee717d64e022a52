#pragma once
// Programs of tool centre point control. Draws as in random_program.hpp.

#include <array>
#include <cstdio>
#include <leadscrew/machine/machine.hpp>
#include <string>

namespace leadscrew::campaign {

template <class Draws>
class FiveAxisProgram {
 public:
  FiveAxisProgram(Draws& draws, const machine::Machine& machine) : draws_(draws) {
    for (std::size_t k = 0; k < 2; ++k) letters_[k] = base::letter(machine.rotary_chain->axes[k].axis);
  }

  /// Of so many blocks, ≥ 1; some stand for several.
  std::string make(int blocks) {
    is_timed_ = draws_.any(0, 5) == 0;
    text_ = is_timed_ ? "G21 G90 G93 G17\n" : "G21 G90 G94 G17 F1200\n";
    path_mode();
    if (draws_.any(0, 3) == 0) offsets();
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
  /// Ends a block that moves; G93 asks each for its time.
  void end(const char* code = "G1") {
    if (is_timed_ && code[1] != '0') word('F', draws_.logarithmic(5, 2000));
    text_ += '\n';
  }
  /// The program's zero lies elsewhere, the rotary axes' too.
  void offsets() {
    const int system = draws_.any(1, 4);
    text_ += "G10 L2 P" + std::to_string(system);
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], draws_.between(-50, 50));
    for (const char letter : letters_) word(letter, draws_.any(0, 2) == 0 ? 0.0 : draws_.between(-30, 30));
    text_ += "\nG" + std::to_string(53 + system) + "\n";
    if (draws_.any(0, 3) > 0) return;
    text_ += "G92";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], draws_.between(-20, 20));
    if (draws_.any(0, 2) == 0) word(letters_[1], draws_.between(-20, 20));
    text_ += '\n';
  }
  void path_mode() {
    if (draws_.any(0, 5) == 0) {
      text_ += "G61\n";
      return;
    }
    text_ += "G64";
    word('P', draws_.logarithmic(2e-3, 0.2));
    if (draws_.any(0, 2) == 0) word('E', draws_.logarithmic(2e-3, 1));
    text_ += '\n';
  }
  void angles(double most) {
    for (std::size_t k = 0; k < 2; ++k) word(letters_[k], angle_[k] += draws_.between(-most, most));
  }
  void line(const char* code, double most, double turn) {
    text_ += code;
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], at_[i] += draws_.between(-most, most));
    if (draws_.any(0, 3) > 0) angles(turn);
    end(code);
  }
  void block() {
    switch (draws_.any(0, 15)) {
      case 0:
        return line("G0", 30, 40);
      case 1:
        text_ += "G1";
        angles(60);
        return end();
      case 2:
        return arc();
      case 3:
        if (!is_timed_) text_ += "F" + std::to_string(draws_.any(100, 6000)) + "\n";
        return;
      case 4:
        text_ += "G4 P0.01\n";
        return;
      case 5:
        return path_mode();
      case 6:
        text_ += draws_.any(0, 2) == 0 ? "G49\nG43.4 H2\n" : "G43.4 H1\n";
        return;
      case 7:
      case 8:
        for (int k = draws_.any(3, 10); k > 0; --k) line("G1", 0.6, 1.2);
        return;
      case 9:
        return uniform_nurbs();
      case 10:
        return nurbs();
      default:
        return line("G1", 15, 25);
    }
  }
  /// Half a circle or a helix in one of the planes, with the rotary axes going along.
  void arc() {
    struct Plane {
      const char* code;
      std::size_t first, second, third;
    };
    constexpr std::array<Plane, 3> planes{{{"G17", 0, 1, 2}, {"G18", 2, 0, 1}, {"G19", 1, 2, 0}}};
    const Plane plane = planes[static_cast<std::size_t>(draws_.any(0, 3))];
    const double radius = draws_.between(0.3, 8);
    line("G1", 1, 1);
    text_ += std::string(plane.code) + (draws_.any(0, 2) == 0 ? " G2" : " G3");
    word("XYZ"[plane.first], at_[plane.first] += 2 * radius);
    word("XYZ"[plane.second], at_[plane.second]);
    if (draws_.any(0, 3) == 0) word("XYZ"[plane.third], at_[plane.third] += draws_.between(-4, 4));
    word("IJK"[plane.first], radius);
    word("IJK"[plane.second], 0);
    if (draws_.any(0, 2) == 0) angles(20);
    end();
    text_ += "G17\n";
  }
  /// The next point of a control polygon of NURBS, and its orientation.
  void control_point() {
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], at_[i] += draws_.between(-8, 8));
    angles(15);
  }
  /// Knots equally apart.
  void uniform_nurbs() {
    const int order = draws_.any(3, 5);
    for (int k = 0, points = draws_.any(order, order + 5); k < points; ++k) {
      if (k == 0) text_ += "G5.2 L" + std::to_string(order);
      control_point();
      word('P', draws_.any(0, 2) == 0 ? 1.0 : draws_.between(0.3, 3));
      end();
    }
    text_ += "G5.3\n";
  }
  /// From where the program is, with simple knots inside, unequally apart.
  void nurbs() {
    const int order = draws_.any(2, 6), points = draws_.any(order, order + 5);
    line("G1", 1, 1);
    double knot = 0;
    for (int k = 0; k < points + order; ++k) {
      if (k == 0) text_ += "G6.2 P" + std::to_string(order);
      if (k >= order && k <= points) knot += draws_.between(0.2, 2);
      word('K', knot);
      if (k == 0) {
        for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], at_[i]);
      } else if (k < points) {
        control_point();
      }
      if (k < points && draws_.any(0, 2) == 0) word('R', draws_.between(0.3, 3));
      if (k == 0)
        end();
      else
        text_ += '\n';
    }
  }

  Draws& draws_;
  std::string text_;
  bool is_timed_ = false;  ///< G93
  std::array<char, 2> letters_{};
  std::array<double, 2> angle_{};
  std::array<double, 3> at_{};
};

}  // namespace leadscrew::campaign
