#pragma once
// How far apart two passes may lie so that the ridge between them is no higher than h.
//
//        ╲          ╱╲          ╱           the section across the passes, tool round with R_e, surface round with ρ:
//         ╲   R_e  ╱  ╲  R_e   ╱            g is the arc on the surface between the two contacts, h the ridge's height above it
//      ────`-.__.-'────`-.__.-'──── S
//              |─── g ───|
//
//     plane             g = 2 √(h (2 R_e − h))
//     convex (s = 1) and concave (s = −1), ρ = 1/|κ|, D = ρ + s R_e, t = ρ + s h:
//                       g = 2 ρ arccos((D² + t² − R_e²)/(2 D t))
//
// √(8 R_e h) of the textbooks leaves more than h.

#include <leadscrew/surfaces/cutter.hpp>

namespace leadscrew::surfaces {

/// mm on the surface. radius: R_e, mm, > 0 or infinite; curvature: across the pass, 1/mm, positive where the surface is concave
/// to the tool, less than 1/R_e; height: h, mm, > 0. Never more than the tool's diameter 2 R_e, nor half a turn about ρ. Infinite where both are
/// flat.
double step_over(double radius, double curvature, double height);
/// The height, mm, that is left by a step; the radius where passes do not meet.
double scallop_height(double radius, double curvature, double step);

/// Half a step, as an arc of the surface on one side of the pass (1: that of b, −1: the other), of a tool that is no ball, with the whole
/// outline of its swept shape for the circle of R_e. axis: by f, b, n, a unit vector, n ≥ 0; surface: its curvature by f and b. Seen
/// along f, the tool is the disc about which its edge is round, and a disc of radius r about each of its points: where it is
/// met in the direction w = (0, sin ψ, −cos ψ) it is at
///
///     P(ψ) = (R − r) (w − (w·O) O)/|w − (w·O) O| + r w
///
/// which passes the section while the tool touches at P_f before it: there the surface is K_ff P_f²/2 + K_fb P_f P_b higher. What the
/// tool leaves is no more than that: it may be lower at other places of the tool.
double outline_arc(const Cutter& cutter, const Vector& axis, const Tensor& surface, double height, double side);

}  // namespace leadscrew::surfaces
