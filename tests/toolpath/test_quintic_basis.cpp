#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/toolpath/quintic_basis.hpp>
#include <limits>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_quintic_basis {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A sum in long double, and that of its terms' magnitudes: what rounding is relative to.
struct Exact {
  long double value = 0, size = 0;

  void add(long double factor, const Exact& term) {
    value += factor * term.value;
    size += std::abs(factor) * term.size;
  }
  bool is(double found, double units) const {
    return std::abs(static_cast<double>(found - value)) <= units * epsilon * static_cast<double>(size);
  }
};

/// The r-th derivative of N_i,p, of its polynomial between t[5] and t[6], by the recursions of Cox and de Boor and of
/// Piegl and Tiller, "The NURBS Book", eq. 2.9.
Exact basis(const double* t, std::size_t i, std::size_t p, std::size_t r, long double u) {
  if (p == 0) return i == 5 && r == 0 ? Exact{1, 1} : Exact{};
  const long double left = t[i + p] - static_cast<long double>(t[i]);
  const long double right = t[i + p + 1] - static_cast<long double>(t[i + 1]);
  Exact sum;
  if (r == 0) {
    if (left > 0) sum.add((u - t[i]) / left, basis(t, i, p - 1, 0, u));
    if (right > 0) sum.add((t[i + p + 1] - u) / right, basis(t, i + 1, p - 1, 0, u));
  } else {
    if (left > 0) sum.add(p / left, basis(t, i, p - 1, r - 1, u));
    if (right > 0) sum.add(-(p / right), basis(t, i + 1, p - 1, r - 1, u));
  }
  return sum;
}

/// Of a spline, on one of its spans.
Exact coordinate(const QuinticSpline& spline, std::size_t span, std::size_t axis, std::size_t r, double u) {
  Exact sum;
  for (std::size_t k = 0; k <= quintic_degree; ++k) {
    const double c = spline.points[span + k][axis];
    const Exact n = basis(spline.knots.data() + span, k, quintic_degree, r, u);
    sum.value += c * n.value;
    sum.size += std::abs(c) * n.size;
  }
  return sum;
}

/// Steps over three decades, some of them 0.
std::vector<double> random_knots(std::size_t count) {
  std::vector<double> t{uniform(-10, 10)};
  while (t.size() < count) t.push_back(t.back() + (any(0, 4) == 0 ? 0 : logarithmic(1e-3, 1)));
  return t;
}

/// Twelve, often clamped at one end or at both.
std::vector<double> knots_about_an_interval() {
  std::vector<double> t = random_knots(12);
  for (std::size_t k = 6; k < t.size(); ++k) t[k] += 1e-3;
  if (any(0, 3) == 0) std::fill_n(t.begin(), 6, t[5]);
  if (any(0, 3) == 0) std::fill_n(t.begin() + 6, 6, t[6]);
  return t;
}

double place_between(double from, double to) {
  const int kind = any(0, 6);
  return kind == 0 ? from : kind == 1 ? to : std::clamp(uniform(from, to), from, to);
}

/// Clamped at its first knot; inner knots are simple.
QuinticSpline random_spline() {
  QuinticSpline spline;
  const std::size_t count = any<std::size_t>(6, 16);
  spline.knots.assign(6, uniform(-10, 10));
  while (spline.knots.size() < count + 6) spline.knots.push_back(spline.knots.back() + logarithmic(1e-2, 1));
  if (any(0, 2) == 0)
    std::fill(spline.knots.begin() + static_cast<std::ptrdiff_t>(count), spline.knots.end(), spline.knots[count]);
  for (std::size_t i = 0; i < count; ++i) {
    Point point{};
    for (double& x : point) x = uniform(-100, 100);
    spline.points.push_back(point);
  }
  return spline;
}

RC_GTEST_PROP(QuinticBasis, SumsToOne, ()) {
  const std::vector<double> t = knots_about_an_interval();
  double sum = 0;
  for (const double n : quintic_values(t.data(), place_between(t[5], t[6]))) {
    RC_ASSERT(n >= 0);
    sum += n;
  }
  RC_ASSERT(std::abs(sum - 1) <= 16 * epsilon);
}

RC_GTEST_PROP(QuinticBasis, HasTheValuesOfTheRecursion, ()) {
  const std::vector<double> t = knots_about_an_interval();
  const double u = place_between(t[5], t[6]);
  const Six n = quintic_values(t.data(), u);
  for (std::size_t i = 0; i < n.size(); ++i) RC_ASSERT(basis(t.data(), i, quintic_degree, 0, u).is(n[i], 32));
}

RC_GTEST_PROP(QuinticBasis, HasTheThirdDerivativesOfTheRecursion, ()) {
  const std::vector<double> t = knots_about_an_interval();
  const double u = place_between(t[5], t[6]);
  const Six n = quintic_third_derivatives(t.data(), u);
  for (std::size_t i = 0; i < n.size(); ++i) RC_ASSERT(basis(t.data(), i, quintic_degree, 3, u).is(n[i], 32));
}

TEST(QuinticBasis, IsBernsteinsWhereBothEndsAreClamped) {
  const std::vector<double> t = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  const Six values = quintic_values(t.data(), 0.5), third = quintic_third_derivatives(t.data(), 0);
  EXPECT_EQ(values, (Six{1 / 32.0, 5 / 32.0, 10 / 32.0, 10 / 32.0, 5 / 32.0, 1 / 32.0}));
  EXPECT_EQ(third, (Six{-60, 180, -180, 60, 0, 0}));
}

RC_GTEST_PROP(QuinticSpline, HasTheStateOfTheRecursion, ()) {
  const QuinticSpline spline = random_spline();
  for (std::size_t span = 0; span < spline.spans(); ++span) {
    const double u = place_between(spline.span_begin(span), spline.span_end(span));
    const State state = spline.state(span, u);
    RC_ASSERT(state.count == State::most);
    const Point value = spline.value(span, u);
    for (std::size_t i = 0; i < base::axis_count; ++i) {
      RC_ASSERT(coordinate(spline, span, i, 0, u).is(value[i], 32));
      for (std::size_t r = 0; r < State::most; ++r)
        RC_ASSERT(coordinate(spline, span, i, r, u).is(state.derivative[r][i], 32));
    }
  }
}

RC_GTEST_PROP(QuinticSpline, FindsTheSpanThatBeginsAtAKnotAndTheLastAtItsEnd, ()) {
  const QuinticSpline spline = random_spline();
  for (std::size_t span = 0; span < spline.spans(); ++span) {
    const double from = spline.span_begin(span), to = spline.span_end(span);
    RC_ASSERT(spline.span_at(from) == span);
    RC_ASSERT(spline.span_at((from + to) / 2) == span);
  }
  RC_ASSERT(spline.span_at(spline.span_end(spline.spans() - 1)) == spline.spans() - 1);
}

/// Derivatives that a spline with these spans could have.
State random_state(double span) {
  State state;
  state.count = any<std::size_t>(1, State::most + 1);
  for (std::size_t r = 0; r < state.count; ++r) {
    for (double& x : state.derivative[r]) x = uniform(-100, 100) / std::pow(span, r);
  }
  return state;
}

bool begins_with(const QuinticSpline& spline, const State& state) {
  const double u = spline.span_begin(0);
  const State found = spline.state(0, u);
  for (std::size_t r = 0; r < state.count; ++r) {
    for (std::size_t i = 0; i < base::axis_count; ++i) {
      const double size = static_cast<double>(coordinate(spline, 0, i, r, u).size);
      if (!(std::abs(found.derivative[r][i] - state.derivative[r][i]) <= 64 * epsilon * size)) return false;
    }
  }
  return true;
}

RC_GTEST_PROP(QuinticSpline, BeginsWithTheStateItIsGiven, ()) {
  QuinticSpline spline = random_spline();
  const std::vector<Point> before = spline.points;
  const State state = random_state(spline.span_end(0) - spline.span_begin(0));
  begin_with(state, spline.knots.data(), spline.points.data());
  RC_ASSERT(begins_with(spline, state));
  RC_ASSERT(std::equal(before.begin() + static_cast<std::ptrdiff_t>(state.count), before.end(),
                       spline.points.begin() + static_cast<std::ptrdiff_t>(state.count)));
}

RC_GTEST_PROP(QuinticSpline, BeginsWithTheStateOfAnother, ()) {
  const QuinticSpline first = random_spline();
  const double end = first.span_end(first.spans() - 1);
  const State state = first.state(first.spans() - 1, end);
  QuinticSpline second = random_spline();
  begin_with(state, second.knots.data(), second.points.data());
  RC_ASSERT(begins_with(second, state));
}

}  // namespace test_quintic_basis
}  // namespace leadscrew::toolpath::testing
