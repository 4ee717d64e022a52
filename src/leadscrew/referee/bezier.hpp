#pragma once
// A part of a rational curve as a Bezier segment, and what the referee asks of it.
//
// In homogeneous coordinates (wP, w) a rational segment is a polynomial one, and de Casteljau's algorithm with another
// argument on each level (the polar form; Ramshaw, "Blossoms are polar forms", 1989) gives its points and the control
// points of any part of it. Every bound here follows from the weights being positive:
//
//            P1 ────── P2        each point lies in the hull of the control points,
//           ╱  .·──·.   ╲        each tangent in the cone of the legs P0P1, P1P2, …,
//          ╱ .·      ·.  ╲       and the length between that of the chord P0P3 and that of the legs.
//        P0 ············· P3
//
// The cone: C' is a positive combination of all Pj − Pi, i < j (Floater, "Derivatives of rational Bezier curves",
// 1992).

#include <array>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/referee/metric.hpp>

namespace leadscrew::referee {

/// A point P of weight w > 0 in homogeneous coordinates.
struct Weighted {
  Point moment{};  ///< wP, mm
  double weight = 1;
};

/// C(t), 0 ≤ t ≤ 1.
struct Bezier {
  int degree = 0;  ///< 1 … gcode::highest_degree
  std::array<Weighted, gcode::highest_degree + 1> control;
};

/// (1 − x)·a + x·b, exact at both ends.
inline Weighted between(const Metric& metric, const Weighted& a, const Weighted& b, double x) {
  Weighted result;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) result.moment[i] = (1 - x) * a.moment[i] + x * b.moment[i];
  result.weight = (1 - x) * a.weight + x * b.weight;
  return result;
}

/// P, mm.
inline Point projected(const Metric& metric, const Weighted& weighted) {
  Point result{};
  for (std::size_t i = 0; i < metric.dimensions(); ++i) result[i] = weighted.moment[i] / weighted.weight;
  return result;
}

Point point_at(const Metric& metric, const Bezier& bezier, double t);

/// The part 0 ≤ from ≤ t ≤ to ≤ 1 as a segment of its own.
Bezier part(const Metric& metric, const Bezier& bezier, double from, double to);

/// Whether every tangent is within π/8 of the chord. Then no two differ by more than π/4, and the distance to a point
/// near the segment has one minimum. True of any segment shorter than a thousandth of a nanometre, as at a cusp.
bool turns_little(const Metric& metric, const Bezier& bezier);

/// Whether the control points differ by more than rounding.
bool has_length(const Metric& metric, const Bezier& bezier);

/// t of the nearest point of a segment that turns little.
double nearest_place(const Metric& metric, const Bezier& bezier, const Point& point);

/// The largest distance of the segment's points to the chord, mm, to a thousandth of a nanometre. Where it is no larger
/// than `negligible`, mm, any value up to that may be returned.
double farthest_from_chord(const Metric& metric, const Bezier& bezier, const Chord& chord, double negligible);

/// Coordinates of the metric in which a length is measured.
using Coordinates = std::array<bool, base::axis_count>;

/// Distance in these coordinates only, mm.
double distance_in(const Metric& metric, const Coordinates& coordinates, const Point& a, const Point& b);

/// Length in these coordinates, mm; relative error below 5e-5 for certain, about 1e-8 where the curve is smooth.
double length_in(const Metric& metric, const Coordinates& coordinates, const Bezier& bezier);

/// By how much segments that follow each other turn in these coordinates, at most: the sum of the angles between the
/// legs of their control polygons, radians.
class Turning {
 public:
  Turning(const Metric& metric, const Coordinates& coordinates) : metric_(metric), coordinates_(coordinates) {}

  void add(const Bezier& bezier);
  double sum() const { return sum_; }

 private:
  const Metric& metric_;
  const Coordinates& coordinates_;
  double sum_ = 0;
  Point direction_{};  // of the last leg; 0 before the first
};

}  // namespace leadscrew::referee
