#pragma once
// NURBS curves to test with, and a judge that shares nothing with the house: the recursion of Cox and de Boor in long
// double, derivatives by differences, lengths by chords.

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/geometry/nurbs.hpp>
#include <vector>

namespace leadscrew::geometry::testing {

using Exact = std::array<long double, base::axis_count>;

/// C(u) = Σ w N P / Σ w N, by N_i,p = (u − u_i)/(u_{i+p} − u_i) N_i,p−1 + (u_{i+p+1} − u)/(u_{i+p+1} − u_{i+1})
/// N_i+1,p−1. At a knot, and beyond the ends, of the span before where `from_before`.
inline Exact de_boor(const NurbsForm& form, long double u, bool from_before = false) {
  const auto p = static_cast<std::size_t>(form.degree);
  const std::size_t n = form.points.size();
  std::size_t span = p;
  for (std::size_t i = p; i < n; ++i) {
    const bool begun = from_before ? form.knots[i] < u : form.knots[i] <= u;
    if (form.knots[i] < form.knots[i + 1] && (begun || form.knots[i] == form.knots[p])) span = i;
  }
  std::vector<long double> basis(n + p + 1, 0.0L);
  basis[span] = 1;
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t i = 0; i + r < n + p; ++i) {
      const long double left = form.knots[i + r] - static_cast<long double>(form.knots[i]);
      const long double right = form.knots[i + r + 1] - static_cast<long double>(form.knots[i + 1]);
      long double value = 0;
      if (left > 0) value += (u - form.knots[i]) / left * basis[i];
      if (right > 0) value += (form.knots[i + r + 1] - u) / right * basis[i + 1];
      basis[i] = value;
    }
  }
  Exact sum{};
  long double weight = 0;
  for (std::size_t i = 0; i < n; ++i) {
    weight += form.weights[i] * basis[i];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += form.weights[i] * basis[i] * form.points[i][k];
  }
  for (long double& x : sum) x /= weight;
  return sum;
}

/// The coordinates whose length counts, where all of the curve moves in them.
inline std::size_t first_of_metric(const NurbsForm& form) {
  for (const std::size_t first : {0u, 6u, 3u}) {
    for (std::size_t i = first; i < first + 3; ++i) {
      for (const Point& point : form.points) {
        if (point[i] != form.points[0][i]) return first;
      }
    }
  }
  return 0;
}

inline long double distance(const Exact& a, const Exact& b, std::size_t first) {
  long double sum = 0;
  for (std::size_t i = first; i < first + 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// Length between two parameters: chords, and what they lack extrapolated from twice as many (error ~ 1/count⁴ where
/// smooth).
inline long double chord_length(const NurbsForm& form, long double from, long double to, int count) {
  const std::size_t first = first_of_metric(form);
  std::vector<long double> cuts = {from};
  for (const double knot : form.knots) {
    if (knot > cuts.back() && knot < to) cuts.push_back(knot);
  }
  cuts.push_back(to);
  long double length = 0;
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
    long double fine = 0, coarse = 0;
    Exact last = de_boor(form, cuts[c]), last_but_one = last;
    for (int k = 1; k <= 2 * count; ++k) {
      const Exact next = de_boor(form, cuts[c] + (cuts[c + 1] - cuts[c]) * k / (2 * count), true);
      fine += distance(next, last, first);
      if (k % 2 == 0) {
        coarse += distance(next, last_but_one, first);
        last_but_one = next;
      }
      last = next;
    }
    length += fine + (fine - coarse) / 3;
  }
  return length;
}

/// k-th derivative by u, 1 ≤ k ≤ 3, by central differences of sixth or fourth order over steps h.
inline Exact derivative(const NurbsForm& form, long double u, int k, long double h) {
  const auto at = [&](int step) { return de_boor(form, u + step * h); };
  const Exact zero = at(0), a1 = at(1), b1 = at(-1), a2 = at(2), b2 = at(-2), a3 = at(3), b3 = at(-3);
  Exact result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const long double odd1 = a1[i] - b1[i], odd2 = a2[i] - b2[i], odd3 = a3[i] - b3[i];
    const long double even1 = a1[i] + b1[i], even2 = a2[i] + b2[i], even3 = a3[i] + b3[i];
    if (k == 1) result[i] = (45 * odd1 - 9 * odd2 + odd3) / (60 * h);
    if (k == 2) result[i] = (270 * even1 - 27 * even2 + 2 * even3 - 490 * zero[i]) / (180 * h * h);
    if (k == 3) result[i] = (-13 * odd1 + 8 * odd2 - odd3) / (8 * h * h * h);
  }
  return result;
}

inline double ulp(double x) {
  return std::nextafter(std::abs(x), INFINITY) - std::abs(x);
}

inline Point point(double x, double y, double z = 0) {
  return {x, y, z};
}

/// A Bézier curve, all weights 1 if none are given.
inline NurbsForm bezier(std::vector<Point> points, std::vector<double> weights = {}) {
  NurbsForm form;
  form.degree = static_cast<int>(points.size()) - 1;
  form.knots.assign(points.size(), 0.0);
  form.knots.insert(form.knots.end(), points.size(), 1.0);
  form.weights = weights.empty() ? std::vector<double>(points.size(), 1.0) : std::move(weights);
  form.points = std::move(points);
  return form;
}

/// Clamped, with these inner knots.
inline NurbsForm spline(int degree, std::vector<Point> points, const std::vector<double>& inner) {
  NurbsForm form;
  form.degree = degree;
  form.weights.assign(points.size(), 1.0);
  form.points = std::move(points);
  const auto times = static_cast<std::size_t>(degree) + 1;
  form.knots.assign(times, 0.0);
  form.knots.insert(form.knots.end(), inner.begin(), inner.end());
  form.knots.insert(form.knots.end(), times, 1.0);
  return form;
}

/// Degrees 1 to 5, up to 14 control points in two or three of the coordinates, up to 200 apart; half of them rational,
/// many with repeated knots, some not clamped, some with coinciding or collinear control points.
inline NurbsForm random_form() {
  NurbsForm form;
  form.degree = *rc::gen::inRange(1, 6);
  const auto p = static_cast<std::size_t>(form.degree), n = p + 1 + *rc::gen::inRange<std::size_t>(0, 9);
  const bool is_rational = *rc::gen::arbitrary<bool>();
  const bool repeats_points = *rc::gen::inRange(0, 3) == 0;
  const std::size_t first = *rc::gen::element<std::size_t>(0, 0, 0, 3, 6), count = *rc::gen::inRange<std::size_t>(1, 4);
  const int size = *rc::gen::element(1000, 10, 100000);
  for (std::size_t i = 0; i < n; ++i) {
    Point next{};
    if (repeats_points && i > 0 && *rc::gen::inRange(0, 3) == 0) {
      next = form.points.back();
    } else {
      for (std::size_t k = first; k < first + count; ++k) next[k] = *rc::gen::inRange(-size, size + 1) / 1000.0;
    }
    form.points.push_back(next);
    form.weights.push_back(is_rational ? *rc::gen::inRange(3, 50) / 10.0 : 1);
  }
  const bool is_clamped = *rc::gen::inRange(0, 5) > 0;
  const int most_step = *rc::gen::element(1, 10, 10, 1000);
  double knot = 0;
  std::size_t times = 0;
  for (std::size_t i = 0; i < n + p + 1; ++i) {
    const bool inner = i > p && i < n;
    const int step = inner || !is_clamped ? *rc::gen::inRange(0, most_step + 1) : (i == n ? 1 : 0);
    times = step > 0 ? 1 : times + 1;
    const std::size_t most = inner || !is_clamped ? p : p + 1;
    if (times > most || (i == n && times > 1)) {
      knot += 1;
      times = 1;
    } else {
      knot += step;
    }
    form.knots.push_back(knot / 8);
  }
  return form;
}

}  // namespace leadscrew::geometry::testing
