#pragma once
// The blend of a corner: one spline that leaves the curve before and joins the curve behind with their tangents and
// curvatures. Between two lines that leave it enough room it swings wide (swing.hpp); elsewhere it is a quintic that cuts
// the corner.
//
//       ───A──╮             It has the position and two derivatives, at both ends, of the sum of both curves,
//              ╲
//               │               q(u) = A(L_A − d(1 − u)³) + B(d u³) − V,   0 ≤ u ≤ 1,
//               B
//               │           and between two lines it is that sum: what axes do whose constant jerk on one line fades
//                           out while that on the other fades in. It cuts the corner by d|t_A − t_B|/8.

#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/tube_spline.hpp>
#include <optional>
#include <span>

namespace leadscrew::toolpath {

struct Corner {
  geometry::Curve before, behind;  ///< meet at the corner
  /// Polylines that stand for what was programmed, to and from the corner, by the parameter of the curve (then a
  /// Nurbs); empty where the curve itself was.
  std::span<const Vertex> programmed_before, programmed_behind;
  double most_before = 0, most_behind = 0;  ///< of each curve's length that the blend may take; > 0
  bool may_swing = true;                    ///< wide, between lines
  geometry::MapTolerance tables = tables_for_motion;
  ToleranceSpace space{};
};

struct Blend {
  geometry::Nurbs curve;
  double before = 0, behind = 0;  ///< lengths that it takes the place of
  double corner = 0;              ///< of the curve's length: the share of the one before
  double deviation = 0;           ///< Fréchet distance from what was programmed, at most, mm
};

/// The longest blend found whose Fréchet distance from what was programmed is within `margin`, mm. None where the path
/// turns back, or where there is none worth it.
std::optional<Blend> blend(const Corner& corner, double margin);

}  // namespace leadscrew::toolpath
