#pragma once
// What Nurbs looks up: for each piece of u(s) a record of numbers, all of a curve in one array.
//
//   [ s low | c1 … c5 | u at its beginning | du/dx | w1 … wp (rational curves) | for each moving coordinate: origin, n0
//   … np ]
//
//   x(σ) = c1 σ + … + c5 σ⁵,  σ = s − s_begin          parameter, counted from the beginning of the record
//   q_i(x) = origin_i + (n0 + n1 x + … + np x^p) / (1 + w1 x + … + wp x^p)
//
// Everything is counted from the beginning of the record, which is on the curve, so that rounding errors are of the
// size of the record's extent, and the last sum rounds once.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/geometry/point.hpp>
#include <optional>
#include <vector>

namespace leadscrew::geometry {

struct NurbsTable {
  static constexpr std::size_t s_low = 0, map = 1, parameter = 6, width = 7, polynomials = 8;

  std::size_t degree = 0;
  bool rational = false;
  std::size_t moving_count = 0;
  std::array<std::uint8_t, base::axis_count> moving{};  ///< coordinates that move, ascending
  std::size_t stride = 0;                               ///< numbers in a record
  std::optional<Point> weights;                         ///< by which length is told

  std::vector<double> nodes;           ///< arc length at the beginning of each record, from 0 on each smooth piece
  std::vector<double> records;         ///< stride numbers for each
  std::vector<std::uint32_t> buckets;  ///< of each smooth piece: equal parts of its length → the record it begins in
  std::vector<double> breaks;

  const double* record(std::size_t index) const { return records.data() + index * stride; }
};

/// X, U or A: in this order, the first of X Y Z, U V W or A B C of which one moves.
std::size_t first_to_move(base::AxisSet moving);
/// By which coordinates length is told, times what: `weights`; else once for the three from the first to move.
Point length_weights(base::AxisSet moving, const std::optional<Point>& weights);

}  // namespace leadscrew::geometry
