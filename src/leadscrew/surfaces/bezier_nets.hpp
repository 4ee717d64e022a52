#pragma once
// A surface as Bezier patches, one a span: the same points for the same parameters, each inside the hull of its net.

#include <array>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::surfaces {

/// Of every span of a form that has no fault, v slowest: (p + 1) · (q + 1) points, u fastest, as x, y, z in mm and the weight,
/// which is above 0.
std::vector<std::vector<std::array<double, 4>>> bezier_nets(const SurfaceForm& form);

}  // namespace leadscrew::surfaces
