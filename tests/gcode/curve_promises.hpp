#pragma once
// What move.hpp promises of every curve, and a point of it by the definition of its basis functions.

#include <array>
#include <cmath>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::gcode {

/// C(u) by the recursion of Cox and de Boor (Piegl and Tiller, eq. 2.5 and 4.1), in extended precision; the last of the
/// parameters belongs to the last span that is not empty. The curve need not be clamped.
inline std::array<long double, base::axis_count> point_of(const NurbsCurve& curve, double u) {
  const auto p = static_cast<std::size_t>(curve.degree);
  const auto& knots = curve.knots;
  std::size_t span = p;
  while (span + 1 < curve.points.size() && knots[span + 1] <= u) ++span;
  while (knots[span] == knots[span + 1]) --span;
  std::vector<long double> basis(knots.size() - 1, 0);
  basis[span] = 1;
  for (std::size_t q = 1; q <= p; ++q) {
    for (std::size_t i = 0; i + q + 1 < knots.size(); ++i) {
      const long double left = static_cast<long double>(knots[i + q]) - knots[i];
      const long double right = static_cast<long double>(knots[i + q + 1]) - knots[i + 1];
      basis[i] = (left > 0 ? (static_cast<long double>(u) - knots[i]) / left * basis[i] : 0) +
                 (right > 0 ? (static_cast<long double>(knots[i + q + 1]) - u) / right * basis[i + 1] : 0);
    }
  }
  std::array<long double, base::axis_count> sum{};
  long double weight = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    weight += basis[i] * curve.points[i].weight;
    for (std::size_t k = 0; k < base::axis_count; ++k) {
      sum[k] += basis[i] * curve.points[i].weight * curve.points[i].position[k];
    }
  }
  for (auto& s : sum) s /= weight;
  return sum;
}

/// Whether the knots are clamped, in order and apart, and no inner one stands more than p times.
inline bool knots_keep_their_promises(const NurbsCurve& curve) {
  const auto p = static_cast<std::size_t>(curve.degree);
  const std::size_t n = curve.points.size();
  if (curve.degree < 1 || curve.degree > highest_degree || n <= p || n > most_control_points) return false;
  if (curve.knots.size() != n + p + 1) return false;
  const auto& u = curve.knots;
  const double range = u.back() - u.front();
  std::size_t run = 1;
  for (std::size_t i = 1; i < u.size(); ++i) {
    const double span = u[i] - u[i - 1];
    if (span < 0 || (span > 0 && span < 1e-12 * range)) return false;
    run = span == 0 ? run + 1 : 1;
    if (run > (i == p || i == n + p ? p + 1 : p)) return false;
  }
  return range > 0 && u[p] == u[0] && u[n] == u[n + p];
}

/// Whether a move keeps what move.hpp promises of its curve; one of another kind has none.
inline bool keeps_promises_of_curve(const Move& move) {
  const NurbsCurve& curve = move.curve;
  if (move.kind != Move::Kind::nurbs) return curve.degree == 0 && curve.points.empty() && curve.knots.empty();
  if (!knots_keep_their_promises(curve)) return false;
  bool moves = false;
  for (const ControlPoint& point : curve.points) {
    if (!(point.weight >= 1e-9 && point.weight <= 1e9)) return false;
    moves |= point.position != move.start;
    for (const double x : point.position) {
      if (!std::isfinite(x)) return false;
    }
  }
  return moves && curve.points.front().position == move.start && curve.points.back().position == move.end &&
         move.feed.mode != Feed::Mode::rapid && move.feed.value > 0;
}

/// Whether so many points of the curve are inside the travel of the machine.
inline bool curve_is_inside(const Move& move, const machine::Machine& machine, int samples) {
  const double from = move.curve.knots.front(), to = move.curve.knots.back();
  for (int i = 0; i <= samples; ++i) {
    const auto point = point_of(move.curve, from + (to - from) * i / samples);
    for (const base::Axis axis : base::all_axes) {
      const long double x = point[base::index(axis)];
      if (!machine.has(axis)) {
        if (x != move.start[base::index(axis)]) return false;
      } else if (x < machine.limits(axis).travel_min - 2e-6 || x > machine.limits(axis).travel_max + 2e-6) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace leadscrew::gcode
