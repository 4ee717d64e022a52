#include <algorithm>
#include <cmath>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>

namespace leadscrew::geometry {

namespace {

/// Value and first derivative of c[0] + … + c[degree] x^degree, as polynomial_jet() has them.
struct Tangent {
  double value = 0, slope = 0;
};
Tangent tangent(const double* c, std::size_t degree, double x) {
  Tangent t;
  for (std::size_t k = degree + 1; k-- > 0;) {
    t.slope = t.slope * x + t.value;
    t.value = t.value * x + c[k];
  }
  return t;
}

}  // namespace

/// Operation by operation as in Nurbs::jets().
Rates Nurbs::rates(double s, std::size_t first) const {
  const NurbsTable& table = *table_;
  const std::size_t index = record_at(std::clamp(s, 0.0, length_));
  const double* const record = table.record(index);
  const double sigma = s - table.nodes[index] - record[NurbsTable::s_low];
  const Tangent map = tangent(record + NurbsTable::map, 4, sigma);
  const double x = map.value * sigma, x_rate = map.slope * sigma + map.value;
  const double* numbers = record + NurbsTable::polynomials;
  Tangent scale{1, 0};
  if (table.rational) {
    const Tangent weight = tangent(numbers, table.degree - 1, x);
    const double r = 1 / (1 + weight.value * x);
    scale = {r, -r * r * (weight.slope * x + weight.value)};
    numbers += table.degree;
  }
  Rates rates{};
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers += table.degree + 2) {
    const std::size_t i = table.moving[k] - first;
    if (i >= rates.size()) continue;
    Tangent q = tangent(numbers + 1, table.degree, x);
    if (table.rational) q.slope = q.slope * scale.value + q.value * scale.slope;
    rates[i] = q.slope * x_rate;
  }
  return rates;
}

/// q‴ = C′x‴ + … with C′ = q′/x′, and x′ and x″ are those of the curve on both sides.
Nurbs::Border Nurbs::map_border(double from, std::size_t index) const {
  const std::size_t behind = record_at(from) + 1 + index;
  const double* const left = table_->record(behind - 1) + NurbsTable::map;
  const double* const right = table_->record(behind) + NurbsTable::map;
  const double h = table_->nodes[behind] - table_->nodes[behind - 1];
  const double left_first = left[0] + h * (2 * left[1] + h * (3 * left[2] + h * (4 * left[3] + h * 5 * left[4])));
  const double left_third = 6 * left[2] + h * (24 * left[3] + h * 60 * left[4]);
  return {table_->nodes[behind], std::abs(6 * right[2] / right[0] - left_third / left_first)};
}

}  // namespace leadscrew::geometry
