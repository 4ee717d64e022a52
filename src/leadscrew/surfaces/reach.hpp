#pragma once
// How far to its side a pass leaves no more than h, by the sweep of the tool itself; for tools with an edge that lean.
//
//        ╲    A     ╱       ╲    B     ╱        B is right where its reach towards A ends where that of A towards B does:
//         ╲        ╱•───────•╲        ╱         then the ridge is h. Farther on, the reaches leave a gap, and the ridge
//      ────`-.__.-'─┴─ gap ─┴─`-.__.-'────      is higher.
//
// The edge is round with r about a circle of radius ρ = R − r. With O the axis, S the contact and C the circle's centre (tip + r O), the
// circle is c(φ) = C + ρ e(φ), its point φ = 0 at S + r n; while the tool goes along the line it sweeps c(t, φ), and the edge
//
//     X(t, φ) = c + r N          N = ± c_t × c_φ/|c_t × c_φ|, downwards        ("canal surface" of variable direction; r = 0: X = c)
//
// The reach of the place t is the place (u, v) of the surface, above which the edge is at h:
//
//     X(t, φ) = S(u, v) + h n(u, v)
//
// by Newton's method, in √height, which grows as φ does. As n is across S_u, S_v and nearly across n_u, n_v, the three equations
// come apart: one along n, for φ, and two in the tangent plane.

#include <leadscrew/surfaces/pass_nodes.hpp>
#include <optional>
#include <vector>

namespace leadscrew::surfaces {

/// Where the reach of a place of a line ends.
struct ReachEnd {
  double angle = 0;     ///< φ, radians; positive towards the side that was asked for
  double u = 0, v = 0;  ///< may lie a little beyond the surface, which goes on there as its quadric
};

/// Whether steps are found by reaches: for a height, of a tool with an edge that leans by the pass. One that keeps its axis touches
/// with all sides of its edge and with its bottom; its steps are outline_arc's.
bool has_reach(const Machining& machining);

/// The reaches of a line, by its places; none of places that were none.
using Reaches = std::vector<std::optional<ReachEnd>>;
/// To the side where the parameter across rises (towards: 1) or falls (−1). None where a place has no reach, or where the log fails.
std::optional<Reaches> reaches_along(PassLog& log, Direction along, const std::vector<std::optional<LinePlace>>& places,
                                     double towards);
/// At each place of the line `there`, which lies towards 1 or −1 of `here`: by how much of the parameter across its reach goes back over
/// that of `here`; below 0: the gap. None where the one along lies beyond the reaches of `here`. Both lines' places ascend.
std::vector<std::optional<double>> overlaps(Direction along, const Reaches& here, const Reaches& there, double towards);

/// An overlap, by parameters, at a place of the reaches.
struct Overlap {
  double along = 0, across = 0;
};
/// Of all places of `there` that have one, and of the ends of `here`, so that they go from the first to the last place where both lines
/// reach; ascending.
std::vector<Overlap> overlaps_between(Direction along, const Reaches& here, const Reaches& there, double towards);

/// The gap that may be left, of the step: the ridge is higher by twice that part of h.
inline constexpr double widest_gap = 2e-4;

}  // namespace leadscrew::surfaces
