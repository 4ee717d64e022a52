#pragma once
// The length by which feed is counted (RS274/NGC 2.1.2.5): of X Y Z together; of U V W where those stand still; of A B
// C (degrees) where all linear axes stand still. For an arc in the plane's axes, radius · |sweep| takes the place of
// their straight distance; a NURBS curve's is the sum of its smooth pieces'.
//
// The curves of a path are told by that length where no other coordinates move, else by the length of the space of
// tolerances (tolerance_space.hpp): where X turns back while A goes on, a curve by the length of X alone has no
// derivatives. Such a piece names the axes by which its feed is counted (Piece::feed_axes).

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

/// Where these coordinates move; none where none does.
FeedAxes feed_axes(base::AxisSet moving);
/// What a piece names where these move and feed is counted by `axes`: none where it is told by that very length.
FeedAxes to_be_named(FeedAxes axes, base::AxisSet moving);

/// Of a straight line.
double line_length(const geometry::Point& start, const geometry::Point& end);
/// 0 for what is no motion, or for motion to where one is.
double feed_length(const gcode::Move& move);

/// How long a part of a piece takes by feed alone, s: where feed is counted by some of the axes that move, a blend of
/// two moves may have more of them than either.
double time_by_feed(const Piece& piece, double from, double to);

/// The move as smooth pieces, each beginning where the one before ends, without their feed; none where it does not
/// move. A curve is cut where feed comes to be counted by other axes. tables: of its arc length; none: as fine as words need.
std::vector<Piece> pieces_of(const gcode::Move& move, const ToleranceSpace& space = {},
                             const std::optional<geometry::MapTolerance>& tables = {});
/// A straight one whose feed is counted by `axes`; none of no length.
std::optional<Piece> straight_piece(const geometry::Point& start, const geometry::Point& end, FeedAxes axes,
                                    const ToleranceSpace& space = {});

/// The same curve: a piece of a spline that moves along one coordinate alone is a straight line, whatever its parameter
/// does.
geometry::Curve simplest(const geometry::Curve& curve, const ToleranceSpace& space = {});

/// Tables of arc length for what is fitted and blended, and for curves of the tip, which may be lines of tool vectors. Their
/// spans are much shorter than their radii, and what a table may be off by is told by the shorter of the two. For times
/// alone, without words, far fewer pieces do: a time changes by some 1e-8 of it.
inline constexpr geometry::MapTolerance tables_for_motion{1e-7, 1e-6, 1e-6}, tables_for_times{1e-5, 1e-3, 1e-2, 1e-9};

/// Smooth pieces of what was fitted, by the length of tolerances.
std::vector<geometry::Nurbs> fitted_pieces(const geometry::NurbsForm& form,
                                           const geometry::MapTolerance& tables = tables_for_motion,
                                           const ToleranceSpace& space = {});

}  // namespace leadscrew::toolpath
