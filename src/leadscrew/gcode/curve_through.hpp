#pragma once
// A smooth curve through given places: the cubic spline with continuous second derivative (de Boor, "A Practical Guide to
// Splines", IV and XIII; not-a-knot ends).

#include <leadscrew/gcode/move.hpp>
#include <vector>

namespace leadscrew::gcode {

/// Makes the curve that is at places[i] at the parameter parameters[i], in all axes: of degree 3, or less where there are
/// fewer than four places. Parameters increase strictly from 0 to 1; 2 … most_control_points places. Coordinates that are
/// proportional to the parameter stay so.
void make_curve_through(NurbsCurve& curve, const std::vector<double>& parameters,
                        const std::vector<base::AxisVector>& places);

}  // namespace leadscrew::gcode
