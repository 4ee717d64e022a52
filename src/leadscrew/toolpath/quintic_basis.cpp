#include <algorithm>
#include <leadscrew/toolpath/quintic_basis.hpp>

namespace leadscrew::toolpath {

using geometry::Point;

namespace {

/// B-splines of degree p on the interval from t[0] to t[1] (t[1 − p] … t[p] are looked at), by the recursion of Cox and
/// de Boor without its zeros.
template <std::size_t p>
std::array<double, p + 1> values_on(const double* t, double u) {
  std::array<double, p + 1> n{1};
  for (std::size_t j = 1; j <= p; ++j) {
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double right = t[r + 1], left = *(t + r + 1 - j);
      const double share = n[r] / (right - left);
      n[r] = saved + (right - u) * share;
      saved = (u - left) * share;
    }
    n[j] = saved;
  }
  return n;
}

}  // namespace

Six quintic_values(const double* t, double u) {
  return values_on<quintic_degree>(t + quintic_degree, u);
}

Six quintic_third_derivatives(const double* t, double u) {
  // q‴ = Σ B_i,2 D³_i, and each difference spreads what counts it over two points of the level below.
  const std::array<double, 3> quadratic = values_on<2>(t + quintic_degree, u);
  Six weights{quadratic[0], quadratic[1], quadratic[2]};
  for (std::size_t r = 3; r-- > 0;) {
    const std::size_t count = quintic_degree - r;  // differences D^{r+1}
    Six below{};
    for (std::size_t i = 0; i < count; ++i) {
      const double factor = static_cast<double>(quintic_degree - r) / (t[i + 6] - t[i + r + 1]) * weights[i];
      below[i] -= factor;
      below[i + 1] += factor;
    }
    weights = below;
  }
  return weights;
}

std::size_t QuinticSpline::span_at(double u) const {
  const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(quintic_degree) + 1;
  const auto end = begin + static_cast<std::ptrdiff_t>(spans()) - 1;
  return static_cast<std::size_t>(std::upper_bound(begin, end, u) - begin);
}

Point QuinticSpline::value(std::size_t span, double u) const {
  const Six n = quintic_values(knots.data() + span, u);
  Point sum{};
  for (std::size_t k = 0; k < n.size(); ++k) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += n[k] * points[span + k][i];
  }
  return sum;
}

State QuinticSpline::state(std::size_t span, double u) const {
  const double* const t = knots.data() + span;
  std::array<Point, quintic_degree + 1> d;
  std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(span), d.size(), d.begin());
  State state;
  state.count = State::most;
  const auto sum = [&](const auto& n) {
    Point total{};
    for (std::size_t k = 0; k < n.size(); ++k) {
      for (std::size_t i = 0; i < total.size(); ++i) total[i] += n[k] * d[k][i];
    }
    return total;
  };
  const auto difference = [&](std::size_t r) {
    for (std::size_t i = 0; i + r < quintic_degree; ++i) {
      const double factor = static_cast<double>(quintic_degree - r) / (t[i + 6] - t[i + r + 1]);
      for (std::size_t k = 0; k < d[i].size(); ++k) d[i][k] = factor * (d[i + 1][k] - d[i][k]);
    }
  };
  state.derivative[0] = sum(values_on<5>(t + quintic_degree, u));
  difference(0);
  state.derivative[1] = sum(values_on<4>(t + quintic_degree, u));
  difference(1);
  state.derivative[2] = sum(values_on<3>(t + quintic_degree, u));
  difference(2);
  state.derivative[3] = sum(values_on<2>(t + quintic_degree, u));
  difference(3);
  state.derivative[4] = sum(values_on<1>(t + quintic_degree, u));
  return state;
}

void begin_with(const State& state, const double* t, Point* points) {
  std::array<Point, State::most> d = state.derivative;  // d[r]: D^r_i, one i after the other
  points[0] = d[0];
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    for (std::size_t r = 0; r + i + 1 < state.count; ++r) {
      const double factor = (t[i + 6] - t[i + r + 1]) / static_cast<double>(quintic_degree - r);
      for (std::size_t k = 0; k < d[r].size(); ++k) d[r][k] += factor * d[r + 1][k];
    }
    points[i + 1] = d[0];
  }
}

}  // namespace leadscrew::toolpath
