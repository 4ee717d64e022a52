#include <leadscrew/study/tube_barrier.hpp>

namespace leadscrew::study {

void TubeModel::reset(std::size_t points) {
  points_ = points;
  const std::size_t variables = 2 * (points - 6);
  hessian_.reset(variables);
  slope_.assign(variables, 0);
  border_.assign(variables, 0);
  w_slope_ = w_curvature_ = 0;
}

void TubeModel::add(std::size_t first, std::span<const double> factors, std::size_t axis, double slope,
                    double curvature, double mixed) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (!is_free(first + i)) continue;
    const std::size_t row = 2 * (first + i - 3) + axis;
    slope_[row] += slope * factors[i];
    border_[row] += mixed * factors[i];
    for (std::size_t k = 0; k <= i; ++k) {
      if (is_free(first + k)) hessian_.add(row, 2 * (first + k - 3) + axis, curvature * factors[i] * factors[k]);
    }
  }
}

void TubeModel::add(std::size_t first, std::span<const double> factors, PlaneVector slope, Hessian curvature,
                    PlaneVector mixed) {
  add(first, factors, 0, slope.x, curvature.xx, mixed.x);
  add(first, factors, 1, slope.y, curvature.yy, mixed.y);
  if (curvature.xy == 0) return;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (is_free(first + i) && is_free(first + k))
        hessian_.add(2 * (first + i - 3), 2 * (first + k - 3) + 1, curvature.xy * factors[i] * factors[k]);
    }
  }
}

void TubeModel::add_to_w(double slope, double curvature) {
  w_slope_ += slope;
  w_curvature_ += curvature;
}

TubeModel::Step TubeModel::newton_step() {
  // [H b; bᵀ d] (Δc, Δw) = −(g, γ) by the Schur complement d − bᵀH⁻¹b.
  hessian_.factor(1e-14);
  std::vector<double> along_slope = slope_, along_border = border_;
  hessian_.solve(along_slope);
  hessian_.solve(along_border);
  double complement = w_curvature_, right = -w_slope_;
  for (std::size_t i = 0; i < slope_.size(); ++i) {
    complement -= border_[i] * along_border[i];
    right += border_[i] * along_slope[i];
  }
  Step step;
  step.points.resize(points_);
  step.w = complement > 0 ? right / complement : 0;
  step.decrement = -w_slope_ * step.w;
  for (std::size_t i = 0; i < slope_.size(); ++i) {
    const double change = -along_slope[i] - along_border[i] * step.w;
    PlaneVector& point = step.points[i / 2 + 3];
    (i % 2 == 0 ? point.x : point.y) = change;
    step.decrement -= slope_[i] * change;
  }
  return step;
}

}  // namespace leadscrew::study
