#pragma once
// How far a path of the tool's tip leads the machine's linear axes: it goes straight or round where the axes do not.
//
// With p(t) the tip, θ(t) the rotary axes, both over 0 ≤ t ≤ 1, an axis is q = R(θ)(p − …) − …, so that its second
// derivative is at most
//
//     |q″| ≤ w²ρ + 2w|p′| + |p″|        w = Σ|θ′|,  ρ: all that is turned, put end to end
//
// and between two places h apart no axis is beyond both by more than |q″| h²/8. Stretches whose bound comes beyond a limit
// are halved until an end of them is beyond it, or the bound says no more than travel_resolution.

#include <array>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/kinematics/transformation.hpp>

namespace leadscrew::gcode {

/// How exactly an axis is judged against its limit between the ends of a block, mm; curves, and what touches a limit for
/// long, a little less so.
inline constexpr double travel_resolution = 1e-5;

/// Of a block: straight, or round a circle of a plane and straight in all other coordinates.
struct TipPath {
  base::AxisVector from{}, to{};  ///< of the tip, mm, and the rotary axes, degrees
  bool is_arc = false;
  Plane plane = Plane::XY;
  PlanePoint center;  ///< of an arc, mm
  double turned = 0;  ///< of an arc, radians, counterclockwise
};

/// The least and the greatest coordinate of X, Y and Z, where they are beyond the limits; those where they are not.
struct AxesReach {
  std::array<double, 3> low{}, high{};  ///< mm
};

AxesReach axes_reach(const kinematics::Transformation& transformation, const TipPath& path, const base::AxisVector& low,
                     const base::AxisVector& high);

/// The same of a curve, as 64 places of each of its spans and parabolas through them tell it.
AxesReach axes_reach(const kinematics::Transformation& transformation, const NurbsCurve& curve,
                     const base::AxisVector& low, const base::AxisVector& high);

}  // namespace leadscrew::gcode
