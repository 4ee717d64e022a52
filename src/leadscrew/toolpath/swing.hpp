#pragma once
// The blend of a corner between two lines that uses both sides of the tolerance: it swings wide before the corner, cuts
// it, and swings wide behind it.
//
//            .--.
//    A -----'    `.  V       q(u) = V − c p(1 − u) t_A + c p(u) t_B,   p(u) = −u³ + 2 (u − w)₊³,   0 ≤ u ≤ 1,
//                  ╲
//                   |        p‴ is −6 up to w and 6 behind: of least time where jerk is what limits each axis, one
//                   .'       sign, then the other. p falls to −(6 + 4√2) w³ at u = (2 + √2) w, on the outer side,
//                  |         and is 0, with two derivatives, where the blend joins its line.
//                  B
//
// Its Fréchet distance from the corner is no more than c times the greater of (6 + 4√2) w³ sin θ, how far it swings from
// the line, θ the turn, and p(½) |t_A − t_B|, how far it passes the corner: up to u = ½ each place is matched to its
// foot on the first line, which lies before the corner and moves on as −p(1 − u) + p(u) cos θ does; at u = ½ the place
// is matched to all between its feet on both. w makes the two equal:
//
//     (6 + 4√2) w³ cos(θ/2) = p(½) = 2 (½ − w)³ − 1/8,   0.093 < w < 0.104.
//
// With w = 0 this is the blend that cuts the corner only (corner.hpp). It is an eighth as long and slower: at a corner
// of 90° and 10 µm by 2 to 13 ms at 1000 mm/s² and 20 000 mm/s³, as the axes lie.

#include <array>

namespace leadscrew::toolpath {

/// For |t_A − t_B| = 2 sin(θ/2), 0 < turn < 2.
class Swing {
 public:
  explicit Swing(double turn);

  double w() const { return w_; }
  /// Fréchet distance from the corner, for c = 1.
  double deviation() const { return deviation_; }
  /// Length of the line that is replaced on each side, for c = 1.
  double reach() const;
  /// The same for the c that a margin allows, in its unit.
  double reach_within(double margin) const { return margin / deviation_ * reach(); }
  /// Values of p at the control points of the cubic B-spline with the knots 0 0 0 0 w 1−w 1 1 1 1; from the last to the
  /// first those of p(1 − u).
  std::array<double, 6> control_values() const;

 private:
  double w_ = 0;
  double deviation_ = 0;
};

}  // namespace leadscrew::toolpath
