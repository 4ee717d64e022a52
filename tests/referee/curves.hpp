#pragma once
// NURBS curves for the referee's tests: evaluated by the recursion of Cox and de Boor over basis functions, in extended
// precision, and gone along from rest to rest in each knot span, so that kinks and cusps at knots cost no jerk.

#include <limits>

#include "track.hpp"

namespace leadscrew::referee::test {

using gcode::NurbsCurve;

/// N_{i,p}(u) where u lies in the knot span `span` (de Boor, "A Practical Guide to Splines", ch. IX, eq. 14).
inline long double basis(const std::vector<double>& knots, std::size_t i, int p, std::size_t span, long double u) {
  if (p == 0) return i == span ? 1 : 0;
  const auto degree = static_cast<std::size_t>(p);
  const auto knot = [&](std::size_t k) { return static_cast<long double>(knots[k]); };
  long double sum = 0;
  if (knot(i + degree) > knot(i)) {
    sum += (u - knot(i)) / (knot(i + degree) - knot(i)) * basis(knots, i, p - 1, span, u);
  }
  if (knot(i + degree + 1) > knot(i + 1)) {
    sum += (knot(i + degree + 1) - u) / (knot(i + degree + 1) - knot(i + 1)) * basis(knots, i + 1, p - 1, span, u);
  }
  return sum;
}

inline AxisVector position_on(const NurbsCurve& curve, std::size_t span, long double u) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::array<long double, base::axis_count> moment{};
  long double weight = 0;
  for (std::size_t i = span - degree; i <= span; ++i) {
    const long double share = basis(curve.knots, i, curve.degree, span, u) * curve.points[i].weight;
    weight += share;
    for (std::size_t k = 0; k < base::axis_count; ++k) moment[k] += share * curve.points[i].position[k];
  }
  AxisVector result{};
  for (std::size_t k = 0; k < base::axis_count; ++k) result[k] = static_cast<double>(moment[k] / weight);
  return result;
}

/// Knot spans of some length.
inline std::vector<std::size_t> spans_of(const NurbsCurve& curve) {
  std::vector<std::size_t> spans;
  for (auto k = static_cast<std::size_t>(curve.degree); k < curve.points.size(); ++k) {
    if (curve.knots[k] < curve.knots[k + 1]) spans.push_back(k);
  }
  return spans;
}

inline NurbsCurve clamped(int degree, std::vector<gcode::ControlPoint> points) {
  NurbsCurve curve{degree, std::move(points), {}};
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t inner = curve.points.size() - p - 1;
  curve.knots.assign(p + 1, 0);
  for (std::size_t i = 1; i <= inner; ++i) curve.knots.push_back(static_cast<double>(i));
  curve.knots.insert(curve.knots.end(), p + 1, static_cast<double>(inner + 1));
  return curve;
}

inline void add_curve(Program& program, const NurbsCurve& curve) {
  const std::vector<std::size_t> spans = spans_of(curve);
  program.position = position_on(curve, spans.front(), curve.knots[spans.front()]);
  Move move;
  move.kind = Move::Kind::nurbs;
  move.curve = curve;
  program.add(move, position_on(curve, spans.back(), curve.knots[spans.back() + 1]));
}

inline Program program_of(const NurbsCurve& curve) {
  Program program;
  add_curve(program, curve);
  return program;
}

/// From rest to rest along a share of a move.
struct Leg {
  std::function<AxisVector(double)> at;  // after a share 0 … 1 of the length by the time law
  double duration = 0;
};

/// A duration in which three quarters of every limit are kept, from differences of a thousand samples; at a programmed
/// feed, also `ratio` of that.
inline double duration_of(const std::function<AxisVector(double)>& at, const gcode::Feed& feed,
                          const machine::Machine& machine, double ratio) {
  constexpr int samples = 1000;
  constexpr double share = 0.75;
  std::vector<AxisVector> places;
  for (int i = 0; i <= samples; ++i) places.push_back(at(law(static_cast<double>(i) / samples)));
  const double step = 1.0 / samples;
  double least = 0, fastest = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    double speed = 0;
    for (std::size_t k = 0; k < base::axis_count; ++k) {
      if (!machine.axes[k]) continue;
      const auto q = [&](std::size_t n) { return places[std::min(n, places.size() - 1)][k]; };
      const double v = std::abs(q(i + 1) - q(i)) / step;
      const double a = std::abs(q(i + 2) - 2 * q(i + 1) + q(i)) / (step * step);
      const double j = std::abs(q(i + 3) - 3 * q(i + 2) + 3 * q(i + 1) - q(i)) / (step * step * step);
      least = std::max({least, v / (share * machine.axes[k]->velocity),
                        std::sqrt(a / (share * machine.axes[k]->acceleration)),
                        std::cbrt(j / (share * machine.axes[k]->jerk))});
      if (k < 3) speed += v * v;
    }
    fastest = std::max(fastest, std::sqrt(speed));
  }
  if (feed.mode == gcode::Feed::Mode::units_per_second) least = std::max(least, fastest / (ratio * feed.value));
  return std::max(least, 1e-6);
}

inline std::vector<Leg> legs_of(const std::vector<Move>& moves, const machine::Machine& machine, double ratio = 0.9) {
  std::vector<Leg> legs;
  const auto add = [&](const Move& move, std::function<AxisVector(double)> at) {
    const double duration = duration_of(at, move.feed, machine, ratio);
    legs.push_back({std::move(at), duration});
  };
  for (const Move& move : moves) {
    if (move.kind != Move::Kind::nurbs) {
      add(move, [&move](double share) { return position_on(move, share); });
      continue;
    }
    for (const std::size_t span : spans_of(move.curve)) {
      add(move, [&move, span](double share) {
        const long double from = move.curve.knots[span], to = move.curve.knots[span + 1];
        return position_on(move.curve, span, from + (to - from) * share);
      });
    }
  }
  return legs;
}

inline Words sample(const std::vector<Leg>& legs, base::Period period, double delay = 0.3e-3) {
  Words words;
  double begins = delay;
  std::size_t i = 0;
  while (true) {
    const double t = static_cast<double>(words.size()) * period.seconds();
    while (i + 1 < legs.size() && t >= begins + legs[i].duration) begins += legs[i++].duration;
    words.push_back(legs[i].at(law((t - begins) / legs[i].duration)));
    if (i + 1 == legs.size() && t >= begins + legs[i].duration) return words;
  }
}

/// Words along lines, arcs and curves.
inline Words exact_words(const Program& program, const machine::Machine& machine, base::Period period) {
  return sample(legs_of(program.moves, machine), period);
}

/// A circle as four rational quarters, counterclockwise from its rightmost point ("The NURBS Book", sec. 7.5).
inline NurbsCurve circle_curve(double x, double y, double radius) {
  const double w = std::sqrt(0.5), r = radius;
  const double corners[9][3] = {{r, 0, 1},   {r, r, w},  {0, r, 1},  {-r, r, w}, {-r, 0, 1},
                                {-r, -r, w}, {0, -r, 1}, {r, -r, w}, {r, 0, 1}};
  NurbsCurve curve{2, {}, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}};
  for (const auto& corner : corners) curve.points.push_back({{x + corner[0], y + corner[1]}, corner[2]});
  return curve;
}

/// Any degree, weights over two decades, uneven and repeated knots, clamped or not, coincident points, two to five
/// axes.
inline NurbsCurve random_curve(std::mt19937_64& random, int degree, int count, double size, double offset) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto chance = [&](double probability) { return uniform(0, 1) < probability; };
  const bool rational = chance(0.6), spatial = chance(0.5), rotary = chance(0.3), begins_clamped = chance(0.8);
  NurbsCurve curve;
  curve.degree = degree;
  for (int i = 0; i < count; ++i) {
    gcode::ControlPoint point;
    at(point.position, Axis::X) = offset + uniform(-size, size);
    at(point.position, Axis::Y) = offset + uniform(-size, size);
    if (spatial) at(point.position, Axis::Z) = offset + uniform(-size, size);
    if (rotary) at(point.position, Axis::C) = uniform(-90, 90);
    if (rational) point.weight = std::exp(uniform(-2.3, 2.3));
    if (i > 0 && chance(0.15)) point.position = curve.points.back().position;
    if (i > 1 && chance(0.1)) point.position = curve.points[static_cast<std::size_t>(i) - 2].position;
    curve.points.push_back(point);
  }
  const int knots = count + degree + 1;
  double knot = uniform(-3, 3);
  int repeated = 1;
  for (int i = 0; i < knots; ++i) {
    const bool outside = i <= degree || i > count;
    const bool stays = outside && i != 0 ? begins_clamped : chance(0.3) && repeated < degree;
    if (i > 0 && !(stays && !(i == degree + 1) && !(i == count))) {
      knot += chance(0.1) ? uniform(1e-4, 1e-3) : uniform(0.1, 1);
      repeated = 0;
    }
    ++repeated;
    curve.knots.push_back(knot);
  }
  return curve;
}

}  // namespace leadscrew::referee::test
