#pragma once
// Programs of lines, arcs, curves and short lines in X, Y, Z and A. Draws is the class of that name (draws.hpp) or one that has
// its calls.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <leadscrew/campaign/kinds.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::campaign {

/// Writes a program block by block, keeping count of where it is.
template <class Draws>
class RandomProgram {
 public:
  /// Of a kind, or of anything: none.
  RandomProgram(Draws& draws, std::optional<Kind> kind) : draws_(draws), kind_(kind) {}

  /// Of so many blocks at most, ≥ 1; some stand for several.
  std::string make(int most_blocks) {
    text_ = "G21 G90 G94 G17 F600\n";
    path_mode();
    const int blocks = draws_.any(1, most_blocks + 1);
    for (int k = 0; k < blocks; ++k) block();
    return text_ + "M2\n";
  }

 private:
  /// Of a kind: what it is about, and a quarter of anything else.
  void block() {
    const bool is_of_kind = kind_ && !draws_.once_in(4);
    if (kind_ == Kind::lines && is_of_kind) return line_block();
    if (kind_ == Kind::arcs && is_of_kind) return draws_.once_in(4) ? parts_of_a_circle() : arc();
    if (kind_ == Kind::nurbs && is_of_kind) return draws_.once_in(3) ? cubic() : nurbs();
    if (kind_ == Kind::corners && is_of_kind) return draws_.once_in(2) ? short_lines() : line("G1");
    any_block();
  }
  void line_block() {
    switch (draws_.any(0, 8)) {
      case 0:
        return line("G0");
      case 1:
        return dwell();
      case 2:
        return inverse_time();
      case 3:
        return straight_on();
      default:
        return line("G1");
    }
  }
  void any_block() {
    switch (draws_.any(0, 15)) {
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
      case 10:
        return nurbs();
      case 11:
        return cubic();
      case 12:
        return straight_on();
      case 13:
        return parts_of_a_circle();
      case 14:
        return draws_.once_in(4) ? path_mode() : short_lines();
      default:
        return line("G1");
    }
  }

  void path_mode() {
    switch (kind_ == Kind::corners ? 2 : draws_.any(0, 5)) {
      case 0:
        text_ += "G61\n";
        return;
      case 1:
        text_ += "G61.1\n";
        return;
      default:
        text_ += "G64";
        if (draws_.any(0, 4) > 0) {
          word('P', draws_.logarithmic(1e-3, 1), 6);
          if (draws_.any(0, 4) == 0) word('Q', draws_.logarithmic(1e-3, 1), 6);
        }
        text_ += '\n';
    }
  }

  /// A curve as a CAM writes it: lines of much the same length that turn little, rounded.
  void short_lines() {
    const double length = draws_.logarithmic(0.002, 5), bend = draws_.any(-1000, 1001) / 1000.0,
                 waver = draws_.any(0, 200) / 1000.0;
    const double turn = draws_.once_in(4) ? small_size() / 10 : 0;  // of A, degrees a line
    double angle = draws_.any(0, 6283) / 1000.0;
    for (int k = draws_.any(2, 30); k > 0; --k) {
      angle += 0.3 * bend + waver * draws_.any(-1000, 1001) / 1000.0;
      at_[0] = rounded(at_[0] + length * numeric::cos(angle));
      at_[1] = rounded(at_[1] + length * numeric::sin(angle));
      text_ += "G1";
      word('X', at_[0]);
      word('Y', at_[1]);
      if (turn > 0) {
        at_[3] = rounded(at_[3] + turn * numeric::cos(2 * angle));
        word('A', at_[3]);
      }
      text_ += '\n';
    }
  }

  double size() { return draws_.one_of({0.0, 0.002, 0.1, 3.0, 30.0, 200.0}); }
  double small_size() { return draws_.one_of({0.0, 0.002, 0.1, 3.0, 10.0}); }
  double rounded(double value) { return std::round(value * 1000) / 1000; }
  double moved(double from) { return rounded(from + size() * draws_.any(-1000, 1001) / 1000.0); }

  void word(char letter, double value, int decimals = 3) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, " %c%.*f", letter, decimals, value);
    text_ += buffer;
  }

  void line(const char* code) {
    text_ += code;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      if (draws_.any(0, 3) == 0) continue;
      at_[axis] = moved(at_[axis]);
      word("XYZA"[axis], at_[axis]);
    }
    text_ += '\n';
  }

  void dwell() {
    text_ += "G4";
    word('P', draws_.any(0, 200) / 1000.0);
    text_ += '\n';
  }

  void feed() { text_ += 'F' + std::to_string(draws_.any(30, 12000)) + '\n'; }

  void plane() {
    plane_ = draws_.any(std::size_t{0}, std::size_t{3});
    text_ += "G" + std::to_string(17 + plane_) + '\n';
  }

  void inverse_time() {
    text_ += "G93 G1";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at_[axis] = rounded(at_[axis] + 1 + size());
      word("XYZ"[axis], at_[axis]);
    }
    const std::string feed_behind = std::to_string(draws_.any(60, 9000));  // drawn first
    text_ += " F" + std::to_string(draws_.any(5, 200)) + "\nG94 F" + feed_behind + '\n';
  }

  /// An arc from here through some angle about a centre not far away, its end rounded as a CAM rounds it.
  void arc() {
    const std::size_t first = std::array<std::size_t, 3>{0, 2, 1}[plane_],
                      second = std::array<std::size_t, 3>{1, 0, 2}[plane_];
    const std::size_t normal = 3 - first - second;
    const bool is_flat = draws_.any(0, 6) == 0;
    const double radius = is_flat ? draws_.logarithmic(300, 9e4) : std::max(0.02, size());
    const double from = draws_.any(0, 6283) / 1000.0;
    const double i = rounded(radius * numeric::cos(from)), j = rounded(radius * numeric::sin(from));
    const bool clockwise = draws_.either(), whole = !is_flat && draws_.any(0, 5) == 0;
    const double sweep = is_flat ? draws_.any(300, 6000) / 100.0 / radius : draws_.any(300, 6000) / 1000.0;
    text_ += clockwise ? "G2" : "G3";
    if (!whole) {
      const double begin = numeric::atan2(-j, -i), angle = begin + (clockwise ? -sweep : sweep),
                   r = numeric::hypot(i, j);
      at_[first] = rounded(at_[first] + i + r * numeric::cos(angle));
      at_[second] = rounded(at_[second] + j + r * numeric::sin(angle));
      word("XYZ"[first], at_[first]);
      word("XYZ"[second], at_[second]);
    }
    if (draws_.any(0, 2) == 0) {
      at_[normal] = moved(at_[normal]);
      word("XYZ"[normal], at_[normal]);
    }
    if (draws_.any(0, 4) == 0) {
      at_[3] = moved(at_[3]);
      word('A', at_[3]);
    }
    word("IJK"[first], i);
    word("IJK"[second], j);
    if (!is_flat && draws_.any(0, 4) == 0) text_ += " P" + std::to_string(draws_.any(1, 4));
    text_ += '\n';
  }

  /// G6.2 from here, of degree 2 to 4, with knots that may coincide and weights other than 1. Its control points go
  /// round in a wavy way: a cusp is as good as impossible. Some turn A besides, and some stand still in X and Y
  /// meanwhile.
  void nurbs() {
    const int order = draws_.any(3, 6), points = order + draws_.any(0, 8);
    const double size = draws_.one_of({0.5, 5.0, 40.0}), step = draws_.any(20, 100) / 100.0;
    std::vector<double> knots(static_cast<std::size_t>(order), 0.0);
    for (int k = order, alike = order; k < points; ++k) {
      const double step_up = alike + 1 < order ? draws_.one_of({0.0, 0.5, 1.0, 1.0, 2.5}) : 1.0;
      alike = step_up == 0 ? alike + 1 : 1;
      knots.push_back(knots.back() + step_up);
    }
    const double last = knots.back() + 1;
    knots.resize(static_cast<std::size_t>(points + order), last);
    text_ += "G6.2 P" + std::to_string(order);
    const double x = at_[0], y = at_[1], turn = draws_.once_in(3) ? small_size() : 0;  // of A, degrees a point
    const bool stands = turn > 0 && draws_.any(0, 2) == 0;
    for (int k = 0; k < points; ++k) {
      word('K', knots[static_cast<std::size_t>(k)]);
      const double radius = size * (1 + draws_.any(-100, 101) / 1000.0), angle = k * step;
      if (k == 0 || !stands || k <= points / 2) {
        at_[0] = k == 0 ? x : rounded(x + radius * numeric::cos(angle) - size);
        at_[1] = k == 0 ? y : rounded(y + radius * numeric::sin(angle));
      }
      word('X', at_[0]);
      word('Y', at_[1]);
      if (turn > 0) {
        if (k > 0) at_[3] = rounded(at_[3] + turn * (1 + draws_.any(-100, 101) / 1000.0));
        word('A', at_[3]);
      }
      if (k > 0 && draws_.any(0, 3) == 0) word('R', draws_.any(500, 2000) / 1000.0);
      text_ += '\n';
    }
    for (std::size_t k = static_cast<std::size_t>(points); k < knots.size(); ++k) {
      word('K', knots[k]);
      text_ += '\n';
    }
  }

  /// G5 from here, and another that goes on in its direction.
  void cubic() {
    text_ += "G17\n";
    plane_ = 0;
    const double size = draws_.one_of({0.5, 5.0, 40.0});
    const auto side = [&] { return rounded(size * draws_.any(200, 1001) / 1000.0); };
    for (int k = 0; k < 2; ++k) {
      text_ += "G5";
      if (k == 0) word('I', side()), word('J', side());
      word('P', -side());
      word('Q', -side());
      at_[0] = rounded(at_[0] + 2 * size + side());
      at_[1] = rounded(at_[1] + side());
      word('X', at_[0]);
      word('Y', at_[1]);
      text_ += '\n';
    }
  }

  /// Lines that do not turn, some with a feed of their own, some with A.
  void straight_on() {
    const double turn = draws_.once_in(4) ? rounded(small_size()) : 0;
    const std::array<double, 3> step = {rounded(small_size()), rounded(small_size() / 2), 0.008};
    for (int k = draws_.any(2, 6); k > 0; --k) {
      const int times = draws_.any(1, 4);
      text_ += "G1";
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at_[axis] = rounded(at_[axis] + times * step[axis]);
        word("XYZ"[axis], at_[axis]);
      }
      if (turn > 0) {
        at_[3] = rounded(at_[3] + times * turn);
        word('A', at_[3]);
      }
      if (draws_.any(0, 3) == 0) text_ += " F" + std::to_string(draws_.any(300, 9000));
      text_ += '\n';
    }
  }

  /// Quarters of one circle, whose curvature goes on from one to the next.
  void parts_of_a_circle() {
    text_ += "G17\n";
    plane_ = 0;
    const double radius = rounded(std::max(0.1, small_size()));
    std::array<double, 2> arm = {-radius, 0};  // from the centre
    for (int k = draws_.any(2, 7); k > 0; --k) {
      const std::array<double, 2> next = {-arm[1], arm[0]};
      text_ += "G3";
      at_[0] = rounded(at_[0] - arm[0] + next[0]);
      at_[1] = rounded(at_[1] - arm[1] + next[1]);
      word('X', at_[0]);
      word('Y', at_[1]);
      word('I', -arm[0]);
      word('J', -arm[1]);
      text_ += '\n';
      arm = next;
    }
  }

  Draws& draws_;
  std::optional<Kind> kind_;
  std::string text_;
  std::array<double, 4> at_{};
  std::size_t plane_ = 0;
};

}  // namespace leadscrew::campaign
