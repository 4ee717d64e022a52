#pragma once
// Curves by arc length: what a path is made of.
//
// A curve is q(s), 0 ≤ s ≤ length, in the space of nine coordinates, each at its own constant or varying rate along s.
// The length is the caller's: the length of the tool tip's way where it moves, else of what moves (see gcode::Feed).
// Each kind has
//
//   evaluate(s)  the position, s in double-double, rounded once: within one unit in the last place of the largest
//                coordinate that the curve reaches; a NURBS curve's within a few. At s ≤ 0 and s ≥ length it is the
//                start and the end, exactly.
//   jets(s)      the position and three derivatives by s, for whoever plans speed along it.

#include <array>
#include <leadscrew/geometry/arc.hpp>
#include <leadscrew/geometry/line.hpp>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/point.hpp>
#include <span>
#include <variant>

namespace leadscrew::geometry {

using Curve = std::variant<Line, Arc, Nurbs>;

inline double length(const Curve& curve) {
  return std::visit([](const auto& kind) { return kind.length(); }, curve);
}
inline const Point& start(const Curve& curve) {
  return std::visit([](const auto& kind) -> const Point& { return kind.start(); }, curve);
}
inline const Point& end(const Curve& curve) {
  return std::visit([](const auto& kind) -> const Point& { return kind.end(); }, curve);
}
inline Point evaluate(const Curve& curve, numeric::DoubleDouble s) {
  return std::visit([&](const auto& kind) { return kind.evaluate(s); }, curve);
}
inline PointJet jets(const Curve& curve, double s) {
  return std::visit([&](const auto& kind) { return kind.jets(s); }, curve);
}
/// Path lengths strictly inside, increasing, at which the third derivative jumps; the first two are continuous.
inline std::span<const double> breaks(const Curve& curve) {
  const auto* nurbs = std::get_if<Nurbs>(&curve);
  return nurbs ? nurbs->breaks() : std::span<const double>();
}

}  // namespace leadscrew::geometry
