#pragma once
// From limits of axes to bounds along one piece, such that a rest-to-rest motion within the bounds keeps every axis
// inside.

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/rest_to_rest.hpp>
#include <leadscrew/toolpath/path.hpp>

namespace leadscrew::planner {

/// The fastest rest-to-rest motion found over the piece, which is a line or an arc: exactly the optimum on a line; on
/// an arc or helix the best of a search over bounds, every candidate scaled in time until its proven worst case meets
/// the limits.
///
/// With q_i the straight axes (rate m_i) and, in the plane of the arc, both axes of the same amplitude g = R|ω| (ω =
/// dθ/ds):
///
///   straight   |m_i| v ≤ v_i            |m_i| |a| ≤ a_i                 |m_i| |j| ≤ j_i
///   in plane   g v ≤ v_p          g √((ωv²)² + a²) ≤ a_p          g √((j − ω²v³)² + (3ωva)²) ≤ j_p
///
/// with v_p, a_p, j_p the smaller limits of the plane's two axes: q″ = −ω²R… turns with θ, so that each axis sees the
/// whole amplitude somewhere on a long arc.
RestToRest plan_piece(const toolpath::Piece& piece, const constraints::Constraints& constraints);

/// Bounds along a line from its axes, not its feed.
machine::Derivatives line_limits(const geometry::Line& line, const constraints::Constraints& constraints);

}  // namespace leadscrew::planner
