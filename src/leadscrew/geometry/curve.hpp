#pragma once
// Curves by arc length: what a path is made of.
//
// A curve is q(s), 0 ≤ s ≤ length, in the space of nine coordinates, each at its own constant or varying rate along s.
// The length is the caller's: that of the tool tip's path where it moves, else of what moves (see gcode::Feed).
// Each kind has
//
//   evaluate(s)  the position, s in double-double, rounded once: within one unit in the last place of the largest
//                coordinate that the curve reaches; a NURBS curve's within a few. At s ≤ 0 and s ≥ length it is the
//                start and the end, exactly.
//   evaluate_unrounded(s)  the same, rounded it is evaluate(s): for whoever goes on from there.
//   jets(s)      the position and three derivatives by s, for whoever plans speed along it.
//   rates(s, first)  the first derivatives of three coordinates from `first` on, to the last bit as jets(s) has them.

#include <array>
#include <leadscrew/geometry/arc.hpp>
#include <leadscrew/geometry/line.hpp>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/point.hpp>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace leadscrew::geometry {

using Curve = std::variant<Line, Arc, Nurbs>;

/// std::visit for what always holds one of its kinds: nothing to throw, and no call through a table, so that what the
/// cycle reaches can be read from its machine code.
template <typename Visitor>
decltype(auto) visit(const Visitor& visitor, const Curve& curve) {
  if (const auto* line = std::get_if<Line>(&curve)) return visitor(*line);
  if (const auto* arc = std::get_if<Arc>(&curve)) return visitor(*arc);
  return visitor(*std::get_if<Nurbs>(&curve));
}

inline double length(const Curve& curve) {
  return geometry::visit([](const auto& kind) { return kind.length(); }, curve);
}
inline const Point& start(const Curve& curve) {
  return geometry::visit([](const auto& kind) -> const Point& { return kind.start(); }, curve);
}
inline const Point& end(const Curve& curve) {
  return geometry::visit([](const auto& kind) -> const Point& { return kind.end(); }, curve);
}
inline Point evaluate(const Curve& curve, numeric::DoubleDouble s) {
  return geometry::visit([&](const auto& kind) { return kind.evaluate(s); }, curve);
}
inline UnroundedPoint evaluate_unrounded(const Curve& curve, numeric::DoubleDouble s) {
  return geometry::visit([&](const auto& kind) { return kind.evaluate_unrounded(s); }, curve);
}
inline Rates rates(const Curve& curve, double s, std::size_t first) {
  return geometry::visit([&](const auto& kind) { return kind.rates(s, first); }, curve);
}
inline PointJet jets(const Curve& curve, double s) {
  return geometry::visit([&](const auto& kind) { return kind.jets(s); }, curve);
}
/// Path lengths strictly inside, increasing, at which the third derivative jumps; the first two are continuous. Valid as long as
/// the curve.
inline std::span<const double> breaks(const Curve& curve) {
  const auto* nurbs = std::get_if<Nurbs>(&curve);
  return nurbs ? nurbs->breaks() : std::span<const double>();
}
/// Coordinates that differ.
base::AxisSet moving(const Point& start, const Point& end);
/// Coordinates that move on the curve.
base::AxisSet moving(const Curve& curve);
/// How many polynomials the curve is made of from one path length to another, 0 ≤ from ≤ to ≤ length, less one.
inline std::size_t borders(const Curve& curve, double from, double to) {
  const auto* nurbs = std::get_if<Nurbs>(&curve);
  return nurbs ? nurbs->map_borders(from, to) : 0;
}
/// Appends all numbers that derivatives by arc length are computed from, the curve's length and kind among them: curves
/// with the same numbers have the same length, derivatives, breaks and borders to the last bit, wherever they lie.
void append_shape(const Curve& curve, std::vector<double>& numbers);
/// What lies between two path lengths, 0 ≤ from < to ≤ length, by the same length.
Curve part(const Curve& curve, double from, double to);
/// The curve turned and shifted, of the same length and as exact; nothing if it is an arc that would lie askew of X Y, Y Z
/// and Z X.
std::optional<Curve> moved(const Curve& curve, const RigidMotion& motion);

}  // namespace leadscrew::geometry
