#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/contour.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double least_piece = 1e-3;            // pieces that are smaller go (LinuxCNC)
constexpr double backward_slack = 1e-3;         // along Z (LinuxCNC)
constexpr double least_gap = 1e-2;              // along Z; a smaller one is closed by a corner (LinuxCNC)
constexpr std::size_t most_offset_steps = 500;  // of an offset

PlanePoint operator+(PlanePoint a, PlanePoint b) {
  return {a.first + b.first, a.second + b.second};
}
PlanePoint operator-(PlanePoint a, PlanePoint b) {
  return {a.first - b.first, a.second - b.second};
}
PlanePoint operator*(double factor, PlanePoint a) {
  return {factor * a.first, factor * a.second};
}
double dot(PlanePoint a, PlanePoint b) {
  return a.first * b.first + a.second * b.second;
}
double cross(PlanePoint a, PlanePoint b) {
  return a.first * b.second - a.second * b.first;
}
PlanePoint midway(PlanePoint a, PlanePoint b) {
  return 0.5 * (a + b);
}
PlanePoint unit_of(PlanePoint a) {
  return (1 / numeric::hypot(a.first, a.second)) * a;
}

double radius_of(const ContourPiece& piece) {
  return span_of(piece.start, piece.center);
}

// How large a piece is: no step of an offset is more than half of it.
double size_of(const ContourPiece& piece) {
  const double chord = span_of(piece.start, piece.end);
  return piece.is_arc() ? std::min(chord, radius_of(piece)) : chord;
}

// To the right: a counterclockwise arc has its centre at the left, and grows.
void shift_aside(ContourPiece& piece, double aside) {
  if (piece.is_arc()) {
    const double radius = radius_of(piece);
    const double factor = (radius + piece.turn * aside) / radius;
    piece.start = piece.center + factor * (piece.start - piece.center);
    piece.end = piece.center + factor * (piece.end - piece.center);
    return;
  }
  const PlanePoint along = unit_of(piece.end - piece.start);
  const PlanePoint by = aside * PlanePoint{along.second, -along.first};
  piece.start = piece.start + by;
  piece.end = piece.end + by;
}

// Of the places where a line through both points and a circle meet, or come closest, that nearer to `to`.
PlanePoint meet_line_circle(const ContourPiece& line, const ContourPiece& arc, PlanePoint to) {
  const PlanePoint along = unit_of(line.end - line.start);
  const PlanePoint foot = line.start + dot(arc.center - line.start, along) * along;
  const double off = span_of(foot, arc.center), radius = radius_of(arc);
  const double half = std::sqrt(std::max(0.0, radius * radius - off * off));
  const PlanePoint one = foot + half * along, other = foot - half * along;
  return span_of(one, to) <= span_of(other, to) ? one : other;
}

// On the line of centres c apart lies the chord at (c² + a² − b²)/2c from the first.
PlanePoint meet_circles(const ContourPiece& one, const ContourPiece& two, PlanePoint to) {
  const double apart = span_of(one.center, two.center), a = radius_of(one), b = radius_of(two);
  if (!(apart > contour_tolerance)) return to;
  const PlanePoint along = unit_of(two.center - one.center), across{-along.second, along.first};
  const double at = (apart * apart + a * a - b * b) / (2 * apart);
  const double half = std::sqrt(std::max(0.0, a * a - at * at));
  const PlanePoint foot = one.center + at * along;
  const PlanePoint left = foot + half * across, right = foot - half * across;
  return span_of(left, to) <= span_of(right, to) ? left : right;
}

// Where the lines or circles of two neighbours meet, nearest to where they should; in the middle where they do not.
PlanePoint meeting_of(const ContourPiece& one, const ContourPiece& two) {
  const PlanePoint to = midway(one.end, two.start);
  if (one.is_arc() && two.is_arc()) return meet_circles(one, two, to);
  if (one.is_arc()) return meet_line_circle(two, one, to);
  if (two.is_arc()) return meet_line_circle(one, two, to);
  const PlanePoint a = unit_of(one.end - one.start), b = unit_of(two.end - two.start);
  const double sine = cross(a, b);
  constexpr double parallel = 1e-9;
  if (std::fabs(sine) < parallel) return to;
  return one.end + (cross(two.start - one.end, b) / sine) * a;
}

void join(ContourPiece& one, ContourPiece& two) {
  if (span_of(one.end, two.start) >= contour_tolerance) one.end = two.start = meeting_of(one, two);
}

// Which way the contour bends from one piece to the next: positive to the left.
double bend(const ContourPiece& one, const ContourPiece& two) {
  const auto direction = [](const ContourPiece& piece, PlanePoint at) {
    if (!piece.is_arc()) return unit_of(piece.end - piece.start);
    const PlanePoint ray = unit_of(at - piece.center);
    return PlanePoint{-piece.turn * ray.second, piece.turn * ray.first};
  };
  return cross(direction(one, one.end), direction(two, two.start));
}

// The centre of a fillet is as far from both sides: where these meet, moved aside to where the contour bends.
bool make_corner(ContourPiece& one, ContourPiece& two, const ContourCorner& corner, ContourPiece& between) {
  const double way = bend(one, two);
  if (way == 0) return false;
  const double aside = way > 0 ? -corner.size : corner.size;
  ContourPiece first = one, second = two;
  shift_aside(first, aside);
  shift_aside(second, aside);
  const PlanePoint center = meeting_of(first, second);
  first.end = second.start = center;
  shift_aside(first, -aside);
  shift_aside(second, -aside);
  between = {first.end, second.start, center, corner.is_chamfer ? 0 : way > 0 ? 1 : -1};
  // It fits where it leaves something of both sides.
  const auto is_left = [](const ContourPiece& piece, PlanePoint start, PlanePoint end) {
    return piece.is_arc() || dot(piece.end - piece.start, end - start) >= 0;
  };
  const bool fits = is_left(one, one.start, first.end) && is_left(two, second.start, two.end);
  one.end = first.end;
  two.start = second.start;
  return fits;
}

// Neighbours meet. What has been swallowed goes: a piece that is small, or the smaller of it and the one before where it
// has been turned round.
void close_gaps(Contour& contour) {
  for (std::size_t i = 0; i + 1 < contour.size();) {
    const double size = size_of(contour[i]);
    const bool is_turned = !goes_one_way(contour[i]);
    if (size >= least_piece && !is_turned) {
      join(contour[i], contour[i + 1]);
      ++i;
      continue;
    }
    const bool before_goes = is_turned && i > 0 && size_of(contour[i - 1]) <= size;
    contour.erase(contour.begin() + static_cast<std::ptrdiff_t>(before_goes ? i - 1 : i));
    i = i > 1 ? i - 2 : 0;
  }
}

// One step of an offset, small against every piece. The last piece may go beyond its circle's top by a little.
bool step_aside(Contour& contour, double aside) {
  const Contour before = contour;
  Contour made;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    ContourPiece piece = before[i];
    shift_aside(piece, aside);
    if (size_of(piece) < least_piece) continue;
    if (!made.empty() && made.back().end.first - piece.start.first > least_gap) {
      ContourPiece back = made.back(), ahead = piece;
      shift_aside(back, -aside);
      shift_aside(ahead, -aside);
      made.push_back({made.back().end, piece.start, midway(back.end, ahead.start), aside > 0 ? 1 : -1});
    }
    made.push_back(piece);
  }
  close_gaps(made);
  contour = std::move(made);
  if (contour.empty()) return false;
  const ContourPiece& last = contour.back();
  return last.end.first - last.start.first <= backward_slack &&
         std::all_of(contour.begin(), contour.end() - 1, goes_one_way);
}

}  // namespace

double span_of(PlanePoint a, PlanePoint b) {
  return numeric::hypot(a.first - b.first, a.second - b.second);
}

void Attitude::face(PlanePoint first, PlanePoint last) {
  if (first.second - last.second > 0) mirrors_x_ = !mirrors_x_;
  if (first.first - last.first < 0) mirrors_z_ = !mirrors_z_;
}

PlanePoint Attitude::in(PlanePoint point) const {
  if (turned_) point = {point.second, -point.first};
  if (mirrors_z_) point.first = -point.first;
  if (mirrors_x_) point.second = -point.second;
  return point;
}

PlanePoint Attitude::out(PlanePoint point) const {
  if (mirrors_z_) point.first = -point.first;
  if (mirrors_x_) point.second = -point.second;
  if (turned_) point = {-point.second, point.first};
  return point;
}

ContourPiece Attitude::in(const ContourPiece& piece) const {
  return {in(piece.start), in(piece.end), in(piece.center), turn_out(piece.turn), piece.block};
}

// An arc goes one way where both its ends are on the same side of its centre.
bool goes_one_way(const ContourPiece& piece) {
  const double along = piece.end.first - piece.start.first;
  if (!piece.is_arc()) return along <= backward_slack;
  // Z decreases over the top counterclockwise, below the centre clockwise.
  const double entry = piece.turn * (piece.start.second - piece.center.second);
  const double exit = piece.turn * (piece.end.second - piece.center.second);
  return entry >= -backward_slack && exit >= -backward_slack && along <= -backward_slack;
}

bool round_corners(Contour& contour, const std::vector<ContourCorner>& corners) {
  Contour made;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    made.push_back(contour[i]);
    if (i + 1 == contour.size() || i >= corners.size() || corners[i].size == 0) continue;
    ContourPiece between;
    if (!make_corner(made.back(), contour[i + 1], corners[i], between)) return false;
    between.block = contour[i].block;
    made.push_back(between);
  }
  std::erase_if(made, [](const ContourPiece& piece) { return size_of(piece) < least_piece; });
  contour = std::move(made);
  return !contour.empty();
}

bool offset(Contour& contour, double aside) {
  double done = 0;
  for (std::size_t step = 0; done != aside; ++step) {
    if (step == most_offset_steps) return false;
    double size = std::fabs(aside - done);
    for (const ContourPiece& piece : contour) size = std::min(size, size_of(piece) / 2);
    const bool is_last = size == std::fabs(aside - done);
    if (!step_aside(contour, std::copysign(size, aside))) return false;
    done = is_last ? aside : done + std::copysign(size, aside);
  }
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    contour[i].end = contour[i + 1].start = midway(contour[i].end, contour[i + 1].start);
  }
  return true;
}

}  // namespace leadscrew::gcode
