#pragma once
// A surface as the blocks that define it in a program:
//
//     G6.4 D1 P4 Q4 I4 J4         surface 1: orders 4 and 4, 4 × 4 points
//     X0 Y0 Z0 R0.5 K0 L0         the first point, its weight where it is not 1, the first knots of u and v
//     …                           all points, u fastest; all knots, but where they are uniform_knots()

#include <leadscrew/surfaces/surface.hpp>
#include <string>

namespace leadscrew::surfaces {

/// Lines, each with its end, that are read back as the same surface to the last bit: numbers are written in mm, without
/// exponents, with as many digits as they need. Of a form that has no fault. number: by which it is machined, D; ≥ 0.
std::string definition_text(const SurfaceForm& form, int number);

}  // namespace leadscrew::surfaces
