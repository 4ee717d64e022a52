#include <algorithm>
#include <leadscrew/referee/piece.hpp>
#include <numbers>

namespace leadscrew::referee {

namespace {

/// Distance of a point to the place φ of an arc, from what both look like in the plane and across it.
struct ArcDistance {
  const Metric& metric;
  const Piece& piece;
  const Point& point;
  double distance_from_center = 0;  // in the plane
  double angle = 0;                 // of the point in the plane, from the arc's start, in its sense of turning

  double squared(double place) const {
    double sum = 0;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) {
      if (i == piece.first || i == piece.second) continue;
      const double offset = point[i] - piece.from[i] - place * piece.slope[i];
      sum += offset * offset;
    }
    const double radius = piece.radius + place * piece.radius_slope;
    const double radial = distance_from_center - radius;
    const double half_chord = std::sin((angle - place) / 2);
    return sum + radial * radial + 4 * distance_from_center * radius * half_chord * half_chord;
  }

  /// Half the derivative of squared() by the place, radius held, and its own derivative.
  double slope(double place, double& curvature) const {
    double sum = 0;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) {
      sum += piece.slope[i] * (piece.from[i] + place * piece.slope[i] - point[i]);
    }
    const double product = distance_from_center * piece.radius;
    curvature = product * std::cos(place - angle) + piece.squared_slope;
    return sum + product * std::sin(place - angle);
  }
};

constexpr int newton_steps = 6;

/// Minimises over 0 ≤ φ ≤ Δ: the best of the ends, the angle in the plane and the place by the other axes, polished.
double nearest_on_helix(const ArcDistance& distance, double across) {
  const double span = distance.piece.span;
  const double starts[] = {std::clamp(distance.angle, 0.0, span), std::clamp(across, 0.0, span), 0.0, span};
  double best = starts[0];
  double least = distance.squared(best);
  for (const double start : {starts[1], starts[2], starts[3]}) {
    const double value = distance.squared(start);
    if (value < least) {
      least = value;
      best = start;
    }
  }
  for (int step = 0; step < newton_steps; ++step) {
    double curvature = 0;
    const double slope = distance.slope(best, curvature);
    if (curvature <= 0) curvature += 2 * distance.distance_from_center * distance.piece.radius;
    if (curvature <= 0) break;
    const double next = std::clamp(best - slope / curvature, 0.0, span);
    const double value = distance.squared(next);
    if (!(value < least)) break;
    least = value;
    best = next;
  }
  return best;
}

}  // namespace

Nearest nearest_on_arc(const Metric& metric, const Piece& piece, const Point& point) {
  const double first = point[piece.first] - piece.center_first;
  const double second = point[piece.second] - piece.center_second;
  const double along = piece.radial_first * first + piece.radial_second * second;
  const double across = piece.side * (piece.radial_first * second - piece.radial_second * first);
  const ArcDistance distance{metric, piece, point, std::sqrt(first * first + second * second),
                             std::atan2(across, along)};
  if (piece.helix) {
    double by_slope = 0;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) by_slope += piece.slope[i] * (point[i] - piece.from[i]);
    const double place = nearest_on_helix(distance, by_slope / piece.squared_slope);
    return {place, std::sqrt(distance.squared(place))};
  }
  double place = distance.angle;
  if (place < 0 || place > piece.span) {
    const double beyond = place > 0 ? place - piece.span : place + 2 * std::numbers::pi - piece.span;
    const double before = place < 0 ? -place : 2 * std::numbers::pi - place;
    place = before <= beyond ? 0 : piece.span;
    return {place, metric.distance(point, place == 0 ? piece.from : piece.to)};
  }
  return {place, std::sqrt(distance.squared(place))};
}

Nearest nearest_on_curve(const Metric& metric, const Piece& piece, const Point& point) {
  const double place = nearest_place(metric, piece.segment, point);
  return {place, metric.distance(point, point_at(metric, piece.segment, place))};
}

Coordinates coordinates_of(const Metric& metric, FeedAxes axes) {
  Coordinates result{};
  for (const base::Axis axis : axes_of(axes)) {
    const std::size_t coordinate = metric.coordinate(axis);
    if (coordinate < metric.dimensions()) result[coordinate] = true;
  }
  return result;
}

Point point_at(const Metric& metric, const Piece& piece, double place) {
  if (piece.kind == Piece::Kind::curve) return point_at(metric, piece.segment, place);
  Point result{};
  for (std::size_t i = 0; i < metric.dimensions(); ++i) result[i] = piece.from[i] + place * piece.slope[i];
  if (piece.kind == Piece::Kind::line) return result;
  const double scale = 1 + place * piece.radius_slope / piece.radius;
  const double cosine = scale * std::cos(place), sine = scale * piece.side * std::sin(place);
  result[piece.first] = piece.center_first + cosine * piece.radial_first - sine * piece.radial_second;
  result[piece.second] = piece.center_second + cosine * piece.radial_second + sine * piece.radial_first;
  return result;
}

double length_of(const Metric& metric, const Piece& piece) {
  if (piece.kind == Piece::Kind::line) return piece.span;
  if (piece.kind == Piece::Kind::arc) return piece.span * std::hypot(piece.radius, std::sqrt(piece.squared_slope));
  return metric.distance(piece.from, piece.to) / std::cos(std::numbers::pi / 8);
}

Piece part(const Metric& metric, const Piece& piece, double from, double to) {
  Piece result = piece;
  result.begins = from;
  if (from > 0) result.from = point_at(metric, piece, from);
  if (to < piece.span) result.to = point_at(metric, piece, to);
  switch (piece.kind) {
    case Piece::Kind::line:
      result.span = to - from;
      break;
    case Piece::Kind::arc:
      result.span = to - from;
      result.angle_before += from;
      result.radial_first = result.from[piece.first] - piece.center_first;
      result.radial_second = result.from[piece.second] - piece.center_second;
      result.radius = std::hypot(result.radial_first, result.radial_second);
      break;
    case Piece::Kind::curve:
      result.segment = part(metric, piece.segment, from, to);
      result.scale = to - from;
      break;
  }
  return result;
}

namespace {

/// The farthest that an arc departs from its own chord between two places, at most: |p''| Δφ²/8 = RΔφ²/8.
double greatest_sagitta(const Piece& piece, double from, double to) {
  return piece.radius * (to - from) * (to - from) / 8;
}

/// Does the chord lie in a plane beside the arc's, or in it? Then both distances add up to the square.
bool is_parallel(const Metric& metric, const Piece& piece, const Chord& chord) {
  constexpr double rounding = 1e-3 * nanometre;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    if (i != piece.first && i != piece.second && std::abs(chord.along[i]) > rounding) return false;
  }
  return true;
}

/// The same in closed form, of an arc in a plane: the distance to a line between two points has its extremes along a
/// circle where the circle is parallel to the line, and opposite the two points.
double farthest_on_circle(const Metric& metric, const Piece& piece, double from, double to, const Chord& chord) {
  const std::size_t x = piece.first, y = piece.second;
  const Point begin = from > 0 ? point_at(metric, piece, from) : piece.from;
  const Point end = to < piece.span ? point_at(metric, piece, to) : piece.to;
  const double begin_x = begin[x] - piece.center_first, begin_y = begin[y] - piece.center_second;
  const double end_x = end[x] - piece.center_first, end_y = end[y] - piece.center_second;
  double greatest = 0;
  const auto look = [&](double along_x, double along_y) {
    // Between both ends, which are at most a quarter turn apart?
    if (piece.side * (begin_x * along_y - begin_y * along_x) <= 0) return;
    if (piece.side * (along_x * end_y - along_y * end_x) <= 0) return;
    const double scale = piece.radius / std::hypot(along_x, along_y);
    Point point = piece.from;
    point[x] = piece.center_first + scale * along_x;
    point[y] = piece.center_second + scale * along_y;
    greatest = std::max(greatest, distance_to_chord(metric, chord, point));
  };
  look(chord.along[y], -chord.along[x]);
  look(-chord.along[y], chord.along[x]);
  const double from_x = piece.center_first - chord.from[x], from_y = piece.center_second - chord.from[y];
  look(from_x, from_y);
  look(from_x - chord.along[x], from_y - chord.along[y]);
  return greatest;
}

/// The largest distance to the chord of the points between two places, without the places themselves, by search.
double farthest_on_arc(const Metric& metric, const Piece& piece, double from, double to, const Chord& chord) {
  constexpr int samples = 8;
  const double step = (to - from) / samples;
  const auto at = [&](double place) { return distance_to_chord(metric, chord, point_at(metric, piece, place)); };
  double greatest = 0;
  double where = from;
  for (int i = 1; i < samples; ++i) {
    const double distance = at(from + i * step);
    if (distance > greatest) {
      greatest = distance;
      where = from + i * step;
    }
  }
  for (double width = step / 2; width > step * 1e-3; width /= 2) {
    for (const double place : {where - width, where + width}) {
      const double distance = at(place);
      if (distance > greatest) {
        greatest = distance;
        where = place;
      }
    }
  }
  return greatest;
}

}  // namespace

double farthest_from_chord(const Metric& metric, const Piece& piece, double from, double to, const Chord& chord,
                           double at_ends, double negligible) {
  if (piece.kind == Piece::Kind::curve) {
    return farthest_from_chord(metric, part(metric, piece.segment, from, to), chord, negligible);
  }
  // The arc's points lie within its sagitta of its own chord, and that within the distance of its ends.
  const double bound = greatest_sagitta(piece, from, to) + at_ends;
  if (bound <= negligible) return bound;
  if (!piece.helix && is_parallel(metric, piece, chord)) return farthest_on_circle(metric, piece, from, to, chord);
  return farthest_on_arc(metric, piece, from, to, chord);
}

}  // namespace leadscrew::referee
