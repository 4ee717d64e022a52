#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/nurbs.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double least_span = 1e-12;  // of the range of the parameter
constexpr int most_halvings = 100;    // weights of any ratio are level after fewer

std::size_t degree_of(const NurbsCurve& curve) {
  return static_cast<std::size_t>(curve.degree);
}

// (1 − α) a + α b of homogeneous points (w x, w), as a position and a weight.
ControlPoint blend(const ControlPoint& a, const ControlPoint& b, double alpha) {
  ControlPoint point;
  point.weight = (1 - alpha) * a.weight + alpha * b.weight;
  const double share = alpha * b.weight / point.weight;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    point.position[i] = a.position[i] + share * (b.position[i] - a.position[i]);
  }
  return point;
}

// The knots that equal u: `first` up to but without `last`. They need not lie at the ends.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t length() const { return last - first; }
};
Run run_of(const NurbsCurve& curve, double u) {
  const auto range = std::equal_range(curve.knots.begin(), curve.knots.end(), u);
  return {static_cast<std::size_t>(range.first - curve.knots.begin()),
          static_cast<std::size_t>(range.second - curve.knots.begin())};
}

// Inserts knots at u until it stands p times. With u_k the last knot that equals u, s of them, the points from k − p +
// 1 to k − s are new (eq. 5.15):
//
//     Q_i = α_i P_i + (1 − α_i) P_{i−1},  α_i = (u − u_i) / (u_{i+p} − u_i)
//
// and those behind move up by one.
void insert_to_full(NurbsCurve& curve, double u) {
  const std::size_t p = degree_of(curve);
  for (Run run = run_of(curve, u); run.length() < p; run = run_of(curve, u)) {
    const std::size_t k = run.last - 1;
    const std::size_t last_new = k - run.length();
    const auto& knots = curve.knots;
    auto& points = curve.points;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(last_new), ControlPoint{});
    // From the back, so that each P_{i−1} is still the old one.
    ControlPoint above = points[last_new + 1];
    for (std::size_t i = last_new; i + p > k; --i) {
      const ControlPoint below = points[i - 1];
      points[i] = blend(below, above, (u - knots[i]) / (knots[i + p] - knots[i]));
      above = below;
    }
    curve.knots.insert(curve.knots.begin() + static_cast<std::ptrdiff_t>(run.last), u);
  }
}

// A coordinate times its weight, and the weight.
struct Homogeneous {
  double x = 0;
  double w = 1;
  double value() const { return x / w; }
};
using Piece = std::array<Homogeneous, highest_degree + 1>;

Homogeneous between(const Homogeneous& a, const Homogeneous& b, double alpha) {
  return {(1 - alpha) * a.x + alpha * b.x, (1 - alpha) * a.w + alpha * b.w};
}

// One coordinate of a curve, upwards or downwards, and how far it reaches.
class Reach {
 public:
  Reach(const NurbsCurve& curve, base::Axis axis, int sign, double limit)
      : curve_(curve), axis_(base::index(axis)), sign_(sign), best_(sign * limit), resolution_(reach_resolution) {
    double largest = 0;
    for (const ControlPoint& point : curve.points) largest = std::max(largest, std::fabs(point.position[axis_]));
    // Halves of halves stop coming closer where rounding keeps them apart.
    resolution_ = std::max(resolution_, 64 * std::numeric_limits<double>::epsilon() * largest);
  }

  double operator()() {
    const std::size_t p = degree_of(curve_);
    for (std::size_t span = p; span < curve_.points.size(); ++span) {
      if (curve_.knots[span] == curve_.knots[span + 1] || !rises_above(span)) continue;
      raise(piece_of(span), most_halvings);
    }
    return sign_ * best_;
  }

 private:
  bool rises_above(std::size_t span) const {
    const std::size_t p = degree_of(curve_);
    for (std::size_t i = span - p; i <= span; ++i) {
      if (sign_ * curve_.points[i].position[axis_] > best_) return true;
    }
    return false;
  }

  // The Bézier points of the curve between u_span = a and u_span+1 = b: the k-th is its blossom at p − k times a and k
  // times b, by de Boor's recursion with an argument of its own in each step.
  Piece piece_of(std::size_t span) const {
    const std::size_t p = degree_of(curve_);
    const auto& u = curve_.knots;
    Piece piece;
    for (std::size_t k = 0; k <= p; ++k) {
      Piece d;
      for (std::size_t i = 0; i <= p; ++i) {
        const ControlPoint& point = curve_.points[span - p + i];
        d[i] = {sign_ * point.weight * point.position[axis_], point.weight};
      }
      for (std::size_t r = 1; r <= p; ++r) {
        const double argument = r + k <= p ? u[span] : u[span + 1];
        for (std::size_t i = p; i >= r; --i) {
          const std::size_t low = span - p + i;
          const std::size_t high = low + p + 1 - r;
          d[i] = between(d[i - 1], d[i], (argument - u[low]) / (u[high] - u[low]));
        }
      }
      piece[k] = d[p];
    }
    return piece;
  }

  void raise(const Piece& piece, int halvings) {
    const std::size_t p = degree_of(curve_);
    best_ = std::max({best_, piece[0].value(), piece[p].value()});
    double hull = best_;
    for (std::size_t i = 1; i < p; ++i) hull = std::max(hull, piece[i].value());
    if (hull <= best_ + resolution_ || halvings == 0) return;
    // De Casteljau's halves: the first points of his columns, and the last.
    Piece low;
    Piece high = piece;
    low[0] = piece[0];
    for (std::size_t r = 1; r <= p; ++r) {
      for (std::size_t i = 0; i + r <= p; ++i) high[i] = between(high[i], high[i + 1], 0.5);
      low[r] = high[0];
    }
    raise(low, halvings - 1);
    raise(high, halvings - 1);
  }

  const NurbsCurve& curve_;
  std::size_t axis_;
  int sign_;
  double best_;
  double resolution_;
};

}  // namespace

void set_uniform_knots(NurbsCurve& curve) {
  const std::size_t p = degree_of(curve);
  const std::size_t n = curve.points.size();
  curve.knots.clear();
  for (std::size_t i = 0; i <= n + p; ++i) {
    curve.knots.push_back(static_cast<double>(std::clamp(i, p, n) - p));
  }
}

KnotProblem judge_last_knot(const NurbsCurve& curve, bool all_points) {
  const auto& knots = curve.knots;
  const std::size_t last = knots.size() - 1;
  if (last > 0 && knots[last] < knots[last - 1]) return KnotProblem::decreases;
  std::size_t first = last;
  while (first > 0 && knots[first - 1] == knots[last]) --first;
  const std::size_t length = last - first + 1;
  const std::size_t p = degree_of(curve);
  const bool at_end = first == 0 || (all_points && first == curve.points.size());
  return length > (at_end ? p + 1 : p) ? KnotProblem::repeats : KnotProblem::none;
}

bool knots_are_apart(const NurbsCurve& curve) {
  const auto& knots = curve.knots;
  const double range = knots[curve.points.size()] - knots[degree_of(curve)];
  if (!(range > 0)) return false;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double span = knots[i] - knots[i - 1];
    if (span != 0 && span < least_span * range) return false;
  }
  return true;
}

void clamp_ends(NurbsCurve& curve) {
  const std::size_t p = degree_of(curve);
  const double from = curve.knots[p];
  const double to = curve.knots[curve.points.size()];
  insert_to_full(curve, to);
  insert_to_full(curve, from);
  // Where only u_m … u_m+p−1 equal u, the curve passes through P_m−1 there, and the knot beside them has no influence
  // on that side of it.
  const std::size_t end = run_of(curve, to).first;
  curve.points.resize(end);
  curve.knots.resize(end + p + 1);
  curve.knots.back() = to;
  const std::size_t begin = run_of(curve, from).last - 1 - p;
  curve.points.erase(curve.points.begin(), curve.points.begin() + static_cast<std::ptrdiff_t>(begin));
  curve.knots.erase(curve.knots.begin(), curve.knots.begin() + static_cast<std::ptrdiff_t>(begin));
  curve.knots.front() = from;
}

double reach_beyond(const NurbsCurve& curve, base::Axis axis, int sign, double limit) {
  return Reach(curve, axis, sign, limit)();
}

bool make_arc_curve(NurbsCurve& curve, Plane plane, const base::AxisVector& start, const base::AxisVector& end,
                    PlanePoint center, int turns) {
  constexpr double longest = std::numbers::pi / 6;
  const int direction = turns > 0 ? 1 : -1;
  const PlanePoint from = in_plane(start, plane), to = in_plane(end, plane);
  const double angle = sweep(from, to, center, direction) + (std::abs(turns) - 1) * 2 * std::numbers::pi;
  double beside = 0;
  for (std::size_t k = 0; k < base::axis_count; ++k) {
    const bool in_it = k == base::index(first_axis(plane)) || k == base::index(second_axis(plane));
    if (!in_it) beside = std::max(beside, std::fabs(end[k] - start[k]));
  }
  // A piece of 30 degrees is off by 0.00222 of what it goes beside the plane, and by the cube of a smaller angle.
  double pieces = std::max(1.0, std::ceil(angle / longest - 1e-9));
  const double off = 0.00222 * beside / pieces;
  if (off > arc_curve_tolerance) pieces = std::ceil(pieces * numeric::cbrt(off / arc_curve_tolerance));
  curve.clear();
  if (2 * pieces + 1 > static_cast<double>(most_control_points)) return false;
  const auto count = static_cast<std::size_t>(pieces);
  const double half = angle / pieces / 2;
  const double x = from.first - center.first, y = from.second - center.second;
  curve.degree = 2;
  for (std::size_t i = 0; i <= 2 * count; ++i) {
    // Between the ends of a piece, where the tangents meet.
    const bool between = i % 2 == 1;
    const double turned = direction * static_cast<double>(i) * half;
    const double reach = between ? 1 / numeric::cos(half) : 1;
    const numeric::Sines sines = numeric::sines(turned);
    const double sine = sines.sine * reach, cosine = sines.cosine * reach;
    ControlPoint point{start, between ? numeric::cos(half) : 1};
    const double share = static_cast<double>(i) / static_cast<double>(2 * count);
    for (std::size_t k = 0; k < base::axis_count; ++k) point.position[k] += (end[k] - start[k]) * share;
    point.position[base::index(first_axis(plane))] = center.first + cosine * x - sine * y;
    point.position[base::index(second_axis(plane))] = center.second + sine * x + cosine * y;
    curve.points.push_back(point);
  }
  curve.points.front().position = start;
  curve.points.back().position = end;
  for (std::size_t i = 0; i <= count; ++i) {
    const bool outer = i == 0 || i == count;
    for (int k = 0; k < (outer ? 3 : 2); ++k) curve.knots.push_back(static_cast<double>(i));
  }
  return true;
}

}  // namespace leadscrew::gcode
