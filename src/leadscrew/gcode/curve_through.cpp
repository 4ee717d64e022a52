#include <algorithm>
#include <leadscrew/gcode/curve_through.hpp>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t greatest_degree = 3;
constexpr std::size_t reach = 3;  ///< rows have nothing farther from the diagonal: each place lies under its own spline

/// Knots p + 1 times at the ends; between them the parameters but for the second and the last but one, where the cubic
/// goes on.
void set_knots(NurbsCurve& curve, std::size_t degree, const std::vector<double>& parameters) {
  curve.clear();
  curve.degree = static_cast<int>(degree);
  curve.knots.assign(degree + 1, parameters.front());
  for (std::size_t i = 2; degree == greatest_degree && i + 2 < parameters.size(); ++i)
    curve.knots.push_back(parameters[i]);
  curve.knots.insert(curve.knots.end(), degree + 1, parameters.back());
}

/// The basis functions of the span that a parameter is in, which are not 0 there (Piegl and Tiller, A2.2).
struct BasisAt {
  std::size_t first = 0;
  std::array<double, greatest_degree + 1> value{};

  BasisAt(const NurbsCurve& curve, std::size_t degree, std::size_t count, double u) {
    const auto& knots = curve.knots;
    const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(degree),
               end = knots.begin() + static_cast<std::ptrdiff_t>(count);
    const auto span = static_cast<std::size_t>(std::upper_bound(begin + 1, end, u) - knots.begin()) - 1;
    first = span - degree;
    value[0] = 1;
    for (std::size_t j = 1; j <= degree; ++j) {
      double saved = 0;
      for (std::size_t r = 0; r < j; ++r) {
        const double right = knots[span + r + 1] - u, left = u - knots[span + 1 + r - j];
        const double part = value[r] / (right + left);
        value[r] = saved + right * part;
        saved = left * part;
      }
      value[j] = saved;
    }
  }
};

/// Of the places as combinations of control points; row i holds columns i − reach … i + reach.
using Row = std::array<double, 2 * reach + 1>;

/// Elimination without pivots: the matrix is totally positive (de Boor, XIII).
void solve(std::vector<Row>& rows, std::vector<ControlPoint>& points) {
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 1; k <= reach && i + k < n; ++k) {
      const double factor = rows[i + k][reach - k] / rows[i][reach];
      if (factor == 0) continue;
      for (std::size_t c = 0; c <= reach; ++c) rows[i + k][reach - k + c] -= factor * rows[i][reach + c];
      for (std::size_t a = 0; a < base::axis_count; ++a) points[i + k].position[a] -= factor * points[i].position[a];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t a = 0; a < base::axis_count; ++a) {
      double sum = points[i].position[a];
      for (std::size_t k = 1; k <= reach && i + k < n; ++k) sum -= rows[i][reach + k] * points[i + k].position[a];
      points[i].position[a] = sum / rows[i][reach];
    }
  }
}

}  // namespace

void make_curve_through(NurbsCurve& curve, const std::vector<double>& parameters,
                        const std::vector<base::AxisVector>& places) {
  const std::size_t count = places.size(), degree = std::min(greatest_degree, count - 1);
  set_knots(curve, degree, parameters);
  std::vector<Row> rows(count, Row{});
  // Seen from the first: coordinates that stay are exactly the same everywhere.
  for (std::size_t i = 0; i < count; ++i) {
    const BasisAt basis(curve, degree, count, parameters[i]);
    for (std::size_t k = 0; k <= degree; ++k) {
      if (basis.value[k] != 0) rows[i][reach + basis.first + k - i] = basis.value[k];
    }
    ControlPoint& point = curve.points.emplace_back();
    for (std::size_t a = 0; a < base::axis_count; ++a) point.position[a] = places[i][a] - places.front()[a];
  }
  solve(rows, curve.points);
  for (ControlPoint& point : curve.points) {
    for (std::size_t a = 0; a < base::axis_count; ++a) point.position[a] += places.front()[a];
  }
  curve.points.front().position = places.front();
  curve.points.back().position = places.back();
}

}  // namespace leadscrew::gcode
