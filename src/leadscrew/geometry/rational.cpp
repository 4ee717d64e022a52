#include <cmath>
#include <leadscrew/geometry/rational.hpp>

namespace leadscrew::geometry {

using numeric::Jet;

namespace {

struct ValueAndSlope {
  double value = 0, slope = 0;
};

ValueAndSlope polynomial(const Coefficients& c, std::size_t degree, double x) {
  ValueAndSlope p;
  for (std::size_t k = degree + 1; k-- > 0;) {
    p.slope = p.slope * x + p.value;
    p.value = p.value * x + c[k];
  }
  return p;
}

/// The blossom of the spline's span at the knots span → span + 1, the latter `upper` times: a Bernstein coefficient.
double blossom(const NurbsForm& form, std::size_t span, std::size_t upper, Coefficients d) {
  const std::size_t p = static_cast<std::size_t>(form.degree);
  const std::vector<double>& u = form.knots;
  for (std::size_t r = 1; r <= p; ++r) {
    const double at = r <= upper ? u[span + 1] : u[span];
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = span - p + k;
      const double low = u[i], high = u[i + p - r + 1];
      const double right = (at - low) / (high - low);
      // The end of the span itself is met exactly: a clamped curve begins at its first control point.
      d[k] = right == 0 ? d[k - 1] : right == 1 ? d[k] : (1 - right) * d[k - 1] + right * d[k];
    }
  }
  return d[p];
}

void split(const Coefficients& c, std::size_t degree, double t, Coefficients& before, Coefficients& after) {
  Coefficients d = c;
  for (std::size_t r = 0; r <= degree; ++r) {
    before[r] = d[0];
    after[degree - r] = d[degree - r];
    for (std::size_t k = 0; k + r < degree; ++k) d[k] = (1 - t) * d[k] + t * d[k + 1];
  }
}

double binomial(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 0; i < k; ++i) value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return value;
}

/// Powers of t from Bernstein coefficients: binomial(n, k) Δᵏ c_0.
Coefficients powers(Coefficients c, std::size_t degree) {
  Coefficients powers{};
  for (std::size_t k = 0; k <= degree; ++k) {
    powers[k] = binomial(degree, k) * c[0];
    for (std::size_t i = 0; i + k < degree; ++i) c[i] = c[i + 1] - c[i];
  }
  return powers;
}

/// Powers of t − 1: those of the reversed coefficients, with alternating sign.
Coefficients powers_from_end(const Coefficients& c, std::size_t degree) {
  Coefficients reversed{};
  for (std::size_t k = 0; k <= degree; ++k) reversed[k] = c[degree - k];
  Coefficients result = powers(reversed, degree);
  for (std::size_t k = 1; k <= degree; k += 2) result[k] = -result[k];
  return result;
}

/// Of numerators about an origin, which goes to where the curve is at x = 0.
RationalTaylor expand(const RationalBezier& curve, const Point& origin,
                      const std::array<Coefficients, base::axis_count>& numerators,
                      Coefficients (*powers_of)(const Coefficients&, std::size_t)) {
  RationalTaylor taylor{curve.degree, curve.count, curve.rational, origin, {}, powers_of(curve.weight, curve.degree)};
  for (std::size_t k = 0; k < curve.count; ++k) {
    Coefficients& numerator = taylor.numerator[k];
    numerator = powers_of(numerators[k], curve.degree);
    taylor.origin[k] = origin[k] + numerator[0] / taylor.weight[0];
    const double moved = taylor.origin[k] - origin[k];
    for (std::size_t i = 0; moved != 0 && i <= curve.degree; ++i) numerator[i] -= moved * taylor.weight[i];
  }
  return taylor;
}

}  // namespace

double RationalTaylor::speed(const Metric& metric, double x) const {
  double sum = 0;
  if (!rational) {
    for (std::size_t k = 0; k < metric.count; ++k) {
      const double slope = metric.weight[k] * polynomial(numerator[metric.slot[k]], degree, x).slope;
      sum += slope * slope;
    }
    return std::sqrt(sum);
  }
  const ValueAndSlope w = polynomial(weight, degree, x);
  for (std::size_t k = 0; k < metric.count; ++k) {
    const ValueAndSlope n = polynomial(numerator[metric.slot[k]], degree, x);
    const double slope = metric.weight[k] * (n.slope * w.value - n.value * w.slope);
    sum += slope * slope;
  }
  return std::sqrt(sum) / (w.value * w.value);
}

Jet<> RationalTaylor::numerator_jet(std::size_t slot, double x) const {
  return polynomial_jet(numerator[slot].data(), degree, x);
}

Jet<> RationalTaylor::weight_jet(double x) const {
  return rational ? polynomial_jet(weight.data(), degree, x) : Jet<>(1);
}

RationalBezier bezier_of_span(const NurbsForm& form, const Moving& moving, bool rational, std::size_t span) {
  const std::size_t p = static_cast<std::size_t>(form.degree);
  RationalBezier curve{.degree = p,
                       .count = moving.count,
                       .rational = rational,
                       .parameter = form.knots[span],
                       .width = form.knots[span + 1] - form.knots[span]};
  const Point &first = form.points[span - p], &last = form.points[span];
  Coefficients d{}, w{};
  for (std::size_t r = 0; r <= p; ++r) w[r] = rational ? form.weights[span - p + r] : 1;
  for (std::size_t r = 0; r <= p; ++r) curve.weight[r] = rational ? blossom(form, span, r, w) : 1;
  for (std::size_t k = 0; k < moving.count; ++k) {
    const std::size_t i = moving.coordinate[k];
    curve.origin[k] = first[i];
    for (std::size_t r = 0; r <= p; ++r) d[r] = w[r] * (form.points[span - p + r][i] - first[i]);
    for (std::size_t r = 0; r <= p; ++r) curve.numerator[k][r] = blossom(form, span, r, d);
    curve.end_origin[k] = last[i];
    for (std::size_t r = 0; r <= p; ++r) d[r] = w[r] * (form.points[span - p + r][i] - last[i]);
    for (std::size_t r = 0; r <= p; ++r) curve.end_numerator[k][r] = blossom(form, span, r, d);
  }
  return curve;
}

std::pair<RationalBezier, RationalBezier> split(const RationalBezier& curve, double t) {
  std::pair<RationalBezier, RationalBezier> parts(curve, curve);
  auto& [before, after] = parts;
  for (std::size_t k = 0; k < curve.count; ++k) {
    split(curve.numerator[k], curve.degree, t, before.numerator[k], after.numerator[k]);
    split(curve.end_numerator[k], curve.degree, t, before.end_numerator[k], after.end_numerator[k]);
  }
  split(curve.weight, curve.degree, t, before.weight, after.weight);
  before.width = curve.width * t;
  after.parameter = curve.parameter + before.width;
  after.width = curve.width - before.width;
  return parts;
}

RationalTaylor from_start(const RationalBezier& curve) {
  return expand(curve, curve.origin, curve.numerator,
                [](const Coefficients& c, std::size_t degree) { return powers(c, degree); });
}

RationalTaylor from_end(const RationalBezier& curve) {
  return expand(curve, curve.end_origin, curve.end_numerator, powers_from_end);
}

}  // namespace leadscrew::geometry
