#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/geometry/rational.hpp>
#include <leadscrew/toolpath/contact_rate.hpp>

namespace leadscrew::toolpath {

ContactRate::ContactRate(const gcode::NurbsCurve& curve) {
  geometry::NurbsForm form{curve.degree, curve.knots, {}, std::vector<double>(curve.contact.size(), 1.0)};
  for (const auto& [x, y, z] : curve.contact) form.points.push_back({x, y, z});
  const geometry::Moving moving{{0, 1, 2}, 3};
  for (std::size_t k = static_cast<std::size_t>(curve.degree); k < form.points.size(); ++k) {
    if (!(form.knots[k] < form.knots[k + 1])) continue;
    const geometry::RationalTaylor taylor = geometry::from_start(geometry::bezier_of_span(form, moving, false, k));
    const double width = form.knots[k + 1] - form.knots[k];
    Span& span = spans_.emplace_back();
    span.begin = form.knots[k];
    for (std::size_t i = 0; i < 3; ++i) {
      double per_power = 1 / width;
      for (std::size_t power = 1; power <= taylor.degree; ++power, per_power /= width)
        span.rate[i][power - 1] = static_cast<double>(power) * taylor.numerator[i][power] * per_power;
    }
  }
}

double ContactRate::at(const geometry::Nurbs& piece, double s) const {
  const double u = piece.parameter(s);
  const auto behind = std::upper_bound(spans_.begin() + 1, spans_.end(), u,
                                       [](double at, const Span& span) { return at < span.begin; });
  const Span& span = *std::prev(behind);
  const double x = u - span.begin;
  double square = 0;
  for (const auto& c : span.rate) {
    const double rate = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
    square += rate * rate;
  }
  return std::sqrt(square) * piece.parameter_rate(s);
}

}  // namespace leadscrew::toolpath
