#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pocket_region.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double angle_rounding = 1e-9;  // radians

PlanePoint plus(PlanePoint a, PlanePoint b, double factor = 1) {
  return {a.first + factor * b.first, a.second + factor * b.second};
}
PlanePoint minus(PlanePoint a, PlanePoint b) {
  return {a.first - b.first, a.second - b.second};
}
double dot_of(PlanePoint a, PlanePoint b) {
  return a.first * b.first + a.second * b.second;
}
double cross_of(PlanePoint a, PlanePoint b) {
  return a.first * b.second - a.second * b.first;
}
double length_of(PlanePoint a) {
  return numeric::hypot(a.first, a.second);
}
PlanePoint left_of(PlanePoint a) {
  return {-a.second, a.first};
}
PlanePoint direction_of(PlanePoint a) {
  const double length = length_of(a);
  return {a.first / length, a.second / length};
}
double radius_of_arc(const ContourPiece& arc) {
  return span_of(arc.start, arc.center);
}
double sweep_of(const ContourPiece& arc) {
  return sweep(arc.start, arc.end, arc.center, arc.turn);
}

// Whether the ray from the centre through the point passes the arc.
bool is_beside_arc(PlanePoint point, const ContourPiece& arc) {
  const double along = sweep(arc.start, point, arc.center, arc.turn);
  return along <= sweep_of(arc) + angle_rounding || along >= whole_turn - angle_rounding;
}
bool is_beside_line(PlanePoint point, const ContourPiece& line) {
  const PlanePoint along = minus(line.end, line.start);
  const double at = dot_of(minus(point, line.start), along);
  return 0 <= at && at <= dot_of(along, along);
}
bool is_beside(PlanePoint point, const ContourPiece& piece) {
  return piece.is_arc() ? is_beside_arc(point, piece) : is_beside_line(point, piece);
}

Meetings chord_of(PlanePoint foot, PlanePoint along, double square) {
  if (square < 0) return {};
  const double half = std::sqrt(square);
  return {{plus(foot, along, half), plus(foot, along, -half)}, 2};
}

// Those ends and middles of two pieces between which the least distance may be.
double distance_by_middles(const ContourPiece& a, const ContourPiece& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](PlanePoint point, const ContourPiece& on, const ContourPiece& other) {
    if (is_beside(point, on)) least = std::min(least, distance(point, other));
  };
  if (!a.is_arc() && b.is_arc()) {
    const PlanePoint along = direction_of(minus(a.end, a.start));
    consider(plus(a.start, along, dot_of(minus(b.center, a.start), along)), a, b);
  }
  if (a.is_arc() && b.is_arc() && span_of(a.center, b.center) > contour_tolerance) {
    const PlanePoint along = direction_of(minus(b.center, a.center));
    for (const double side : {1.0, -1.0}) {
      consider(plus(a.center, along, side * radius_of_arc(a)), a, b);
      consider(plus(b.center, along, side * radius_of_arc(b)), b, a);
    }
  }
  return least;
}

// By which the contour turns about a point along a piece.
double turn_about(PlanePoint point, const ContourPiece& piece) {
  const PlanePoint from = minus(piece.start, point), to = minus(piece.end, point);
  const double chord = numeric::atan2(cross_of(from, to), dot_of(from, to));
  if (!piece.is_arc()) return chord;
  // Between the chord and the arc, which bulges to the chord's right where it turns counterclockwise.
  const PlanePoint along = minus(piece.end, piece.start);
  const bool is_whole = length_of(along) < contour_tolerance;
  const bool is_on_chord =
      !is_whole && dot_of(from, to) < 0 && std::fabs(std::fabs(chord) - whole_turn / 2) < angle_rounding;
  if (is_on_chord) return piece.turn * whole_turn / 2;
  const double side = cross_of(along, minus(point, piece.start)) * piece.turn;
  const bool is_between = span_of(point, piece.center) < radius_of_arc(piece) && (is_whole || side < 0);
  return chord + (is_between ? whole_turn * piece.turn : 0);
}

}  // namespace

Meetings meetings_of(const ContourPiece& a, const ContourPiece& b) {
  if (a.is_arc() && !b.is_arc()) return meetings_of(b, a);
  if (!a.is_arc() && !b.is_arc()) {
    const PlanePoint u = minus(a.end, a.start), v = minus(b.end, b.start);
    const double sine = cross_of(u, v);
    if (std::fabs(sine) <= angle_rounding * length_of(u) * length_of(v)) return {};
    return {{plus(a.start, u, cross_of(minus(b.start, a.start), v) / sine), {}}, 1};
  }
  if (!a.is_arc()) {
    const PlanePoint along = direction_of(minus(a.end, a.start));
    const PlanePoint foot = plus(a.start, along, dot_of(minus(b.center, a.start), along));
    const double radius = radius_of_arc(b), off = span_of(foot, b.center);
    return chord_of(foot, along, radius * radius - off * off);
  }
  const PlanePoint between = minus(b.center, a.center);
  const double apart = length_of(between), one = radius_of_arc(a), other = radius_of_arc(b);
  if (!(apart > contour_tolerance)) return {};
  const PlanePoint along = direction_of(between);
  const double at = (apart * apart + one * one - other * other) / (2 * apart);
  return chord_of(plus(a.center, along, at), left_of(along), one * one - at * at);
}

PlanePoint heading(const ContourPiece& piece, PlanePoint at) {
  if (!piece.is_arc()) return direction_of(minus(piece.end, piece.start));
  const PlanePoint along = left_of(direction_of(minus(at, piece.center)));
  return {piece.turn * along.first, piece.turn * along.second};
}

PlanePoint nearest(PlanePoint point, const ContourPiece& piece) {
  if (piece.is_arc()) {
    const double off = span_of(point, piece.center);
    if (off > contour_tolerance && is_beside_arc(point, piece)) {
      return plus(piece.center, minus(point, piece.center), radius_of_arc(piece) / off);
    }
  } else if (is_beside_line(point, piece) && span_of(piece.start, piece.end) > 0) {
    const PlanePoint along = direction_of(minus(piece.end, piece.start));
    return plus(piece.start, along, dot_of(minus(point, piece.start), along));
  }
  return span_of(point, piece.start) <= span_of(point, piece.end) ? piece.start : piece.end;
}

double distance(PlanePoint point, const ContourPiece& piece) {
  if (piece.is_arc()) {
    const double off = span_of(point, piece.center), radius = radius_of_arc(piece);
    if (off < contour_tolerance) return radius - off;
    if (is_beside_arc(point, piece)) return std::fabs(off - radius);
  } else if (is_beside_line(point, piece) && span_of(piece.start, piece.end) > 0) {
    return std::fabs(cross_of(direction_of(minus(piece.end, piece.start)), minus(point, piece.start)));
  }
  return std::min(span_of(point, piece.start), span_of(point, piece.end));
}

double distance(const ContourPiece& a, const ContourPiece& b) {
  if (a.is_arc() && !b.is_arc()) return distance(b, a);
  if (a.is_arc() || span_of(a.start, a.end) > 0) {
    const Meetings meetings = meetings_of(a, b);
    for (int i = 0; i < meetings.count; ++i) {
      if (is_beside(meetings.points[i], a) && is_beside(meetings.points[i], b)) return 0;
    }
  }
  double least = std::min({distance(a.start, b), distance(a.end, b), distance(b.start, a), distance(b.end, a)});
  if (a.is_arc() || span_of(a.start, a.end) > 0) least = std::min(least, distance_by_middles(a, b));
  return least;
}

double distance(const ContourPiece& piece, const Contour& contour) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContourPiece& each : contour) least = std::min(least, distance(piece, each));
  return least;
}

bool is_within(PlanePoint point, const Contour& contour) {
  double turned = 0;
  for (const ContourPiece& piece : contour) turned += turn_about(point, piece);
  return std::fabs(turned) > whole_turn / 2;
}

// The area between the contour and the origin, and between chords and arcs: r²(φ − sin φ)/2.
bool is_counterclockwise(const Contour& contour) {
  double twice = 0;
  for (const ContourPiece& piece : contour) {
    twice += cross_of(minus(piece.start, contour.front().start), minus(piece.end, contour.front().start));
    if (!piece.is_arc()) continue;
    const double angle = sweep_of(piece), radius = radius_of_arc(piece);
    twice += piece.turn * radius * radius * (angle - numeric::sin(angle));
  }
  return twice > 0;
}

bool crosses_itself(const Contour& contour) {
  const std::size_t count = contour.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 2; k < count; ++k) {
      const bool are_neighbours = i == 0 && k + 1 == count;
      if (!are_neighbours && distance(contour[i], contour[k]) < pocket_rounding) return true;
    }
  }
  return false;
}

std::vector<Span> clear_spans(const Contour& contour, double aside, double y) {
  std::vector<double> borders;
  const auto meet_circle = [&](PlanePoint center, double radius) {
    const double square = radius * radius - (y - center.second) * (y - center.second);
    if (square < 0) return;
    borders.push_back(center.first - std::sqrt(square));
    borders.push_back(center.first + std::sqrt(square));
  };
  for (const ContourPiece& piece : contour) {
    meet_circle(piece.start, aside);
    if (piece.is_arc()) {
      meet_circle(piece.center, radius_of_arc(piece) + aside);
      meet_circle(piece.center, radius_of_arc(piece) - aside);
      continue;
    }
    const PlanePoint along = direction_of(minus(piece.end, piece.start));
    if (std::fabs(along.second) < angle_rounding) continue;
    for (const double side : {aside, -aside}) {
      const PlanePoint from = plus(piece.start, left_of(along), side);
      borders.push_back(from.first + along.first * (y - from.second) / along.second);
    }
  }
  std::ranges::sort(borders);
  std::vector<Span> spans;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    if (borders[i + 1] - borders[i] < pocket_rounding) continue;
    const PlanePoint middle{(borders[i] + borders[i + 1]) / 2, y};
    const bool is_clear =
        std::ranges::all_of(contour, [&](const ContourPiece& piece) { return distance(middle, piece) >= aside; });
    if (!is_clear || !is_within(middle, contour)) continue;
    const bool goes_on = !spans.empty() && borders[i] - spans.back().high < pocket_rounding;
    if (goes_on) {
      spans.back().high = borders[i + 1];
    } else {
      spans.push_back({borders[i], borders[i + 1]});
    }
  }
  return spans;
}

namespace {

// To the left by a distance; false of an arc that is swallowed.
bool shift_to_left(ContourPiece& piece, double by) {
  if (!piece.is_arc()) {
    const PlanePoint side = left_of(heading(piece, piece.start));
    piece.start = plus(piece.start, side, by);
    piece.end = plus(piece.end, side, by);
    return true;
  }
  const double radius = radius_of_arc(piece), left = radius - piece.turn * by;
  if (left < pocket_rounding) return false;
  piece.start = plus(piece.center, minus(piece.start, piece.center), left / radius);
  piece.end = plus(piece.center, minus(piece.end, piece.center), left / radius);
  return true;
}

struct Shifted {
  ContourPiece piece;
  const ContourPiece* of = nullptr;
};

// Where two shifted neighbours meet, nearest to where the contour had its corner.
bool cut_corner(Shifted& one, Shifted& two, PlanePoint corner) {
  const Meetings meetings = meetings_of(one.piece, two.piece);
  if (meetings.count == 0) return false;
  const bool first = meetings.count == 1 || span_of(meetings.points[0], corner) <= span_of(meetings.points[1], corner);
  one.piece.end = two.piece.start = meetings.points[first ? 0 : 1];
  return true;
}

// What is left of a piece goes the way of the whole.
bool keeps_its_way(const Shifted& shifted, const ContourPiece& whole) {
  const ContourPiece& piece = shifted.piece;
  if (!piece.is_arc()) return dot_of(minus(piece.end, piece.start), minus(whole.end, whole.start)) > 0;
  return is_beside_arc(piece.start, whole) && is_beside_arc(piece.end, whole) &&
         sweep_of(piece) <= sweep_of(whole) + angle_rounding;
}

}  // namespace

std::optional<Contour> inside_of(const Contour& contour, double aside) {
  if (aside < pocket_rounding) return contour;
  const int way = is_counterclockwise(contour) ? 1 : -1;
  std::vector<Shifted> shifted;
  for (const ContourPiece& piece : contour) {
    Shifted moved{piece, &piece};
    if (shift_to_left(moved.piece, way * aside)) shifted.push_back(moved);
  }
  if (shifted.empty()) return std::nullopt;
  const std::vector<Shifted> whole = shifted;
  Contour made;
  std::vector<std::optional<ContourPiece>> corners(shifted.size());
  for (std::size_t i = 0; i < shifted.size(); ++i) {
    Shifted &one = shifted[i], &two = shifted[(i + 1) % shifted.size()];
    const PlanePoint from = whole[i].piece.end, to = whole[(i + 1) % shifted.size()].piece.start;
    if (span_of(from, to) < pocket_rounding) {
      one.piece.end = two.piece.start = from;
      continue;
    }
    const PlanePoint corner = one.of->end;
    const bool are_neighbours = span_of(corner, two.of->start) < contour_tolerance;
    const double bend = way * cross_of(heading(*one.of, corner), heading(*two.of, corner));
    if (are_neighbours && bend < 0) {
      corners[i] = ContourPiece{from, to, corner, -way};
    } else if (shifted.size() < 2 || !cut_corner(one, two, corner)) {
      return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < shifted.size(); ++i) {
    if (!keeps_its_way(shifted[i], whole[i].piece)) return std::nullopt;
    made.push_back(shifted[i].piece);
    if (corners[i]) made.push_back(*corners[i]);
  }
  const bool keeps_distance = std::ranges::all_of(
      made, [&](const ContourPiece& piece) { return distance(piece, contour) >= aside - pocket_rounding; });
  if (!keeps_distance || !is_within(made.front().start, contour)) return std::nullopt;
  return made;
}

}  // namespace leadscrew::gcode
