#include <algorithm>
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

}  // namespace leadscrew::geometry
