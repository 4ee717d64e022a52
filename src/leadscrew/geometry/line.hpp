#pragma once
// The straight segment.

#include <leadscrew/geometry/point.hpp>
#include <vector>

namespace leadscrew::geometry {

class Line {
 public:
  /// From start to end, by a length > 0 of the caller's choice.
  Line(const Point& start, const Point& end, double length)
      : start_(start), end_(end), length_(length), slopes_(start, end, length) {}

  double length() const { return length_; }
  const Point& start() const { return start_; }
  const Point& end() const { return end_; }
  const Slopes& slopes() const { return slopes_; }

  Point evaluate(numeric::DoubleDouble s) const;
  UnroundedPoint evaluate_unrounded(numeric::DoubleDouble s) const;
  PointJet jets(double s) const;
  Rates rates(double s, std::size_t first) const;
  /// As geometry::append_shape() has it.
  void append_shape(std::vector<double>& numbers) const;
  /// What lies between two path lengths, 0 ≤ from < to ≤ length.
  Line part(double from, double to) const;

 private:
  Point start_;
  Point end_;
  double length_;
  Slopes slopes_;
};

}  // namespace leadscrew::geometry
