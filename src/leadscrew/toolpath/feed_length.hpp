#pragma once
// The length by which feed is counted (RS274/NGC 2.1.2.5), and moves as curves by that length: of X Y Z together; of U
// V W where those stand still; of A B C (degrees) where all linear axes stand still. For an arc in the plane's axes,
// radius · |sweep| takes the place of their straight distance; a NURBS curve's is the sum of its smooth pieces'.
//
// A path that is to be smoothed is told by the length of the space of tolerances (tolerance_space.hpp): where X turns
// back while A goes on, a curve by the length of X alone has no derivatives.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::toolpath {

/// Of a straight line.
FeedAxes feed_axes(const geometry::Point& start, const geometry::Point& end);
double line_length(const geometry::Point& start, const geometry::Point& end);

/// 0 for what is no motion, or for motion to where one is.
double feed_length(const gcode::Move& move);

enum class Length : std::uint8_t { of_feed, of_tolerance };

/// The move as smooth curves, each beginning where the one before ends; none where it does not move.
std::vector<geometry::Curve> curves_of(const gcode::Move& move, Length length = Length::of_feed);

/// What a piece is to name (Piece::feed_axes) that is told by the length of tolerances, its feed counted by `axes`:
/// none where both lengths are the same, no coordinate but theirs being different among the points.
FeedAxes to_be_named(FeedAxes axes, std::span<const geometry::Point> points);
FeedAxes to_be_named(FeedAxes axes, const gcode::Move& move);

/// Smooth pieces of what was fitted, by the length of tolerances.
std::vector<geometry::Nurbs> fitted_pieces(const geometry::NurbsForm& form);

/// A straight piece of a smoothed path, with the axes its feed is counted by; none of no length.
std::optional<Piece> straight_piece(const geometry::Point& start, const geometry::Point& end);

}  // namespace leadscrew::toolpath
