#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/offset_contour.hpp>
#include <leadscrew/gcode/pocket_region.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double least_way_radius = 1e-6;  // mm
constexpr double way_rounding = 1e-9;      // mm
constexpr double reversal = 1e-6;          // radians
constexpr double least_depth = 2e-7;       // mm; by as much a line may be off where it goes on in an arc

PlanePoint shifted(PlanePoint point, PlanePoint along, double by) {
  return {point.first + by * along.first, point.second + by * along.second};
}

double radius_of_way(const ContourPiece& arc) {
  return span_of(arc.start, arc.center);
}

// Positive to the left.
double curvature_of(const ContourPiece& piece) {
  return piece.is_arc() ? piece.turn / radius_of_way(piece) : 0;
}

ContourPiece contour_of(const Move& move) {
  ContourPiece piece{in_plane(move.start, move.plane), in_plane(move.end, move.plane), {}, 0};
  if (move.kind != Move::Kind::arc) return piece;
  piece.center = {move.center_first, move.center_second};
  piece.turn = move.turns > 0 ? 1 : -1;
  return piece;
}

// How far along a way from one of its points to another: of arcs radians in [0, 2π), of lines mm, negative the other way.
double along_way(const ContourPiece& way, PlanePoint from, PlanePoint to) {
  if (!way.is_arc()) {
    const PlanePoint heads = heading(way, way.start);
    return (to.first - from.first) * heads.first + (to.second - from.second) * heads.second;
  }
  const double angle = sweep(from, to, way.center, way.turn);
  return angle > full_turn - way_rounding / radius_of_way(way) ? 0 : angle;
}

// How much there is of it, in the same measure; and what of that measure is a millimetre.
double measure_of(const OffsetPiece& piece) {
  return piece.way.is_arc() ? piece.turned : span_of(piece.way.start, piece.way.end);
}
double measure_of_mm(const OffsetPiece& piece) {
  return piece.way.is_arc() ? 1 / radius_of_way(piece.way) : 1;
}

bool has_length(const OffsetPiece& piece) {
  return measure_of(piece) > way_rounding * measure_of_mm(piece);
}

}  // namespace

std::optional<OffsetPiece> offset_of(const Move& move, double aside) {
  OffsetPiece piece{contour_of(move), contour_of(move), 0};
  ContourPiece& way = piece.way;
  if (!way.is_arc()) {
    const PlanePoint heads = heading(way, way.start), left{-heads.second, heads.first};
    way.start = shifted(way.start, left, aside);
    way.end = shifted(way.end, left, aside);
    return piece;
  }
  const double radius = radius_of_way(way), left = radius - way.turn * aside;
  if (!(left > least_way_radius)) return std::nullopt;
  for (PlanePoint* const end : {&way.start, &way.end}) {
    *end = {way.center.first + (end->first - way.center.first) * (left / radius),
            way.center.second + (end->second - way.center.second) * (left / radius)};
  }
  piece.turned =
      sweep(piece.contour.start, piece.contour.end, way.center, way.turn) + (std::abs(move.turns) - 1) * full_turn;
  if (piece.turned > full_turn) piece.contour.end = piece.contour.start;
  return piece;
}

// Where the contour comes back along itself, as along both sides of a sheet, the tool is between the two where the second
// bends to its side of the first.
CornerKind corner_of(const OffsetPiece& one, const OffsetPiece& two, double aside) {
  // Where a line is shifted along itself by the gap, it is off by gap²/2r.
  const double gap = span_of(one.way.end, two.way.start);
  const bool has_line = !one.way.is_arc() || !two.way.is_arc();
  if (gap <= joined || (has_line && gap * gap <= 2 * std::fabs(aside) * least_depth)) return CornerKind::none;
  const PlanePoint before = heading(one.contour, one.way.end), behind = heading(two.contour, two.way.start);
  const double sine = before.first * behind.second - before.second * behind.first;
  const double cosine = before.first * behind.first + before.second * behind.second;
  if (cosine < 0 && std::fabs(sine) < reversal) {
    const double bend = (curvature_of(one.contour) + curvature_of(two.contour)) * aside;
    return bend < 0 ? CornerKind::inner : CornerKind::outer;
  }
  return sine * aside > 0 ? CornerKind::inner : CornerKind::outer;
}

// Of the places where both meet that which leaves most of the first way: what it goes along before is clear of the second.
bool cut_inner_corner(OffsetPiece& one, OffsetPiece& two) {
  if (!has_length(one) || !has_length(two)) return false;
  const double slack_one = way_rounding * measure_of_mm(one), slack_two = way_rounding * measure_of_mm(two);
  const Meetings meetings = meetings_of(one.way, two.way);
  double least = std::numeric_limits<double>::infinity(), forth_of_least = 0;
  PlanePoint meeting;
  for (int i = 0; i < meetings.count; ++i) {
    const double back = along_way(one.way, meetings.points[i], one.way.end);
    const double forth = along_way(two.way, two.way.start, meetings.points[i]);
    const bool is_within = back >= -slack_one && back <= measure_of(one) + slack_one && forth >= -slack_two &&
                           forth <= measure_of(two) + slack_two;
    if (!is_within || back >= least) continue;
    least = back, forth_of_least = forth, meeting = meetings.points[i];
  }
  if (!std::isfinite(least)) return false;
  one.way.end = two.way.start = meeting;
  if (one.way.is_arc()) one.turned = std::max(0.0, one.turned - least);
  if (two.way.is_arc()) two.turned = std::max(0.0, two.turned - forth_of_least);
  return true;
}

bool keeps_clear(const OffsetPiece& way, const ContourPiece& contour, double radius) {
  ContourPiece piece = way.way;
  if (piece.is_arc() && way.turned >= full_turn) piece.end = piece.start;
  if (!has_length(way)) piece = {piece.start, piece.start, {}, 0};
  return distance(piece, contour) >= radius - clearance_rounding;
}

int turns_of(const OffsetPiece& arc) {
  if (!has_length(arc)) return 0;
  const double shown = sweep(arc.way.start, arc.way.end, arc.way.center, arc.way.turn);
  return arc.way.turn * (1 + static_cast<int>(std::lround((arc.turned - shown) / full_turn)));
}

}  // namespace leadscrew::gcode
