#pragma once
// A programmed NURBS curve, cut into Bezier segments that turn little, one after the other.
//
// De Boor's algorithm in homogeneous coordinates, with another argument on each level, gives the control points of any
// part [a, b] of a knot span from the programmed ones: the polar form of the span at a … a, b … b (Ramshaw, "Blossoms
// are polar forms", 1989). So every segment comes from the programmed points in one go, and nothing accumulates over
// the halvings; all of its weights are convex, whatever the knots, clamped or not.

#include <cstdint>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/referee/bezier.hpp>
#include <vector>

namespace leadscrew::referee {

class Nurbs {
 public:
  explicit Nurbs(const Metric& metric) : metric_(metric) {}

  /// Takes another curve; false if it is none by the rules of gcode::NurbsCurve.
  bool begin(const gcode::NurbsCurve& curve);

  /// The next segment that has a length; false at the curve's end.
  bool next(Bezier& segment);

  /// Of the segment given out last, where the tool touches a surface: how much faster the tip goes than the contact, at most, to
  /// 1e-4; segments are so short that it does not change by more. 1 where feed is not the contact's.
  double tip_per_contact() const { return tip_per_contact_; }

  /// Length of the whole curve in these coordinates, mm.
  double length_in(const Coordinates& coordinates) const;

 private:
  Bezier segment_of(const std::vector<Weighted>& points, std::size_t span, double from, double to) const;
  bool is_even(const Bezier& segment, double to);
  bool next_span();
  std::size_t degree() const { return static_cast<std::size_t>(degree_); }

  const Metric& metric_;
  int degree_ = 0;
  std::vector<Weighted> points_;
  std::vector<Weighted> contact_;  // none where feed is the curve's own
  double tip_per_contact_ = 1;
  std::vector<double> knots_;

  std::size_t span_ = 0;      // knots_[span_] ≤ u ≤ knots_[span_ + 1]
  double at_ = 0;             // u up to which segments were given out
  std::vector<double> ends_;  // of what is left of the span, halved; the nearest last
};

}  // namespace leadscrew::referee
