#include <algorithm>
#include <leadscrew/surfaces/across_spline.hpp>

namespace leadscrew::surfaces {

namespace {

/// The six polynomials of a uniform B-spline of degree 5 on one of its spans, times 120: powers of x, 0 … 1.
constexpr std::array<std::array<double, 6>, 6> uniform_quintics = {{{1, -5, 10, -10, 5, -1},
                                                                    {26, -50, 20, 20, -20, 5},
                                                                    {66, 0, -60, 0, 30, -10},
                                                                    {26, 50, 20, -20, -20, 10},
                                                                    {1, 5, 10, 10, 5, -5},
                                                                    {0, 0, 0, 0, 0, 1}}};

}  // namespace

numeric::Jet<3> UniformSpline::at(double place) const {
  Memo none;
  return at_near(place, none);
}

numeric::Jet<3> UniformSpline::at_near(double place, Memo& memo) const {
  const double scale = static_cast<double>(spans_) / (range_.to - range_.from);
  const double position = std::clamp((place - range_.from) * scale, 0.0, static_cast<double>(spans_));
  const std::size_t span = std::min(static_cast<std::size_t>(position), spans_ - 1);
  const double x = position - static_cast<double>(span);
  std::array<double, 6>& c = memo.polynomial;
  if (memo.span != span) {
    c = {};
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t i = 0; i < 6; ++i) c[i] += coefficients_[span + k] * uniform_quintics[k][i] / 120;
    }
    memo.span = span;
  }
  return {c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))),
          scale * (c[1] + x * (2 * c[2] + x * (3 * c[3] + x * (4 * c[4] + x * 5 * c[5])))),
          scale * scale * (2 * c[2] + x * (6 * c[3] + x * (12 * c[4] + x * 20 * c[5]))),
          scale * scale * scale * (6 * c[3] + x * (24 * c[4] + x * 60 * c[5]))};
}

std::vector<double> UniformSpline::breaks(double from, double to) const {
  std::vector<double> found;
  if (across_breaks_.empty()) return found;
  const std::size_t parts = 4 * spans_;
  double before = at(range_.from).value;
  for (std::size_t k = 1; k <= parts; ++k) {
    const double high_end = knot(static_cast<double>(k) / 4), after = at(high_end).value;
    // Those c with before < c ≤ after, or the other way round.
    const auto first = std::upper_bound(across_breaks_.begin(), across_breaks_.end(), std::min(before, after));
    for (auto it = first; it != across_breaks_.end() && *it <= std::max(before, after); ++it) {
      const double cut = *it;
      double low = knot(static_cast<double>(k - 1) / 4), high = high_end;
      for (int round = 0; round < 60; ++round) {
        const double middle = (low + high) / 2;
        ((at(middle).value < cut) == (before < cut) ? low : high) = middle;
      }
      found.push_back((low + high) / 2);
    }
    before = after;
  }
  std::erase_if(found, [&](double place) { return !(place > from && place < to); });
  return found;
}

UniformSpline spline_below(const Range& range, std::size_t spans, std::size_t per_span,
                           const std::vector<double>& wanted) {
  UniformSpline steps(range, spans, 0);
  std::vector<double>& c = steps.coefficients();
  const auto last = static_cast<std::ptrdiff_t>(wanted.size()) - 1;
  // The coefficient i belongs to the knot i − 2, and reaches three spans to both sides.
  const auto sample_of = [&](std::size_t i) {
    return (static_cast<std::ptrdiff_t>(i) - 2) * static_cast<std::ptrdiff_t>(per_span);
  };
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = wanted[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(sample_of(i), 0, last))];
  }
  std::vector<double> share;
  AcrossFunction::Memo memo;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const double place = steps.knot(static_cast<double>(k) / static_cast<double>(per_span));
    share.push_back(wanted[k] / steps.at_near(place, memo).value);
  }
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::ptrdiff_t reach = 3 * static_cast<std::ptrdiff_t>(per_span);
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(sample_of(i) - reach, 0),
                         to = std::min(sample_of(i) + reach, last);
    double least = 1e300;
    for (std::ptrdiff_t k = from; k <= to; ++k) least = std::min(least, share[static_cast<std::size_t>(k)]);
    c[i] *= least;
  }
  return steps;
}

}  // namespace leadscrew::surfaces
