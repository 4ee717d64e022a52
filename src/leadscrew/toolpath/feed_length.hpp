#pragma once
// The length by which feed is counted (RS274/NGC 2.1.2.5), and moves as curves by that length: of X Y Z together; of U
// V W where those stand still; of A B C (degrees) where all linear axes stand still. For an arc in the plane's axes,
// radius · |sweep| takes the place of their straight distance; a NURBS curve's is the sum of its smooth pieces'.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <vector>

namespace leadscrew::toolpath {

enum class FeedAxes : std::uint8_t { none, xyz, uvw, abc };
/// Of a straight line.
FeedAxes feed_axes(const geometry::Point& start, const geometry::Point& end);
double line_length(const geometry::Point& start, const geometry::Point& end);

/// 0 for what is no motion, or for motion to where one is.
double feed_length(const gcode::Move& move);

/// The move as smooth curves, each beginning where the one before ends; none where it does not move.
std::vector<geometry::Curve> curves_of(const gcode::Move& move);

}  // namespace leadscrew::toolpath
