#pragma once
// From a place of the triangles to one of the surface: the least distance of a part of a tool near there.
//
// f(u, v) = g(S(u, v)) is least where its gradient vanishes. Newton's method, with the second derivatives
//
//     f_ij = ∇g·S_ij + S_iᵀ H S_j        H: curvature of the surfaces of equal distance, that about the axis g_ρ/ρ, that of
//                                        the corner 1/(g's distance from the core)
//
// takes few steps; where g has a bend, as at the edge of a flat tool that is inside the surface, it does not, and a search in
// shrinking steps along eight directions follows.

#include <leadscrew/gouging/tool.hpp>
#include <leadscrew/surfaces/surface.hpp>

namespace leadscrew::gouging {

/// On a surface.
struct RefinedPlace {
  double distance = 0;  ///< mm
  double u = 0, v = 0;
  Vector place{};  ///< mm
};

/// From u, v, which are right to about `size` in either parameter. What lies above the part's top counts by its height.
RefinedPlace nearest_on(const surfaces::Surface& surface, const Part& part, const Pose& pose, double u, double v,
                        const std::array<double, 2>& size);

}  // namespace leadscrew::gouging
