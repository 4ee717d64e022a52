#pragma once
// The curves of the experiments, as curves and as part programs.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <string>

namespace leadscrew::study {

/// x = 20u, y = −50u³ + 80u² − 10u, 0 ≤ u ≤ 1 (mm): the plane cubic of Koren and Lin's real-time interpolator, as a
/// Bézier curve.
geometry::NurbsForm plane_cubic();

/// A part program and where it begins.
struct PartProgram {
  std::string text;
  base::AxisVector start{};    ///< machine coordinates, mm
  machine::ToolTable tools{};  ///< whose shapes surfaces need
};

/// A word of a block, such as " X1.25"; the number reads back bit for bit.
std::string word(char letter, double value);

/// The curve as one G6.2, in X and Y; feed in mm/s, > 0. Every number is written so that it reads back bit for bit.
PartProgram program_of(const geometry::NurbsForm& curve, double feed);

/// A full counterclockwise circle about the origin, from (radius, 0); radius in mm, feed in mm/s, both > 0.
PartProgram circle_program(double radius, double feed);

/// Smallest radius of curvature along the curve, mm: |C′|³/|C′ × C″| at 20001 places, refined by golden section
/// wherever they come near the smallest. Infinite where the curve is straight.
double min_radius(const geometry::Nurbs& curve);

/// Curvature where this jet (derivatives by any parameter) was taken, 1/mm, ≥ 0, in X Y Z.
double curvature(const geometry::PointJet& jet);

}  // namespace leadscrew::study
