#pragma once
// How far a triangle is from a part of a tool, and where it reaches deepest into it.
//
// A part is its core, all within a = R − r of the axis above the height b = bottom + r, made thicker by r. With ρ the
// distance from the axis and z the height above the tip, the signed distance of a place from the core is
//
//                 hypot(max(ρ − a, 0), max(b − z, 0))      outside
//     g(ρ, z) =
//                 max(ρ − a, b − z)                        inside
//
// and g − r that from the part: below 0 inside, by the distance to the part's surface. The core is convex, and so is g: on a
// flat facet it has one least value, which is
//
//     where the facet's plane has its least, in closed form, if that lies inside the facet      (facet test)
//     else on an edge that faces that place, where it is a convex function of one parameter     (edge test)
//     or at an edge's end                                                                       (vertex test)
//
// r = R is a ball, whose core is a ray; r = 0 a flat cylinder, which is its own core; all between are bull noses.

#include <leadscrew/gouging/tool.hpp>
#include <span>

namespace leadscrew::gouging {

/// Of a place from a part, without its upper end.
struct SignedDistance {
  double value = 0;  ///< mm; < 0 inside
  double by_rho = 0;
  double by_z = 0;  ///< derivatives; where there is none, one of those that there are beside
};

/// rho: distance from the axis, z: height above the tip, mm. As though the part went up without end.
SignedDistance signed_distance(const Part& part, double rho, double z);

/// Coordinates of a tool: the tip at 0, the axis along z.
class ToolFrame {
 public:
  explicit ToolFrame(const Pose& pose);

  Vector to_tool(const Vector& place) const;
  Vector from_tool(const Vector& place) const;

 private:
  Vector tip_{}, x_{}, y_{}, z_{};
};

/// The place of a facet that reaches deepest into a part, or comes nearest to it.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();  ///< mm; < 0: so deep inside
  Vector place{};
};

/// A convex, flat polygon of three vertices or more in coordinates of the tool; it may be as thin as a line. Right to 1e-9 mm
/// where it is less than `bound`; else anything from `bound` on. The part is taken as though it went up without end.
Nearest nearest_of_polygon(const Part& part, std::span<const Vector> polygon, double bound);

/// The same of a triangle and the part as it is. What lies above its top counts no less than 0, nor than its height above the
/// top, and has no place.
Nearest nearest_of_triangle(const Part& part, const std::array<Vector, 3>& triangle, double bound);

}  // namespace leadscrew::gouging
