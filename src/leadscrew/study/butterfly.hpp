#pragma once
// The butterfly: a closed cubic NURBS curve in the plane, on which interpolators are commonly compared. Control points,
// weights and knots are those printed by Hu et al., "International Journal of Advanced Manufacturing Technology" 129
// (2023) 2843, doi 10.1007/s00170-023-12427-5. Millimetres in X and Y.

#include <leadscrew/geometry/nurbs.hpp>

namespace leadscrew::study {

geometry::NurbsForm butterfly();

/// Reference figures kept with the data.
inline constexpr double butterfly_length = 382.8596;    ///< mm
inline constexpr double butterfly_min_radius = 0.0231;  ///< mm, the smallest radius of curvature

}  // namespace leadscrew::study
