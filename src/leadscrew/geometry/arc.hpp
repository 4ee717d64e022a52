#pragma once
// The circular arc and the helix: a circle in two coordinates, straight in all others.
//
//     ^ second        q_first  = c_first  + x cos θ − y sin θ        θ = sweep · s / length
//     |  .-""-. start q_second = c_second + x sin θ + y cos θ        (x, y) = start − centre
//     | /   c--x
//     | \     /y      so that q′ = ω R n(θ), q″ = −ω² R …, with ω = sweep / length
//     +----------> first

#include <cstddef>
#include <leadscrew/geometry/point.hpp>
#include <vector>

namespace leadscrew::geometry {

class Arc {
 public:
  /// Turns the start about the centre (in the coordinates `first` and `second`) through an angle `sweep` (radians,
  /// counterclockwise from first to second positive, not 0) while the other coordinates go straight to the end. The end
  /// should lie on the circle; what it is off (a few units in the last place, by rounding) is spread evenly along the
  /// arc. length > 0.
  Arc(const Point& start, const Point& end, std::size_t first, std::size_t second, double center_first,
      double center_second, numeric::DoubleDouble sweep, double length);

  double length() const { return length_; }
  const Point& start() const { return start_; }
  const Point& end() const { return end_; }

  Point evaluate(numeric::DoubleDouble s) const;
  UnroundedPoint evaluate_unrounded(numeric::DoubleDouble s) const;
  PointJet jets(double s) const;
  Rates rates(double s, std::size_t first) const;
  /// As geometry::append_shape() has it.
  void append_shape(std::vector<double>& numbers) const;
  /// What lies between two path lengths, 0 ≤ from < to ≤ length.
  Arc part(double from, double to) const;

  std::size_t first() const { return first_; }
  std::size_t second() const { return second_; }
  double radius() const { return radius_; }             ///< mm
  double angle_rate() const { return rate_.hi.value; }  ///< ω = dθ/ds, rad per unit of length, signed
  /// Radians, signed as the constructor's.
  numeric::DoubleDouble sweep() const {
    return numeric::DoubleDouble(rate_.hi.value, rate_.lo) * numeric::DoubleDouble(length_);
  }
  const Slopes& slopes() const { return slopes_; }  ///< of the straight coordinates

  /// What turned() is made of, for kernels that make many positions at once with the same operations.
  struct Turn {
    double start_first, start_second, center_first, center_second;
    Rate x, y;                           ///< start − centre
    Rate rate;                           ///< ω
    double defect_first, defect_second;  ///< per unit of length
  };
  Turn turn() const {
    return {start_[first_], start_[second_], center_first_, center_second_, x_, y_,
            rate_,          defect_first_,   defect_second_};
  }
  /// Below so many radians displacement is counted from the start, else from the centre.
  static constexpr double small_angle = 0.5;

  /// Length of a circular arc or a helix: √ of squares of radius·|sweep| in the plane and `rise` across it.
  static double helix_length(double radius, numeric::DoubleDouble sweep, double rise);

 private:
  struct Turned {
    numeric::Compensated first, second;
  };
  template <typename T>
  void go_along(std::array<T, base::axis_count>& position, numeric::DoubleDouble s) const;
  Turned turned(const SplitLength& s) const;

  Point start_;
  Point end_;
  std::size_t first_;
  std::size_t second_;
  double center_first_;
  double center_second_;
  Rate x_, y_;  ///< start − centre
  double radius_;
  double length_;
  Rate rate_;
  double defect_first_ = 0, defect_second_ = 0;  ///< end minus where the turn ends, per unit of length
  Slopes slopes_;
};

/// Angle of an arc from `from` to `to` (both seen from the centre), with `turns` begun turns, counterclockwise positive
/// (as gcode::Move::turns): in (0, 2π]·sign plus the whole turns. Coinciding ends make whole turns.
numeric::DoubleDouble sweep_angle(double from_first, double from_second, double to_first, double to_second, int turns);

}  // namespace leadscrew::geometry
