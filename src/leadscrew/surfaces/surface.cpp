#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/surface.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

using Homogeneous = std::array<double, 4>;

void add_scaled(Homogeneous& sum, double factor, const Homogeneous& term) {
  for (std::size_t k = 0; k < 4; ++k) sum[k] += factor * term[k];
}

}  // namespace

std::vector<double> uniform_knots(std::size_t points, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> knots(points + p + 1, 0.0);
  const std::size_t spans = points - p;
  for (std::size_t k = 0; k < points + p + 1; ++k) {
    if (k > p) knots[k] = k >= points ? 1 : static_cast<double>(k - p) / static_cast<double>(spans);
  }
  return knots;
}

/// The basis functions' powers of each span, from the recursion of Cox and de Boor on polynomials.
Surface::Axis Surface::axis_of(int degree, const std::vector<double>& knots) {
  Axis axis;
  const auto p = static_cast<std::size_t>(degree);
  axis.terms = p + 1;
  for (std::size_t span = p; span + p + 1 < knots.size(); ++span) {
    const double begin = knots[span];
    if (!(knots[span + 1] > begin)) continue;
    axis.breaks.push_back(begin);
    axis.first.push_back(span - p);
    // functions[k] is N of span − d + k, k = 0 … d
    std::array<Powers, most_terms> functions{};
    functions[0][0] = 1;
    for (std::size_t d = 1; d <= p; ++d) {
      std::array<Powers, most_terms> next{};
      for (std::size_t k = 0; k < d; ++k) {
        const double low = knots[span + k + 1 - d], high = knots[span + k + 1], width = high - low;
        // rises by (u − low)/width in the next one, falls by (high − u)/width in this one
        for (std::size_t i = 0; i < d; ++i) {
          const double c = functions[k][i] / width;
          next[k + 1][i] += c * (begin - low);
          next[k + 1][i + 1] += c;
          next[k][i] += c * (high - begin);
          next[k][i + 1] -= c;
        }
      }
      functions = next;
    }
    std::array<Powers, most_terms> by_power{};
    for (std::size_t k = 0; k < most_terms; ++k) {
      for (std::size_t i = 0; i < most_terms; ++i) by_power[i][k] = functions[k][i];
    }
    axis.basis.push_back(by_power);
  }
  axis.breaks.push_back(knots[knots.size() - 1 - p]);
  return axis;
}

Surface::Surface(SurfaceForm form) : form_(std::move(form)) {
  for (std::size_t d = 0; d < 2; ++d) axes_[d] = axis_of(form_.degree[d], form_.knots[d]);
  homogeneous_.reserve(form_.net.size());
  for (const NetPoint& point : form_.net) {
    // Weights that are all alike count for nothing.
    is_rational_ = is_rational_ || point.weight != form_.net.front().weight;
  }
  for (const NetPoint& point : form_.net) {
    const double w = is_rational_ ? point.weight : 1;
    homogeneous_.push_back({w * point.position[0], w * point.position[1], w * point.position[2], w});
  }
}

Range Surface::range(Direction direction) const {
  const std::vector<double>& all = breaks(direction);
  return {all.front(), all.back()};
}

/// Horner's rule, of all functions side by side, as vectors of the processor take them.
template <std::size_t highest>
Surface::Weights Surface::weights_of(const Axis& axis, double parameter) {
  const double inside = std::clamp(parameter, axis.breaks.front(), axis.breaks.back());
  const auto above = std::upper_bound(axis.breaks.begin() + 1, axis.breaks.end() - 1, inside);
  const auto span = static_cast<std::size_t>(above - axis.breaks.begin()) - 1;
  const double x = inside - axis.breaks[span];
  Weights weights;
  weights.first = axis.first[span];
  constexpr std::size_t lanes = 2;
  for (std::size_t k = 0; k < axis.terms; k += lanes) {
    std::array<std::array<double, lanes>, 4> taylor{};  // derivatives of order n, over n!
    for (std::size_t i = axis.terms; i-- > 0;) {
      for (std::size_t order = highest; order > 0; --order) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
          taylor[order][lane] = taylor[order][lane] * x + taylor[order - 1][lane];
      }
      for (std::size_t lane = 0; lane < lanes; ++lane)
        taylor[0][lane] = taylor[0][lane] * x + axis.basis[span][i][k + lane];
    }
    constexpr std::array<double, 4> factorial = {1, 1, 2, 6};
    for (std::size_t order = 0; order <= highest; ++order) {
      for (std::size_t lane = 0; lane < lanes; ++lane)
        weights.derivative[order][k + lane] = factorial[order] * taylor[order][lane];
    }
  }
  return weights;
}

Vector Surface::at(double u, double v) const {
  const Weights along = weights_of<0>(axes_[0], u), across = weights_of<0>(axes_[1], v);
  Homogeneous sum{};
  for (std::size_t l = 0; l < axes_[1].terms; ++l) {
    const Homogeneous* const row = &homogeneous_[along.first + (across.first + l) * form_.count[0]];
    Homogeneous of_row{};
    for (std::size_t k = 0; k < axes_[0].terms; ++k) add_scaled(of_row, along.derivative[0][k], row[k]);
    add_scaled(sum, across.derivative[0][l], of_row);
  }
  if (!is_rational_) return {sum[0], sum[1], sum[2]};
  return {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
}

namespace {

/// Derivatives a times by u and b times by v, a + b ≤ 3, by [a][b].
using Partials = std::array<std::array<Homogeneous, 4>, 4>;

constexpr std::array<std::array<double, 4>, 4> binomial = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};

/// S from w S and w, by Leibniz' rule (Piegl and Tiller, eq. 4.20), to the highest order; the first three of each become S.
void divide_by_weight(Partials& partials, std::size_t highest) {
  for (std::size_t order = 0; order <= highest; ++order) {
    for (std::size_t a = 0; a <= order; ++a) {
      const std::size_t b = order - a;
      Homogeneous sum = partials[a][b];
      for (std::size_t i = 0; i <= a; ++i) {
        for (std::size_t j = 0; j <= b; ++j) {
          if (i + j == 0) continue;
          const double factor = binomial[a][i] * binomial[b][j] * partials[i][j][3];
          for (std::size_t k = 0; k < 3; ++k) sum[k] -= factor * partials[a - i][b - j][k];
        }
      }
      for (std::size_t k = 0; k < 3; ++k) partials[a][b][k] = sum[k] / partials[0][0][3];
    }
  }
}

Vector position_in(const Homogeneous& h) {
  return {h[0], h[1], h[2]};
}

}  // namespace

template <std::size_t highest>
SurfaceJet Surface::jet_of(double u, double v) const {
  const Weights along = weights_of<highest>(axes_[0], u), across = weights_of<highest>(axes_[1], v);
  std::array<std::array<Homogeneous, highest + 1>, most_terms> rows;
  for (std::size_t l = 0; l < axes_[1].terms; ++l) {
    const Homogeneous* const row = &homogeneous_[along.first + (across.first + l) * form_.count[0]];
    std::array<Homogeneous, highest + 1> of_row{};
    for (std::size_t k = 0; k < axes_[0].terms; ++k) {
      for (std::size_t a = 0; a <= highest; ++a) add_scaled(of_row[a], along.derivative[a][k], row[k]);
    }
    rows[l] = of_row;
  }
  Partials partials{};
  for (std::size_t a = 0; a <= highest; ++a) {
    for (std::size_t b = 0; a + b <= highest; ++b) {
      Homogeneous sum{};
      for (std::size_t l = 0; l < axes_[1].terms; ++l) add_scaled(sum, across.derivative[b][l], rows[l][a]);
      partials[a][b] = sum;
    }
  }
  if (is_rational_) divide_by_weight(partials, highest);
  return {position_in(partials[0][0]), position_in(partials[1][0]), position_in(partials[0][1]),
          position_in(partials[2][0]), position_in(partials[1][1]), position_in(partials[0][2]),
          position_in(partials[3][0]), position_in(partials[2][1]), position_in(partials[1][2]),
          position_in(partials[0][3])};
}

SurfaceJet Surface::jet(double u, double v) const {
  return jet_of<3>(u, v);
}

SurfaceJet Surface::jet_of_second_order(double u, double v) const {
  return jet_of<2>(u, v);
}

SurfaceJet Surface::jet_of_first_order(double u, double v) const {
  return jet_of<1>(u, v);
}

}  // namespace leadscrew::surfaces
