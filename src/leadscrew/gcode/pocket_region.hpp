#pragma once
// The region of a pocket that the tool's middle may be in: inside a closed contour of lines and arcs, and at least a
// distance from it. All lengths are mm, in the plane of X and Y.
//
// The boundary of the region lies on lines beside the contour's, on circles about its arcs' centres and on circles about
// its corners. Along a straight line the places where it meets these are found in closed form, and whether what lies
// between two of them belongs to the region is asked of the distance at its middle.

#include <leadscrew/gcode/contour.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

/// By how much places may be nearer than they should: rounding.
inline constexpr double pocket_rounding = 1e-6;

/// Where the lines or circles of two pieces meet: none, one or two points. Lines that are parallel do not.
struct Meetings {
  PlanePoint points[2];
  int count = 0;
};
Meetings meetings_of(const ContourPiece& a, const ContourPiece& b);

/// Which way a piece goes at one of its ends: a vector of length 1. A line must have a length.
PlanePoint heading(const ContourPiece& piece, PlanePoint at);

/// The point of a piece that is nearest to another.
PlanePoint nearest(PlanePoint point, const ContourPiece& piece);
/// From a point to a piece; arcs may be of up to one turn, a whole one where their ends coincide.
double distance(PlanePoint point, const ContourPiece& piece);
/// Between two pieces: 0 where they cross or touch.
double distance(const ContourPiece& a, const ContourPiece& b);
/// From a piece to the nearest of a contour.
double distance(const ContourPiece& piece, const Contour& contour);

/// Whether a closed contour goes round a point, in either direction.
bool is_within(PlanePoint point, const Contour& contour);
/// Whether a closed contour goes round its inside counterclockwise.
bool is_counterclockwise(const Contour& contour);

/// Whether pieces of a closed contour that are no neighbours meet.
bool crosses_itself(const Contour& contour);

/// The closed contour at a distance from another, inside it and in its direction; none where the tool does not get
/// everywhere along it: all of what is found is proven to keep the distance.
std::optional<Contour> inside_of(const Contour& contour, double aside);

/// What of a line belongs to the region.
struct Span {
  double low = 0;
  double high = 0;
};
/// Of the line along X at this Y, in order.
std::vector<Span> clear_spans(const Contour& contour, double aside, double y);

}  // namespace leadscrew::gcode
