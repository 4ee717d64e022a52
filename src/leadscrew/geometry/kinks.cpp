#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/geometry/kinks.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::geometry {

namespace {

constexpr double shortest_interval = 1e-6;  // mm or degrees
constexpr double shortest_stretch = 1e-11;  // mm or degrees
constexpr double in_front = 0.05;           // of the largest coefficient
constexpr double standing = 1e-12;          // of the largest coefficient
constexpr std::size_t most_bernstein = 2 * most_coefficients - 2;

double binomial(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 0; i < k; ++i) value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return value;
}

/// D by Bernstein coefficients on [begin, end], which are vectors of the metric's coordinates.
struct Hodograph {
  using Vector = std::array<double, base::axis_count>;
  std::array<Vector, most_bernstein> d{};
  std::size_t degree = 0;
  std::size_t count = 0;  ///< coordinates
  double begin = 0, end = 1;

  double largest() const {
    double square = 0;
    for (std::size_t i = 0; i <= degree; ++i) square = std::max(square, dot(d[i], d[i]));
    return std::sqrt(square);
  }
  double dot(const Vector& a, const Vector& b) const { return numeric::dot(a, b, count); }
  double norm(const Vector& a) const { return numeric::norm(a, count); }

  bool is_in_front_of_a_plane() const {
    Vector sum{};
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t k = 0; k < count; ++k) sum[k] += d[i][k];
    }
    const double least = in_front * norm(sum) * largest();
    if (least <= 0) return false;
    return std::all_of(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(degree) + 1,
                       [&](const Vector& of) { return dot(of, sum) >= least; });
  }

  /// de Casteljau's algorithm.
  void halve(Hodograph& before, Hodograph& after) const {
    auto e = d;
    before = after = *this;
    for (std::size_t r = 0; r <= degree; ++r) {
      before.d[r] = e[0];
      after.d[degree - r] = e[degree - r];
      for (std::size_t i = 0; i + r < degree; ++i) {
        for (std::size_t k = 0; k < count; ++k) e[i][k] = (e[i][k] + e[i + 1][k]) / 2;
      }
    }
    before.end = after.begin = (begin + end) / 2;
  }
};

/// The polynomial's product: binomials weigh the coefficients (Farin and Rajan, "Algorithms for polynomials in
/// Bernstein form", eq. 44).
Hodograph hodograph(const RationalBezier& curve, const Metric& metric) {
  const std::size_t p = curve.degree;
  Hodograph result;
  result.count = metric.count;
  result.degree = curve.rational ? 2 * p - 1 : p - 1;
  for (std::size_t k = 0; k < metric.count; ++k) {
    const Coefficients& n = curve.numerator[metric.slot[k]];
    for (std::size_t i = 0; i < p; ++i) {
      const double slope = metric.weight[k] * static_cast<double>(p) * (n[i + 1] - n[i]);
      if (!curve.rational) {
        result.d[i][k] = slope;
        continue;
      }
      const double w_slope = static_cast<double>(p) * (curve.weight[i + 1] - curve.weight[i]);
      for (std::size_t j = 0; j <= p; ++j) {
        const double share = binomial(p - 1, i) * binomial(p, j) / binomial(2 * p - 1, i + j);
        result.d[i + j][k] += share * (slope * curve.weight[j] - metric.weight[k] * n[j] * w_slope);
      }
    }
  }
  return result;
}

double least_weight(const RationalBezier& curve) {
  return *std::min_element(curve.weight.begin(), curve.weight.begin() + static_cast<std::ptrdiff_t>(curve.degree) + 1);
}

/// The zero of D nearest in the sense of Gauss and Newton, t ← t − D·D′/D′·D′, kept inside the interval. Converges
/// quadratically to a simple zero, and halves the distance to a double one at each step.
double polish(const Hodograph& whole, double begin, double end) {
  double t = (begin + end) / 2;
  for (int step = 0; step < 60; ++step) {
    auto e = whole.d;
    Hodograph::Vector slope{};
    for (std::size_t r = whole.degree; r > 0; --r) {
      if (r == 1) {
        for (std::size_t k = 0; k < whole.count; ++k)
          slope[k] = static_cast<double>(whole.degree) * (e[1][k] - e[0][k]);
      }
      for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t k = 0; k < whole.count; ++k) e[i][k] += t * (e[i + 1][k] - e[i][k]);
      }
    }
    const double steepness = whole.dot(slope, slope);
    if (steepness == 0) break;
    const double next = std::clamp(t - whole.dot(e[0], slope) / steepness, begin, end);
    if (next == t) break;
    t = next;
  }
  return t;
}

struct Search {
  double least_weight = 1;
  std::vector<std::pair<double, double>> found;  ///< intervals, touching ones merged

  void examine(const Hodograph& part) {
    if (part.is_in_front_of_a_plane()) return;
    const double width = part.end - part.begin;
    if (part.largest() * width <= shortest_interval * least_weight * least_weight || width < 1e-15) {
      if (!found.empty() && found.back().second == part.begin) {
        found.back().second = part.end;
      } else {
        found.emplace_back(part.begin, part.end);
      }
      return;
    }
    Hodograph before, after;
    part.halve(before, after);
    examine(before);
    examine(after);
  }
};

}  // namespace

double longest_possible(const RationalBezier& curve, const Metric& metric) {
  const double weight = least_weight(curve);
  return hodograph(curve, metric).largest() / (weight * weight);
}

Kinks find_kinks(const RationalBezier& curve, const Metric& metric) {
  Kinks kinks;
  const Hodograph whole = hodograph(curve, metric);
  Search search;
  search.least_weight = least_weight(curve);
  const double largest = whole.largest();
  kinks.at_start = whole.norm(whole.d[0]) <= standing * largest;
  kinks.at_end = whole.norm(whole.d[whole.degree]) <= standing * largest;
  if (largest < shortest_examined * search.least_weight * search.least_weight) return kinks;
  search.examine(whole);
  // What lies before or after a kink is no stretch of its own if it is negligibly short.
  const double negligible = shortest_stretch * search.least_weight * search.least_weight / largest;
  for (const auto& [begin, end] : search.found) {
    if ((begin == 0 && kinks.at_start) || (end == 1 && kinks.at_end)) continue;
    const double t = polish(whole, begin, end);
    if (t <= negligible) {
      kinks.at_start = true;
    } else if (t >= 1 - negligible) {
      kinks.at_end = true;
    } else {
      kinks.inside.push_back(t);
    }
  }
  return kinks;
}

}  // namespace leadscrew::geometry
