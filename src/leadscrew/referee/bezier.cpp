#include <algorithm>
#include <leadscrew/referee/bezier.hpp>
#include <limits>

namespace leadscrew::referee {

namespace {

constexpr double least_size = nanometre / 1000;  // mm; a thousandth of what is held against a trace
constexpr int most_halvings = 60;                // of 0 ≤ t ≤ 1

using ControlPoints = std::array<Weighted, gcode::highest_degree + 1>;

/// One level of de Casteljau's algorithm: `count` points become count − 1.
void reduce(const Metric& metric, ControlPoints& points, int count, double x) {
  for (int i = 0; i + 1 < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    points[at] = between(metric, points[at], points[at + 1], x);
  }
}

/// The control points themselves, mm.
struct Polygon {
  int legs = 0;
  std::array<Point, gcode::highest_degree + 1> points;

  Polygon(const Metric& metric, const Bezier& bezier) : legs(bezier.degree) {
    for (std::size_t i = 0; i <= last(); ++i) points[i] = projected(metric, bezier.control[i]);
  }
  std::size_t last() const { return static_cast<std::size_t>(legs); }

  double length(const Metric& metric) const {
    double sum = 0;
    for (std::size_t i = 0; i < last(); ++i) sum += metric.distance(points[i], points[i + 1]);
    return sum;
  }

  /// What evaluating the curve may be off by, generously: 64 units in the last place of the largest coordinate, mm.
  double rounding(const Metric& metric) const {
    double largest = 0;
    for (std::size_t i = 0; i <= last(); ++i) {
      for (std::size_t k = 0; k < metric.dimensions(); ++k) largest = std::max(largest, std::abs(points[i][k]));
    }
    return 64 * std::numeric_limits<double>::epsilon() * largest;
  }
};

Point difference(const Metric& metric, const Point& a, const Point& b) {
  Point result{};
  for (std::size_t i = 0; i < metric.dimensions(); ++i) result[i] = a[i] - b[i];
  return result;
}

/// C, C′ and C″ at t.
struct Local {
  Point position{}, first{}, second{};
  double leg_speed = 0;  // |C′| over the length of de Casteljau's last leg
};

/// With A = wC: A and w are de Casteljau's last point, A′ and A″ come from differences of the levels before, and
///   C′ = p·w0·w1/w²·(P1 − P0),   C″ = (A″ − 2w′C′ − w″C)/w      (Floater eq. 7; "The NURBS Book" eq. 4.8).
Local local_at(const Metric& metric, const Bezier& bezier, double t) {
  ControlPoints points = bezier.control;
  for (int count = bezier.degree + 1; count > 3; --count) reduce(metric, points, count, t);
  const ControlPoints three = points;
  if (bezier.degree > 1) reduce(metric, points, 3, t);
  const Weighted last = between(metric, points[0], points[1], t);
  const double p = bezier.degree, w = last.weight;
  const double w1 = p * (points[1].weight - points[0].weight);
  const auto bend = [p](double a, double b, double c) { return p * (p - 1) * (a - 2 * b + c); };
  const double w2 = bezier.degree > 1 ? bend(three[0].weight, three[1].weight, three[2].weight) : 0;
  Local local;
  local.leg_speed = p * (points[0].weight / w) * (points[1].weight / w);
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    local.position[i] = last.moment[i] / w;
    local.first[i] =
        local.leg_speed * (points[1].moment[i] / points[1].weight - points[0].moment[i] / points[0].weight);
    const double a2 = bezier.degree > 1 ? bend(three[0].moment[i], three[1].moment[i], three[2].moment[i]) : 0;
    local.second[i] = (a2 - 2 * w1 * local.first[i] - w2 * local.position[i]) / w;
  }
  return local;
}

/// Finds where (C − q)·C′ = 0 between two places, by Newton's steps as long as they stay inside and shrink by half, and
/// by halving where they do not.
///
/// Where very unequal weights or coincident points make the curve stand still, C′ is rounding. The chord, from which no
/// tangent turns by more than π/8, is then taken for the direction; at an end of the segment the search goes inside.
class Descent {
 public:
  Descent(const Metric& metric, const Bezier& bezier, const Point& point)
      : metric_(metric), bezier_(bezier), point_(point) {
    const Polygon polygon(metric, bezier);
    rounding_ = polygon.rounding(metric);
    chord_ = difference(metric, polygon.points[polygon.last()], polygon.points[0]);
  }

  double squared(double t) const { return metric_.squared_distance(point_at(metric_, bezier_, t), point_); }

  double minimum(double low, double high, double t) {
    low_ = {low, {}, false};
    high_ = {high, {}, false};
    step_ = high - low;
    for (int i = 0; i < most_halvings && low_.t < high_.t && !closed(); ++i) {
      const Local here = local_at(metric_, bezier_, t);
      const Point offset = difference(metric_, here.position, point_);
      const double squared_speed = metric_.dot(here.first, here.first);
      const bool standing = squared_speed <= here.leg_speed * here.leg_speed * rounding_ * rounding_;
      const double slope = metric_.dot(offset, standing ? chord_ : here.first);
      if (!standing && slope * slope <= rounding_ * rounding_ * squared_speed) return t;
      const bool ahead = standing && (t <= 0 || t >= 1) ? t <= 0 : slope < 0;
      (ahead ? low_ : high_) = {t, here.position, true};
      const double curvature = squared_speed + metric_.dot(offset, here.second);
      const double next = next_after(t, standing || !(curvature > 0) ? none : t - slope / curvature);
      step_ = std::abs(next - t);
      t = next;
    }
    return t;
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  struct End {
    double t = 0;
    Point position{};
    bool seen = false;
  };

  /// Whether all that is left is rounding.
  bool closed() const {
    return low_.seen && high_.seen && metric_.distance(low_.position, high_.position) <= rounding_;
  }

  double next_after(double t, double newton) const {
    if (newton > low_.t && newton < high_.t && std::abs(newton - t) <= step_ / 2) return newton;
    if (newton <= low_.t && !low_.seen) return low_.t;
    if (newton >= high_.t && !high_.seen) return high_.t;
    return low_.t + (high_.t - low_.t) / 2;
  }

  const Metric& metric_;
  const Bezier& bezier_;
  const Point& point_;
  double rounding_ = 0;
  Point chord_{};
  End low_, high_;
  double step_ = 1;
};

/// No less than the distance to the chord of any point of the segment: the distance to a convex set is a convex
/// function, so that the control points have the largest of their hull.
double greatest_of_hull(const Metric& metric, const Bezier& bezier, const Chord& chord) {
  double greatest = 0;
  for (int i = 0; i <= bezier.degree; ++i) {
    const Point point = projected(metric, bezier.control[static_cast<std::size_t>(i)]);
    greatest = std::max(greatest, distance_to_chord(metric, chord, point));
  }
  return greatest;
}

/// Halves the segment until no hull exceeds the farthest point found or `negligible`.
void bound_farthest(const Metric& metric, const Bezier& bezier, const Chord& chord, double negligible, int halvings,
                    double& farthest) {
  if (halvings == 0 || greatest_of_hull(metric, bezier, chord) <= std::max(negligible, farthest + least_size)) return;
  farthest = std::max(farthest, distance_to_chord(metric, chord, point_at(metric, bezier, 0.5)));
  bound_farthest(metric, part(metric, bezier, 0, 0.5), chord, negligible, halvings - 1, farthest);
  bound_farthest(metric, part(metric, bezier, 0.5, 1), chord, negligible, halvings - 1, farthest);
}

constexpr double straight = 1e-4;  // chord and legs differ by no more than this share of their length

double length_halved(const Metric& metric, const Coordinates& coordinates, const Bezier& bezier, int halvings) {
  const Polygon polygon(metric, bezier);
  double legs = 0;
  for (std::size_t i = 0; i < polygon.last(); ++i) {
    legs += distance_in(metric, coordinates, polygon.points[i], polygon.points[i + 1]);
  }
  const double chord = distance_in(metric, coordinates, polygon.points[0], polygon.points[polygon.last()]);
  if (halvings == 0 || legs - chord <= straight * legs || legs <= least_size) {
    return (2 * chord + (bezier.degree - 1) * legs) / (bezier.degree + 1);
  }
  return length_halved(metric, coordinates, part(metric, bezier, 0, 0.5), halvings - 1) +
         length_halved(metric, coordinates, part(metric, bezier, 0.5, 1), halvings - 1);
}

}  // namespace

Point point_at(const Metric& metric, const Bezier& bezier, double t) {
  ControlPoints points = bezier.control;
  for (int count = bezier.degree + 1; count > 1; --count) reduce(metric, points, count, t);
  return projected(metric, points[0]);
}

Bezier part(const Metric& metric, const Bezier& bezier, double from, double to) {
  Bezier result;
  result.degree = bezier.degree;
  for (int j = 0; j <= bezier.degree; ++j) {
    ControlPoints points = bezier.control;
    for (int level = 0; level < bezier.degree; ++level) {
      reduce(metric, points, bezier.degree + 1 - level, level < bezier.degree - j ? from : to);
    }
    result.control[static_cast<std::size_t>(j)] = points[0];
  }
  return result;
}

bool turns_little(const Metric& metric, const Bezier& bezier) {
  constexpr double squared_cosine = 0.8535533905932737;  // of π/8: (2 + √2)/4
  const Polygon polygon(metric, bezier);
  if (polygon.length(metric) <= std::max(least_size, polygon.rounding(metric))) return true;
  const Point chord = difference(metric, polygon.points[polygon.last()], polygon.points[0]);
  const double squared_chord = metric.dot(chord, chord);
  const double rounding = polygon.rounding(metric);
  for (std::size_t i = 0; i < polygon.last(); ++i) {
    const Point leg = difference(metric, polygon.points[i + 1], polygon.points[i]);
    const double squared_leg = metric.dot(leg, leg);
    if (squared_leg <= rounding * rounding) continue;  // of no direction
    const double along = metric.dot(leg, chord);
    if (!(along > 0) || along * along < squared_cosine * squared_leg * squared_chord) return false;
  }
  return true;
}

bool has_length(const Metric& metric, const Bezier& bezier) {
  const Polygon polygon(metric, bezier);
  return polygon.length(metric) > polygon.rounding(metric);
}

double nearest_place(const Metric& metric, const Bezier& bezier, const Point& point) {
  constexpr int samples = 4;
  Descent descent(metric, bezier, point);
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double squared = descent.squared(static_cast<double>(i) / samples);
    if (squared < least) {
      least = squared;
      best = i;
    }
  }
  const double sample = static_cast<double>(best) / samples;
  const double low = std::max(0, best - 1) / static_cast<double>(samples);
  const double high = std::min(samples, best + 1) / static_cast<double>(samples);
  const double start = best == 0 || best == samples ? (low + high) / 2 : sample;
  const double place = descent.minimum(low, high, start);
  return descent.squared(place) <= least ? place : sample;
}

double farthest_from_chord(const Metric& metric, const Bezier& bezier, const Chord& chord, double negligible) {
  double farthest = std::max(distance_to_chord(metric, chord, point_at(metric, bezier, 0)),
                             distance_to_chord(metric, chord, point_at(metric, bezier, 1)));
  bound_farthest(metric, bezier, chord, negligible, most_halvings, farthest);
  return farthest;
}

double distance_in(const Metric& metric, const Coordinates& coordinates, const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    if (coordinates[i]) sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum);
}

/// Halved until chord and legs nearly agree; then their weighted mean, which is exact to the fourth order of the size
/// (Gravesen, "Adaptive subdivision and the length and energy of Bezier curves", 1997).
double length_in(const Metric& metric, const Coordinates& coordinates, const Bezier& bezier) {
  return length_halved(metric, coordinates, bezier, most_halvings);
}

void Turning::add(const Bezier& bezier) {
  const Polygon polygon(metric_, bezier);
  const double rounding = polygon.rounding(metric_);
  for (std::size_t i = 0; i < polygon.last(); ++i) {
    const double length = distance_in(metric_, coordinates_, polygon.points[i], polygon.points[i + 1]);
    if (!(length > rounding)) continue;  // of no direction
    Point direction{};
    for (std::size_t k = 0; k < metric_.dimensions(); ++k) {
      if (coordinates_[k]) direction[k] = (polygon.points[i + 1][k] - polygon.points[i][k]) / length;
    }
    if (metric_.dot(direction_, direction_) > 0) {
      sum_ += std::acos(std::clamp(metric_.dot(direction_, direction), -1.0, 1.0));
    }
    direction_ = direction;
  }
}

}  // namespace leadscrew::referee
