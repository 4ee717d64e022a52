#pragma once
// The circle of an arc from what a block says of it: a centre that may be slightly off, or a radius.
//
//            end ·  .
//             │      `.
//     ─ ─ c' ─┼─ ─ ─ ─ ·     perpendicular bisector of start and end
//          c  │      .´
//          start ·  ´
//
// Rounded coordinates put the programmed centre c off the bisector, and its distances r₁ and r₂ to start and end
// differ. The nearest point c' of the bisector is the centre of a circle through both: that circle is the arc. With d
// from start to end, |c' − c| = |r₁² − r₂²|/2d.
//
// Where an arc of more than half a turn nearly closes, d is small and c' would lie far from c. Such an arc keeps its
// centre and ends where its circle comes closest to the programmed end; a line leads on to that end.

#include <leadscrew/gcode/move.hpp>

namespace leadscrew::gcode {

/// A point of the plane: coordinates along first_axis and second_axis, mm.
struct PlanePoint {
  double first = 0;
  double second = 0;
};

/// A position seen in the plane.
inline PlanePoint in_plane(const base::AxisVector& position, Plane plane) {
  return {position[base::index(first_axis(plane))], position[base::index(second_axis(plane))]};
}

/// How far the radii at both ends may differ: `absolute`, or beyond it `relative` of the greater radius, but never
/// `most`. LinuxCNC: 2√2·0.01 mm (2√2·0.001 inch under G20), 0.1 %, and 100 times the first. An R word may be short of
/// half the distance of the ends by `radius` (0.00005 inch).
struct ArcTolerance {
  double absolute = 0;  ///< mm
  double relative = 0.001;
  double most = 0;                 ///< mm
  double radius = 0.00005 * 25.4;  ///< mm
};

constexpr ArcTolerance arc_tolerance(bool inches) {
  const double absolute = 2 * 1.4142135623730951 * (inches ? 0.001 * 25.4 : 0.01);
  return {.absolute = absolute, .most = 100 * absolute};
}

struct ArcCircle {
  enum class Problem { none, zero_radius, radii_differ, radius_too_small, ends_coincide };
  Problem problem = Problem::none;
  double difference = 0;  ///< mm; of the radii, or by which the radius is too small
  PlanePoint center;
  PlanePoint end;     ///< of the arc: the programmed one, unless a line must lead on to it
  double radius = 0;  ///< mm; from the arc's start to the centre; 0 where there is a problem
};

/// The circle with its centre at or near `center`. `direction`: +1 counterclockwise (G3), −1 clockwise (G2); `turns`
/// ≥ 1.
ArcCircle circle_by_center(PlanePoint start, PlanePoint end, PlanePoint center, int direction, int turns,
                           const ArcTolerance& tolerance);

/// The circle of this radius, mm: positive for the arc of up to half a turn, negative for the longer one.
ArcCircle circle_by_radius(PlanePoint start, PlanePoint end, double radius, int direction,
                           const ArcTolerance& tolerance);

/// Radians from start to end about the centre in the direction of the arc, in (0, 2π]: a whole turn where they
/// coincide.
double sweep(PlanePoint start, PlanePoint end, PlanePoint center, int direction);

/// The least box of the plane around an arc of |turns| ≥ 1.
struct PlaneBox {
  PlanePoint low;
  PlanePoint high;
};
PlaneBox arc_extent(PlanePoint start, PlanePoint end, PlanePoint center, int turns);

}  // namespace leadscrew::gcode
