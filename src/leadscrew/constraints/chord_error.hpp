#pragma once
// The chord between two words departs from the path by ε = (VT)²/8ρ (Lin and Koren, eq. 3), V the speed, T the servo
// period, ρ the radius of curvature: x ≤ 8ερ/T². ε is the machine's chord error; along a curve that stands for what was
// programmed within a tolerance, what the curve leaves of it, if that is more. A demand on the words, not on the machine:
// it is kept where speed is planned, but neither proven between knots nor counted by what bounds time.

#include <algorithm>
#include <cstddef>
#include <leadscrew/constraints/row.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string_view>

namespace leadscrew::constraints {

class ChordError {
 public:
  using Row = SquareRow;
  static constexpr std::string_view name = "chord error";
  static constexpr bool is_of_axes = false, is_proven = false, is_smooth = true;

  explicit ChordError(const machine::Machine& machine)
      : chord_error_(machine.chord_error), period_(machine.period.seconds()) {}

  template <typename Take>
  void rows(const Place& at, const Take& take) const {
    const double bend = at.chords.bend ? *at.chords.bend : geometry::tip_curvature(at.jet);
    const double allowed = std::max(chord_error_, at.chords.sagitta);
    take(0, SquareRow{8 * allowed / (bend * period_ * period_)});  // infinite where the path is straight
  }

 private:
  double chord_error_;  // mm
  double period_;       // s
};

}  // namespace leadscrew::constraints
