#include <leadscrew/toolpath/newton_model.hpp>

namespace leadscrew::toolpath {

template <std::size_t D>
void NewtonModel<D>::reset(std::size_t points) {
  hessian.reset(D * points);
  slope.assign(D * points, 0);
  border.assign(D * points, 0);
  w_slope = w_curvature = 0;
}

template <std::size_t D>
void NewtonModel<D>::fix_ends() {
  const std::size_t rows = slope.size(), count = 3 * D;
  for (std::size_t i = 0; i < rows; ++i) {
    const bool is_fixed = i < count || i >= rows - count;
    auto& row = hessian.row(i);
    if (is_fixed) {
      row.fill(0);
      row[0] = 1;
      slope[i] = border[i] = 0;
    } else {
      for (std::size_t k = 1; k <= half_bandwidth && k <= i; ++k) {
        if (i - k < count) row[k] = 0;
      }
    }
  }
}

template <std::size_t D>
double NewtonModel<D>::solve(double damping, std::vector<Vector<D>>& step, double& w_step) {
  // [H b; bᵀ d] (Δc, Δw) = −(g, γ) by the Schur complement d − bᵀH⁻¹b.
  for (std::size_t i = 0; i < hessian.size(); ++i) hessian.row(i)[0] *= 1 + damping;
  hessian.factor(1e-14);
  along_slope = slope;
  along_border = border;
  hessian.solve(along_slope);
  hessian.solve(along_border);
  double complement = w_curvature, right = -w_slope;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    complement -= border[i] * along_border[i];
    right += border[i] * along_slope[i];
  }
  w_step = complement > 0 ? right / complement : 0;
  double decrement = -w_slope * w_step;
  step.resize(slope.size() / D);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const double change = -along_slope[i] - along_border[i] * w_step;
    step[i / D][i % D] = change;
    decrement -= slope[i] * change;
  }
  return decrement;
}

template struct NewtonModel<2>;
template struct NewtonModel<3>;

}  // namespace leadscrew::toolpath
