#pragma once
// The interface between a path and the axes that travel it: positions of all axes as a function of path length. Whoever
// plans, interpolates or goes back asks a piece for it (Piece::axes()) and never takes coordinates of a curve for
// positions of axes.
//
// On a Cartesian machine the two are the same, and everything here is inline and passes through. Under tool centre point
// control the curve is that of the tool's tip in the workpiece and of the rotary axes; the kinematics of the machine lies
// between them, pushing positions and jets through one formula: here, and nowhere else.

#include <cstddef>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::toolpath {

/// Of one piece, which must outlive it. Path length runs from 0 to length().
class AxisPath {
 public:
  /// transformation: between the curve's coordinates and the axes; may be nullptr: they are the same.
  explicit AxisPath(const geometry::Curve& curve, const kinematics::Transformation* transformation = nullptr)
      : curve_(curve), transformation_(transformation) {}

  double length() const { return geometry::length(curve_); }
  geometry::Point start() const { return axes_of(geometry::start(curve_)); }
  geometry::Point end() const { return axes_of(geometry::end(curve_)); }
  /// mm or degrees, rounded once; at s ≤ 0 and s ≥ length the start and the end, exactly. For the cycle: takes no
  /// memory.
  geometry::Point position(numeric::DoubleDouble s) const {
    return transformation_ ? transformation_->axes_of(geometry::evaluate_unrounded(curve_, s))
                           : geometry::evaluate(curve_, s);
  }
  /// Positions and three derivatives by path length.
  geometry::PointJet jets(double s) const { return axes_of(geometry::jets(curve_, s)); }
  /// Path lengths strictly inside, increasing, at which the third derivative jumps; the first two are continuous.
  /// Valid as long as the path's curve.
  std::span<const double> breaks() const { return geometry::breaks(curve_); }
  /// Those of them between two path lengths, from which they are farther than rounding, 1e-12 of the path's length.
  std::span<const double> breaks(double from, double to) const;
  /// How many polynomials there are from one path length to another, 0 ≤ from ≤ to ≤ length, less one: between two of
  /// them derivatives may have peaks anywhere. A part of a turn counts as one more.
  std::size_t borders(double from, double to) const;
  /// Axes that may move somewhere on the path; derivatives of the others are 0.
  base::AxisSet moving() const;
  /// Calls visit(Nurbs::Border) for every border of a table of arc length from one path length to another, 0 ≤ from ≤ to ≤
  /// length; its step is one of the axes' derivatives, too, under a transformation.
  template <typename Visit>
  void each_table_border(double from, double to, const Visit& visit) const {
    const geometry::Nurbs* const nurbs = std::get_if<geometry::Nurbs>(&curve_);
    const std::size_t count = nurbs ? nurbs->map_borders(from, to) : 0;
    for (std::size_t k = 0; k < count; ++k) visit(nurbs->map_border(from, k));
  }

  /// Where every axis goes straight, or two of them round a circle at constant rate and the others straight; else none.
  /// For closed forms.
  const geometry::Line* line() const { return transformation_ ? nullptr : std::get_if<geometry::Line>(&curve_); }
  const geometry::Arc* arc() const { return transformation_ ? nullptr : std::get_if<geometry::Arc>(&curve_); }

  /// For published rules that step the parameter u of a NURBS curve instead of its length: that curve; else none.
  const geometry::Nurbs* nurbs() const { return transformation_ ? nullptr : std::get_if<geometry::Nurbs>(&curve_); }
  /// Positions at a parameter of nurbs(), which must not be none. For the cycle: takes no memory.
  geometry::Point position_at_parameter(double u) const {
    const geometry::PointJet jets = nurbs()->jets_at(u);
    geometry::Point position;
    for (std::size_t i = 0; i < position.size(); ++i) position[i] = jets[i].value;
    return position;
  }

 private:
  template <typename T>
  kinematics::Coordinates<T> axes_of(const kinematics::Coordinates<T>& path) const {
    return transformation_ ? transformation_->axes_of(path) : path;
  }

  const geometry::Curve& curve_;
  const kinematics::Transformation* transformation_;
};

/// The same path in the axes' own coordinates, where no rotary axis of the chain turns on the curve, a curve of the tip and
/// of those axes; nothing where one does, and where an arc would lie askew of the machine's planes.
std::optional<geometry::Curve> standing_curve(const kinematics::Transformation& transformation,
                                              const geometry::Curve& curve);

}  // namespace leadscrew::toolpath
