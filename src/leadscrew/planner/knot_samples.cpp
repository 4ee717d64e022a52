#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/knot_samples.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

/// ∫ ds/h from one sample to the next is a logarithm, and so is its inverse.
double quantity(const KnotSample& a, const KnotSample& b) {
  const double width = b.s - a.s, rise = b.h - a.h;
  if (std::abs(rise) < 1e-3 * a.h) return width / (a.h + rise / 2);
  return width / rise * numeric::log(b.h / a.h);
}
double inverse(const KnotSample& a, const KnotSample& b, double amount) {
  const double width = b.s - a.s, slope = (b.h - a.h) / width;
  if (std::abs(b.h - a.h) < 1e-3 * a.h) return std::min(b.s, a.s + amount * (a.h + b.h) / 2);
  return std::min(b.s, a.s + a.h / slope * numeric::expm1(amount * slope));
}

/// From the sample to a place behind it, before the next.
double quantity_to(std::span<const KnotSample> samples, std::size_t first, double to) {
  if (first + 1 >= samples.size() || !(to > samples[first].s)) return 0;
  const KnotSample &a = samples[first], &b = samples[first + 1];
  KnotSample here = a;
  here.s = to;
  here.h = a.h + (b.h - a.h) * (to - a.s) / (b.s - a.s);
  return quantity(a, here);
}

/// Squares of q″ and q‴.
struct Bends {
  double second = 0, third = 0;
};
Bends bends(const geometry::PointJet& jet, bool is_of_tip, double tangent_acceleration,
            const constraints::Constraints& constraints) {
  Bends bends;
  for (const base::Axis axis : base::all_axes) {
    const numeric::Jet<>& q = jet[base::index(axis)];
    if (q.second == 0 && q.third == 0) continue;
    const double weight = is_of_tip ? tangent_acceleration / constraints.of_axis(axis).acceleration : 1;
    bends.second += weight * q.second * (weight * q.second);
    bends.third += weight * q.third * (weight * q.third);
  }
  return bends;
}

}  // namespace

KnotSample sample_of(const constraints::Place& place, double s, double from_rest, bool is_of_tip,
                     const constraints::Constraints& constraints) {
  const machine::Derivatives t = tangent_limits(place.jet, constraints);
  KnotSample sample;
  sample.s = s;
  sample.a = t.acceleration;
  sample.j = t.jerk;
  sample.greatest = std::min(constraints.greatest_square(place), constraints.greatest_square_by_curve(place));
  sample.is_by_feed = sample.greatest == squared(place.feed);
  sample.reach = sample.cap = std::min(sample.greatest, squared(numeric::cbrt(4.5 * t.jerk * from_rest * from_rest)));
  const auto [second, third] = bends(place.jet, is_of_tip, t.acceleration, constraints);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  sample.h_curve = std::min(second > 0 ? 0.08 / std::sqrt(second) : infinity,
                            third > 0 ? 0.2 / std::sqrt(std::sqrt(third)) : infinity);
  return sample;
}

void grade(std::span<KnotSample> samples, double grading) {
  const auto limit = [&](KnotSample& sample, const KnotSample& by) {
    sample.h = std::min(sample.h, by.h + grading * std::abs(sample.s - by.s));
  };
  for (std::size_t k = 1; k < samples.size(); ++k) limit(samples[k], samples[k - 1]);
  for (std::size_t k = samples.size() - 1; k-- > 0;) limit(samples[k], samples[k + 1]);
}

std::size_t place_quantiles(std::span<const KnotSample> samples, double from, double to, std::size_t first,
                            std::size_t most, Knots& knots) {
  constexpr double most_parts = 1e9;
  const double skipped = quantity_to(samples, first, from);
  double total = -skipped;
  std::size_t last = first;
  while (last + 1 < samples.size() && samples[last].s < to) {
    if (samples[last + 1].s > samples[last].s) total += quantity(samples[last], samples[last + 1]);
    ++last;
  }
  const int count = std::max(1, static_cast<int>(std::ceil(std::min(total, most_parts))));
  double before = -skipped;
  std::size_t k = first;
  for (int n = 1; n < count; ++n) {
    const double wanted = total * n / count;
    while (k < last) {
      const double here = samples[k + 1].s > samples[k].s ? quantity(samples[k], samples[k + 1]) : 0;
      if (before + here >= wanted) break;
      before += here;
      ++k;
    }
    const double s = inverse(samples[k], samples[std::min(k + 1, samples.size() - 1)], wanted - before);
    if (s > knots.s.back() && s < to) {
      knots.s.push_back(s);
      knots.breaks.push_back(false);
      if (knots.s.size() > most) return first;
    }
  }
  knots.s.push_back(to);
  knots.breaks.push_back(true);
  return last;
}

}  // namespace leadscrew::planner
