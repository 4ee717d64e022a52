#pragma once
// The arithmetic of curves as the reader needs it: knots, clamped ends, and how far a curve reaches (Piegl and Tiller,
// "The NURBS Book", 2nd edition).
//
//         P1 ·········· P2             The curve lies in the hull of its control points, here below the limit's line or
//           :  _-----_  :    limit     not: where a control point is beyond the limit, the curve is cut into Bézier
//     ------:-´-------`-:---------     pieces and these into halves, whose hulls close in on it, until one of their
//           : /         \:             ends is beyond or all of their control points are inside.
//          P0            P3

#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/move.hpp>

namespace leadscrew::gcode {

/// The least and the greatest weight of a control point: rational arithmetic keeps its digits between them.
inline constexpr double least_weight = 1e-9;
inline constexpr double greatest_weight = 1e9;

/// Gives the curve, of degree p and with n > p points, the knots of LinuxCNC's G5.2: 0 (p + 1 times), 1, 2 … n − p − 1,
/// n − p (p + 1 times).
void set_uniform_knots(NurbsCurve& curve);

/// Makes the curve that goes with an arc, of a plane, from start to end about a centre of the plane, with turns as Move
/// has them, in the coordinates of these: rational pieces of degree 2 of at most 30 degrees (Piegl and Tiller, 7.3),
/// exact in the plane. Axes outside the plane go as the angle to within arc_curve_tolerance. False where that takes more
/// than most_control_points.
inline constexpr double arc_curve_tolerance = 1e-5;  // mm or degrees
bool make_arc_curve(NurbsCurve& curve, Plane plane, const base::AxisVector& start, const base::AxisVector& end,
                    PlanePoint center, int turns);

/// What is wrong with the knot that came last.
enum class KnotProblem {
  none,
  decreases,  ///< it is less than the one before
  repeats,    ///< it stands more than p times within the curve, or more than p + 1 times at an end
};

/// Judges the last of the knots so far. The points may be incomplete while each comes with its knot: `all_points` says
/// that they are not.
KnotProblem judge_last_knot(const NurbsCurve& curve, bool all_points);

/// Whether the parameter has a range, u_p < u_n, and neighbouring knots are equal or at least 1e-12 of it apart. The
/// curve is complete.
bool knots_are_apart(const NurbsCurve& curve);

/// Makes u_p the first knot and u_n the last, p + 1 times each, by knot insertion (eq. 5.15); the curve stays what it
/// is. Where its ends are clamped already, nothing changes. Its knots have been judged.
void clamp_ends(NurbsCurve& curve);

/// How exactly a curve is judged against a limit, mm or degrees.
inline constexpr double reach_resolution = 1e-6;

/// The greatest coordinate of the curve along an axis (sign +1), or the least (sign −1), where it is beyond `limit`, to
/// within reach_resolution or a few units in the last place; `limit` where the curve is not beyond it by more.
double reach_beyond(const NurbsCurve& curve, base::Axis axis, int sign, double limit);

}  // namespace leadscrew::gcode
